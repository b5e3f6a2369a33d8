// Sliders for inputs and runtime parameters. In: the live part of a mechanism. Out: elements, and `onChange(place, value)`.

const text = (value) => (value !== 0 && (Math.abs(value) >= 1e5 || Math.abs(value) < 1e-3) ? value.toExponential(2) : String(Number(value.toPrecision(4))));

export class Sliders {
  constructor(element, live, parameters, onChange) {
    element.replaceChildren();
    this.places = [];
    for (const [title, input] of [["Inputs", true], ["Parameters", false]]) {
      const own = live.sliders.filter((slider) => slider.input === input);
      if (own.length === 0) continue;
      const section = document.createElement("section");
      const heading = document.createElement("h2");
      heading.textContent = title;
      const hint = document.createElement("small");
      hint.textContent = "a double click takes back";
      heading.append(" ", hint);
      section.append(heading);
      for (const slider of own) section.append(this.row(slider, live.parameters[slider.place], parameters, onChange));
      element.append(section);
    }
  }

  row({ name, place, low, high }, usual, parameters, onChange) {
    const label = document.createElement("label");
    const title = document.createElement("span");
    title.textContent = title.title = name;
    const range = document.createElement("input");
    Object.assign(range, { type: "range", min: Math.min(low, usual), max: Math.max(high, usual), step: "any" });
    range.dataset.name = name;
    range.value = String(parameters[place]);
    const value = document.createElement("output");
    value.textContent = text(parameters[place]);
    const set = (x) => {
      value.textContent = text(x);
      onChange(place, x);
    };
    range.addEventListener("input", () => set(Number(range.value)));
    range.addEventListener("dblclick", () => {
      range.value = String(usual);
      set(usual);
    });
    label.append(title, range, value);
    return label;
  }
}

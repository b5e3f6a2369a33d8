// Plots of values over time, each a canvas with a line at the current time and a legend of the values there. In:
// series of a mechanism. Out: elements in the panel; `onSeek(t)` when one is clicked or dragged. Series of a plot have one
// unit; the limits of coordinates are dashed lines, where the motion is not too small to be seen between them.
import { valueAt } from "./scene_data.js";

const kColors = {
  light: ["#2f6fb0", "#d9730d", "#3c8d40", "#c93a3d", "#8a5a9e", "#0d8a84", "#9a7400", "#7a5440"],
  dark: ["#6fa8e0", "#f5a04a", "#74c274", "#f27f7f", "#c79ad6", "#5fc7c0", "#e6c65c", "#c29a86"],
};
const kHeight = 142;
const kMargin = { left: 52, right: 10, top: 18, bottom: 20 };
const kLeastShare = 0.1;  // of the axis that the motion takes, if limits are to be on it

/// About `count` round numbers from low to high.
function ticks(low, high, count) {
  const rough = (high - low) / count;
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = power * [1, 2, 5, 10].find((m) => m * power >= rough * 0.999);
  const out = [];
  for (let i = Math.ceil(low / step - 1e-9); i * step <= high + 1e-9 * step; ++i) out.push(i * step);
  return { step, values: out };
}

function tickText(value, step) {
  if (Math.abs(value) < 1e-9 * step) return "0";
  if (Math.abs(value) >= 1e5 || (step < 1e-4 && Math.abs(value) < 100 * step)) return value.toExponential(1);
  return value.toFixed(Math.max(0, Math.ceil(-Math.log10(step) - 1e-9)));
}

const legendText = (value) => (Math.abs(value) >= 1e5 || (value !== 0 && Math.abs(value) < 1e-4) ? value.toExponential(3) : value.toPrecision(5));

class Plot {
  constructor(title, note, times, series, onSeek) {
    this.times = times;
    this.series = series;
    this.unit = series[0].unit;
    this.element = document.createElement("section");
    const heading = document.createElement("h2");
    heading.textContent = title;
    if (note) {
      const small = document.createElement("small");
      small.textContent = note;
      heading.append(" ", small);
    }
    this.canvas = document.createElement("canvas");
    this.legend = document.createElement("ul");
    this.values = series.map((one) => {
      const item = document.createElement("li");
      const swatch = document.createElement("i");
      const name = document.createElement("span");
      name.textContent = one.name;
      const value = document.createElement("b");
      item.append(swatch, name, value);
      if (one.limits) item.title = `limits ${one.limits.map(legendText).join(" \u2026 ")} ${one.unit}`;
      this.legend.append(item);
      return { swatch, value };
    });
    this.element.append(heading, this.canvas, this.legend);
    this.background = document.createElement("canvas");
    const seek = (event) => {
      const box = this.canvas.getBoundingClientRect();
      const share = (event.clientX - box.left - kMargin.left) / (box.width - kMargin.left - kMargin.right);
      onSeek(this.start + Math.min(1, Math.max(0, share)) * (this.end - this.start));
    };
    this.canvas.addEventListener("pointerdown", (event) => {
      this.canvas.setPointerCapture(event.pointerId);
      seek(event);
    });
    this.canvas.addEventListener("pointermove", (event) => {
      if (event.buttons & 1) seek(event);
    });
    this.fit();
  }

  /// Axes that hold what there is.
  fit() {
    this.start = this.times[0];
    const last = this.times[this.times.length - 1];
    this.end = last > this.times[0] ? last : this.times[0] + 1;
    this.low = Infinity;
    this.high = -Infinity;
    for (const { values } of this.series) {
      for (const value of values) {
        if (!Number.isFinite(value)) continue;  // an output may have no value at times
        this.low = Math.min(this.low, value);
        this.high = Math.max(this.high, value);
      }
    }
    if (this.low > this.high) this.low = this.high = 0;
    const limits = this.series.flatMap((one) => one.limits ?? []).filter((limit) => limit !== null);
    const [low, high] = [Math.min(this.low, ...limits), Math.max(this.high, ...limits)];
    if (this.high - this.low >= kLeastShare * (high - low)) [this.low, this.high] = [low, high];
    // A constant is drawn in the middle, not its last digits across the height.
    const size = Math.max(Math.abs(this.low), Math.abs(this.high));
    const constant = this.high - this.low < 1e-7 * Math.max(size, 1e-3);
    const margin = constant ? Math.max(0.1 * size, 1e-3) : 0.06 * (this.high - this.low);
    this.low -= margin;
    this.high += margin;
  }

  x(t) {
    return kMargin.left + ((t - this.start) / (this.end - this.start)) * (this.width - kMargin.left - kMargin.right);
  }
  y(value) {
    return kHeight - kMargin.bottom - ((value - this.low) / (this.high - this.low)) * (kHeight - kMargin.top - kMargin.bottom);
  }

  resize(theme) {
    this.width = this.element.clientWidth;
    if (!(this.width > kMargin.left + kMargin.right)) return;
    const ratio = window.devicePixelRatio || 1;
    for (const canvas of [this.canvas, this.background]) {
      canvas.width = Math.round(this.width * ratio);
      canvas.height = Math.round(kHeight * ratio);
    }
    this.canvas.style.height = `${kHeight}px`;
    const style = getComputedStyle(document.documentElement);
    const ink = style.getPropertyValue("--quiet").trim();
    const line = style.getPropertyValue("--line").trim();
    this.cursor = style.getPropertyValue("--ink").trim();
    const context = this.background.getContext("2d");
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    context.clearRect(0, 0, this.width, kHeight);
    context.font = `11px ${style.getPropertyValue("--font")}`;
    context.fillStyle = ink;
    context.strokeStyle = line;
    context.lineWidth = 1;
    const stroke = (x0, y0, x1, y1) => {
      context.beginPath();
      context.moveTo(x0, y0);
      context.lineTo(x1, y1);
      context.stroke();
    };
    const right = this.width - kMargin.right;
    const bottom = kHeight - kMargin.bottom;
    const vertical = ticks(this.low, this.high, 5);
    context.textAlign = "right";
    context.textBaseline = "middle";
    for (const value of vertical.values) {
      const y = Math.round(this.y(value)) + 0.5;
      stroke(kMargin.left, y, right, y);
      context.fillText(tickText(value, vertical.step), kMargin.left - 6, y);
    }
    const horizontal = ticks(this.start, this.end, 5);
    context.textAlign = "center";
    context.textBaseline = "top";
    for (const value of horizontal.values) {
      const x = Math.round(this.x(value)) + 0.5;
      stroke(x, bottom, x, bottom + 4);
      context.fillText(`${tickText(value, horizontal.step)} s`, Math.min(x, right - 8), bottom + 6);
    }
    if (this.unit) {
      context.textAlign = "right";
      context.textBaseline = "top";
      context.fillText(this.unit, kMargin.left - 6, 0);
    }
    this.series.forEach(({ limits }, s) => {
      context.strokeStyle = kColors[theme][s % kColors[theme].length];
      context.setLineDash([5, 4]);
      for (const limit of limits ?? [])
        if (limit !== null && limit > this.low && limit < this.high) stroke(kMargin.left, this.y(limit), right, this.y(limit));
      context.setLineDash([]);
    });
    context.lineWidth = 1.6;
    context.lineJoin = "round";
    this.series.forEach(({ values }, s) => {
      const color = kColors[theme][s % kColors[theme].length];
      this.values[s].swatch.style.background = color;
      context.strokeStyle = color;
      context.beginPath();
      for (let k = 0; k < values.length; ++k) context.lineTo(this.x(this.times[k]), this.y(values[k]));
      context.stroke();
    });
  }

  seek(t, theme) {
    const context = this.canvas.getContext("2d");
    const ratio = window.devicePixelRatio || 1;
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.clearRect(0, 0, this.canvas.width, this.canvas.height);
    if (this.background.width > 0 && this.background.height > 0) context.drawImage(this.background, 0, 0);
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    const held = Math.min(Math.max(t, this.start), this.end);
    const x = this.x(held);
    context.strokeStyle = this.cursor;
    context.lineWidth = 1;
    context.beginPath();
    context.moveTo(x, kMargin.top);
    context.lineTo(x, kHeight - kMargin.bottom);
    context.stroke();
    this.series.forEach(({ values }, s) => {
      const value = valueAt(this.times, values, held);
      this.values[s].value.textContent = legendText(value);
      context.fillStyle = kColors[theme][s % kColors[theme].length];
      context.beginPath();
      context.arc(x, this.y(value), 3, 0, 2 * Math.PI);
      context.fill();
    });
  }
}

/// Name of the quaternion that a coordinate is a part of.
const stem = (name) => name.match(/^(.*)\.[xyzw]$/)?.[1];

/// Potential energy has no zero of its own: from its lowest value, kinetic energy can be seen beside it.
function fromLowestPotential(energies) {
  const lowest = energies.find(({ name }) => name === "potential").values.reduce((a, b) => Math.min(a, b), Infinity);
  return energies.map((one) => ({ ...one, values: one.name === "kinetic" ? one.values : one.values.map((x) => x - lowest) }));
}

/// Series that share a plot: the parts of a quaternion or a vector, otherwise four of one unit at a time.
function groups(all) {
  const out = [];
  for (const series of all) {
    const last = out[out.length - 1];
    const same = last && stem(last[0].name) === stem(series.name) && last[0].unit === series.unit;
    if (same && last.length < 4) last.push(series);
    else out.push([series]);
  }
  return out;
}

export class Plots {
  constructor(element, mechanism, onSeek) {
    element.replaceChildren();
    // Of a live motion they are from the lowest already, and change as they are pulled.
    const live = mechanism.energy_change === undefined;
    const note = `J, potential from its lowest${live ? "" : `; total changes by ${mechanism.energy_change.toPrecision(2)} at most`}`;
    const energies = live ? mechanism.energies : fromLowestPotential(mechanism.energies);
    this.plots = [new Plot("Energy", note, mechanism.times, energies, onSeek)];
    this.next = 0;
    for (const [all, kind] of [[mechanism.coordinates, ""], [mechanism.forces, "force"], [mechanism.inputs, "input"], [mechanism.states, "state"], [mechanism.outputs, "output"]])
      for (const group of groups(all)) {
        const part = stem(group[0].name);
        const last = group[group.length - 1].name;
        const title = part ?? (group.length === 1 ? last : `${group[0].name} \u2026 ${last}`);
        const series = part ? group.map((one) => ({ ...one, name: one.name.slice(part.length + 1) })) : group;
        const what = kind === "force" && group[0].unit === "J" ? "potential" : kind;
        const note = [what, group[0].unit].filter((word) => word).join(", ");
        this.plots.push(new Plot(title, note, mechanism.times, series, onSeek));
      }
    element.append(...this.plots.map((plot) => plot.element));
  }

  resize(theme) {
    for (const plot of this.plots) plot.resize(theme);
  }
  seek(t, theme) {
    for (const plot of this.plots) plot.seek(t, theme);
  }
  /// Draws one of them anew as it has grown, each in turn, and the values of all at the end.
  grow(theme) {
    const plot = this.plots[this.next++ % this.plots.length];
    plot.fit();
    plot.resize(theme);
    plot.seek(plot.end, theme);
  }
}

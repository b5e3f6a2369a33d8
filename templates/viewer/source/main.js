// The page: reads the scene, connects picture, plots and playback, and offers `window.viewer` to scripts.
import "./page.css";
import { LiveMode } from "./live_mode.js";
import { Plots } from "./plots.js";
import { readScene } from "./scene_data.js";
import { Sliders } from "./sliders.js";
import { Stage } from "./stage.js";

const element = (id) => document.getElementById(id);
const data = readScene(element("scene").textContent);
const starts = data.mechanisms.map((mechanism) => mechanism.times[0]);
const ends = data.mechanisms.map((mechanism) => mechanism.times[mechanism.times.length - 1]);
const start = Math.min(...starts);
const end = Math.max(...ends);
const duration = end - start;

const stage = new Stage(element("stage"), data);
const state = { time: start, playing: false, shown: 0, theme: "light", last: 0 };
let plots = null;
const live = data.mechanisms.some((mechanism) => mechanism.live) ? new LiveMode(stage, data, () => play()) : null;
const speed = () => Number(element("speed").value);

function show() {
  if (live?.on) {
    live.show();
    showClock(live.time);
    return;
  }
  stage.seek(state.time);
  plots.seek(state.time, state.theme);
  element("time").value = String(duration > 0 ? (state.time - start) / duration : 0);
  showClock(state.time);
}

function showClock(t) {
  element("clock").textContent = `${t.toFixed(2)} s`;
}

/// Live, or the motion as it was recorded.
function setMode(on) {
  if (!live || live.on === on) return;
  pause();
  live.set(on);
  document.body.dataset.mode = on ? "live" : "recorded";
  element("live").setAttribute("aria-pressed", String(on));
  element("recorded").setAttribute("aria-pressed", String(!on));
  select(state.shown, false);
  show();
}

function reset() {
  const goesOn = state.playing || live.stopped;  // what stopped by itself was not paused
  setMode(true);
  live.reset();
  note("");
  show();
  plots.resize(state.theme);
  if (goesOn) play();
}

function note(text) {
  element("hint").textContent = text === "" ? "Drag a body to pull it, elsewhere to turn the picture" : `It stops: ${text}. Reset starts anew`;
  element("hint").classList.toggle("problem", text !== "");
}

function seek(t) {
  setMode(false);
  pause();
  state.time = Math.min(Math.max(t, start), end);
  show();
}

function step(now) {
  if (!state.playing) return;
  const elapsed = Math.min(Math.max(now - state.last, 0) / 1000, 0.1);  // the first frame may lie before play()
  state.last = now;
  if (live?.on) {
    live.advance(elapsed * speed());
    showClock(live.time);
    plots.grow(state.theme);
    if (live.problem) note(live.problem);
    if (live.stopped) pause();
    requestAnimationFrame(step);
    return;
  }
  state.time += elapsed * speed();
  if (state.time > end) state.time = start;
  show();
  requestAnimationFrame(step);
}

function play() {
  if (state.playing || !(duration > 0 || live?.on)) return;
  state.playing = true;
  if (!live?.on && state.time >= end) state.time = start;
  state.last = performance.now();
  showPlaying();
  requestAnimationFrame(step);
}

function pause() {
  state.playing = false;
  showPlaying();
}

function showPlaying() {
  element("play").dataset.state = state.playing ? "playing" : "paused";
  element("play").setAttribute("aria-label", state.playing ? "Pause" : "Play");
}

function setTheme(theme) {
  state.theme = theme;
  document.documentElement.dataset.theme = theme;
  stage.setTheme(theme);
  showPlots();
  show();
}

/// Heading and plots of one of the mechanisms.
function select(index, look) {
  state.shown = index;
  const mechanism = data.mechanisms[index];
  element("heading").querySelector("h1").textContent = mechanism.name.replaceAll("_", " ");
  const description = element("heading").querySelector("p");  // a few lines; a click shows or hides the rest
  description.textContent = mechanism.description;
  description.onclick = () => description.classList.toggle("whole");
  stage.resize();  // the heading has another height
  for (const [i, button] of [...element("mechanisms").children].entries())
    button.setAttribute("aria-pressed", String(i === index));
  const record = live?.on && live.records[index];
  plots = record ? new Plots(element("plots"), record.data, () => {}) : new Plots(element("plots"), mechanism, seek);
  showPlots();
  const motion = record && live.motions[index];
  const slide = (place, value) => {
    motion.setParameter(place, value);
    show();  // paused as well
  };
  if (motion) new Sliders(element("sliders"), mechanism.live, motion.inputs.parameters, slide);
  else element("sliders").replaceChildren();
  if (look) stage.frame(index);
}

function showPlots() {
  plots.resize(state.theme);
  plots.seek(live?.on ? Infinity : state.time, state.theme);
}

if (data.mechanisms.length > 1) {
  data.mechanisms.forEach((mechanism, i) => {
    const button = document.createElement("button");
    button.type = "button";
    button.textContent = mechanism.name;
    button.addEventListener("click", () => select(i, true));
    element("mechanisms").append(button);
  });
}
select(0, false);
stage.frame();

const dark = window.matchMedia("(prefers-color-scheme: dark)");
setTheme(dark.matches ? "dark" : "light");
dark.addEventListener("change", () => setTheme(dark.matches ? "dark" : "light"));
new ResizeObserver(showPlots).observe(element("plots"));

element("theme").addEventListener("click", () => setTheme(state.theme === "dark" ? "light" : "dark"));
element("home").addEventListener("click", () => stage.frame());
element("trails").addEventListener("click", () => {
  const on = element("trails").getAttribute("aria-pressed") !== "true";
  element("trails").setAttribute("aria-pressed", String(on));
  stage.showTrails(on);
});
element("live").addEventListener("click", () => {
  setMode(true);
  play();
});
element("recorded").addEventListener("click", () => setMode(false));
element("reset").addEventListener("click", reset);
element("play").addEventListener("click", () => (state.playing ? pause() : play()));
element("time").addEventListener("input", () => seek(start + Number(element("time").value) * duration));
// What the pointer has used does not keep the keyboard from the picture.
window.addEventListener("click", (event) => event.detail > 0 && event.target.closest?.("button")?.blur());
window.addEventListener("pointerup", (event) => event.target instanceof HTMLInputElement && event.target.blur());
window.addEventListener("change", (event) => event.target instanceof HTMLSelectElement && event.target.blur());
window.addEventListener("keydown", (event) => {
  if (event.target instanceof HTMLSelectElement || event.target instanceof HTMLInputElement) return;
  if (event.key === " " && !(event.target instanceof HTMLButtonElement)) {
    event.preventDefault();
    if (state.playing) pause();
    else play();
  } else if (event.key === "r" && live && !event.ctrlKey && !event.metaKey) {
    reset();
  } else if (!live?.on && (event.key === "ArrowRight" || event.key === "ArrowLeft")) {
    seek(state.time + (event.key === "ArrowRight" ? 1 : -1) / 60);
  }
});

/// For scripts: times in seconds; a pose is four rows of the body's 4x4 matrix in its mechanism's world, or null; onScreen is
/// where a body's origin is in the picture, from -1 to 1.
window.viewer = {
  start,
  duration,
  mechanisms: data.mechanisms.map(({ name, bodies }) => ({ name, bodies: bodies.map((body) => body.name) })),
  seek,
  play,
  pause,
  setTheme,
  select: (index) => select(index, true),
  showAll: () => stage.frame(),
  /// A force between points as drawn: tension in N, state pull, push or slack, radius, points in its mechanism's world.
  line: (name, mechanismName) => stage.forces(mechanismName)?.line(name) ?? null,
  /// A contact as drawn: normal force in N, whether it touches, radius of the dot, its point.
  contact: (name, mechanismName) => stage.forces(mechanismName)?.contact(name) ?? null,
  onScreen: (bodyName, mechanismName) => stage.onScreen(bodyName, mechanismName),
  get time() {
    return live?.on ? live.time : state.time;
  },
  /// The live mode: `motions`, by mechanism, have the generated `module`, q, u, t, `inputs`, `energy()`, `work` of the hand, `grab(body,
  /// point)`, `moveTarget(point)`, `release()` and `step(h)`; null where there is none.
  live,
  setMode: (mode) => setMode(mode === "live"),
  reset,
  get drawn() {
    return stage.renderer !== null;
  },
  pose(bodyName, mechanismName) {
    const matrix = stage.pose(bodyName, mechanismName);
    if (!matrix) return null;
    const m = matrix.elements;
    return [0, 1, 2, 3].map((row) => [m[row], m[row + 4], m[row + 8], m[row + 12]]);
  },
};

note("");
element("modes").hidden = !live;
show();
showPlaying();
if (live && location.hash !== "#paused") setMode(true);
if (!window.matchMedia("(prefers-reduced-motion: reduce)").matches && location.hash !== "#paused") play();

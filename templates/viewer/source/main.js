// The page: reads the scene, connects picture, plots and playback, and offers `window.viewer` to scripts.
import "./page.css";
import { Plots } from "./plots.js";
import { readScene } from "./scene_data.js";
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

function show() {
  stage.seek(state.time);
  plots.seek(state.time, state.theme);
  element("time").value = String(duration > 0 ? (state.time - start) / duration : 0);
  element("clock").textContent = `${(state.time).toFixed(2)} s`;
}

function seek(t) {
  pause();
  state.time = Math.min(Math.max(t, start), end);
  show();
}

function step(now) {
  if (!state.playing) return;
  const elapsed = Math.min(Math.max(now - state.last, 0) / 1000, 0.1);  // the first frame may lie before play()
  state.last = now;
  state.time += elapsed * Number(element("speed").value);
  if (state.time > end) state.time = start;
  show();
  requestAnimationFrame(step);
}

function play() {
  if (state.playing || !(duration > 0)) return;
  state.playing = true;
  if (state.time >= end) state.time = start;
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
  plots.resize(theme);
  show();
}

/// Heading and plots of one of the mechanisms.
function select(index, look) {
  state.shown = index;
  const mechanism = data.mechanisms[index];
  element("heading").querySelector("h1").textContent = mechanism.name.replaceAll("_", " ");
  element("heading").querySelector("p").textContent = mechanism.description;
  for (const [i, button] of [...element("mechanisms").children].entries())
    button.setAttribute("aria-pressed", String(i === index));
  plots = new Plots(element("plots"), mechanism, seek);
  plots.resize(state.theme);
  plots.seek(state.time, state.theme);
  if (look) stage.frame(index);
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

const dark = window.matchMedia("(prefers-color-scheme: dark)");
setTheme(dark.matches ? "dark" : "light");
dark.addEventListener("change", () => setTheme(dark.matches ? "dark" : "light"));
new ResizeObserver(() => {
  plots.resize(state.theme);
  plots.seek(state.time, state.theme);
}).observe(element("plots"));

element("theme").addEventListener("click", () => setTheme(state.theme === "dark" ? "light" : "dark"));
element("home").addEventListener("click", () => stage.frame());
element("trails").addEventListener("click", () => {
  const on = element("trails").getAttribute("aria-pressed") !== "true";
  element("trails").setAttribute("aria-pressed", String(on));
  stage.showTrails(on);
});
element("play").addEventListener("click", () => (state.playing ? pause() : play()));
element("time").addEventListener("input", () => seek(start + Number(element("time").value) * duration));
window.addEventListener("keydown", (event) => {
  if (event.target instanceof HTMLSelectElement || event.target instanceof HTMLInputElement) return;
  if (event.key === " " && !(event.target instanceof HTMLButtonElement)) {
    event.preventDefault();
    if (state.playing) pause();
    else play();
  } else if (event.key === "ArrowRight" || event.key === "ArrowLeft") {
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
    return state.time;
  },
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

show();
showPlaying();
if (!window.matchMedia("(prefers-reduced-motion: reduce)").matches && location.hash !== "#paused") play();

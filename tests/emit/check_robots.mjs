// Modules of JavaScript of whole robots against `alembert evaluate` at random states: 1e-12 of the largest entry of each array.
//   node check_robots.mjs ALEMBERT FOLDER FUNCTION,... ROBOT...
import { execFileSync } from "node:child_process";
import { mkdirSync, readdirSync } from "node:fs";
import { basename, join } from "node:path";
import { pathToFileURL } from "node:url";

const [alembert, folder, functions, ...robots] = process.argv.slice(2);
const kArguments = {
  inverse_dynamics: ["q", "qd", "qdd"],
  mass_matrix: ["q"],
  bias: ["q", "qd"],
  forward_dynamics: ["q", "qd", "tau"],
  inverse_dynamics_derivatives: ["q", "qd", "qdd"],
  frame_jacobians: ["q"],
  body_poses: ["q"],
};
let seed = 1;
// Numerical Recipes' generator: the same states in every run.
const random = () => ((seed = (1664525 * seed + 1013904223) % 4294967296) / 2147483648 - 1);
const vector = (n) => Float64Array.from({ length: n }, random);

let failed = false;
for (const robot of robots) {
  const own = join(folder, basename(robot));
  mkdirSync(own, { recursive: true });
  const options = ["--root", "floating", "--functions", functions];
  execFileSync(alembert, ["generate", robot, ...options, "--language", "javascript", "--out-dir", own], { stdio: ["ignore", "ignore", "ignore"] });
  const modules = readdirSync(join(own, "javascript"));
  const module = await import(pathToFileURL(join(own, "javascript", modules[0])));
  const states = Array.from({ length: 3 }, () => {
    const q = vector(module.nq);
    for (const first of module.quaternion_offsets) {
      const norm = Math.hypot(...q.subarray(first, first + 4));
      for (let i = 0; i < 4; ++i) q[first + i] /= norm;
    }
    return { q, qd: vector(module.nv), qdd: vector(module.nv), tau: vector(module.nv) };
  });
  const lines = states.map((state) => JSON.stringify(Object.fromEntries(Object.entries(state).map(([key, x]) => [key, [...x]]))));
  const answers = execFileSync(alembert, ["evaluate", robot, ...options, "--json"], { input: lines.join("\n"), stdio: ["pipe", "pipe", "ignore"], maxBuffer: 1 << 30 });
  let worst = 0, entries = 0;
  answers.toString().trim().split("\n").forEach((line, k) => {
    const answer = JSON.parse(line);
    for (const name of functions.split(",")) {
      const result = module[name](...kArguments[name].map((key) => states[k][key]));
      const arrays = result instanceof Float64Array ? { only: result } : result;
      const expected = answer[name];
      for (const [key, found] of Object.entries(arrays)) {
        const values = (key === "only" ? Object.values(expected)[0] : expected[key]).flat(9);
        if (values.length !== found.length) throw new Error(`${robot}: ${name} has ${found.length} entries, not ${values.length}`);
        const largest = Math.max(...values.map(Math.abs));
        values.forEach((x, i) => (worst = Math.max(worst, x === found[i] ? 0 : Math.abs(x - found[i]) / largest)));
        if (found.some(Number.isNaN)) worst = Infinity;
        entries += values.length;
      }
    }
  });
  console.log(`${basename(robot)}: ${module.nv} speeds, ${entries} numbers, worst ${worst.toExponential(1)}`);
  failed ||= !(worst <= 1e-12) || entries === 0;
}
process.exit(failed ? 1 : 0);

// A pole that is balanced on a cart by state feedback, in JavaScript.
//   node main.mjs PATH/cart.mjs
import { pathToFileURL } from "node:url";

const cart = await import(pathToFileURL(process.argv[2]));
const [x, angle] = [cart.coordinate_names.indexOf("x"), cart.coordinate_names.indexOf("angle")];
const push = (q, qd) => 3 * q[x] + 6 * qd[x] + 60 * q[angle] + 18 * qd[angle]; // N, state feedback
const free = new Float64Array(cart.nv); // no forces besides the motor's

const q = Float64Array.from(cart.initial_coordinates);
const qd = Float64Array.from(cart.initial_speeds);
const h = 1 / 240; // s
console.log("time       x    angle   pole's end x       z");
for (let k = 0; k <= 1440; ++k) {
  if (k % 240 === 0) {
    const pole = cart.body_poses(q, { length: 1 }).subarray(12 * cart.body_names.indexOf("pole")); // [R p], row by row
    console.log([k * h, q[x], q[angle], pole[3], pole[11]].map((value) => value.toFixed(4).padStart(8)).join(" "));
  }
  const qdd = cart.forward_dynamics(q, qd, free, { push: push(q, qd), length: 1 });
  for (let i = 0; i < cart.nv; ++i) {
    qd[i] += h * qdd[i]; // semi-implicit Euler
    q[i] += h * qd[i];
  }
}
process.exitCode = Math.hypot(...q, ...qd) < 0.05 ? 0 : 1;

// A mechanism that moves in the browser, by the functions that were generated for it. In: the live part of a mechanism
// (scene_data.js), time that passes, a point that is pulled. Out: coordinates, speeds, poses, energy.
//
// Without forces in the description, steps are RK4, by forward_dynamics where there are no constraints; with forces, which may
// be stiff, they are of the backward Euler method. Steps that are inexact are made again in halves. Constraints are kept by projecting the
// state after each step.
import { ConstrainedEquations } from "./linear_equations.js";
import { Pull } from "./pull.js";

const kSteps = [1 / 960, 1 / 480, 1 / 240, 1 / 120, 1 / 60];  // s
const kShare = 0.5;       // of the time that passes may be taken by computing
const kMostTime = 14;     // ms of computing at once: then time passes more slowly
const kLeastMobility = 1e-6;  // of that without constraints: what has less is held fast
const kProjections = 6;
const kHalvings = 7;      // of a step
const kExact = 1e-4;      // of the kinetic energy may be lost in a step
const kBearable = 1e-2;   // of it in one that is not halved again
const kImplicitHalvings = 5;
const kIterations = 8;
const kLeastShare = 0.01;  // of a step of Newton's method
const kImplicitlyExact = 1e-10;  // of the kinetic energy may be that of what an iteration adds to the speeds
const kStill = 1e-11;     // m/s^2, of all mass: no motion
const kRounding = 1e-12;  // of the potential energy cannot be told
const kKept = 1e-9;       // a constraint is kept to

/// The exports of an ES module that imports nothing.
function moduleOf(text) {
  const at = text.lastIndexOf("\nexport {");
  return new Function(`"use strict";${text.slice(0, at)}\nreturn {${text.slice(at + "\nexport {".length)}`)();
}

export class LiveMotion {
  /// `bodies`: with `mass` and `center`.
  constructor(live, bodies) {
    const m = moduleOf(live.module);
    this.module = m;
    this.start = live;
    this.bodies = bodies;
    this.mass = bodies.reduce((sum, { mass }) => sum + mass, 0);
    const { nq, nv } = m;
    const nc = m.constraint_names.length;
    this.nc = nc;
    this.direct = m.forward_dynamics !== undefined;
    this.timed = /\bgiven\.t\b/.test(live.module);  // motion prescribed in time does work
    this.stiff = m.inverse_dynamics_derivatives !== undefined;
    this.statePlaces = m.state_names.map((name) => m.parameter_names.indexOf(name));
    const numbers = (n) => new Float64Array(n);
    Object.assign(this, { q: numbers(nq), u: numbers(nv), states: numbers(this.statePlaces.length) });
    this.inputs = { t: live.t, parameters: Float64Array.from(live.parameters) };
    this.equations = new ConstrainedEquations(nv, nc);
    this.dynamics = { M: numbers(nv * nv), c: numbers(nv) };
    this.rows = { P: numbers(nc * nv), gamma: numbers(nc), velocity: numbers(nc), position: numbers(nc) };
    this.derivatives = { tau_q: numbers(nv * nv), tau_qd: numbers(nv * nv) };
    this.W = numbers(12 * bodies.length);
    this.side = numbers(nc);
    this.A = numbers(nv * nv);
    this.tau = numbers(nv);
    this.cost = 0;  // ms of a step, of late
    this.reset();
  }

  /// Back to the state it started from; parameters and inputs stay as they were set.
  reset() {
    this.q.set(this.start.q);
    this.u.set(this.start.qd);
    this.states.set(this.statePlaces.map((place) => this.start.parameters[place]));
    this.t = this.start.t;
    this.waiting = 0;
    this.work = 0;  // of the pull, J
    this.problem = "";
    this.pull = null;
    this.settle();
  }

  /// Sets time and states; what functions take besides q and u.
  inputsAt(t, states) {
    this.inputs.t = t;
    this.statePlaces.forEach((place, i) => (this.inputs.parameters[place] = states[i]));
    return this.inputs;
  }
  here() {
    return this.inputsAt(this.t, this.states);
  }
  poses() {
    return this.module.body_poses(this.q, this.here(), this.W);
  }
  /// Kinetic and potential, J.
  energy() {
    return this.module.energy(this.q, this.u, this.here());
  }
  setParameter(place, value) {
    this.inputs.parameters[place] = value;
    this.settle();
  }

  /// Pulls a point of a body, given in the body's frame, towards a target in the world, until release(). A body that
  /// cannot move is not pulled.
  grab(body, point) {
    const { nv } = this.module;
    this.pull = null;
    const pull = new Pull(this.module, this.bodies, body, point);
    pull.move(this.q, this.here());
    pull.target = [...pull.at];
    const response = this.responses();
    let [mobility, free] = [0, 0];  // 1/kg, with the constraints and without
    for (let a = 0; a < 3; ++a) {
      const row = pull.J.subarray(a * nv, (a + 1) * nv);
      const { x, y } = response(row);
      for (let i = 0; i < nv; ++i) {
        mobility += row[i] * x[i];
        free += row[i] * y[i];
      }
    }
    if (!(mobility > kLeastMobility * free) || !(free > 0)) return false;
    pull.setStrength(mobility, this.mass);
    this.pull = pull;
    return true;
  }
  /// What generalized forces add to the rates of the speeds here: x, and without constraints y.
  responses() {
    const inputs = this.evaluate(this.q, this.u, this.t, this.states);
    const { module: m, q, u, equations, dynamics, rows, side } = this;
    if (this.direct) {
      const none = m.forward_dynamics(q, u, new Float64Array(m.nv), inputs);
      return (force) => {
        const x = m.forward_dynamics(q, u, force, inputs).map((rate, i) => rate - none[i]);
        return { x, y: x };
      };
    }
    return (force) => {
      const x = Float64Array.from(force);
      equations.solve(dynamics.M, x, rows.P, side.fill(0));
      return { x, y: equations.factor.solve(Float64Array.from(force)) };
    };
  }
  moveTarget(target) {
    if (this.pull) this.pull.target = [...target];
  }
  release() {
    this.pull = null;
  }

  evaluate(q, u, t, states) {
    const inputs = this.inputsAt(t, states);
    if (!this.direct) this.module.mass_matrix_and_bias(q, u, inputs, this.dynamics);
    if (this.nc > 0) this.module.constraints(q, u, inputs, this.rows);
    return inputs;
  }

  /// Rates of the speeds into `rate`; the power of the pull.
  accelerate(q, u, t, states, rate) {
    const inputs = this.evaluate(q, u, t, states);
    const { nv } = this.module;
    const { tau } = this;
    const power = this.applyPull(q, u, inputs);
    if (this.direct) {
      this.module.forward_dynamics(q, u, tau, inputs, rate);
      return power;
    }
    for (let i = 0; i < nv; ++i) rate[i] = tau[i] - this.dynamics.c[i];
    for (let r = 0; r < this.nc; ++r) this.side[r] = -this.rows.gamma[r];
    if (!this.equations.solve(this.dynamics.M, rate, this.rows.P, this.side)) this.problem = "the mass matrix is singular here";
    return power;
  }

  /// The pull's generalized forces, alone, into tau; its power.
  applyPull(q, u, inputs) {
    this.tau.fill(0);
    this.pull?.move(q, inputs);
    return this.pull?.addTo(this.tau, u) ?? 0;
  }

  stepByRk4(h) {
    const { nq, nv } = this.module;
    const sizes = [nq, nv, this.states.length];
    const start = [this.q, this.u, this.states].map((x) => Float64Array.from(x));
    const sum = sizes.map((n) => new Float64Array(n));
    const rates = sizes.map((n) => new Float64Array(n));
    let work = 0;
    for (const [share, weight] of [[0, 1], [0.5, 2], [0.5, 2], [1, 1]]) {
      const [q, u, s] = start.map((x, k) => x.map((value, i) => value + share * h * rates[k][i]));
      const t = this.t + share * h;
      const power = this.accelerate(q, u, t, s, rates[1]);
      this.module.coordinate_rates(q, u, rates[0]);
      if (s.length > 0) this.module.state_rates(q, u, this.inputsAt(t, s), rates[2]);
      sum.forEach((x, k) => x.forEach((_, i) => (x[i] += (weight / 6) * rates[k][i])));
      work += (weight / 6) * h * power;
    }
    [this.q, this.u, this.states].forEach((x, k) => x.forEach((_, i) => (x[i] = start[k][i] + h * sum[k][i])));
    this.t += h;
    this.work += work;
  }

  /// Backward Euler by Newton's method: M (u - u0) = h (tau - c) and the constraints' velocities, where the step ends. Its steps are halved
  /// until those that would follow with the same matrix are shorter; where none does it, as at a jump of a force, it ends. Returns whether
  /// it has converged.
  stepImplicitly(h) {
    const { q, u, A, pull, dynamics, derivatives, side, tau } = this;
    const { nv } = this.module;
    const numbers = () => new Float64Array(nv);
    const [q0, u0, base] = [q, u, u].map((x) => Float64Array.from(x));
    const [change, rate, newton, following] = [numbers(), numbers(), numbers(), numbers()];
    let inputs = null;
    this.t += h;
    // What the equations are off by where the speeds are u.
    const residual = (rest) => {
      q.set(q0);
      this.addRates(q, u, h);
      inputs = this.evaluate(q, u, this.t, this.states);
      this.applyPull(q, u, inputs);
      for (let i = 0; i < nv; ++i) {
        change[i] = u[i] - u0[i];
        rest[i] = h * (tau[i] - dynamics.c[i]);
      }
      for (let i = 0; i < nv; ++i) for (let j = 0; j < nv; ++j) rest[i] -= dynamics.M[i * nv + j] * change[j];
      for (let r = 0; r < this.nc; ++r) side[r] = -this.rows.velocity[r];
    };
    const solve = (rest) => this.equations.solve(A, rest, this.rows.P, side);
    residual(newton);
    const before = this.kineticOf(u0);
    const still = 0.5 * this.mass * (kStill * h) ** 2;
    const isEnough = (left) => {
      const scale = Math.max(before, this.kineticOf(u), this.kineticOf(change));
      return left <= kImplicitlyExact * scale + kRounding * Math.abs(this.energy()[1]) + still;
    };
    let converged = false;
    for (let k = 0, goesOn = true; k < kIterations && goesOn && !converged; ++k) {
      for (let i = 0; i < nv; ++i) rate[i] = change[i] / h;
      const { tau_q, tau_qd } = this.module.inverse_dynamics_derivatives(q, u, rate, inputs, derivatives);
      for (let i = 0; i < A.length; ++i) A[i] = dynamics.M[i] + h * (tau_qd[i] + h * tau_q[i]);
      pull?.addToMatrix(A, h);
      if (!solve(newton)) {
        this.problem = "the equations of a step are singular here";
        break;
      }
      base.set(u);
      const size = this.kineticOf(newton);
      if (isEnough(size)) {  // at rest
        for (let i = 0; i < nv; ++i) u[i] += newton[i];
        converged = true;
        break;
      }
      goesOn = false;
      for (let share = 1; !goesOn && share > kLeastShare; share /= 2) {
        for (let i = 0; i < nv; ++i) u[i] = base[i] + share * newton[i];
        residual(following);
        const rest = Float64Array.from(following);
        if (!solve(following)) continue;
        const left = this.kineticOf(following);
        goesOn = left <= (1 - share / 4) ** 2 * size;
        if (!goesOn) continue;
        converged = isEnough(left);
        if (converged) for (let i = 0; i < nv; ++i) u[i] += following[i];
        newton.set(rest);
      }
      if (goesOn) continue;
      u.set(base);
      residual(following);
    }
    q.set(q0);
    this.addRates(q, u, h);
    for (let i = 0; i < nv; ++i) change[i] = u[i] - u0[i];
    this.work += pull?.workInStep(u, change, h) ?? 0;
    this.stepStates(h);
    return converged;
  }
  /// Of speeds u with the mass matrix that was evaluated last, J.
  kineticOf(u) {
    const { M } = this.dynamics;
    const n = u.length;
    let sum = 0;
    for (let i = 0; i < n; ++i) for (let j = 0; j < n; ++j) sum += 0.5 * u[i] * M[i * n + j] * u[j];
    return sum;
  }
  /// q goes on at speeds u for a time.
  addRates(q, u, h) {
    const rates = this.module.coordinate_rates(q, u);
    for (let i = 0; i < q.length; ++i) q[i] += h * rates[i];
  }
  stepStates(h) {
    const n = this.states.length;
    if (n === 0) return;
    const inputs = this.here();
    const rates = this.module.state_rates(this.q, this.u, inputs);
    const { r_s } = this.module.state_rates_derivatives(this.q, this.u, inputs);
    const equations = new ConstrainedEquations(n, 0);
    const change = rates.map((rate) => h * rate);
    if (equations.solve(r_s.map((x, k) => (k % (n + 1) === 0 ? 1 : 0) - h * x), change))
      this.states.forEach((_, i) => (this.states[i] += change[i]));
  }

  /// Quaternions of unit length, and the nearest state that keeps the constraints.
  settle() {
    const { module: m, q, u, nc } = this;
    const normalise = () => {
      for (const first of m.quaternion_offsets) {
        const size = Math.hypot(q[first], q[first + 1], q[first + 2], q[first + 3]);
        for (let i = first; i < first + 4; ++i) q[i] /= size;
      }
    };
    normalise();
    this.kept = true;
    if (nc === 0) return;
    const { P, position, velocity } = this.rows;
    const change = new Float64Array(m.nv);
    for (let k = 0; k < kProjections; ++k) {
      this.evaluate(q, u, this.t, this.states);
      if (position.every((x) => Math.abs(x) <= kKept)) break;
      m.holonomic.forEach((is, r) => {
        this.side[r] = -position[r];
        if (!is) P.fill(0, r * m.nv, (r + 1) * m.nv);
      });
      if (!this.equations.solve(this.dynamics.M, change.fill(0), P, this.side)) break;
      this.addRates(q, change, 1);
      normalise();
    }
    this.evaluate(q, u, this.t, this.states);
    for (let r = 0; r < nc; ++r) this.side[r] = -velocity[r];
    if (this.equations.solve(this.dynamics.M, change.fill(0), P, this.side)) for (let i = 0; i < m.nv; ++i) u[i] += change[i];
    this.kept = position.every((x) => Math.abs(x) <= kKept);
  }

  /// One step. Where it leads nowhere, the state stays as it was and `problem` says why. Inexact steps are made again, in halves: of RK4
  /// those after which the energy has not changed by the work of the hand, of backward Euler those whose iterations do not converge. Where the
  /// shortest of RK4 fail, the motion stops.
  step(h, halvings = this.stiff ? kImplicitHalvings : kHalvings) {
    const state = [this.q, this.u, this.states];
    const before = state.map((x) => Float64Array.from(x));
    const { t, work, kept } = this;
    const last = halvings === 0;
    const energy = this.energy();
    let exact = true;
    if (this.stiff) exact = this.stepImplicitly(h) || last;  // at a jump of a force no step converges
    else this.stepByRk4(h);
    this.settle();
    const finite = state.every((x) => x.every(Number.isFinite));
    if (finite && kept && !this.stiff) exact = !this.isInexact(energy, work, last ? kBearable : kExact);
    if (finite && this.problem === "" && exact) return true;
    const problem = this.problem || (finite ? "the motion is too fast here for its steps" : "the motion has no finite state from here");
    state.forEach((x, k) => x.set(before[k]));
    Object.assign(this, { t, work, kept, problem: "" });
    if (!last) return this.step(h / 2, halvings - 1) && this.step(h / 2, halvings - 1);
    this.problem = problem;
    return false;
  }
  /// Not told where something else than the hand may do work, nor of a step from a state that breaks constraints.
  isInexact([kinetic, potential], work, share) {
    if (this.timed) return false;
    const [after, place] = this.energy();
    const gained = after + place - kinetic - potential;
    const untold = kRounding * Math.max(Math.abs(potential), Math.abs(place));
    return Math.abs(gained - (this.work - work)) > share * Math.max(kinetic, after) + untold;
  }

  /// Length of a step: as short as there is time to compute.
  stepLength() {
    const lengths = this.stiff ? kSteps : kSteps.slice(1);
    return lengths.find((h) => this.cost < 1000 * kShare * h) ?? lengths[lengths.length - 1];
  }

  /// Time passes. Returns false where the motion cannot go on.
  advance(seconds) {
    const h = this.stepLength();
    this.waiting += seconds;
    const begin = performance.now();
    let steps = 0;
    for (; this.waiting >= h; this.waiting -= h, ++steps) {
      if (this.problem || !this.step(h)) return false;
      if (performance.now() - begin > kMostTime) this.waiting = 0;
    }
    if (steps > 0) this.cost += 0.2 * ((performance.now() - begin) / steps - this.cost);
    this.waiting = Math.max(this.waiting, 0);
    return true;
  }
}

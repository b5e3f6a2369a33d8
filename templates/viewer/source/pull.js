// A spring with a damper from a point of a body to a target in the world. In: a mechanism's functions, its state. Out: generalized
// forces, through the point's Jacobian, and their power.

const kFrequency = 16;  // rad/s, of the spring and the mass it is made for
const kDamping = 0.7;   // of the critical one
const kHeaviest = 8;    // times the mass that is felt at the point is what the spring is made for, at most

export class Pull {
  /// `point`: in the body's frame; `bodies`: with `mass` and `center`.
  constructor(module, bodies, body, point) {
    const { nv } = module;
    Object.assign(this, { module, bodies, body, point, size: nv });
    this.W = new Float64Array(12 * bodies.length);
    this.jacobians = new Float64Array(6 * nv * bodies.length);
    this.J = new Float64Array(3 * nv);
    this.at = [0, 0, 0];
    this.target = [0, 0, 0];
    this.stiffness = this.damping = 0;
  }

  /// For what is felt at the point: mobility is the trace of J M^-1 J^T, 1/kg; `all` the mass of all bodies.
  setStrength(mobility, all) {
    const mass = Math.min(Math.sqrt(Math.max(all, 1 / mobility) / mobility), kHeaviest / mobility);
    this.stiffness = kFrequency * kFrequency * mass;
    this.damping = 2 * kDamping * Math.sqrt(this.stiffness / mobility);
  }

  /// Finds the point and its Jacobian.
  move(q, inputs) {
    const { body, point, at, J, size: n } = this;
    const W = this.module.body_poses(q, inputs, this.W).subarray(12 * body);
    const jacobian = this.module.body_jacobians(q, inputs, this.jacobians).subarray(6 * n * body);
    const { center } = this.bodies[body];
    const turned = (x, row) => W[4 * row] * x[0] + W[4 * row + 1] * x[1] + W[4 * row + 2] * x[2];
    const arm = [0, 1, 2].map((row) => turned(point, row) - turned(center, row));
    for (let a = 0; a < 3; ++a) {
      at[a] = turned(point, a) + W[4 * a + 3];
      const [b, c] = [(a + 1) % 3, (a + 2) % 3];
      for (let i = 0; i < n; ++i) J[a * n + i] = jacobian[(3 + a) * n + i] + jacobian[b * n + i] * arm[c] - jacobian[c * n + i] * arm[b];
    }
  }
  /// An entry of the point's velocity.
  velocity(u, a) {
    let sum = 0;
    for (let i = 0; i < this.size; ++i) sum += this.J[a * this.size + i] * u[i];
    return sum;
  }

  /// Adds to generalized forces. Returns the power.
  addTo(tau, u) {
    let power = 0;
    for (let a = 0; a < 3; ++a) {
      const velocity = this.velocity(u, a);
      const force = this.stiffness * (this.target[a] - this.at[a]) - this.damping * velocity;
      power += force * velocity;
      for (let i = 0; i < this.size; ++i) tau[i] += this.J[a * this.size + i] * force;
    }
    return power;
  }

  /// Adds to the matrix of a step of h that ends here what the force changes by with the speeds after it.
  addToMatrix(A, h) {
    const { J, size: n, stiffness, damping } = this;
    const stiffer = h * damping + h * h * stiffness;
    for (let a = 0; a < 3; ++a)
      for (let i = 0; i < n; ++i) {
        const entry = J[a * n + i];
        if (entry === 0) continue;
        for (let j = 0; j < n; ++j) A[i * n + j] += stiffer * entry * J[a * n + j];
      }
  }
  /// The work in a step of h that ended here, with the speeds after it and their change.
  workInStep(u, change, h) {
    let work = 0;
    for (let a = 0; a < 3; ++a) {
      const after = this.velocity(u, a);
      const force = this.stiffness * (this.target[a] - this.at[a]) - this.damping * after;
      work += h * force * (after - this.velocity(change, a) / 2);
    }
    return work;
  }
}

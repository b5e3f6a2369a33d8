// What a live motion was like of late, as plots and pictures take it. In: a motion after each picture. Out: a mechanism like those
// of the scene (scene_data.js), whose times and values grow at the end and are forgotten at the beginning; lines and contacts as
// they are now.

const kMost = 480;  // moments: at 60 a second, 8 s

export class LiveRecord {
  constructor(data, motion) {
    this.motion = motion;
    const empty = (all) => all.map(({ name, unit, limits }) => ({ name, unit, limits, values: [] }));
    const readable = motion.module.readings !== undefined;
    const read = (all) => (readable ? empty(all) : []);
    this.potentials = [];
    const point = () => new Float32Array(3);
    this.data = {
      name: data.name, times: [], coordinates: empty(data.coordinates), energies: empty(data.energies), forces: read(data.forces),
      inputs: read(data.inputs), states: read(data.states), outputs: read(data.outputs),
      lines: data.lines.map(({ force, points }) => ({ force, points: points.map(point) })),
      contacts: data.contacts.map(({ force }) => ({ force, points: point() })),
    };
    const { forces, inputs, states, outputs, lines, contacts } = this.data;
    this.read = [...forces, ...inputs, ...states, ...outputs];
    this.points = [...lines.flatMap(({ points }) => points), ...contacts.map(({ points }) => points)];
    // The last value of each force, for what draws it.
    this.now = { forces: forces.map(({ name }) => ({ name, values: [0] })), lines, contacts };
    this.append();
  }

  clear() {
    for (const list of this.lists()) list.length = 0;
    this.append();
  }
  lists() {
    const { times, coordinates, energies } = this.data;
    return [times, this.potentials, ...[...coordinates, ...energies, ...this.read].map(({ values }) => values)];
  }

  append() {
    const { motion, data } = this;
    data.times.push(motion.t);
    data.coordinates.forEach(({ values }, i) => values.push(motion.q[i]));
    if (this.read.length > 0) this.appendReadings(motion.module.readings(motion.q, motion.u, motion.here()));
    const [kinetic, potential] = motion.energy();
    data.energies[0].values.push(kinetic);
    this.potentials.push(potential);
    if (data.times.length > kMost) for (const list of this.lists()) if (list.length > kMost) list.shift();
    const lowest = this.potentials.reduce((a, b) => Math.min(a, b), Infinity);
    data.energies[1].values = this.potentials.map((x) => x - lowest);
    data.energies[2].values = this.potentials.map((x, k) => x - lowest + data.energies[0].values[k]);
  }

  appendReadings(readings) {
    this.read.forEach(({ values }, i) => values.push(readings[i]));
    this.now.forces.forEach(({ values }, i) => (values[0] = readings[i]));
    this.points.forEach((point, i) => point.set(readings.subarray(this.read.length + 3 * i, this.read.length + 3 * i + 3)));
  }
}

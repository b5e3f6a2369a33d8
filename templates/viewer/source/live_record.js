// What a live motion was like of late, as plots take it. In: a motion after each picture. Out: a mechanism like those of the
// scene (scene_data.js), whose times and values grow at the end and are forgotten at the beginning.

const kMost = 480;  // moments: at 60 a second, 8 s

export class LiveRecord {
  constructor(data, motion) {
    this.motion = motion;
    const empty = (all) => all.map(({ name, unit, limits }) => ({ name, unit, limits, values: [] }));
    const inputs = data.live.sliders.filter(({ input }) => input);
    this.inputs = inputs.map(({ place }) => place);
    this.potentials = [];
    this.data = {
      name: data.name, times: [], coordinates: empty(data.coordinates), energies: empty(data.energies), forces: [],
      inputs: inputs.map(({ name }) => ({ name, unit: data.inputs.find((one) => one.name === name)?.unit ?? "", values: [] })),
      states: empty(data.states), outputs: [],
    };
    this.append();
  }

  clear() {
    for (const list of this.lists()) list.length = 0;
    this.append();
  }
  lists() {
    const { times, coordinates, energies, inputs, states } = this.data;
    return [times, this.potentials, ...[...coordinates, ...energies, ...inputs, ...states].map(({ values }) => values)];
  }

  append() {
    const { motion, data } = this;
    data.times.push(motion.t);
    data.coordinates.forEach(({ values }, i) => values.push(motion.q[i]));
    data.inputs.forEach(({ values }, i) => values.push(motion.inputs.parameters[this.inputs[i]]));
    data.states.forEach(({ values }, i) => values.push(motion.states[i]));
    const [kinetic, potential] = motion.energy();
    data.energies[0].values.push(kinetic);
    this.potentials.push(potential);
    if (data.times.length > kMost) for (const list of this.lists()) if (list.length > kMost) list.shift();
    const lowest = this.potentials.reduce((a, b) => Math.min(a, b), Infinity);
    data.energies[1].values = this.potentials.map((x) => x - lowest);
    data.energies[2].values = this.potentials.map((x, k) => x - lowest + data.energies[0].values[k]);
  }
}

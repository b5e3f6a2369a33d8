// The scene as it stands in the page: JSON, its arrays of numbers as little-endian 32-bit words in base64. Out: the same
// object with typed arrays.

function bytes(text) {
  const binary = atob(text);
  const out = new Uint8Array(binary.length);
  for (let i = 0; i < binary.length; ++i) out[i] = binary.charCodeAt(i);
  return out.buffer;
}
const floats = (text) => new Float32Array(bytes(text));
const indices = (text) => new Uint32Array(bytes(text));

export function readScene(text) {
  const scene = JSON.parse(text);
  for (const mesh of scene.meshes) {
    mesh.positions = floats(mesh.positions);
    mesh.normals = floats(mesh.normals);
    mesh.indices = indices(mesh.indices);
  }
  for (const mechanism of scene.mechanisms) {
    mechanism.times = floats(mechanism.times);
    for (const body of mechanism.bodies) {
      body.origins = floats(body.origins);
      body.rotations = floats(body.rotations);
    }
    for (const key of ["forces", "inputs", "states", "outputs", "lines", "contacts"]) mechanism[key] ??= [];
    for (const line of mechanism.lines) line.points = line.points.map(floats);
    for (const contact of mechanism.contacts) contact.points = floats(contact.points);
    const { coordinates, energies, forces, inputs, states, outputs } = mechanism;
    for (const series of [...coordinates, ...energies, ...forces, ...inputs, ...states, ...outputs]) series.values = floats(series.values);
  }
  return scene;
}

/// Frame before time t and the share of the way to the next one, 0 to 1; the ends are held.
export function frameAt(times, t) {
  const last = times.length - 1;
  if (last < 1 || !(t > times[0])) return { frame: 0, share: 0 };
  if (t >= times[last]) return { frame: last, share: 0 };
  let low = 0;
  let high = last;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (times[middle] <= t) low = middle;
    else high = middle;
  }
  return { frame: low, share: (t - times[low]) / (times[high] - times[low]) };
}

/// Value of a series at a time, linear between frames.
export function valueAt(times, values, t) {
  const { frame, share } = frameAt(times, t);
  const next = Math.min(frame + 1, values.length - 1);
  return values[frame] + share * (values[next] - values[frame]);
}

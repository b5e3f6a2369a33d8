// Models of MJCF, evaluated at random states, against MuJoCo: tau, M, c, energy and rates of activations, under random inputs; connected and
// welded bodies by the directions that MuJoCo's rows bind, and the accelerations under them.
//   node check_mjcf.mjs ALEMBERT FOLDER MODEL...
// Meshes and textures that a model names and that are not there are made up in FOLDER, alike for both. Joints that
// follow others are independent for MuJoCo: its equations are projected onto the others.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { cpSync, existsSync, mkdirSync, readFileSync, readdirSync, rmSync, statSync, writeFileSync } from "node:fs";
import { basename, dirname, join, relative } from "node:path";
import load from "@mujoco/mujoco";

const kStates = 3;
const kTolerance = 1e-9;
const kFrictionVelocity = 0.01;
const kPixel = "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAIAAACQd1PeAAAADElEQVR4nGP4//8/AAX+Av4N70a4AAAAAElFTkSuQmCC";

const mujoco = await load();
let seed = 1;
const random = () => {
  seed = (seed * 48271) % 2147483647;
  return (2 * seed) / 2147483647 - 1;
};
const largest = (values) => values.reduce((most, v) => Math.max(most, Math.abs(v)), 0);
const sum = (count, term) => Array.from({ length: count }, (_, i) => term(i)).reduce((a, b) => a + b, 0);

/// A tetrahedron, large where models shrink their meshes.
function tetrahedron(path, size) {
  const v = [[0, 0, 0], [size, 0, 0], [0, size, 0], [0, 0, size]];
  const faces = [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]];
  if (path.toLowerCase().endsWith(".obj"))
    return v.map((p) => `v ${p.join(" ")}\n`).join("") + faces.map((f) => `f ${f.map((i) => i + 1).join(" ")}\n`).join("");
  const bytes = Buffer.alloc(84 + 50 * faces.length);
  bytes.writeUInt32LE(faces.length, 80);
  faces.forEach((face, f) =>
    face.forEach((i, k) => v[i].forEach((x, axis) => bytes.writeFloatLE(x, 84 + 50 * f + 12 + 12 * k + 4 * axis))));
  return bytes;
}

const files = (folder) =>
  readdirSync(folder, { withFileTypes: true }).flatMap((entry) =>
    entry.isDirectory() ? files(join(folder, entry.name)) : [join(folder, entry.name)]);

/// A copy of the model's folder with all that it names.
function whole(model, to) {
  rmSync(to, { recursive: true, force: true });
  cpSync(dirname(model), to, { recursive: true, dereference: true });
  const texts = files(to).filter((file) => file.endsWith(".xml")).map((file) => readFileSync(file, "utf8"));
  const dir = (name) => texts.map((t) => t.match(new RegExp(`<compiler[^>]*\\b(?:${name}|assetdir)="([^"]*)"`))?.[1]).find((d) => d !== undefined) ?? "";
  const small = texts.some((t) => /scale="\.?0?\.001/.test(t));
  for (const text of texts)
    for (const [, kind, name] of text.matchAll(/<(mesh|texture|skin|hfield)\b[^>]*?\bfile="([^"]*)"/g)) {
      const path = join(to, dir(kind === "mesh" ? "meshdir" : "texturedir"), name);
      if (existsSync(path) || relative(to, path).startsWith("..")) continue;
      mkdirSync(dirname(path), { recursive: true });
      writeFileSync(path, kind === "mesh" ? tetrahedron(path, small ? 10 : 0.01) : Buffer.from(kPixel, "base64"));
    }
  return join(to, basename(model));
}

/// MuJoCo reads from a file system of its own.
function compiled(model) {
  const folder = dirname(model), root = `/${Math.abs(seed)}_${basename(folder)}`;
  const made = new Set();
  const make = (path) => {
    if (path === "/" || made.has(path)) return;
    make(dirname(path));
    made.add(path);
    try { mujoco.FS.mkdir(path); } catch { /* is there */ }
  };
  for (const file of files(folder)) {
    if (statSync(file).size > 64e6) continue;
    const path = join(root, relative(folder, file));
    make(dirname(path));
    mujoco.FS.writeFile(path, readFileSync(file));
  }
  return mujoco.MjModel.from_xml_path(join(root, basename(model)));
}

const text_of = (names, at) => new TextDecoder().decode(names.subarray(at, names.indexOf(0, at)));
const fit = (name) => name.replace(/[^A-Za-z0-9]+/g, "_").replace(/^_+|_+$/g, "");

function run(alembert, args, input) {
  const { status, stdout, stderr } = spawnSync(alembert, args, { encoding: "utf8", input, maxBuffer: 1 << 30 });
  if (status !== 0) throw new Error(stderr.trim().split("\n").filter((line) => line.includes("error:"))[0] ?? stderr);
  return stdout;
}

/// Names in a section of a description.
function names_in(description, section) {
  const from = description.search(new RegExp(`^${section}:`, "m"));
  if (from < 0) return [];
  const rest = description.slice(from + section.length + 1);
  const text = rest.slice(0, Math.max(0, rest.search(/^\w/m)) || rest.length);
  if (text.trim().startsWith("[")) return text.replace(/[[\]\s]/g, "").split(",");
  return [...text.matchAll(/^ {2}- (?:\{?name: )?(\w+)/gm)].map((match) => match[1]);
}

const kFree = 0, kBall = 1, kHinge = 3;

/// The joints that are functions of others: position, slope and curvature along those.
function followers(m, names) {
  const coordinates = new Set(names), out = new Map();
  for (let e = 0; e < m.neq; ++e) {
    const joint = m.eq_obj1id[e];
    if (m.eq_type[e] !== mujoco.mjtEq.mjEQ_JOINT.value || out.has(joint)) continue;
    const name = fit(text_of(m.names, m.name_jntadr[joint]));
    if (!name || coordinates.has(name) || coordinates.has(`${name}_joint`)) continue;
    out.set(joint, { of: m.eq_obj2id[e], p: Array.from(m.eq_data.subarray(11 * e, 11 * e + 5)) });
  }
  return out;
}

/// Full positions and speeds from the independent ones. G: speeds along the independent speeds; drift: accelerations
/// without theirs.
function project(m, following, free) {
  const nv = m.nv, G = Array.from({ length: nv }, () => new Array(free.length).fill(0));
  const drift = new Array(nv).fill(0), qpos = Float64Array.from(free.qpos), qvel = Float64Array.from(free.qvel);
  free.dofs.forEach((dof, k) => (G[dof][k] = 1));
  const done = new Set();
  const follow = (joint) => {
    if (done.has(joint) || !following.has(joint)) return;
    done.add(joint);
    const { of, p } = following.get(joint), at = m.jnt_qposadr[joint], dof = m.jnt_dofadr[joint];
    let x = 0, u = 0, slope = 0, bend = 0;
    if (of >= 0) {
      follow(of);
      x = qpos[m.jnt_qposadr[of]] - m.qpos0[m.jnt_qposadr[of]];
      u = qvel[m.jnt_dofadr[of]];
      slope = p[1] + 2 * p[2] * x + 3 * p[3] * x ** 2 + 4 * p[4] * x ** 3;
      bend = 2 * p[2] + 6 * p[3] * x + 12 * p[4] * x ** 2;
      G[dof] = G[m.jnt_dofadr[of]].map((g) => slope * g);
      drift[dof] = slope * drift[m.jnt_dofadr[of]] + bend * u * u;
    }
    qpos[at] = m.qpos0[at] + p[0] + p[1] * x + p[2] * x ** 2 + p[3] * x ** 3 + p[4] * x ** 4;
    qvel[dof] = slope * u;
  };
  following.forEach((_, joint) => follow(joint));
  return { G, drift, qpos, qvel };
}

function random_state(m, following) {
  const qpos = Float64Array.from(m.qpos0), qvel = new Float64Array(m.nv), dofs = [], q = [];
  for (let j = 0; j < m.njnt; ++j) {
    const at = m.jnt_qposadr[j], dof = m.jnt_dofadr[j], type = m.jnt_type[j];
    const quaternion = (first) => {
      const v = [0, 0, 0, 0].map(random), norm = Math.hypot(...v) || 1;
      v.forEach((x, i) => (qpos[first + i] = x / norm));
      if (!following.has(j)) q.push(qpos[first + 1], qpos[first + 2], qpos[first + 3], qpos[first]);
    };
    const count = type === kFree ? 6 : type === kBall ? 3 : 1;
    if (type === kFree) for (let i = 0; i < 3; ++i) q.push((qpos[at + i] = random()));
    if (type === kFree || type === kBall) quaternion(type === kFree ? at + 3 : at);
    else {
      const limited = m.jnt_range[2 * j] < m.jnt_range[2 * j + 1];
      const [low, high] = limited ? [m.jnt_range[2 * j], m.jnt_range[2 * j + 1]] : [m.qpos0[at] - 1, m.qpos0[at] + 1];
      qpos[at] = (low + high) / 2 + ((high - low) / 2) * random();
      if (!following.has(j)) q.push(qpos[at]);
    }
    for (let i = 0; i < count; ++i) {
      qvel[dof + i] = random();
      if (!following.has(j)) dofs.push(dof + i);
    }
  }
  return { qpos, qvel, dofs, q, length: dofs.length };
}

/// M, row by row, and the forces at rest or in motion, of what mj_forward has worked out.
function mass_and_bias(m, d) {
  const full = mujoco.DoubleBuffer ? new mujoco.DoubleBuffer(m.nv * m.nv) : null;
  const M = new Float64Array(m.nv * m.nv);
  mujoco.mj_fullM(m, d, full ?? M);
  if (full) M.set(full.GetView());
  full?.delete();
  const friction = Array.from(m.dof_frictionloss, (f, i) => f * Math.tanh(d.qvel[i] / kFrictionVelocity));
  return { M, friction, c: Array.from(d.qfrc_bias, (b, i) => b - d.qfrc_passive[i] - d.qfrc_actuator[i] + friction[i]) };
}

/// The coordinates after some time at constant speeds.
function moved(m, qpos, qvel, time) {
  const out = Float64Array.from(qpos);
  for (let j = 0; j < m.njnt; ++j) {
    const type = m.jnt_type[j];
    let at = m.jnt_qposadr[j], dof = m.jnt_dofadr[j];
    for (let i = 0; i < (type === kFree ? 3 : type === kBall ? 0 : 1); ++i) out[at++] += time * qvel[dof++];
    if (type !== kFree && type !== kBall) continue;
    const turn = Array.from(qvel.slice(dof, dof + 3), (w) => (time * w) / 2), angle = Math.hypot(...turn);
    const s = angle > 0 ? Math.sin(angle) / angle : 1, [x, y, z] = turn.map((t) => s * t), w = Math.cos(angle);
    const [qw, qx, qy, qz] = out.slice(at, at + 4);
    const q = [qw * w - qx * x - qy * y - qz * z, qw * x + qx * w + qy * z - qz * y,
      qw * y - qx * z + qy * w + qz * x, qw * z + qx * y - qy * x + qz * w];
    const norm = Math.hypot(...q);
    q.forEach((each, i) => (out[at + i] = each / norm));
  }
  return out;
}

const dot = (a, b) => sum(a.length, (i) => a[i] * b[i]);

/// Orthonormal vectors that span rows, and the right-hand sides for which rows x = sides.
function orthonormal(rows, sides) {
  const basis = [], values = [], longest = largest(rows.flat());
  rows.forEach((row, r) => {
    let rest = Array.from(row), side = sides[r];
    for (let pass = 0; pass < 2; ++pass)
      basis.forEach((b, k) => {
        const part = dot(rest, b);
        rest = rest.map((x, i) => x - part * b[i]);
        side -= part * values[k];
      });
    const norm = Math.hypot(...rest);
    if (!(norm > 1e-7 * longest)) return;
    basis.push(rest.map((x) => x / norm));
    values.push(side / norm);
  });
  return { basis, values, shortest: rows[0].map((_, i) => sum(basis.length, (k) => values[k] * basis[k][i])) };
}

/// Solves A x = b by elimination.
function solved(A, b) {
  const n = b.length, rows = A.map((row, i) => [...row, b[i]]);
  for (let k = 0; k < n; ++k) {
    let pivot = k;
    for (let i = k + 1; i < n; ++i) if (Math.abs(rows[i][k]) > Math.abs(rows[pivot][k])) pivot = i;
    [rows[k], rows[pivot]] = [rows[pivot], rows[k]];
    for (let i = k + 1; i < n; ++i) {
      const factor = rows[i][k] / rows[k][k];
      for (let j = k; j <= n; ++j) rows[i][j] -= factor * rows[k][j];
    }
  }
  const x = new Array(n).fill(0);
  for (let k = n - 1; k >= 0; --k) x[k] = (rows[k][n] - sum(n - 1 - k, (j) => rows[k][k + 1 + j] * x[k + 1 + j])) / rows[k][k];
  return x;
}

/// Each equality that is no function of a joint by itself, and all of them: at states that keep it, the same directions
/// and accelerations as MuJoCo's rows give, whose rates are differences. \return how many were compared
function compare_equalities(alembert, model, m, d, following, inputs, states, close) {
  const kinds = mujoco.mjtEq, rows_of = new Map([[kinds.mjEQ_CONNECT.value, 3], [kinds.mjEQ_WELD.value, 6]]);
  m.opt.jacobian = mujoco.mjtJacobian.mjJAC_DENSE.value;
  const flags = m.opt.disableflags, off = mujoco.mjtDisableBit;
  m.opt.disableflags = (flags & ~off.mjDSBL_CONSTRAINT.value) | off.mjDSBL_CONTACT.value | off.mjDSBL_LIMIT.value | off.mjDSBL_FRICTIONLOSS.value;
  const rows_at = (qpos, chosen) => {
    d.qpos.set(qpos);
    mujoco.mj_forward(m, d);
    const found = { J: [], position: [] };
    for (let r = 0; r < d.nefc; ++r) {
      if (d.efc_type[r] !== mujoco.mjtConstraint.mjCNSTR_EQUALITY.value || !chosen.includes(d.efc_id[r])) continue;
      found.J.push(Array.from(d.efc_J.subarray(m.nv * r, m.nv * (r + 1))));
      found.position.push(d.efc_pos[r]);
    }
    return found;
  };
  rows_at(m.qpos0, []);
  const active = new Set(Array.from(d.efc_id).filter((_, r) => d.efc_type[r] === mujoco.mjtConstraint.mjCNSTR_EQUALITY.value));
  const kept = [...active].filter((e) => m.eq_type[e] !== kinds.mjEQ_JOINT.value || !following.has(m.eq_obj1id[e]));
  if (kept.length === 0) return 0;
  d.ctrl.fill(0);
  d.act.fill(0);
  const zeros = (names) => Object.fromEntries([...names].map((name) => [name, 0]));
  const lines = [], checks = [];
  const compare_at = (chosen, first_row, count) => {
    const free = random_state(m, following);
    // Near the start, where models are put together; then onto it by Newton's method.
    const start = Float64Array.from(m.qpos0), wander = Float64Array.from({ length: m.nv }, () => 0.1 * random());
    free.qpos = moved(m, start, wander, 1);
    const along = () => rows.J.map((row) => free.dofs.map((_, c) => sum(m.nv, (i) => row[i] * state.G[i][c])));
    let off_by = Infinity, state, rows;
    for (let k = 0; k < 60 && off_by > 1e-13; ++k) {
      state = project(m, following, free);
      rows = rows_at(state.qpos, chosen);
      off_by = largest(rows.position);
      const change = orthonormal(along(), rows.position.map((x) => -x)).shortest, full = new Float64Array(m.nv);
      free.dofs.forEach((dof, c) => (full[dof] = change[c]));
      free.qpos = moved(m, free.qpos, full, 1);
    }
    if (off_by > 1e-13) return false;
    const Jf = along();
    // Speeds that keep it.
    const wished = free.dofs.map((dof) => free.qvel[dof]);
    const excess = orthonormal(Jf, Jf.map((row) => dot(row, wished))).shortest;
    free.dofs.forEach((dof, c) => (free.qvel[dof] = wished[c] - excess[c]));
    free.qpos = Float64Array.from(state.qpos);
    state = project(m, following, free);
    const h = 1e-3, rate = (time) => rows_at(moved(m, state.qpos, state.qvel, time), chosen).J.map((row) => dot(row, Array.from(state.qvel)));
    const rates = [1, 2, 3].map((k) => [rate(k * h), rate(-k * h)]), weights = [45, -9, 1];
    const sides = rows.J.map((row, r) =>
      -sum(3, (k) => weights[k] * (rates[k][0][r] - rates[k][1][r])) / (60 * h) - dot(row, state.drift));
    const { basis, values, shortest } = orthonormal(Jf, sides);
    d.qvel.set(state.qvel);
    rows_at(state.qpos, chosen);
    const { M, c } = mass_and_bias(m, d), n = free.dofs.length;
    const onto = (force) => free.dofs.map((_, k) => sum(m.nv, (i) => state.G[i][k] * force[i]));
    const times = (x) => Array.from({ length: m.nv }, (_, i) => sum(m.nv, (j) => M[m.nv * i + j] * x[j]));
    const columns = free.dofs.map((_, k) => onto(times(state.G.map((row) => row[k])))), bias = onto(times(state.drift).map((x, i) => x + c[i]));
    const q = [];
    for (let j = 0; j < m.njnt; ++j) {
      if (following.has(j)) continue;
      const at = m.jnt_qposadr[j], x = state.qpos;
      if (m.jnt_type[j] === kFree) q.push(x[at], x[at + 1], x[at + 2], x[at + 4], x[at + 5], x[at + 6], x[at + 3]);
      else if (m.jnt_type[j] === kBall) q.push(x[at + 1], x[at + 2], x[at + 3], x[at]);
      else q.push(x[at]);
    }
    lines.push(JSON.stringify({ q, qd: free.dofs.map((dof) => state.qvel[dof]), tau: free.dofs.map(() => 0), inputs: zeros(inputs), states: zeros(states) }));
    const whole = first_row === undefined;
    checks.push((found) => {
      const P = found.constraints.P.slice(first_row ?? 0, whole ? undefined : first_row + count);
      const gamma = found.constraints.gamma.slice(first_row ?? 0, whole ? undefined : first_row + count);
      assert.equal(orthonormal(P, gamma).basis.length, basis.length, "as many directions as MuJoCo binds");
      P.forEach((row, r) => {
        const outside = basis.reduce((rest, v) => { const part = dot(rest, v); return rest.map((x, i) => x - part * v[i]); }, row);
        close(`P[${r}] outside of MuJoCo's rows`, outside, outside.map(() => 0), Math.hypot(...row) || 1);
      });
      const size = Math.max(largest(gamma), largest(shortest), 1);
      close("P a + gamma", P.map((row, r) => dot(row, shortest) + gamma[r]), gamma.map(() => 0), size);
      if (whole) {
        const A = columns.map((column, i) => [...free.dofs.map((_, k) => columns[k][i]), ...basis.map((v) => v[i])]);
        basis.forEach((v) => A.push([...v, ...basis.map(() => 0)]));
        const qdd = solved(A, [...bias.map((x) => -x), ...values]).slice(0, n);
        close("qdd under constraints", found.constrained_forward_dynamics.qdd, qdd, largest(qdd));
      }
    });
    return true;
  };
  let row = 0;
  for (const e of kept) {
    const count = rows_of.get(m.eq_type[e]) ?? 1;
    assert.ok(compare_at([e], row, count), `equality ${e} cannot be kept near the start`);
    row += count;
  }
  compare_at(kept);
  m.opt.disableflags = flags;
  const output = run(alembert, ["evaluate", model, "--json", "--effort", "0", "--functions", "constraints,constrained_forward_dynamics"], lines.join("\n") + "\n");
  output.trim().split("\n").forEach((line, k) => checks[k](JSON.parse(line)));
  return checks.length;
}

function compare(alembert, model) {
  const description = run(alembert, ["import", model]);
  const m = compiled(model), d = new mujoco.MjData(m);
  m.opt.disableflags |= mujoco.mjtDisableBit.mjDSBL_CONSTRAINT.value | mujoco.mjtDisableBit.mjDSBL_CONTACT.value;
  m.opt.enableflags |= mujoco.mjtEnableBit.mjENBL_ENERGY.value;
  const following = followers(m, names_in(description, "coordinates"));
  const inputs = new Set(names_in(description, "inputs")), states = new Set(names_in(description, "states"));
  // Where every sensor is taken.
  const outputs = names_in(description, "outputs").length, sensors = outputs > 0 && outputs === m.nsensordata;
  const lines = [], expected = [];
  for (let s = 0; s < kStates; ++s) {
    const free = random_state(m, following), { G, drift, qpos, qvel } = project(m, following, free);
    const udot = free.dofs.map(random), state = { q: free.q, qd: free.dofs.map((dof) => qvel[dof]), qdd: udot, inputs: {}, states: {} };
    d.qpos.set(qpos);
    d.qvel.set(qvel);
    for (let a = 0; a < m.nu; ++a) {
      const name = fit(text_of(m.names, m.name_actuatoradr[a])) || `actuator_${a + 1}`;
      const input = [`${name}_input`, name].find((each) => inputs.has(each));
      const range = m.actuator_ctrlrange.subarray(2 * a, 2 * a + 2), [low, high] = range[0] < range[1] ? range : [-1, 1];
      d.ctrl[a] = input ? (low + high) / 2 + ((high - low) / 2) * random() : 0;
      if (input) state.inputs[input] = d.ctrl[a];
      const at = m.actuator_actadr[a];
      if (at < 0) continue;
      d.act[at] = random();
      if (states.has(`${name}_activation`)) state.states[`${name}_activation`] = d.act[at];
    }
    mujoco.mj_forward(m, d);
    // What stops at the ends of a range stops earlier here than in MuJoCo, which does it in its next step.
    const rates = [];
    for (let a = 0; a < m.nu; ++a) {
      const at = m.actuator_actadr[a], name = `${fit(text_of(m.names, m.name_actuatoradr[a]))}_activation`;
      if (at >= 0 && states.has(name) && !(m.actuator_actrange[2 * a] < m.actuator_actrange[2 * a + 1])) rates.push([[...states].indexOf(name), d.act_dot[at]]);
    }
    const sensed = Array.from(d.sensordata);
    const nv = m.nv, { M: values, friction, c } = mass_and_bias(m, d);
    const qacc = drift.map((x, i) => x + sum(free.length, (k) => G[i][k] * udot[k]));
    const scale = Math.max(largest(d.qfrc_bias), largest(d.qfrc_passive), largest(d.qfrc_actuator), 1e-3);
    // What mj_inverse itself gives must be M qacc + c too.
    d.qacc.set(qacc);
    mujoco.mj_inverse(m, d);
    const tau = Array.from(d.qfrc_inverse, (t, i) => t - d.qfrc_actuator[i] + friction[i]);
    const onto = (force) => free.dofs.map((_, k) => sum(nv, (i) => G[i][k] * force[i]));
    const times = (x) => Array.from({ length: nv }, (_, i) => sum(nv, (j) => values[nv * i + j] * x[j]));
    lines.push(JSON.stringify(state));
    const MG = Array.from({ length: nv }, (_, i) => free.dofs.map((_, k) => sum(nv, (j) => values[nv * i + j] * G[j][k])));
    expected.push({
      tau: onto(tau), c: onto(times(drift).map((x, i) => x + c[i])), scale: Math.max(scale, largest(tau)),
      M: free.dofs.map((_, r) => free.dofs.map((_, k) => sum(nv, (i) => G[i][r] * MG[i][k]))),
      energy: [d.energy[1], d.energy[0]], sensed, rates,
    });
  }
  const output = run(alembert, ["evaluate", model, "--json", "--effort", "0", "--functions", `inverse_dynamics,mass_matrix_and_bias,energy${sensors ? ",outputs" : ""}${states.size > 0 ? ",state_rates" : ""}`], lines.join("\n") + "\n");
  let worst = 0;
  const close = (what, found, wanted, scale) => {
    assert.equal(found.length, wanted.length, `${what} has ${found.length} entries, not ${wanted.length}`);
    found.forEach((x, i) => {
      const error = Math.abs(x - wanted[i]) / scale;
      worst = Math.max(worst, error);
      assert.ok(error <= kTolerance, `${what}[${i}] is ${x}, not ${wanted[i]}: off by ${error} of ${scale}`);
    });
  };
  output.trim().split("\n").forEach((line, s) => {
    const found = JSON.parse(line), wanted = expected[s];
    close("M", found.mass_matrix_and_bias.M.flat(), wanted.M.flat(), largest(wanted.M.flat()));
    close("c", found.mass_matrix_and_bias.c, wanted.c, wanted.scale);
    close("tau", found.inverse_dynamics.tau, wanted.tau, wanted.scale);
    if (sensors) close("sensors", Object.values(found.outputs).flat(), wanted.sensed, Math.max(1, largest(wanted.sensed)));
    for (const [i, rate] of wanted.rates) close(`rate of state ${i}`, [Object.values(found.state_rates)[0][i]], [rate], Math.max(1, Math.abs(rate)));
    close("energy", Object.values(found.energy).flat(), wanted.energy, Math.max(1, largest(wanted.energy)));
  });
  const equalities = compare_equalities(alembert, model, m, d, following, inputs, states, close);
  const summary = `${m.nbody - 1} bodies, ${m.nv} speeds, ${following.size} joints follow, ${sensors ? outputs : 0} outputs, ${equalities} comparisons of equalities, error ${worst.toExponential(1)}`;
  d.delete();
  m.delete();
  return summary;
}

const [alembert, folder, ...models] = process.argv.slice(2);
assert(models.length > 0, "no models");
mkdirSync(folder, { recursive: true });
let bad = 0;
models.forEach((model, i) => {
  const began = Date.now();
  let result;
  try {
    result = compare(alembert, whole(model, join(folder, `${i}`)));
  } catch (error) {
    ++bad;
    result = `FAILED: ${error.message ?? error}`;
  }
  console.log(`${join(basename(dirname(model)), basename(model))}: ${result} (${((Date.now() - began) / 1000).toFixed(1)} s)`);
});
process.exitCode = bad === 0 ? 0 : 1;

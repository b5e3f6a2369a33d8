// Live pages in Chromium: the page's functions against `evaluate`, what the hand does against the energy, and controls.
//   node check_live.mjs ALEMBERT FOLDER MECHANISMS
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdirSync, writeFileSync } from "node:fs";
import { basename } from "node:path";
import { drawn, openPage, startBrowser } from "./browser.mjs";

const [alembert, folder, mechanisms] = process.argv.slice(2);
mkdirSync(folder, { recursive: true });
const run = (args, input = "") => execFileSync(alembert, args, { input, encoding: "utf8", maxBuffer: 1 << 28 });

async function livePage(browser, description, more = []) {
  const path = `${folder}/${basename(description, ".yaml")}.html`;
  run(["simulate", description, "--duration", "0.1", "--step", "0.01", "--html", path, ...more]);
  const opened = await openPage(browser, path, { width: 640, height: 360 });
  await opened.page.evaluate(() => window.viewer.setMode("live"));
  return opened;
}

/// Every function of the page's module at random states against `evaluate`, but for what it reads off forces (check_page.mjs).
async function checkValues(browser, description, more = []) {
  const { page, wrong } = await livePage(browser, description, more);
  const { states, values } = await page.evaluate(() => {
    const { module: m, start, inputs } = window.viewer.live.motions[0];
    let seed = 1;
    const random = () => ((seed = (seed * 48271) % 2147483647) / 2147483647) * 2 - 1;
    const states = [];
    const values = [];
    for (let k = 0; k < 4; ++k) {
      const q = start.q.map((x) => x + 0.3 * random());
      for (const first of m.quaternion_offsets) {
        const size = Math.hypot(...q.slice(first, first + 4));
        for (let i = first; i < first + 4; ++i) q[i] /= size;
      }
      const [qd, qdd] = [0, 1].map(() => Array.from({ length: m.nv }, random));
      states.push({ t: 0.25 * k, q, qd, qdd, tau: qdd });
      values.push(Object.fromEntries(m.function_names.filter((name) => name !== "readings").map((name) => {
        const given = { t: 0.25 * k, parameters: inputs.parameters };
        const args = name === "coordinate_rates" ? [q, qd] : [...[q, qd, qdd].slice(0, m[name].length - 2), given];
        const found = m[name](...args);
        return [name, (found instanceof Float64Array ? [found] : Object.values(found)).map((array) => [...array])];
      })));
    }
    return { states, values };
  });
  const names = Object.keys(values[0]);
  const expected = run(["evaluate", description, "--json", "--functions", names.join(",")], states.map((s) => JSON.stringify(s)).join("\n"))
    .trim().split("\n").map((line) => JSON.parse(line));
  let worst = 0;
  let compared = 0;
  values.forEach((found, k) => {
    for (const name of names)
      Object.values(expected[k][name]).forEach((array, r) => {
        const wanted = array.flat(Infinity);
        assert.equal(found[name][r].length, wanted.length, `${name} of ${description}`);
        const largest = Math.max(...wanted.map(Math.abs), 1e-300);
        wanted.forEach((x, i) => (worst = Math.max(worst, Math.abs(x - found[name][r][i]) / largest)));
        compared += wanted.length;
      });
  });
  console.log(`${basename(description)}: ${names.length} functions, ${compared} numbers, off by ${worst.toExponential(1)} at most`);
  assert.ok(worst < 1e-12);
  assert.deepEqual(wrong, []);
  return page;
}

/// Steps of the page against those of `simulate`, from the same state by the same method.
async function checkSteps(page, description, integrator, more = []) {
  const csv = run(["simulate", description, "--duration", "0.1", "--step", "0.01", "--every", "10", "--integrator", integrator, ...more]);
  const { q, u, problem } = await page.evaluate(() => {
    const motion = window.viewer.live.motions[0];
    motion.reset();
    for (let k = 0; k < 10; ++k) motion.step(0.01, 0);
    return { q: [...motion.q], u: [...motion.u], problem: motion.problem };
  });
  const row = csv.trim().split("\n").at(-1).split(",").map(Number);
  const error = [...q, ...u].reduce((most, x, i) => Math.max(most, Math.abs(x - row[i + 1]) / Math.max(1, Math.abs(x))), 0);
  console.log(`after ten steps off by ${error.toExponential(1)}`);
  assert.ok(problem === "" && error < 1e-8);
}

/// Steps without pictures: energy stays, or changes by the work of the hand; constraints are kept.
async function checkMotion(page, { conserves, body, by }) {
  const result = await page.evaluate((body, by) => {
    const motion = window.viewer.live.motions[0];
    const total = () => motion.energy().reduce((a, b) => a + b);
    const residual = () => Math.max(0, ...(motion.nc ? motion.module.constraints(motion.q, motion.u, motion.inputs).position.map(Math.abs) : []));
    motion.reset();
    const before = total();
    let most = 0;
    for (let k = 0; k < 480; ++k) motion.step(1 / 480);
    const free = total() - before;
    const index = window.viewer.mechanisms[0].bodies.indexOf(body);
    const grabbed = motion.grab(index, [0.01, 0.02, 0.03]);
    const { at } = motion.pull;
    const place = [...at];
    motion.moveTarget(place.map((x, a) => x + by[a]));
    for (let k = 0; k < 480; ++k) {
      motion.step(1 / 480);
      most = Math.max(most, residual());
    }
    const gained = total() - before - free;
    const target = motion.pull.target;
    const left = Math.hypot(...motion.pull.at.map((x, a) => x - target[a]));
    motion.release();
    return { free, before, gained, work: motion.work, left, residual: most, problem: motion.problem, grabbed, size: Math.hypot(...by) };
  }, body, by);
  console.log(JSON.stringify(result));
  assert.ok(result.grabbed && result.problem === "" && result.residual < 1e-8);
  assert.ok(result.left < 0.8 * result.size, "the body comes near to where it is pulled");
  if (!conserves) return;
  const size = Math.max(1, Math.abs(result.work));
  assert.ok(Math.abs(result.free) < 1e-6 * Math.max(1, Math.abs(result.before)), "without forces the energy stays");
  assert.ok(Math.abs(result.work) > 1e-3 && Math.abs(result.gained - result.work) < 1e-5 * size, "the energy changes by the work of the hand");
}

const motionOf = (page) =>
  page.evaluate(() => {
    const motion = window.viewer.live.motions[0];
    return { t: motion.t, q: [...motion.q], work: motion.work, energy: motion.energy()[0] + motion.energy()[1], pulled: motion.pull !== null };
  });

/// The pointer on a pendulum, by mouse and by finger, the camera beside it, and the buttons.
async function checkHand(browser) {
  const { page, wrong } = await livePage(browser, `${mechanisms}/double_pendulum.yaml`);
  // A page takes longer steps where computing is slow, and they lose more energy.
  await page.evaluate(() => { window.viewer.live.motions[0].stepLength = () => 1 / 480; });
  const box = await (await page.$("#stage canvas")).boundingBox();
  const seen = () => page.evaluate(() => {
    const { stage } = window.viewer.live;
    const lower = stage.mechanisms[0].bodies[1];
    lower.updateMatrixWorld(true);
    const point = lower.position.clone().set(...stage.mechanisms[0].data.bodies[1].center).applyMatrix4(lower.matrixWorld).project(stage.camera);
    return [point.x, point.y];
  });
  const place = async () => {
    const [x, y] = await seen();
    return [box.x + ((1 + x) / 2) * box.width, box.y + ((1 - y) / 2) * box.height];
  };
  await page.evaluate(() => window.viewer.pause());
  const start = await motionOf(page);
  let [x, y] = await place();
  await page.mouse.move(x, y);
  await page.mouse.down();
  assert.equal((await motionOf(page)).pulled, true, "a press on a body takes it");
  for (let k = 1; k <= 5; ++k) await page.mouse.move(x + 30 * k, y - 12 * k);
  await page.waitForFunction(() => window.viewer.live.motions[0].t > 0.4);
  await page.screenshot({ path: `${folder}/hand.png` });
  await page.mouse.up();
  await page.evaluate(() => window.viewer.pause());
  const pulled = await motionOf(page);
  assert.equal(pulled.pulled, false);
  assert.ok(pulled.work > 0.1, `the hand lifts it: ${pulled.work} J`);
  assert.ok(Math.abs(pulled.energy - start.energy - pulled.work) < 2e-5 * pulled.work, `${pulled.energy - start.energy} J, and ${pulled.work} J of work`);
  assert.ok(Math.hypot(...pulled.q) > 0.05);

  // Paused, it stays.
  await drawn(page);
  assert.equal((await motionOf(page)).t, pulled.t);
  // Slow motion.
  await page.select("#speed", "0.1");
  await page.click("#play");
  await page.waitForFunction((t) => window.viewer.live.motions[0].t > t, {}, pulled.t);
  await page.click("#play");
  // Beside the bodies the camera turns.
  const camera = () => page.evaluate(() => window.viewer.live.stage.camera.position.toArray());
  const before = await camera();
  await page.mouse.move(box.x + 40, box.y + box.height - 40);
  await page.mouse.down();
  await page.mouse.move(box.x + 140, box.y + box.height - 60, { steps: 4 });
  await page.mouse.up();
  assert.notDeepEqual(await camera(), before);
  await page.click("#reset");
  const anew = await motionOf(page);
  assert.deepEqual([anew.t, anew.q, anew.work], [0, start.q, 0]);

  // The recorded motion, and back.
  await page.click("#recorded");
  assert.equal(await page.evaluate(() => document.body.dataset.mode), "recorded");
  await page.evaluate(() => window.viewer.seek(0.05));
  assert.ok(Math.abs((await page.evaluate(() => window.viewer.time)) - 0.05) < 1e-6);
  await page.click("#live");
  await page.waitForFunction(() => window.viewer.time > 0.02);
  // Keys are the picture's after a click on a button, and an arrow does not leave the live mode.
  await page.keyboard.press("ArrowRight");
  assert.equal(await page.evaluate(() => document.body.dataset.mode), "live");
  await page.keyboard.press(" ");
  const playing = () => page.evaluate(() => document.querySelector("#play").dataset.state);
  assert.equal(await playing(), "paused");

  // Paths are of the live motion there, from when they are asked for or the motion begins anew, and of the recorded one in its mode.
  await page.click("#trails");
  const paths = () => page.evaluate(() => {
    const { live } = window.viewer;
    const { trails, bodies, data } = live.stage.mechanisms[0];
    const center = bodies[1].position.clone().set(...data.bodies[1].center).applyMatrix4(bodies[1].updateMatrix() ?? bodies[1].matrix);
    const { array } = trails.live.children[1].geometry.attributes.position;
    const last = array.subarray(3 * (trails.count - 1), 3 * trails.count);
    return { live: trails.live.visible, recorded: trails.recorded.visible, count: trails.count, off: Math.hypot(...center.toArray().map((x, a) => x - last[a])) };
  });
  const moveBy = (steps) => page.evaluate((steps) => {
    const { live } = window.viewer;
    for (let k = 0; k < steps; ++k) {
      live.motions[0].step(0.002);
      live.show();
    }
    live.show();  // the same moment again
  }, steps);
  await moveBy(1500);
  let path = await paths();
  assert.ok(path.live && !path.recorded && path.count === 1200 && path.off < 1e-6, JSON.stringify(path));
  await page.click("#reset");
  await moveBy(9);
  path = await paths();
  assert.ok(path.count === 10 && path.off < 1e-6, JSON.stringify(path));
  await page.click("#recorded");
  path = await paths();
  assert.ok(path.recorded && !path.live);
  await page.click("#live");
  await page.keyboard.press(" ");

  // What stopped by itself moves again after a reset; what was paused stays so.
  await page.click("#reset");
  assert.equal(await playing(), "paused");
  await page.evaluate(() => {
    window.viewer.live.motions[0].problem = "a wall";
    window.viewer.play();
  });
  await page.waitForFunction(() => document.querySelector("#play").dataset.state === "paused");
  assert.match(await page.$eval("#hint", (hint) => hint.textContent), /^It stops: a wall/);
  await page.click("#reset");
  assert.equal(await playing(), "playing");
  await page.waitForFunction(() => window.viewer.time > 0);
  await page.keyboard.press(" ");

  // A finger.
  [x, y] = await place();
  await page.touchscreen.touchStart(x, y);
  await page.touchscreen.touchMove(x + 40, y);
  assert.equal((await motionOf(page)).pulled, true, "a finger takes it");
  await page.touchscreen.touchEnd();
  assert.equal((await motionOf(page)).pulled, false);
  assert.deepEqual(wrong, []);
  await page.close();
}

/// A slider changes what the functions take.
async function checkSliders(browser) {
  const description = `${folder}/sliders.yaml`;
  writeFileSync(description, `alembert: 1
name: sliders
parameters: {l: {value: 0.5, runtime: true}}
inputs: [{name: push, limits: [-4, 4]}]
coordinates: [{name: q, initial: 0.4}]
bodies:
  - {name: bob, transform: [{rotate: {axis: y, angle: q}}, {translate: [0, 0, -l]}], mass: 2}
forces:
  - {name: motor, on: q, value: push}
`);
  const { page, wrong } = await livePage(browser, description);
  const slide = (name, value) => page.evaluate((name, value) => {
    const slider = document.querySelector(`#sliders input[data-name=${name}]`);
    slider.value = String(value);
    slider.dispatchEvent(new Event("input"));
    return [Number(slider.min), Number(slider.max)];
  }, name, value);
  assert.deepEqual(await slide("push", 1.5), [-4, 4]);
  const bob = () => page.evaluate(() => window.viewer.live.stage.mechanisms[0].bodies[0].position.toArray());
  await page.evaluate(() => window.viewer.pause());
  const [before, t] = [await bob(), (await motionOf(page)).t];
  assert.deepEqual(await slide("l", 0.75), [0.1, 1.5]);
  const after = await bob();
  assert.equal((await motionOf(page)).t, t);
  assert.ok(Math.abs(Math.hypot(...after) - 0.75) < 1e-9 && Math.hypot(...before) < 0.6, `drawn at ${before}, then at ${after}, while paused`);
  const { c, push } = await page.evaluate(() => {
    const motion = window.viewer.live.motions[0];
    return { c: motion.module.mass_matrix_and_bias([0.3], [0], motion.here()).c[0], push: motion.inputs.parameters };
  });
  assert.ok(Math.abs(c - (2 * 9.81 * 0.75 * Math.sin(0.3) - 1.5)) < 1e-12, `bias ${c}, parameters ${JSON.stringify(push)}`);
  await page.evaluate(() => document.querySelector("#sliders input[data-name=push]").dispatchEvent(new Event("dblclick")));
  assert.equal(await page.evaluate(() => window.viewer.live.motions[0].inputs.parameters[1]), 0);
  await page.screenshot({ path: `${folder}/sliders.png` });
  assert.deepEqual(wrong, []);
  await page.close();
}

/// The picture goes along with what leaves the recorded motion's part of the world.
async function checkFarAway(browser) {
  const { page, wrong } = await livePage(browser, `${mechanisms}/free_body.yaml`);
  const seen = await page.evaluate(() => {
    const { live } = window.viewer;
    window.viewer.pause();
    const places = [];
    for (let k = 0; k < 30; ++k) {
      live.advance(0.05);
      live.stage.camera.updateMatrixWorld();
      const point = live.stage.mechanisms[0].middle().clone().project(live.stage.camera);
      places.push(Math.max(Math.abs(point.x), Math.abs(point.y)));
    }
    return places;
  });
  assert.ok(Math.max(...seen) < 1, `in the picture at ${seen}`);
  assert.deepEqual(wrong, []);
  await page.close();
}

/// A length that changes moves a linkage to where its constraint is kept, and the motion goes on from there.
async function checkLengths(browser) {
  const description = `${folder}/lengths.yaml`;
  writeFileSync(description, `alembert: 1
name: lengths
parameters: {l: {value: 0.5, runtime: true}}
coordinates: [{name: a, initial: 0.609069}, {name: b, initial: -1.10603}]
bodies:
  - {name: crank, transform: [{rotate: {axis: y, angle: a}}], mass: 1, com: [0.2, 0, 0]}
  - {name: rod, parent: crank, transform: [{translate: [l, 0, 0]}, {rotate: {axis: y, angle: b}}], mass: 1, com: [0.25, 0, 0]}
frames: [{name: tip, body: rod, transform: [{translate: [0.6, 0, 0]}]}]
constraints: [{name: rail, type: holonomic, equations: [position(tip).z]}]
`);
  const { page, wrong } = await livePage(browser, description);
  const problems = await page.evaluate(() => {
    const [motion] = window.viewer.live.motions;
    return [0.55, 0.9, 0.4].map((l) => {
      motion.setParameter(motion.module.parameter_names.indexOf("l"), l);
      for (let k = 0; k < 100; ++k) if (!motion.step(1 / 480)) return motion.problem;
      return Math.abs(motion.rows.position[0]) < 1e-8 ? "" : `${motion.rows.position[0]} m off`;
    });
  });
  assert.deepEqual(problems, ["", "", ""]);
  assert.deepEqual(wrong, []);
  await page.close();
}

/// A head that is a point mass: its mass matrix is singular in many places, and its speeds are tamed by their damping alone. However hard
/// it is pulled, no more energy comes than by the work of the hand.
async function checkPoles(browser) {
  const { page, wrong } = await livePage(browser, `${mechanisms}/../tests/cli/neck.yaml`, ["--integrator", "implicit"]);
  const { problem, most, gained } = await page.evaluate(() => {
    const [motion] = window.viewer.live.motions;
    const total = () => motion.energy()[0] + motion.energy()[1];
    motion.reset();
    let [most, gained] = [0, 0];
    const before = total();
    motion.grab(2, [0.0185, 0, 0.11]);
    for (const by of [[0.5, -0.4, 0.6], [-0.5, 0.6, -0.5], [0, -0.8, 0]]) {
      motion.moveTarget(by);
      for (let k = 0; k < 240 && motion.step(1 / 240); ++k) {
        most = Math.max(most, motion.energy()[0]);
        gained = Math.max(gained, total() - before - motion.work);
      }
    }
    return { problem: motion.problem, most, gained };
  });
  console.log(`a pulled neck: kinetic energy up to ${most} J, ${gained} J not by the hand`);
  assert.equal(problem, "");
  assert.ok(most > 0.01 && gained < 1e-3);
  assert.deepEqual(wrong, []);
  await page.close();
}

/// Contacts with friction, pulled about at the steps of a slow computer.
async function checkContacts(browser) {
  const { page, wrong } = await livePage(browser, `${mechanisms}/forces/rolling_balls.yaml`);
  const found = await page.evaluate(() => {
    const [motion] = window.viewer.live.motions;
    return motion.bodies.map(({ center }, body) => {
      motion.reset();
      if (!motion.grab(body, center)) return { most: 0, problem: "not taken" };
      const at = [...motion.pull.at];
      let most = 0;
      for (let k = 0; k < 180 && !motion.problem; ++k) {
        if (k % 30 === 0) motion.moveTarget(at.map((x, a) => x + 0.5 * Math.sin((17 * k) / 60 + a)));
        motion.step(1 / 60);
        most = Math.max(most, motion.energy()[0]);
      }
      return { most, problem: motion.problem };
    });
  });
  console.log(JSON.stringify(found));
  assert.ok(found.every(({ most, problem }) => problem === "" && most > 1 && most < 1000));
  assert.deepEqual(wrong, []);
  await page.close();
}

const browser = await startBrowser();
try {
  const aside = ["--q", "0.4,-0.7"];
  const swings = await checkValues(browser, `${mechanisms}/double_pendulum.yaml`, aside);
  await checkMotion(swings, { conserves: true, body: "lower", by: [0.3, 0, 0.2] });
  await checkSteps(swings, `${mechanisms}/double_pendulum.yaml`, "rk4", aside);
  await swings.close();
  const floats = await checkValues(browser, `${mechanisms}/free_body.yaml`);
  await checkMotion(floats, { conserves: true, body: "body", by: [0.8, 0.4, 0.4] });
  await checkSteps(floats, `${mechanisms}/free_body.yaml`, "rk4");
  await floats.close();
  const closed = await checkValues(browser, `${mechanisms}/paper/five_bar.yaml`);
  await checkMotion(closed, { conserves: true, body: "left_lower", by: [0.4, 0, 0.3] });
  await checkSteps(closed, `${mechanisms}/paper/five_bar.yaml`, "rk4");
  await closed.close();
  const rocks = await checkValues(browser, `${mechanisms}/paper/rattleback.yaml`);
  await checkMotion(rocks, { conserves: true, body: "rattleback", by: [0.1, 0, 0] });
  await rocks.close();
  const hops = await checkValues(browser, `${mechanisms}/forces/hopping_leg.yaml`);
  await checkMotion(hops, { conserves: false, body: "trunk", by: [0, 0, 0.2] });
  await checkSteps(hops, `${mechanisms}/forces/hopping_leg.yaml`, "implicit");
  await hops.close();
  const elastic = await checkValues(browser, `${mechanisms}/forces/elbow_elastic_tendons.yaml`);
  await checkSteps(elastic, `${mechanisms}/forces/elbow_elastic_tendons.yaml`, "implicit");
  await elastic.close();
  await checkPoles(browser);
  await checkContacts(browser);
  await checkHand(browser);
  await checkSliders(browser);
  await checkFarAway(browser);
  await checkLengths(browser);
} finally {
  await browser.close();
}

// Pages of simulated mechanisms in Chromium: poses against forward kinematics, times, plots, colours, and no error.
//   node check_page.mjs ALEMBERT FOLDER DESCRIPTION...
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { basename } from "node:path";
import { drawn, openPage, startBrowser } from "./browser.mjs";

const [alembert, folder, ...descriptions] = process.argv.slice(2);
assert(descriptions.length > 0, "no descriptions");
mkdirSync(folder, { recursive: true });

const run = (args, input = "") => execFileSync(alembert, args, { input, encoding: "utf8", maxBuffer: 1 << 28 });

/// Simulates: a frame each 20 ms, a row of the CSV each 10 ms.
function simulate(description, more = []) {
  const path = `${folder}/${basename(description, ".yaml")}`;
  run(["simulate", description, "--duration", "1", "--step", "0.001", "--fps", "50", "--every", "10",
    "--html", `${path}.html`, "--csv", `${path}.csv`, ...more]);
  return path;
}

/// Times and poses of all bodies, by `evaluate` from the coordinates in the CSV.
function kinematics(description, csv) {
  const [header, ...lines] = readFileSync(csv, "utf8").trim().split("\n");
  const names = header.split(",");
  const nq = names.findIndex((name) => name.startsWith("d("));
  const rows = lines.map((line) => line.split(",").map(Number));
  const states = rows.map((row) => JSON.stringify({ t: row[0], q: row.slice(1, nq) })).join("\n");
  const poses = run(["evaluate", description, "--json"], states).trim().split("\n").map((line) => JSON.parse(line).poses);
  assert.equal(poses.length, rows.length);
  return rows.map((row, k) => ({ t: row[0], poses: poses[k] }));
}

/// Largest difference between two poses' entries.
function difference(matrix, rows) {
  let most = 0;
  for (let i = 0; i < 12; ++i) most = Math.max(most, Math.abs(matrix[Math.floor(i / 4)][i % 4] - rows[i]));
  return most;
}

const posesAt = (page, t) =>
  page.evaluate((time) => {
    window.viewer.seek(time);
    return window.viewer.mechanisms[0].bodies.map((name) => window.viewer.pose(name));
  }, t);

/// Brightness from 0 to 1 in the mean, and number of different colours, of the picture.
async function picture(page) {
  await drawn(page);
  return page.evaluate(() => {
    const canvas = document.querySelector("#stage canvas");
    const copy = document.createElement("canvas");
    copy.width = copy.height = 256;
    const context = copy.getContext("2d");
    context.drawImage(canvas, 0, 0, 256, 256);
    const { data } = context.getImageData(0, 0, 256, 256);
    const colors = new Set();
    let sum = 0;
    for (let i = 0; i < data.length; i += 4) {
      colors.add((data[i] << 16) | (data[i + 1] << 8) | data[i + 2]);
      sum += data[i] + data[i + 1] + data[i + 2];
    }
    return { brightness: sum / (256 * 256 * 3 * 255), colors: colors.size };
  });
}

async function checkPoses(browser, description) {
  const path = simulate(description);
  const states = kinematics(description, `${path}.csv`);
  const { page, wrong } = await openPage(browser, `${path}.html`, { width: 900, height: 480 });
  assert.equal(await page.evaluate(() => window.viewer.drawn), true, "no WebGL: nothing was drawn");
  assert.ok(Math.abs((await page.evaluate(() => window.viewer.duration)) - 1) < 1e-6);
  let scale = 1;
  for (const { poses } of states) for (const rows of poses) for (const value of rows) scale = Math.max(scale, Math.abs(value));
  let atFrames = 0;
  let between = 0;
  for (let k = 0; k < states.length; k += 5) {
    const { t, poses } = states[k];
    const shown = await posesAt(page, t);
    assert.equal(shown.length, poses.length);
    shown.forEach((matrix, b) => {
      assert.deepEqual(matrix[3], [0, 0, 0, 1]);
      const error = difference(matrix, poses[b]) / scale;
      if (k % 2 === 0) atFrames = Math.max(atFrames, error);
      else between = Math.max(between, error);
    });
  }
  console.log(`${basename(description)}: poses off by ${atFrames.toExponential(1)} at frames, ${between.toExponential(1)} between`);
  assert.ok(atFrames < 1e-6, "at a frame the pose is that of the kinematics, in single precision");
  assert.ok(between < 2e-3, "between frames it is near");
  const { brightness, colors } = await picture(page);
  assert.ok(brightness > 0.7 && colors > 60, `light: brightness ${brightness}, ${colors} colours`);
  assert.deepEqual(wrong, []);
  await page.close();
}

/// Playing, seeking by slider and plot, dark and light.
async function checkControls(browser, description) {
  const { page, wrong } = await openPage(browser, `${simulate(description)}.html`, { scheme: "dark" });
  assert.equal(await page.evaluate(() => document.documentElement.dataset.theme), "dark");
  const dark = await picture(page);
  assert.ok(dark.brightness < 0.3 && dark.colors > 60, `dark: brightness ${dark.brightness}, ${dark.colors} colours`);
  await page.screenshot({ path: `${folder}/dark.png` });
  await page.click("#theme");
  assert.equal(await page.evaluate(() => document.documentElement.dataset.theme), "light");
  const light = await picture(page);
  assert.ok(light.brightness > 0.7, `light: brightness ${light.brightness}`);
  await page.screenshot({ path: `${folder}/light.png` });

  const time = () => page.evaluate(() => window.viewer.time);
  await page.evaluate(() => window.viewer.seek(0));
  await page.click("#play");
  await page.waitForFunction(() => window.viewer.time > 0.05);
  await page.click("#play");
  const paused = await time();
  await drawn(page);
  assert.equal(await time(), paused, "paused, and yet it goes on");

  await page.evaluate(() => {
    const slider = document.getElementById("time");
    slider.value = "0.25";
    slider.dispatchEvent(new Event("input"));
  });
  assert.ok(Math.abs((await time()) - 0.25) < 1e-6);
  assert.match(await page.$eval("#clock", (clock) => clock.textContent), /^0\.25 s$/);

  const plot = await page.$("#plots canvas");
  const box = await plot.boundingBox();
  await page.mouse.click(box.x + 52 + (box.width - 62) / 2, box.y + 40);
  assert.ok(Math.abs((await time()) - 0.5) < 0.01, `a click in the middle of a plot went to ${await time()}`);

  await page.evaluate(() => window.viewer.seek(99));
  assert.ok(Math.abs((await time()) - 1) < 1e-6, "times end with the motion");
  await page.click("#trails");
  await drawn(page);
  assert.equal(await page.evaluate(() => window.viewer.pose("nobody")), null);
  assert.deepEqual(wrong, []);
  await page.close();
}

/// Several mechanisms in one page, and texts that try to leave their place.
async function checkScene(browser, other) {
  const path = `${folder}/evil.yaml`;
  const text = "</script><script>window.evil = 1</script><img src=x onerror='window.evil = 2'> @scene@ @title@";
  writeFileSync(path, `alembert: 1
name: evil
description: "${text}"
coordinates: [{name: q, initial: 0.3}]
bodies:
  - {name: bob, transform: [{rotate: {axis: y, angle: q}}, {translate: [0, 0, -0.5]}], mass: 1}
`);
  const { page, wrong } = await openPage(browser, `${simulate(path, ["--scene", `${path},${other}`])}.html`);
  const names = await page.evaluate(() => window.viewer.mechanisms.map((mechanism) => mechanism.name));
  assert.deepEqual(names, ["evil", "evil 2", basename(other, ".yaml")]);
  assert.equal(await page.evaluate(() => window.evil), undefined);
  assert.equal(await page.$eval("#heading p", (p) => p.textContent), text);
  const states = kinematics(path, `${folder}/evil.csv`);
  const both = await page.evaluate((t) => {
    window.viewer.seek(t);
    return ["evil", "evil 2"].map((mechanism) => window.viewer.pose("bob", mechanism));
  }, states[50].t);
  for (const matrix of both) assert.ok(difference(matrix, states[50].poses[0]) < 1e-6);
  const buttons = await page.$$("#mechanisms button");
  assert.equal(buttons.length, 3);
  await page.evaluate(() => window.viewer.setMode("live"));
  assert.equal(await page.evaluate(() => window.viewer.live.motions.every((motion) => motion.step(0.001))), true);
  assert.equal(await page.evaluate(() => window.evil), undefined);
  await page.evaluate(() => window.viewer.setMode("recorded"));
  await buttons[2].click();
  assert.notEqual(await page.$eval("#heading h1", (h) => h.textContent), "evil");
  await page.evaluate(() => window.viewer.showAll());
  await drawn(page);
  await page.screenshot({ path: `${folder}/scene.png` });
  assert.deepEqual(wrong, []);
  await page.close();
}

/// Units on axes and limits of coordinates; the picture is as near as the motion allows.
async function checkPlots(browser) {
  const description = (name, limits) => {
    const path = `${folder}/${name}.yaml`;
    writeFileSync(path, `alembert: 1
name: ${name}
coordinates: [{name: turn, initial: 0.3${limits}}, {name: slide, initial: 0.1}, {name: roll, initial: 0.2}]
bodies:
  - {name: arm, transform: [{rotate: {axis: y, angle: turn}}, {translate: [0, 0, -0.5]}], mass: 1}
  - {name: cart, transform: [{translate: [slide + 2, 0, 0]}], mass: 1}
  - {name: wheel, transform: [{translate: [roll, 0, 1]}, {rotate: {axis: y, angle: 2*roll}}], mass: 1, inertia: {xx: 0.1, yy: 0.1, zz: 0.1}}
`);
    return path;
  };
  // Rows of a plot that the colour of its first series takes a third of.
  const lines = (page) =>
    page.evaluate(() => {
      const canvas = document.querySelectorAll("#plots canvas")[1];
      const { data, width, height } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
      let rows = 0;
      for (let y = 0; y < height; ++y) {
        let blue = 0;
        for (let x = 0; x < width; ++x) if (data[4 * (y * width + x) + 2] - data[4 * (y * width + x)] > 60 && data[4 * (y * width + x) + 3] > 60) ++blue;
        if (3 * blue > width) ++rows;
      }
      return rows;
    });
  const { page: limited, wrong } = await openPage(browser, `${simulate(description("limited", ", limits: [-1, 0.75]"))}.html`);
  await drawn(limited);
  await limited.screenshot({ path: `${folder}/limits.png` });
  assert.deepEqual(await limited.$$eval("#plots h2", (all) => all.map((h) => h.textContent)).then((all) => all.slice(1)),
    ["turn rad", "slide m", "roll rad"]);
  assert.equal(await limited.$eval("#plots section:nth-child(2) li", (li) => li.title), "limits -1.0000 \u2026 0.75000 rad");
  assert.ok((await lines(limited)) >= 2, "limits are lines");
  const reach = await limited.evaluate(() => {
    let most = 0;
    window.viewer.showAll();
    for (let t = 0; t <= 1; t += 0.05) {
      window.viewer.seek(t);
      for (const body of window.viewer.mechanisms[0].bodies) most = Math.max(most, ...window.viewer.onScreen(body).map(Math.abs));
    }
    return most;
  });
  console.log(`bodies are up to ${reach.toFixed(2)} of the way to the edge`);
  assert.ok(reach > 0.7 && reach < 1, "the motion fills the picture, and nothing leaves it");
  assert.equal(await limited.evaluate(() => window.viewer.onScreen("nobody")), null);
  assert.deepEqual(wrong, []);
  await limited.close();
  const { page: free } = await openPage(browser, `${simulate(description("unlimited", ""))}.html`);
  await drawn(free);
  assert.equal(await lines(free), 0, "no limits, no lines");
  await free.close();
}

/// Forces: lines go through their frames, as thick as they pull, and dots are where bodies touch. All against `evaluate`
/// and against outputs that say the same in words of their own.
async function checkForces(browser) {
  const path = `${folder}/forces.yaml`;
  writeFileSync(path, `alembert: 1
name: forces
inputs: [{name: drive, initial: 0.5, limits: [-2, 2]}]
coordinates: [{name: swing, initial: 0.9}, {name: drop, initial: 0.3}]
bodies:
  - {name: arm, transform: [{rotate: {axis: y, angle: swing}}, {translate: [0, 0, -0.5]}], mass: 1}
  - {name: ball, transform: [{translate: [1, 0, drop]}], mass: 0.4, geometry: [{sphere: 0.1}]}
frames:
  - {name: peg, body: world, transform: [{translate: [-0.4, 0, 0.1]}]}
  - {name: hole, body: arm, transform: [{translate: [0, 0, 0.2]}]}
  - {name: end, body: arm, transform: [{translate: [0.05, 0, -0.1]}]}
  - {name: center, body: ball}
forces:
  - {name: string, path: [peg, hole, end], tension: "max(0, 60*(length - 0.75))"}
  - {name: spring, between: [peg, end], tension: "20*(length - 0.8)"}
  - {name: bounce, contact: {frame: center, radius: 0.1, plane: {point: [0, 0, 0.05], normal: [0, 0, 1]}, stiffness: 4000, dissipation: 0.2}}
  - {name: motor, on: swing, value: drive}
outputs:
  - {name: string_pulls, value: "max(0, 60*(distance(peg, hole) + distance(hole, end) - 0.75))"}
  - {name: spring_pulls, value: "20*distance(peg, end) - 16"}
  - {name: depth, value: "max(0, 0.15 - drop)"}
  - {name: push, value: "4000*(max(0, 0.15 - drop))^(3/2)*max(0, 1 - 0.3*d(drop))"}
`);
  const base = simulate(path, ["--input", "drive=0.3*sin(6*t) - 0.1*d(swing)"]);
  const [header, ...lines] = readFileSync(`${base}.csv`, "utf8").trim().split("\n");
  const names = header.split(",");
  const rows = lines.map((line) => Object.fromEntries(line.split(",").map((value, i) => [names[i], Number(value)])));
  const states = rows.map((row) => JSON.stringify({ t: row.t, q: [row.swing, row.drop] })).join("\n");
  const frames = run(["evaluate", path, "--json", "--functions", "frame_poses"], states).trim().split("\n").map((line) => JSON.parse(line).frame_poses.F.flat());
  const { page, wrong } = await openPage(browser, `${base}.html`, { width: 900, height: 480 });
  // In single precision, as times are: beside the largest, which may come at the next frame.
  const near = (a, b, text, size = 1) => assert.ok(Math.abs(a - b) < 2e-6 * size, `${text}: ${a} is not ${b}`);
  const largest = (name) => Math.max(...rows.map((row) => Math.abs(row[name])));
  const seen = { pull: 0, push: 0, slack: 0, touch: 0, apart: 0 };
  const thick = [];
  for (let k = 0; k < rows.length; k += 2) {
    const { t } = rows[k];
    const shown = await page.evaluate((time) => {
      window.viewer.seek(time);
      return { string: window.viewer.line("string"), spring: window.viewer.line("spring"), bounce: window.viewer.contact("bounce") };
    }, t);
    const origin = (frame) => [3, 7, 11].map((i) => frames[k][12 * frame + i]);
    const same = (point, expected, text) => point.forEach((x, a) => near(x, expected[a], `${text} at ${t}`));
    [0, 1, 2].forEach((frame, i) => same(shown.string.points[i], origin(frame), "string"));
    [0, 2].forEach((frame, i) => same(shown.spring.points[i], origin(frame), "spring"));
    near(shown.string.tension, rows[k].string_pulls, `tension of the string at ${t}`, largest("string_pulls"));
    near(shown.spring.tension, rows[k].spring_pulls, `tension of the spring at ${t}`, largest("spring_pulls"));
    near(shown.bounce.force, rows[k].push, `normal force at ${t}`, largest("push"));
    same(shown.bounce.point, [1, 0, rows[k].drop - 0.1], "contact");
    if (rows[k].depth === 0 || rows[k].push > 1) assert.equal(shown.bounce.touches, rows[k].depth > 0, `contact at ${t}`);
    assert.equal(shown.bounce.radius > 0, shown.bounce.touches);
    ++seen[shown.bounce.touches ? "touch" : "apart"];
    for (const line of [shown.string, shown.spring]) {
      if (line.tension === 0 || Math.abs(line.tension) > 0.01)
        assert.equal(line.state, line.tension > 0 ? "pull" : line.tension < 0 ? "push" : "slack");
      ++seen[line.state];
      thick.push([Math.abs(line.tension), line.radius]);
    }
  }
  for (const [what, times] of Object.entries(seen)) assert.ok(times > 2, `${what} was seen ${times} times`);
  thick.sort((a, b) => a[0] - b[0]);
  thick.slice(1).forEach(([, radius], i) => assert.ok(radius >= thick[i][1], "a line that pulls more is not thinner"));
  assert.equal(await page.evaluate(() => window.viewer.line("nothing")), null);
  assert.equal(await page.evaluate(() => window.viewer.contact("string")), null);
  assert.deepEqual(await page.$$eval("#plots h2", (all) => all.map((h) => h.textContent).slice(3)), ["string \u2026 bounce force, N",
    "motor force, N m", "drive input, N m", "string_pulls \u2026 spring_pulls output", "depth output, m", "push output"]);
  // Live, they are those of the state at hand.
  await page.evaluate(() => window.viewer.setMode("live"));
  for (const row of rows.filter((_, k) => k % 25 === 0)) {
    const shown = await page.evaluate(({ t, q, qd }) => {
      const { live } = window.viewer;
      const [motion] = live.motions;
      motion.t = t;
      motion.q.set(q);
      motion.u.set(qd);
      live.records[0].append();
      live.show();
      return { string: window.viewer.line("string"), spring: window.viewer.line("spring"), bounce: window.viewer.contact("bounce") };
    }, { t: row.t, q: [row.swing, row.drop], qd: [row["d(swing)"], row["d(drop)"]] });
    near(shown.string.tension, row.string_pulls, `live tension of the string at ${row.t}`, largest("string_pulls"));
    near(shown.spring.tension, row.spring_pulls, `live tension of the spring at ${row.t}`, largest("spring_pulls"));
    near(shown.bounce.force, row.push, `live normal force at ${row.t}`, largest("push"));
    near(shown.bounce.point[2], row.drop - 0.1, `live contact at ${row.t}`);
  }
  await page.evaluate(() => window.viewer.seek(0.3));
  await drawn(page);
  await page.screenshot({ path: `${folder}/forces.png` });
  assert.deepEqual(wrong, []);
  await page.close();
}

const browser = await startBrowser();
try {
  for (const description of descriptions) await checkPoses(browser, description);
  await checkControls(browser, descriptions[0]);
  await checkScene(browser, descriptions[0]);
  await checkPlots(browser);
  await checkForces(browser);
} finally {
  await browser.close();
}

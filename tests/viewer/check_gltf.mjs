// Scenes of simulated mechanisms in the validator of glTF: neither errors nor warnings.
//   node check_gltf.mjs ALEMBERT FOLDER DESCRIPTION...
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { existsSync, mkdirSync, readFileSync, rmSync } from "node:fs";
import { basename } from "node:path";
import { validateBytes } from "gltf-validator";

const [alembert, folder, ...descriptions] = process.argv.slice(2);
assert(descriptions.length > 0, "no descriptions");
mkdirSync(folder, { recursive: true });

async function check(name, args) {
  const path = `${folder}/${name}.glb`;
  rmSync(path, { force: true });
  const { status, stderr } = spawnSync(alembert, ["simulate", ...args, "--duration", "0.2", "--glb", path], { encoding: "utf8" });
  // Motions that end early are written too.
  assert.ok((status === 0 || status === 1) && existsSync(path), `${name}: ${stderr}`);
  const report = await validateBytes(new Uint8Array(readFileSync(path)), { maxIssues: 20 });
  const { numErrors, numWarnings, messages } = report.issues;
  assert.equal(numErrors + numWarnings, 0, `${name}: ${JSON.stringify(messages, null, 1)}`);
  assert.equal(report.info.hasTextures, false);
  assert.ok(report.info.totalTriangleCount > 0, `${name}: nothing to be seen`);
  return report;
}

let animated = 0;
for (const description of descriptions) {
  const report = await check(basename(description, ".yaml"), [description]);
  if (report.info.animationCount > 0) ++animated;
}
assert.ok(animated > 0.8 * descriptions.length, `only ${animated} of ${descriptions.length} scenes move`);
const scene = await check("scene", [descriptions[0], "--scene", descriptions.slice(1, 4).join(",")]);
assert.equal(scene.info.animationCount, 4);
console.log(`${descriptions.length + 1} scenes are valid`);

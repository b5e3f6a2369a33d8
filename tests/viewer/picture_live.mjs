// Pictures of live pages for src/javascript/README.md: an arm that is pulled, a page on a phone, an imported robot.
//   node picture_live.mjs ALEMBERT FOLDER MECHANISMS
import { execFileSync } from "node:child_process";
import { mkdirSync } from "node:fs";
import { drawn, openPage, startBrowser } from "./browser.mjs";

const [alembert, folder, mechanisms] = process.argv.slice(2);
mkdirSync(folder, { recursive: true });

const kPictures = [
  { name: "pulled", file: "puma560.yaml", by: [0.25, -0.2, 0.35], size: { width: 960, height: 560 }, more: [] },
  { name: "phone", file: "runtime_parameters.yaml", by: [0.2, 0, 0.1], size: { width: 390, height: 780 }, more: ["--q", "0.6,-0.4"] },
  { name: "imported", file: "examples/controller/arm.urdf", by: [0.1, 0.2, 0.2], size: { width: 960, height: 560 }, more: [] },
];

const browser = await startBrowser();
try {
  for (const { name, file, by, size, more } of kPictures) {
    const path = `${folder}/${name}.html`;
    execFileSync(alembert, ["simulate", `${mechanisms}/${file}`, "--duration", "0.5", "--html", path, ...more]);
    const { page } = await openPage(browser, path, size);
    await page.evaluate((by) => {
      const { viewer } = window;
      viewer.setMode("live");
      viewer.pause();
      const [motion] = viewer.live.motions;
      const last = motion.bodies.length - 1;
      // Each twentieth of a second a point of the plots; on the way the hand takes the last body.
      for (let k = 0; k < 24; ++k) {
        if (k === 8) {
          motion.grab(last, motion.bodies[last].center);
          motion.moveTarget(motion.pull.at.map((x, i) => x + by[i]));
          viewer.live.grab.held = { motion, mechanism: viewer.live.stage.mechanisms[0], pointer: -1 };
        }
        for (let i = 0; i < 24; ++i) motion.step(1 / 480);
        viewer.live.records[0].append();
      }
      viewer.live.show();
      viewer.select(0);
      viewer.setTheme("light");
    }, by);
    await drawn(page);
    await page.screenshot({ path: `${folder}/${name}.png` });
    await page.close();
  }
} finally {
  await browser.close();
}

// Time of a step of a live page's first mechanism, in node, free and pulled: milliseconds of processor, by the state it starts from
// and those of the next twelfth of a second.
//   node measure_live.mjs PAGE.html...
import { readFileSync } from "node:fs";
import { LiveMotion } from "../../templates/viewer/source/live_motion.js";

for (const file of process.argv.slice(2)) {
  const scene = JSON.parse(readFileSync(file, "utf8").match(/<script type="application\/json" id="scene">(.*?)<\/script>/s)[1]);
  const { name, live, bodies } = scene.mechanisms[0];
  const motion = new LiveMotion(live, bodies);
  const measure = (pulled) => {
    const steps = (count) => {
      const begin = process.cpuUsage();
      for (let k = 0; k < count; ++k) {
        if (k % 40 === 0) {
          motion.reset();
          if (pulled !== undefined && motion.grab(pulled, bodies[pulled].center)) motion.moveTarget(motion.pull.at.map((x) => x + 0.05));
        }
        motion.step(1 / 480);
      }
      const { user, system } = process.cpuUsage(begin);
      return (user + system) / 1000 / count;
    };
    steps(2000);  // until it is compiled
    return steps(1000).toFixed(3);
  };
  const free = measure();
  const body = bodies.findLastIndex((_, i) => motion.grab(i, bodies[i].center));
  const size = `${(live.module.length / 1024).toFixed(0)} kB of functions`;
  console.log(`${name}: ${motion.module.nv} speeds, ${size}, ${free} ms a step, ${body < 0 ? "nothing to pull" : `${measure(body)} ms pulled at ${bodies[body].name}`}`);
}

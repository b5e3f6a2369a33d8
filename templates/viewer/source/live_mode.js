// The live mode of the page: mechanisms move on by themselves, the hand pulls bodies and moves sliders. In: a stage, its scene.
// Out: motions (live_motion.js), what they were like of late, and pictures.
import { Grab } from "./grab.js";
import { LiveMotion } from "./live_motion.js";
import { LiveRecord } from "./live_record.js";

export class LiveMode {
  /// `onGrab()` when the hand takes a body.
  constructor(stage, data, onGrab) {
    this.stage = stage;
    this.motions = data.mechanisms.map(({ live, bodies }) => (live ? new LiveMotion(live, bodies) : null));
    this.records = data.mechanisms.map((mechanism, i) => this.motions[i] && new LiveRecord(mechanism, this.motions[i]));
    this.on = false;
    this.grab = new Grab(stage, this.motions, () => this.on, onGrab);
  }

  set(on) {
    this.on = on;
    if (!on) this.grab.release();
    else this.show();
  }

  /// Time passes. Returns what stops a mechanism, or nothing.
  advance(seconds) {
    let problem = "";
    this.motions.forEach((motion, i) => {
      if (!motion) return;
      if (!motion.advance(seconds)) problem ||= motion.problem;
      this.records[i].append();
    });
    this.show();
    return problem;
  }

  reset() {
    this.grab.release();
    this.motions.forEach((motion, i) => {
      motion?.reset();
      this.records[i]?.clear();
    });
    this.show();
  }

  show() {
    this.stage.showLive(this.motions.map((motion, i) => motion && { poses: motion.poses(), forces: this.records[i].now }));
    this.grab.show();
  }

  get time() {
    return this.motions.find((motion) => motion)?.t ?? 0;
  }
}

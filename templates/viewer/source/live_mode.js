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
    this.names = data.mechanisms.map(({ name }) => name);
    this.records = data.mechanisms.map((mechanism, i) => this.motions[i] && new LiveRecord(mechanism, this.motions[i]));
    this.on = false;
    this.grab = new Grab(stage, this.motions, () => this.on, onGrab);
  }

  set(on) {
    this.on = on;
    if (!on) this.grab.release();
    else this.show();
  }

  /// Time passes for the mechanisms that nothing stops.
  advance(seconds) {
    this.motions.forEach((motion, i) => motion?.advance(seconds) && this.records[i].append());
    this.show();
  }
  /// What stops mechanisms, of which they may be one of several, or nothing.
  get problem() {
    const stopped = this.names.map((name, i) => [name, this.motions[i]?.problem]).filter(([, problem]) => problem);
    return stopped.map(([name, problem]) => (this.names.length > 1 ? `${name}: ${problem}` : problem)).join("; ");
  }
  /// Whether nothing moves any more.
  get stopped() {
    return this.motions.every((motion) => !motion || motion.problem);
  }

  reset() {
    this.grab.release();
    this.stage.clearLiveTrails();
    this.motions.forEach((motion, i) => {
      motion?.reset();
      this.records[i]?.clear();
    });
    this.show();
  }

  show() {
    this.stage.showLive(this.motions.map((motion, i) => motion && { poses: motion.poses(), time: motion.t, forces: this.records[i].now }));
    this.grab.show();
  }

  get time() {
    return this.motions.reduce((latest, motion) => Math.max(latest, motion?.t ?? -Infinity), -Infinity);
  }
}

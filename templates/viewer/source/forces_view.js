// Forces in the picture: lines that pull, thicker with tension, and dots where bodies touch. In: lines and contacts of a
// mechanism (scene_data.js) and a frame. Out: a group in the mechanism's world.
import {
  CylinderGeometry, Group, Mesh, MeshBasicMaterial, MeshStandardMaterial, Quaternion, SphereGeometry, SRGBColorSpace, Vector3,
} from "three";

const kColors = { pull: [0.79, 0.21, 0.2], push: [0.18, 0.44, 0.72], slack: [0.5, 0.53, 0.58], touch: [0.95, 0.45, 0.05] };
const kLeast = 0.0035;  // radius of a line, in sizes of the mechanism: a pull of nearly 0, ...
const kMost = 0.013;    // ... and the largest of the motion
const kSlack = 0.002;   // no tension at all
const kDot = [0.014, 0.032];  // radius of a dot, likewise
const kNothing = 1e-4;  // of the largest, which is none: times are of single precision, and values between frames are near

const valueBetween = (values, frame, share) =>
  share > 0 ? values[frame] + share * (values[frame + 1] - values[frame]) : values[frame];

function pointBetween(points, frame, share) {
  const point = new Vector3().fromArray(points, 3 * frame);
  return share > 0 ? point.lerp(new Vector3().fromArray(points, 3 * frame + 3), share) : point;
}

const largest = (all) => all.reduce((most, { values }) => values.reduce((a, b) => Math.max(a, Math.abs(b) || 0), most), 0);

/// Tubes from point to point, with a ball at each.
class LineView {
  constructor(series, points, geometries) {
    this.series = series;
    this.points = points;
    this.material = new MeshStandardMaterial({ roughness: 0.6, transparent: true });
    const mesh = (geometry) => {
      const made = new Mesh(geometry, this.material);
      made.castShadow = true;
      return made;
    };
    this.tubes = points.slice(1).map(() => mesh(geometries.tube));
    this.balls = points.map(() => mesh(geometries.ball));
  }

  show(frame, share, size, most) {
    const tension = valueBetween(this.series.values, frame, share);
    const relative = most > 0 ? Math.abs(tension) / most : 0;
    this.state = relative > kNothing ? (tension > 0 ? "pull" : "push") : "slack";
    this.radius = size * (this.state === "slack" ? kSlack : kLeast + (kMost - kLeast) * relative);
    this.tension = tension;
    this.material.color.setRGB(...kColors[this.state], SRGBColorSpace);
    this.material.opacity = this.state === "slack" ? 0.4 : 1;
    this.places = this.points.map((points) => pointBetween(points, frame, share));
    const up = new Vector3(0, 1, 0);
    this.tubes.forEach((tube, i) => {
      const along = this.places[i + 1].clone().sub(this.places[i]);
      const length = along.length();
      tube.visible = length > 0;
      if (!tube.visible) return;
      tube.position.copy(this.places[i]).addScaledVector(along, 0.5);
      tube.quaternion.setFromUnitVectors(up, along.divideScalar(length));
      tube.scale.set(this.radius, length, this.radius);
    });
    this.balls.forEach((ball, i) => {
      ball.position.copy(this.places[i]);
      ball.scale.setScalar(this.radius * (this.state === "slack" ? 1 : 1.35));
    });
  }
}

/// A dot, drawn over what hides it: a contact lies between two bodies.
class DotView {
  constructor(series, points, geometries) {
    this.series = series;
    this.points = points;
    const material = new MeshBasicMaterial({ depthTest: false, transparent: true, opacity: 0.85, toneMapped: false });
    material.color.setRGB(...kColors.touch, SRGBColorSpace);
    this.mesh = new Mesh(geometries.ball, material);
    this.mesh.renderOrder = 1;
  }

  show(frame, share, size, most) {
    this.force = valueBetween(this.series.values, frame, share);
    this.touches = this.force > kNothing * most;
    this.radius = this.touches ? size * (kDot[0] + (kDot[1] - kDot[0]) * Math.cbrt(this.force / most)) : 0;
    this.mesh.visible = this.touches;
    this.mesh.position.copy(pointBetween(this.points, frame, share));
    if (this.touches) this.mesh.scale.setScalar(this.radius);
  }
}

export class ForcesView {
  /// `size`: of the mechanism.
  constructor(mechanism, size) {
    this.group = new Group();
    this.size = size;
    const geometries = { tube: new CylinderGeometry(1, 1, 1, 12, 1, true), ball: new SphereGeometry(1, 20, 12) };
    const view = (Kind) => ({ force, points }) => new Kind(mechanism.forces[force], points, geometries);
    this.lines = mechanism.lines.map(view(LineView));
    this.dots = mechanism.contacts.map(view(DotView));
    this.mostTension = largest(this.lines.map(({ series }) => series));
    this.mostForce = largest(this.dots.map(({ series }) => series));
    for (const line of this.lines) this.group.add(...line.tubes, ...line.balls);
    for (const dot of this.dots) this.group.add(dot.mesh);
  }

  /// Thickness beside the strongest so far, here or there.
  measure(other) {
    this.mostTension = Math.max(this.mostTension, other.mostTension, largest(this.lines.map(({ series }) => series)));
    this.mostForce = Math.max(this.mostForce, other.mostForce, largest(this.dots.map(({ series }) => series)));
  }

  seek(frame, share) {
    for (const line of this.lines) line.show(frame, share, this.size, this.mostTension);
    for (const dot of this.dots) dot.show(frame, share, this.size, this.mostForce);
  }

  /// For scripts, as drawn: places in the mechanism's world.
  line(name) {
    const line = this.lines.find(({ series }) => series.name === name);
    if (!line) return null;
    const { tension, state, radius, places } = line;
    return { tension, state, radius, points: places.map((place) => place.toArray()) };
  }
  contact(name) {
    const dot = this.dots.find(({ series }) => series.name === name);
    return dot ? { force: dot.force, touches: dot.touches, radius: dot.radius, point: dot.mesh.position.toArray() } : null;
  }
}

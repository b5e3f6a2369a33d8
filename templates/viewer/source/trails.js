// Paths of the bodies' centres of mass. In: bodies of a scene (scene_data.js), and poses as a live motion comes to them. Out: lines, of
// the recorded motion or of the live one.
import { BufferAttribute, BufferGeometry, Color, Group, Line, LineBasicMaterial, Quaternion, Vector3 } from "three";

const kMost = 1200;  // points of a live path: at 60 a second, 20 s

function recordedPoints(body) {
  const points = new Float32Array(body.origins.length);
  const [point, rotation] = [new Vector3(), new Quaternion()];
  for (let k = 0; 3 * k < points.length; ++k) {
    rotation.fromArray(body.rotations, 4 * k);
    point.fromArray(body.center).applyQuaternion(rotation);
    for (let a = 0; a < 3; ++a) points[3 * k + a] = body.origins[3 * k + a] + point.getComponent(a);
  }
  return points;
}

export class Trails {
  constructor(bodies) {
    this.bodies = bodies;
    this.group = new Group();
    const lines = (pointsOf) => {
      const group = new Group();
      for (const body of bodies) {
        const geometry = new BufferGeometry();
        geometry.setAttribute("position", new BufferAttribute(pointsOf(body), 3));
        const color = new Color(...(body.parts[0]?.color ?? [0.5, 0.5, 0.5])).convertSRGBToLinear();
        group.add(new Line(geometry, new LineBasicMaterial({ color, transparent: true, opacity: 0.75 })));
      }
      this.group.add(group);
      return group;
    };
    this.recorded = lines(recordedPoints);
    this.live = lines(() => new Float32Array(3 * kMost));
    for (const line of this.live.children) line.frustumCulled = false;  // its points move
    this.clear();
    this.choose(false);
  }

  choose(live) {
    this.live.visible = live;
    this.recorded.visible = !live;
  }
  /// A live motion begins anew.
  clear() {
    this.count = 0;
    this.time = NaN;
  }
  /// Poses [R p] of a live motion, row by row. Of one moment the last ones count.
  append(W, time) {
    const same = time === this.time;
    const full = this.count === kMost && !same;
    if (!full && !same) ++this.count;
    this.time = time;
    this.live.children.forEach(({ geometry }, i) => {
      const { position } = geometry.attributes;
      if (full) position.array.copyWithin(0, 3);
      const { center } = this.bodies[i];
      for (let a = 0; a < 3; ++a) {
        const [x, y, z, origin] = W.subarray(12 * i + 4 * a, 12 * i + 4 * a + 4);
        position.array[3 * (this.count - 1) + a] = x * center[0] + y * center[1] + z * center[2] + origin;
      }
      position.needsUpdate = true;
      geometry.setDrawRange(0, this.count);
    });
  }
}

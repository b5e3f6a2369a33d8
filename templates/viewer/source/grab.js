// The hand on a body: what lies under the pointer, and where it is pulled to. In: a stage and its motions. Out: motions whose
// bodies are pulled, and a line from the body to the pointer in the picture.
import { CylinderGeometry, Mesh, MeshBasicMaterial, Plane, Raycaster, SphereGeometry, Vector2, Vector3 } from "three";

const kNear = 26;        // pixels from a body that are taken for it: fingers are no arrows
const kThickness = 0.004;  // of the line, in sizes of the picture

export class Grab {
  /// `motions`: by mechanism; `active()`: whether bodies can be grabbed now; `onGrab()` when one is.
  constructor(stage, motions, active, onGrab) {
    Object.assign(this, { stage, motions, active, onGrab });
    this.held = null;
    this.ray = new Raycaster();
    const material = new MeshBasicMaterial({ color: "#e8590c", depthTest: false, transparent: true, opacity: 0.9, toneMapped: false });
    this.line = new Mesh(new CylinderGeometry(1, 1, 1, 12, 1, true), material);
    this.ends = [0, 1].map(() => new Mesh(new SphereGeometry(1, 20, 12), material));
    for (const mesh of [this.line, ...this.ends]) {
      mesh.visible = false;
      mesh.renderOrder = 2;
      stage.scene.add(mesh);
    }
    const canvas = stage.renderer?.domElement;
    if (!canvas) return;
    // Before the controls of the camera, which take what is left.
    canvas.addEventListener("pointerdown", (event) => this.down(event), { capture: true });
    canvas.addEventListener("pointermove", (event) => this.move(event), { capture: true });
    for (const end of ["pointerup", "pointercancel", "lostpointercapture"]) canvas.addEventListener(end, (event) => this.up(event), { capture: true });
  }

  aim(event) {
    const box = this.stage.renderer.domElement.getBoundingClientRect();
    const place = new Vector2(((event.clientX - box.left) / box.width) * 2 - 1, 1 - ((event.clientY - box.top) / box.height) * 2);
    this.stage.camera.updateMatrixWorld();
    this.ray.setFromCamera(place, this.stage.camera);
    return box;
  }

  /// The body under the pointer, or one whose centre of mass is near: its mechanism, its place there, and a point of it.
  find(event) {
    const box = this.aim(event);
    this.stage.scene.updateMatrixWorld(true);
    let best = null;
    this.stage.mechanisms.forEach((mechanism, index) => {
      if (!this.motions[index]) return;
      mechanism.bodies.forEach((node, body) => {
        for (const { distance, point } of this.ray.intersectObject(node, true))
          if (!best || distance < best.distance) best = { index, body, distance, point: point.clone() };
      });
    });
    if (best) return best;
    let nearest = kNear;
    this.stage.mechanisms.forEach((mechanism, index) => {
      if (!this.motions[index]) return;
      mechanism.data.bodies.forEach(({ center }, body) => {
        const point = new Vector3().fromArray(center).applyMatrix4(mechanism.bodies[body].matrixWorld);
        const seen = point.clone().project(this.stage.camera);
        const aside = Math.hypot(
          ((seen.x + 1) / 2) * box.width + box.left - event.clientX, ((1 - seen.y) / 2) * box.height + box.top - event.clientY);
        if (seen.z < 1 && aside < nearest) [nearest, best] = [aside, { index, body, point }];
      });
    });
    return best;
  }

  down(event) {
    if (!this.active() || this.held || event.button !== 0) return;
    const found = this.find(event);
    if (!found) return;
    const mechanism = this.stage.mechanisms[found.index];
    const inBody = mechanism.bodies[found.body].worldToLocal(found.point.clone());
    const motion = this.motions[found.index];
    if (!motion.grab(found.body, inBody.toArray())) return;
    event.stopImmediatePropagation();
    event.preventDefault();
    this.stage.renderer.domElement.setPointerCapture(event.pointerId);
    const facing = this.stage.camera.getWorldDirection(new Vector3());
    this.held = { motion, mechanism, pointer: event.pointerId, plane: new Plane().setFromNormalAndCoplanarPoint(facing, found.point) };
    this.onGrab();
    this.show();
  }

  move(event) {
    if (this.held?.pointer !== event.pointerId) {
      if (event.pointerType === "mouse" && event.buttons === 0)
        this.stage.renderer.domElement.style.cursor = this.active() && this.find(event) ? "grab" : "";
      return;
    }
    event.stopImmediatePropagation();
    this.aim(event);
    const target = this.ray.ray.intersectPlane(this.held.plane, new Vector3());
    if (target) this.held.motion.moveTarget(this.held.mechanism.group.worldToLocal(target).toArray());
    this.show();
  }

  up(event) {
    if (this.held?.pointer !== event.pointerId) return;
    event.stopImmediatePropagation();
    this.release();
  }
  release() {
    this.held?.motion.release();
    this.held = null;
    this.show();
  }

  /// The line as it is now.
  show() {
    const pull = this.held?.motion.pull;
    if (this.held && !pull) this.held = null;
    for (const mesh of [this.line, ...this.ends]) mesh.visible = Boolean(pull);
    this.stage.draw();
    if (!pull) return;
    const group = this.held.mechanism.group;
    const W = this.held.motion.poses().subarray(12 * pull.body);
    const at = [0, 1, 2].map((r) => W[4 * r] * pull.point[0] + W[4 * r + 1] * pull.point[1] + W[4 * r + 2] * pull.point[2] + W[4 * r + 3]);
    const [from, to] = [at, pull.target].map((x) => group.localToWorld(new Vector3().fromArray(x)));
    const along = to.clone().sub(from);
    const thickness = kThickness * this.stage.camera.position.distanceTo(from) * 0.6;
    this.line.position.copy(from).addScaledVector(along, 0.5);
    this.line.scale.set(thickness, Math.max(along.length(), 1e-9), thickness);
    if (along.lengthSq() > 0) this.line.quaternion.setFromUnitVectors(new Vector3(0, 1, 0), along.normalize());
    [from, to].forEach((point, i) => {
      this.ends[i].position.copy(point);
      this.ends[i].scale.setScalar((i === 0 ? 2.6 : 1.9) * thickness);
    });
  }
}

// The three-dimensional part: meshes, lights, ground and camera. In: a scene (scene_data.js) and a time. Out: a picture.
import {
  ACESFilmicToneMapping, BufferAttribute, BufferGeometry, Box3, CircleGeometry, Color, DirectionalLight, DoubleSide,
  Fog, FrontSide, Group, HemisphereLight, LineBasicMaterial, LineSegments, Matrix4, Mesh, MeshStandardMaterial,
  PCFShadowMap, PerspectiveCamera, PMREMGenerator, Quaternion, Scene, ShadowMaterial, Sphere, SRGBColorSpace, Vector3,
  WebGLRenderer,
} from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import { RoomEnvironment } from "three/addons/environments/RoomEnvironment.js";
import { ForcesView } from "./forces_view.js";
import { frameAt } from "./scene_data.js";
import { Trails } from "./trails.js";

const kLook = {
  light: { background: "#eef0f3", grid: "#c3c9d1", sky: "#ffffff", ground: "#b8bcc4", hemisphere: 0.7, environment: 0.35, key: 2.0, shadow: 0.28 },
  dark: { background: "#14171c", grid: "#39404a", sky: "#9fb4d0", ground: "#1b1e24", hemisphere: 0.45, environment: 0.3, key: 2.0, shadow: 0.55 },
};
const kFarAway = 5;  // a motion that goes so many times the mechanism's size is followed by the camera
const kView = new Vector3(0.62, -1, 0.46).normalize();  // from where the motion is looked at first
const kMargin = 1.1;  // of the picture around the motion
const kMostFrames = 200;  // whose places are looked at for that

function geometryOf(mesh) {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(mesh.positions, 3));
  geometry.setAttribute("normal", new BufferAttribute(mesh.normals, 3));
  geometry.setIndex(new BufferAttribute(mesh.indices, 1));
  return geometry;
}

/// Points of a mesh that lie farthest out in 26 directions.
function outermost(mesh) {
  const points = [];
  for (let direction = 0; direction < 27; ++direction) {
    if (direction === 13) continue;
    const [dx, dy, dz] = [(direction % 3) - 1, (Math.floor(direction / 3) % 3) - 1, Math.floor(direction / 9) - 1];
    let farthest = 0;
    let most = -Infinity;
    for (let i = 0; i < mesh.positions.length; i += 3) {
      const distance = dx * mesh.positions[i] + dy * mesh.positions[i + 1] + dz * mesh.positions[i + 2];
      if (distance > most) [most, farthest] = [distance, i];
    }
    points.push(new Vector3().fromArray(mesh.positions, farthest));
  }
  return points;
}

/// Where along an axis to look from `place`, so that points go as far to one side of the picture as to the other.
function middleSeen(points, axis, place) {
  const seen = points.map((point) => [point.dot(axis), 1 / (place - point.dot(kView))]);
  let [low, high] = seen.reduce(([a, b], [aside]) => [Math.min(a, aside), Math.max(b, aside)], [Infinity, -Infinity]);
  for (let i = 0; i < 24; ++i) {
    const middle = (low + high) / 2;
    let [least, most] = [Infinity, -Infinity];
    for (const [aside, share] of seen) {
      const x = (aside - middle) * share;
      if (x < least) least = x;
      if (x > most) most = x;
    }
    if (least + most > 0) low = middle;
    else high = middle;
  }
  return (low + high) / 2;
}

/// 1, 2 or 5 times a power of ten, near `length`.
function roundLength(length) {
  const power = 10 ** Math.floor(Math.log10(length));
  const share = length / power;
  return power * (share < 1.5 ? 1 : share < 3.5 ? 2 : share < 7.5 ? 5 : 10);
}

class MechanismView {
  constructor(data, partOf) {
    this.data = data;
    this.group = new Group();
    this.group.position.fromArray(data.origin);
    this.group.quaternion.fromArray(data.rotation);
    for (const part of data.scenery) this.group.add(partOf(part));
    this.bodies = data.bodies.map((body) => {
      const node = new Group();
      node.name = body.name;
      for (const part of body.parts) node.add(partOf(part));
      this.group.add(node);
      return node;
    });
    this.trails = null;
    this.group.updateMatrixWorld(true);
    const box = ({ min, max }) =>
      new Box3(new Vector3().fromArray(min), new Vector3().fromArray(max)).applyMatrix4(this.group.matrixWorld);
    this.box = box(data.bounds);
    this.firstBox = box(data.first_bounds);
    this.forces = this.recordedForces = new ForcesView(data, this.firstBox.getSize(new Vector3()).length());
    this.liveForces = null;
    this.group.add(this.forces.group);
  }

  /// Outermost points of all that is shown, in the scene: at all frames, or at the first one only.
  points(outermostOf, first) {
    const inFrame = (parts) =>
      parts.flatMap((part) => {
        const rotation = new Quaternion().fromArray(part.rotation);
        const origin = new Vector3().fromArray(part.origin);
        return outermostOf(part.mesh).map((point) => point.clone().applyQuaternion(rotation).add(origin));
      });
    const points = inFrame(this.data.scenery);
    const frames = first ? 1 : this.data.times.length;
    const step = Math.max(1, Math.floor(frames / kMostFrames));
    const rotation = new Quaternion();
    const origin = new Vector3();
    for (const body of this.data.bodies) {
      const own = body.parts.length > 0 ? inFrame(body.parts) : [new Vector3().fromArray(body.center)];
      for (let k = 0; k < frames; k += step) {
        rotation.fromArray(body.rotations, 4 * k).normalize();
        origin.fromArray(body.origins, 3 * k);
        for (const point of own) points.push(point.clone().applyQuaternion(rotation).add(origin));
      }
    }
    for (const line of this.data.lines)
      for (const own of line.points) for (let k = 0; k < frames; k += step) points.push(new Vector3().fromArray(own, 3 * k));
    return points.map((point) => point.applyMatrix4(this.group.matrixWorld));
  }

  /// Mean of the bodies' origins, in the scene.
  middle() {
    const sum = new Vector3();
    for (const node of this.bodies) sum.add(node.position);
    return sum.divideScalar(Math.max(this.bodies.length, 1)).applyMatrix4(this.group.matrixWorld);
  }

  seek(t) {
    const { frame, share } = frameAt(this.data.times, t);
    const next = new Vector3();
    const turned = new Quaternion();
    this.data.bodies.forEach((body, i) => {
      const node = this.bodies[i];
      node.position.fromArray(body.origins, 3 * frame);
      node.quaternion.fromArray(body.rotations, 4 * frame);
      if (share > 0) {
        node.position.lerp(next.fromArray(body.origins, 3 * frame + 3), share);
        node.quaternion.slerp(turned.fromArray(body.rotations, 4 * frame + 4), share);
      }
      node.quaternion.normalize();
    });
    this.trails?.choose(false);
    if (this.liveForces) this.liveForces.group.visible = false;
    this.forces = this.recordedForces;
    this.forces.group.visible = true;
    this.forces.seek(frame, share);
  }

  /// Bodies at poses [R p], row by row, at a time, and forces as they are then (live_record.js).
  place(W, time, forces) {
    this.trails?.choose(true);
    this.trails?.append(W, time);
    const matrix = new Matrix4();
    const size = new Vector3();
    this.bodies.forEach((node, i) => {
      matrix.set(...W.subarray(12 * i, 12 * i + 12), 0, 0, 0, 1).decompose(node.position, node.quaternion, size);
    });
    this.recordedForces.group.visible = false;
    if (!this.liveForces) {
      this.liveForces = new ForcesView(forces, this.recordedForces.size);
      this.group.add(this.liveForces.group);
    }
    this.forces = this.liveForces;
    this.forces.group.visible = true;
    this.forces.measure(this.recordedForces);
    this.forces.seek(0, 0);
  }

  /// Paths are of the live motion from when they are first asked for.
  showTrails(visible) {
    if (visible && !this.trails) {
      this.trails = new Trails(this.data.bodies);
      this.group.add(this.trails.group);
    }
    if (this.trails) this.trails.group.visible = visible;
  }
}

export class Stage {
  constructor(element, data) {
    this.element = element;
    this.scene = new Scene();
    this.scene.up.set(0, 0, 1);
    const geometries = data.meshes.map(geometryOf);
    const materials = new Map();
    const partOf = (part) => {
      const side = data.meshes[part.mesh].closed ? FrontSide : DoubleSide;
      const key = `${part.color} ${side}`;
      if (!materials.has(key)) {
        const color = new Color().setRGB(...part.color, SRGBColorSpace);
        materials.set(key, new MeshStandardMaterial({ color, roughness: 0.5, metalness: 0.08, side }));
      }
      const mesh = new Mesh(geometries[part.mesh], materials.get(key));
      mesh.position.fromArray(part.origin);
      mesh.quaternion.fromArray(part.rotation);
      mesh.castShadow = mesh.receiveShadow = true;
      return mesh;
    };
    const points = [];
    this.outermostOf = (mesh) => (points[mesh] ??= outermost(data.meshes[mesh]));
    this.mechanisms = data.mechanisms.map((mechanism) => new MechanismView(mechanism, partOf));
    this.box = new Box3();
    const first = new Box3();
    for (const mechanism of this.mechanisms) {
      this.scene.add(mechanism.group);
      this.box.union(mechanism.box);
      first.union(mechanism.firstBox);
    }
    const size = (box) => box.getSize(new Vector3()).length();
    this.follows = size(this.box) > kFarAway * size(first);
    this.middle = this.meanOfMechanisms();
    const falls = this.follows && this.box.max.z - this.box.min.z > kFarAway * size(first);
    if (this.follows) this.box = first;
    this.bounds = this.box.getBoundingSphere(new Sphere());
    this.bounds.radius = Math.max(this.bounds.radius, 1e-3);
    this.addGround(this.box.min.z);
    this.grid.visible = this.floor.visible = !falls;
    this.addLights();
    this.startDrawing();
  }

  /// Grid that fades into the background, and a floor that only shows shadows.
  addGround(height) {
    const { center, radius } = this.bounds;
    const z = height - 0.01 * radius;
    const spacing = roundLength(radius / 3);
    this.spacing = spacing;
    this.away = new Vector3();  // how far the camera has followed the motion
    const lines = Math.ceil((6 * radius) / spacing);
    const x0 = Math.round(center.x / spacing) * spacing;
    const y0 = Math.round(center.y / spacing) * spacing;
    const points = [];
    // A piece for each cell: long lines that pass behind the camera are not drawn well everywhere.
    for (let i = -lines; i <= lines; ++i) {
      for (let k = -lines; k < lines; ++k) {
        const [a, b, c] = [i * spacing, k * spacing, (k + 1) * spacing];
        points.push(x0 + b, y0 + a, z, x0 + c, y0 + a, z);
        points.push(x0 + a, y0 + b, z, x0 + a, y0 + c, z);
      }
    }
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(new Float32Array(points), 3));
    this.grid = new LineSegments(geometry, new LineBasicMaterial());
    this.floor = new Mesh(new CircleGeometry(9 * radius, 48), new ShadowMaterial());
    this.floorCenter = new Vector3(center.x, center.y, z - 0.002 * radius);
    this.floor.position.copy(this.floorCenter);
    this.floor.receiveShadow = true;
    this.scene.add(this.grid, this.floor);
  }

  addLights() {
    const { center, radius } = this.bounds;
    this.hemisphere = new HemisphereLight();
    this.hemisphere.position.set(0, 0, 1);
    this.key = new DirectionalLight();
    this.key.position.copy(center).addScaledVector(new Vector3(-0.45, -0.55, 1.25).normalize(), 4 * radius);
    this.key.target.position.copy(center);
    this.key.castShadow = true;
    this.key.shadow.mapSize.set(2048, 2048);
    const camera = this.key.shadow.camera;
    camera.left = camera.bottom = -1.6 * radius;
    camera.right = camera.top = 1.6 * radius;
    camera.near = 0.5 * radius;
    camera.far = 9 * radius;
    this.key.shadow.normalBias = 0.004 * radius;
    this.key.shadow.bias = -0.0004;
    this.key.shadow.radius = 5;
    this.scene.add(this.hemisphere, this.key, this.key.target);
  }

  /// Camera, controls and renderer; without WebGL all but the picture works.
  startDrawing() {
    const { radius } = this.bounds;
    this.camera = new PerspectiveCamera(32, 1, 0.02 * radius, 60 * radius);
    this.camera.up.set(0, 0, 1);
    this.renderer = null;
    this.waiting = false;
    try {
      this.renderer = new WebGLRenderer({ antialias: true, preserveDrawingBuffer: true });
    } catch {
      const note = document.createElement("p");
      note.className = "note";
      note.textContent = "This browser offers no WebGL: plots and times work, the picture cannot be drawn.";
      this.element.append(note);
      return;
    }
    this.renderer.toneMapping = ACESFilmicToneMapping;
    this.renderer.shadowMap.enabled = true;
    this.renderer.shadowMap.type = PCFShadowMap;
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio, 2));
    this.element.append(this.renderer.domElement);
    // Reflections on these materials are blurred: a small picture looks the same, and most of the time to open a page without a GPU is saved.
    const environment = new PMREMGenerator(this.renderer);
    this.scene.environment = environment.fromScene(new RoomEnvironment(), 0.04, 0.1, 100, { size: 64 }).texture;
    this.scene.environmentRotation.set(Math.PI / 2, 0, 0);
    this.controls = new OrbitControls(this.camera, this.renderer.domElement);
    this.controls.addEventListener("change", () => this.draw());
    new ResizeObserver(() => this.resize()).observe(this.element);
    this.resize();
  }

  resize() {
    const { clientWidth: width, clientHeight: height } = this.element;
    if (!this.renderer || width === 0 || height === 0) return;
    this.renderer.setSize(width, height);
    // The camera looks at what lies below the heading, and draws what is behind it too.
    const above = Math.min(document.getElementById("heading")?.offsetHeight ?? 0, height / 3);
    this.camera.aspect = width / (height - above);
    this.camera.setViewOffset(width, height - above, 0, -above, width, height);
    this.draw();
  }

  /// Looks at all that moves, or at one mechanism: as near as the points that its bodies pass allow.
  frame(index) {
    if (!this.controls) return;
    const chosen = index === undefined ? this.mechanisms : [this.mechanisms[index]];
    const right = new Vector3(0, 0, 1).cross(kView).normalize();
    const up = kView.clone().cross(right);
    const slopes = [this.camera.aspect, 1].map((x) => (x * Math.tan((this.camera.fov * Math.PI) / 360)) / kMargin);
    // Where the four sides of the picture touch the points: along `right` and `up`, each way.
    const sides = [[-Infinity, -Infinity], [-Infinity, -Infinity]];
    let [far, near] = [Infinity, -Infinity];
    const points = chosen.flatMap((mechanism) => mechanism.points(this.outermostOf, this.follows));
    for (const point of points) {
      const depth = point.dot(kView);
      [far, near] = [Math.min(far, depth), Math.max(near, depth)];
      [right, up].forEach((axis, i) => {
        const aside = point.dot(axis);
        sides[i][0] = Math.max(sides[i][0], aside + slopes[i] * depth);
        sides[i][1] = Math.max(sides[i][1], -aside + slopes[i] * depth);
      });
    }
    const place = Math.max(near + 0.1 * this.bounds.radius, ...sides.map(([a, b], i) => (a + b) / (2 * slopes[i])));
    const target = kView.clone().multiplyScalar((far + near) / 2);
    for (const axis of [right, up]) target.addScaledVector(axis, middleSeen(points, axis, place));
    target.add(this.away);
    this.camera.position.copy(target).addScaledVector(kView, place - (far + near) / 2);
    this.controls.target.copy(target);
    this.controls.update();
    this.draw();
  }

  /// Where a body's origin is in the picture: from -1, left and below, to 1; or null.
  onScreen(bodyName, mechanismName) {
    const found = this.find(bodyName, mechanismName);
    if (!found || !this.renderer) return null;
    this.camera.updateMatrixWorld();
    const { x, y } = new Vector3().setFromMatrixPosition(found.node.matrixWorld).project(this.camera);
    return [x, y];
  }

  meanOfMechanisms() {
    const sum = new Vector3();
    for (const mechanism of this.mechanisms) sum.add(mechanism.middle());
    return sum.divideScalar(Math.max(this.mechanisms.length, 1));
  }

  seek(t) {
    for (const mechanism of this.mechanisms) mechanism.seek(t);
    if (this.follows) this.followTheMiddle();
    else this.goAlong(this.away.clone().negate());
    this.draw();
  }

  /// The same of mechanisms as they are now: poses of the bodies and forces, where there are. Where the recorded motion stays
  /// near, the picture goes along with what leaves the middle of it.
  showLive(moments) {
    this.mechanisms.forEach((mechanism, i) => moments[i] && mechanism.place(moments[i].poses, moments[i].time, moments[i].forces));
    if (this.follows) {
      this.followTheMiddle();
    } else {
      const off = this.meanOfMechanisms().sub(this.bounds.center).sub(this.away);
      const beyond = 1 - this.bounds.radius / 3 / off.length();
      if (beyond > 0) this.goAlong(off.multiplyScalar(beyond));
    }
    this.draw();
  }

  followTheMiddle() {
    const middle = this.meanOfMechanisms();
    this.goAlong(middle.clone().sub(this.middle));
    this.middle = middle;
  }

  /// Camera, ground and light go along with a motion that leads far away; the grid by whole cells.
  goAlong(moved) {
    if (moved.lengthSq() === 0) return;
    this.camera?.position.add(moved);
    this.controls?.target.add(moved);
    this.key.position.add(moved);
    this.key.target.position.add(moved);
    this.away.add(moved);
    const cells = (x) => Math.round(x / this.spacing) * this.spacing;
    this.grid.position.set(cells(this.away.x), cells(this.away.y), 0);
    this.floor.position.set(this.away.x, this.away.y, 0).add(this.floorCenter);
  }

  clearLiveTrails() {
    for (const { trails } of this.mechanisms) trails?.clear();
  }
  showTrails(visible) {
    for (const mechanism of this.mechanisms) mechanism.showTrails(visible);
    this.draw();
  }

  setTheme(theme) {
    const look = kLook[theme];
    this.scene.background = new Color(look.background);
    this.scene.fog = new Fog(look.background, 4.2 * this.bounds.radius, 11 * this.bounds.radius);
    this.scene.environmentIntensity = look.environment;
    this.grid.material.color.set(look.grid);
    this.floor.material.opacity = look.shadow;
    this.hemisphere.color.set(look.sky);
    this.hemisphere.groundColor.set(look.ground);
    this.hemisphere.intensity = look.hemisphere;
    this.key.intensity = look.key;
    this.draw();
  }

  /// Asks for a picture: one for all changes until the browser wants the next.
  draw() {
    if (!this.renderer || this.waiting) return;
    this.waiting = true;
    requestAnimationFrame(() => {
      this.waiting = false;
      this.renderer.render(this.scene, this.camera);
    });
  }

  /// A body's mechanism and node, placed as at the present time; or null if there is no such body.
  find(bodyName, mechanismName) {
    for (const mechanism of this.mechanisms) {
      if (mechanismName !== undefined && mechanism.data.name !== mechanismName) continue;
      const node = mechanism.bodies.find((body) => body.name === bodyName);
      if (!node) continue;
      this.scene.updateMatrixWorld(true);
      return { mechanism, node };
    }
    return null;
  }

  /// The forces of a mechanism, the first one unless named.
  forces(mechanismName) {
    return this.mechanisms.find(({ data }) => mechanismName === undefined || data.name === mechanismName)?.forces;
  }

  /// Pose of a body in its mechanism's world as the scene graph has it, or null if there is no such body.
  pose(bodyName, mechanismName) {
    const found = this.find(bodyName, mechanismName);
    return found && new Matrix4().copy(found.mechanism.group.matrixWorld).invert().multiply(found.node.matrixWorld);
  }
}

// The three-dimensional view.
import { Box3, ColorManagement, Group, LinearSRGBColorSpace, Matrix4,
  Mesh, MeshBasicMaterial, PerspectiveCamera, Quaternion, Raycaster, Scene, SphereGeometry, Vector2, Vector3,
  WebGLRenderer } from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import { Mechanism } from "./mechanism.js";
import { Surface, sharedUniforms } from "./surface.js";

ColorManagement.enabled = false;  // colours are those of the legend, as given

/** Box that joints and marks of the mechanism sweep [mm]. */
function extent(motion, surfaces) {
  const box = new Box3();
  const states = motion.joint_states;
  for (let i = 0; i + 2 < states.length; i += 9) {
    box.expandByPoint(new Vector3(states[i], states[i + 1], states[i + 2]));
  }
  const turn = new Matrix4(), one = new Vector3(1, 1, 1);
  motion.bodies.forEach((body, b) => {
    const local = new Box3().expandByPoint(new Vector3(...body.centre_mm));
    for (const surface of surfaces) {
      if (surface.part.body === body.name) local.union(surface.box);
    }
    for (let i = 7 * b; i < motion.poses.length; i += 7 * motion.bodies.length) {
      const [x, y, z, w, qx, qy, qz] = motion.poses.subarray(i, i + 7);
      turn.compose(new Vector3(x, y, z), new Quaternion(qx, qy, qz, w), one);
      box.union(local.clone().applyMatrix4(turn));
    }
  });
  return box;
}

export class Stage {
  constructor(canvas, data) {
    this.data = data;
    this.renderer = new WebGLRenderer({ canvas, antialias: true,
                                        preserveDrawingBuffer: true });
    this.renderer.outputColorSpace = LinearSRGBColorSpace;
    this.renderer.setClearColor(0xffffff);
    this.scene = new Scene();
    this.camera = new PerspectiveCamera(32, 1, 1, 1000);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.addEventListener("change", () => this.draw());
    this.shared = sharedUniforms();
    this.state = { t: 0, scale: 1, explode: 0, part: null };
    this.live = false;  // draws nothing before all stands
    this.#build();
  }

  #build() {
    const { motion, parts, shapes } = this.data;
    const bodies = new Set([...parts, ...shapes].map((part) => part.body)
      .filter(Boolean));
    this.surfaces = parts.map((part) => new Surface(part, this.shared));
    this.shapes = shapes.map((part) => new Surface(part, this.shared));
    const all = [...this.surfaces, ...this.shapes];
    this.box = extent(motion, all);
    this.size = Math.max(this.box.isEmpty() ? 0
      : this.box.getSize(new Vector3()).length(),
                         ...all.map((s) => s.size), 1e-3);
    this.mechanism = new Mechanism(motion, bodies, this.size);
    this.loose = new Group();
    for (const shape of this.shapes) shape.show(0, 0, false);  // grey
    all.forEach((surface) => {
      const body = motion.bodies.findIndex((b) => b.name === surface.part.body);
      (body < 0 ? this.loose : this.mechanism.bodies[body]).add(surface.mesh);
      this.#add_zones(surface);
    });
    this.scene.add(this.mechanism.group, this.loose);
    this.fit();
  }

  /** Singular zones as spheres around them. */
  #add_zones(surface) {
    for (const zone of surface.part.result?.singular_zones ?? []) {
      const sphere = new Mesh(new SphereGeometry(zone.radius_mm, 14, 10),
        new MeshBasicMaterial({ color: 0xb34700, wireframe: true }));
      sphere.position.set(...zone.at_mm);
      surface.mesh.add(sphere);
    }
  }

  /** Normal of the plane in which most joints turn. */
  get normal() {
    const sum = new Vector3();
    for (const joint of this.data.motion.joints) {
      const axis = new Vector3(...joint.axes_on_a[2]);
      sum.add(axis.dot(sum) < 0 ? axis.negate() : axis);
    }
    return sum.lengthSq() > 0 ? sum.normalize() : new Vector3(0, 0, 1);
  }

  /** What is shown, as a box in the world [mm]. */
  #shown() {
    const box = new Box3();
    for (const surface of [...this.surfaces, ...this.shapes]) {
      if (this.state.part ? surface.part === this.state.part
                          : surface.mesh.parent === this.loose) {
        box.union(surface.box.clone().applyMatrix4(surface.mesh.matrixWorld));
      }
    }
    if (!this.state.part) box.union(this.box);
    return box;
  }

  /** Looks at what is shown, from the front, and fills the picture with it. */
  fit() {
    const box = this.#shown();
    const centre = box.getCenter(new Vector3());
    const gravity = new Vector3(...this.data.motion.gravity_m_per_s2);
    const normal = this.normal;
    const up = gravity.lengthSq() > 0 ? gravity.negate().normalize()
                                      : new Vector3(0, 1, 0);
    if (Math.abs(up.dot(normal)) > 0.9) up.set(0, 1, 0);
    if (Math.abs(up.dot(normal)) > 0.9) up.set(1, 0, 0);
    const side = up.clone().cross(normal);
    const seen = normal.clone().addScaledVector(up, 0.28)
      .addScaledVector(side, 0.32).normalize();
    const right = up.clone().cross(seen).normalize();
    const upward = seen.clone().cross(right);
    const tall = Math.tan(this.camera.fov * Math.PI / 360);
    let away = 0;
    for (let k = 0; k < 8; ++k) {
      const arm = new Vector3(k & 1 ? box.max.x : box.min.x,
        k & 2 ? box.max.y : box.min.y, k & 4 ? box.max.z : box.min.z)
        .sub(centre);
      away = Math.max(away, arm.dot(seen) + Math.max(
        Math.abs(arm.dot(right)) / (tall * this.camera.aspect),
        Math.abs(arm.dot(upward)) / tall));
    }
    away = 1.08 * away + 1e-3 * this.size;
    this.camera.up.copy(up);
    this.camera.near = 0.01 * away;
    this.camera.far = 20 * away + 10 * this.size;
    this.camera.position.copy(centre).addScaledVector(seen, away);
    this.controls.target.copy(centre);
    this.camera.updateProjectionMatrix();
    this.controls.update();
    this.draw();
  }

  /** Fits the drawing to its element. */
  resize() {
    const { clientWidth: width, clientHeight: height } =
      this.renderer.domElement.parentElement;
    if (width === 0 || height === 0) return;
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    this.draw();
  }

  set range([low, high]) { this.shared.range.value = [low, high]; }
  set shading(share) { this.shared.shading.value = share; }

  /** Changes the state and shows it. */
  show(change = {}) {
    Object.assign(this.state, change);
    const { t, scale, explode, part } = this.state;
    const n = this.data.motion.bodies.length;
    const step = 0.35 * this.size * explode;
    const normal = this.normal;
    this.mechanism.show(t, (b) => b < 0 ? new Vector3()
      : normal.clone().multiplyScalar(step * (b - (n - 1) / 2)));
    for (const surface of this.surfaces) {
      surface.mesh.visible = !part || surface.part === part;
      if (surface.mesh.visible) {
        surface.show(t, scale, surface.part === part ||
                               surface.mesh.parent === this.loose);
      }
    }
    const alone = part !== null;
    for (const shape of this.shapes) shape.mesh.visible = !alone;
    for (const body of this.mechanism.bodies) {
      for (const child of body.children) {
        if (!child.userData.surface) child.visible = !alone;
      }
    }
    this.mechanism.symbols.visible = !alone && this.showJoints !== false;
    this.mechanism.forces.visible = !alone && this.showForces !== false;
    this.draw();
  }

  draw() {
    if (!this.live) return;
    this.renderer.render(this.scene, this.camera);
    this.onDraw?.();
  }

  /** What stands at a place of the canvas [CSS px]; null if nothing does. */
  pick(x, y) {
    const { clientWidth, clientHeight } = this.renderer.domElement;
    const ray = new Raycaster();
    ray.setFromCamera(new Vector2(2 * x / clientWidth - 1,
                                  1 - 2 * y / clientHeight), this.camera);
    const meshes = this.surfaces.map((s) => s.mesh).filter((m) => m.visible);
    const [hit] = ray.intersectObjects(meshes, false);
    if (!hit) return null;
    const { surface } = hit.object.userData;
    return { part: surface.part, point: surface.pointAt(hit) };
  }

  /** Looks straight at a point of a part's surface from close by.
   * @returns where it is seen [CSS px], and the stress it shows [MPa] */
  lookAt(part, point) {
    const surface = this.surfaces.find((s) => s.part === part);
    const { at, normal, inward } = surface.around(point);
    const turn = surface.mesh.matrixWorld;
    // a hair inside the triangle: beside the point stand other cells
    const place = at.clone().lerp(inward, 0.02).applyMatrix4(turn);
    const away = 0.004 * surface.size;
    this.controls.target.copy(place);
    this.camera.position.copy(place)
      .addScaledVector(normal.transformDirection(turn), away);
    this.camera.near = 1e-3 * away;
    this.camera.updateProjectionMatrix();
    this.controls.update();
    this.draw();
    const { clientWidth, clientHeight } = this.renderer.domElement;
    return { screen: { x: clientWidth / 2, y: clientHeight / 2 },
             stress: surface.mises[point] };
  }

  /** Where a point of a part is seen [CSS px]. */
  seen(part, position) {
    const surface = this.surfaces.find((s) => s.part === part);
    const local = typeof position === "number" ? surface.drawn(position)
                                               : new Vector3(...position);
    const at = surface.mesh.localToWorld(local).project(this.camera);
    const { clientWidth, clientHeight } = this.renderer.domElement;
    return { x: (at.x + 1) / 2 * clientWidth, y: (1 - at.y) / 2 * clientHeight,
             visible: surface.mesh.visible && Math.abs(at.z) < 1 };
  }
}

// The mechanism around the parts: poses, bodies without a mesh, joints, forces.
import { ArrowHelper, BoxGeometry, ConeGeometry, CylinderGeometry, Group, Mesh,
  MeshBasicMaterial, Quaternion, SphereGeometry, TorusGeometry, Vector3 }
  from "three";
import { moment } from "./data.js";

const POSE = 7, JOINT = 9, ACTION = 12;
const LINK = 0x7d8a94, JOINTS = 0x2b3a42, REACTION = 0xb34700, LOAD = 0x0072b2;

const point = (array, at) => new Vector3(array[at], array[at + 1], array[at + 2]);
const material = (color) => new MeshBasicMaterial({ color });

/** A rod between two points. */
function rod(from, to, radius, color) {
  const along = to.clone().sub(from);
  const mesh = new Mesh(new CylinderGeometry(radius, radius, along.length(), 12),
                        material(color));
  mesh.position.copy(from).addScaledVector(along, 0.5);
  mesh.quaternion.setFromUnitVectors(new Vector3(0, 1, 0), along.normalize());
  return mesh;
}

/** Symbols of joints, z along the axis. */
function symbol(type, s) {
  switch (type) {
    case "revolute": return new TorusGeometry(s, 0.3 * s, 10, 28);
    case "prismatic": return new BoxGeometry(1.4 * s, 1.4 * s, 3.2 * s);
    case "cylindrical": case "screw":
      return new CylinderGeometry(0.8 * s, 0.8 * s, 3 * s, 20)
        .rotateX(Math.PI / 2);
    case "spherical": return new SphereGeometry(1.1 * s, 20, 12);
    case "weld": return new BoxGeometry(1.5 * s, 1.5 * s, 1.5 * s);
    case "planar": return new BoxGeometry(3 * s, 3 * s, 0.4 * s);
    default: return new SphereGeometry(0.8 * s, 8, 6);
  }
}

/** Points of a body to which something is joined, in its frame [mm]. */
function pointsOf(motion, index) {
  const points = [];
  const add = (values) => {
    const p = new Vector3(...values);
    if (points.every((other) => other.distanceTo(p) > 1e-6)) points.push(p);
  };
  for (const joint of motion.joints) {
    if (joint.a === index) add(joint.on_a_mm);
    if (joint.b === index) add(joint.on_b_mm);
  }
  for (const marker of motion.markers) {
    if (marker.body === index) add(marker.at_mm);
  }
  return points;
}

export class Mechanism {
  /** @param size  of the whole [mm] */
  constructor(motion, drawn, size) {
    this.motion = motion;
    this.size = size;
    this.group = new Group();
    this.bodies = motion.bodies.map((body, b) => {
      const group = new Group();
      group.name = body.name;
      if (!drawn.has(body.name)) this.#stand_in(group, body, b);
      this.group.add(group);
      return group;
    });
    this.symbols = new Group();
    this.joints = motion.joints.map((joint) => this.#joint(joint));
    this.forces = new Group();
    this.reactions = motion.joints.map(() => this.#arrow(REACTION));
    this.loads = motion.forces.flatMap(() =>
      [this.#arrow(LOAD), this.#arrow(LOAD)]);
    this.group.add(this.symbols, this.forces);
    this.largest = this.#largest_force();
  }

  #stand_in(group, body, index) {
    const points = pointsOf(this.motion, index);
    const radius = 0.006 * this.size;
    const centre = new Vector3(...body.centre_mm);
    if (points.length < 2) points.push(centre);
    const few = points.length <= 4;
    const middle = points.reduce((sum, p) => sum.add(p), new Vector3())
      .multiplyScalar(1 / points.length);
    points.forEach((from, i) => {
      const ends = few ? points.slice(i + 1) : [middle];
      for (const to of ends) {
        if (from.distanceTo(to) > 1e-6) {
          group.add(rod(from, to, radius, LINK));
        }
      }
    });
    const mass = new Mesh(new SphereGeometry(1.8 * radius, 16, 10),
                          material(LINK));
    mass.position.copy(centre);
    group.add(mass);
  }

  #joint(joint) {
    const s = 0.014 * this.size;
    const mesh = new Mesh(symbol(joint.type, s), material(JOINTS));
    const grounded = joint.a < 0 || joint.b < 0;
    if (grounded) {
      const foot = new Mesh(new ConeGeometry(1.5 * s, 2.4 * s, 4),
                            material(LINK));
      foot.position.y = -1.6 * s;
      mesh.add(foot);
    }
    this.symbols.add(mesh);
    return mesh;
  }

  #arrow(color) {
    const arrow = new ArrowHelper(new Vector3(1, 0, 0), new Vector3(), 1, color);
    this.forces.add(arrow);
    return arrow;
  }

  #largest_force() {
    let largest = 0;
    const states = this.motion.joint_states;
    for (let i = 0; i < states.length; i += JOINT) {
      largest = Math.max(largest, point(states, i + 3).length());
    }
    const actions = this.motion.force_actions;
    for (let i = 0; i < actions.length; i += ACTION / 2) {
      largest = Math.max(largest, point(actions, i + 3).length());
    }
    return largest;
  }

  /** Between two instants, as a number of `step` numbers each stores it. */
  #mixed(array, step, count, at, item) {
    const low = point(array, (at.frame * count + item) * step);
    const high = point(array, (at.next * count + item) * step);
    return low.lerp(high, at.part);
  }

  /** Moves all to a time [s]. @param offset  of each body, exploded [mm] */
  show(t, offset) {
    const { motion } = this;
    const at = moment(motion.t_s, t);
    this.bodies.forEach((group, b) => {
      const n = motion.bodies.length;
      group.position.copy(this.#mixed(motion.poses, POSE, n, at, b));
      group.position.add(offset(b));
      const turn = (frame) => {
        const q = (frame * n + b) * POSE + 3;
        const [w, x, y, z] = motion.poses.subarray(q, q + 4);
        return new Quaternion(x, y, z, w);
      };
      group.quaternion.copy(turn(at.frame).slerp(turn(at.next), at.part));
      group.updateMatrixWorld();
    });
    this.#show_joints(at, offset);
  }

  #show_joints(at, offset) {
    const { motion } = this;
    const n = motion.joints.length;
    motion.joints.forEach((joint, j) => {
      const shift = offset(Math.max(joint.a, joint.b));
      const states = motion.joint_states;
      const place = this.#mixed(states, JOINT, n, at, j).add(shift);
      const mesh = this.joints[j];
      mesh.position.copy(place);
      mesh.quaternion.copy(this.#axis_turn(joint));
      const force = this.#mixed(states.subarray(3), JOINT, n, at, j);
      this.#point_arrow(this.reactions[j], place, force);
    });
    const actions = motion.force_actions;
    this.loads.forEach((arrow, k) => {
      const place = this.#mixed(actions, ACTION / 2, this.loads.length, at, k);
      const force = this.#mixed(actions.subarray(3), ACTION / 2,
                                this.loads.length, at, k);
      this.#point_arrow(arrow, place, force);
    });
  }

  /** Turns z into the joint's axis on body b, in the world. */
  #axis_turn(joint) {
    const on_b = joint.b >= 0;
    const body = this.bodies[on_b ? joint.b : joint.a];
    const axis = new Vector3(...(on_b ? joint.axes_on_b : joint.axes_on_a)[2]);
    if (body) axis.applyQuaternion(body.quaternion);
    return new Quaternion().setFromUnitVectors(new Vector3(0, 0, 1),
                                               axis.normalize());
  }

  #point_arrow(arrow, place, force) {
    const length = 0.22 * this.size * force.length() / (this.largest || 1);
    arrow.visible = length > 0.004 * this.size;
    if (!arrow.visible) return;
    arrow.position.copy(place);
    arrow.setDirection(force.clone().normalize());
    arrow.setLength(length, Math.min(0.04 * this.size, 0.4 * length),
                    Math.min(0.02 * this.size, 0.2 * length));
  }
}

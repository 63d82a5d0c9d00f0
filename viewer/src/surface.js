// A part's surface as three.js draws it.
import { Box3, BufferAttribute, BufferGeometry, DataTexture, DoubleSide,
  GLSL3, LinearFilter, Mesh, ShaderMaterial, Sphere, Vector3 } from "three";
import { colourBytes } from "./colour.js";

const COLOURS = 256;

const vertexShader = `
  in float stress;
  out float value;
  out vec3 place;
  void main() {
    value = stress;
    vec4 seen = modelViewMatrix * vec4(position, 1.0);
    place = seen.xyz;
    gl_Position = projectionMatrix * seen;
  }`;

const fragmentShader = `
  precision highp float;
  uniform sampler2D colours;
  uniform vec2 range;
  uniform float shading;
  uniform bool known;
  in float value;
  in vec3 place;
  out vec4 seen;
  void main() {
    float share = clamp((value - range.x) / (range.y - range.x), 0.0, 1.0);
    float at = (share * ${COLOURS - 1}.0 + 0.5) / ${COLOURS}.0;
    vec3 tone = known ? texture(colours, vec2(at, 0.5)).rgb : vec3(0.72);
    vec3 normal = normalize(cross(dFdx(place), dFdy(place)));
    float light = 0.45 + 0.55 * abs(normal.z);
    seen = vec4(tone * mix(1.0, light, shading), 1.0);
  }`;

/** Uniforms that all parts share. */
export function sharedUniforms() {
  const colours = new DataTexture(colourBytes(COLOURS), COLOURS, 1);
  colours.magFilter = colours.minFilter = LinearFilter;
  colours.needsUpdate = true;
  return { colours: { value: colours }, range: { value: [0, 1] },
           shading: { value: 1 } };
}

/** Vertices, each with the point of the part that it shows. A plate told by
 * its mid-plane gets both faces and its rim. */
function skin(part) {
  const source = [], heights = [], corners = [];
  const add = (point, z) => heights.push(z) && source.push(point) - 1;
  if (!part.faces_z_mm) {
    for (let p = 0; p < part.points; ++p) add(p, part.positions[3 * p + 2]);
    return { source, heights, corners: Array.from(part.corners) };
  }
  const [low, high] = part.faces_z_mm;
  for (const z of [low, high]) {
    for (let p = 0; p < part.points; ++p) add(p, z);
  }
  for (let c = 0; c < part.corners.length; c += 3) {
    const [a, b, d] = part.corners.subarray(c, c + 3);
    corners.push(a, d, b, a + part.points, b + part.points, d + part.points);
  }
  for (let e = 0; e < part.edges.length; e += 2) {
    const [a, b] = part.edges.subarray(e, e + 2);
    const [p, q, r, s] = [add(a, low), add(b, low), add(b, high), add(a, high)];
    corners.push(p, q, r, p, r, s);
  }
  return { source, heights, corners };
}

export class Surface {
  constructor(part, shared) {
    this.part = part;
    const { source, heights, corners } = skin(part);
    this.source = Int32Array.from(source);
    this.heights = Float32Array.from(heights);
    this.mises = new Float32Array(part.points);
    this.shifts = new Float32Array(part.places * part.displacement_components);
    this.geometry = new BufferGeometry();
    this.geometry.setIndex(corners);
    this.geometry.setAttribute("position",
      new BufferAttribute(new Float32Array(3 * source.length), 3));
    this.geometry.setAttribute("stress",
      new BufferAttribute(new Float32Array(source.length), 1));
    this.box = this.#box();
    this.geometry.boundingSphere = this.box.getBoundingSphere(new Sphere());
    this.geometry.boundingSphere.radius *= 1.5;  // room for displacements
    this.known = { value: true };
    this.mesh = new Mesh(this.geometry, new ShaderMaterial({
      glslVersion: GLSL3, vertexShader, fragmentShader, side: DoubleSide,
      uniforms: { ...shared, known: this.known } }));
    this.mesh.userData.surface = this;
  }

  #box() {
    const box = new Box3(), point = new Vector3();
    for (let p = 0; p < this.part.points; ++p) {
      box.expandByPoint(point.fromArray(this.part.positions, 3 * p));
    }
    for (const z of this.part.faces_z_mm ?? []) {
      box.expandByPoint(point.setZ(z));
    }
    return box;
  }

  /** Largest distance from the middle [mm]. */
  get size() { return this.geometry.boundingSphere.radius; }

  /** Shows the part at a time of the motion [s], displacements times `scale`;
   * without colours where cases, not the motion, load it, unless `cases`. */
  show(t, scale, cases) {
    const moment = this.part.moment(t);
    this.known.value = this.part.is_motion || cases;
    this.part.stress.fill(moment, this.mises);
    const moved = scale !== 0;
    if (moved) this.part.shift.fill(moment, this.shifts);
    const position = this.geometry.attributes.position;
    const stress = this.geometry.attributes.stress;
    const { positions, placeOf, places, displacement_components: components } =
      this.part;
    for (let v = 0; v < this.source.length; ++v) {
      const p = this.source[v];
      stress.array[v] = this.mises[p];
      for (let d = 0; d < 3; ++d) {
        const shift = moved && d < components
          ? scale * this.shifts[placeOf[p] + d * places] : 0;
        position.array[3 * v + d] =
          (d < 2 ? positions[3 * p + d] : this.heights[v]) + shift;
      }
    }
    stress.needsUpdate = position.needsUpdate = true;
  }

  /** The point nearest to where a ray met the surface. */
  pointAt({ face, point }) {
    const local = this.mesh.worldToLocal(point.clone());
    const position = this.geometry.attributes.position;
    const corner = new Vector3();
    let best = face.a, least = Infinity;
    for (const v of [face.a, face.b, face.c]) {
      const away = corner.fromBufferAttribute(position, v).distanceTo(local);
      if (away < least) [best, least] = [v, away];
    }
    return this.source[best];
  }

  /** A point with the normal and the middle of a triangle that has it. */
  around(point) {
    const index = this.geometry.index.array;
    const position = this.geometry.attributes.position;
    const corner = (k) => new Vector3().fromBufferAttribute(position, index[k]);
    // of a plate the upper face, which comes behind its lower one
    for (let c = index.length - 3; c >= 0; c -= 3) {
      const k = [0, 1, 2].findIndex((i) => this.source[index[c + i]] === point);
      if (k < 0 || (this.part.faces_z_mm &&
                    index[c + k] !== point + this.part.points)) continue;
      const [a, b, d] = [corner(c), corner(c + 1), corner(c + 2)];
      const normal = b.clone().sub(a).cross(d.clone().sub(a)).normalize();
      const inward = a.clone().add(b).add(d).multiplyScalar(1 / 3);
      return { at: corner(c + k), normal, inward };
    }
    throw new Error(`no triangle has point ${point}`);
  }

  /** A point as it is drawn now, in the part's frame [mm]. */
  drawn(point) {
    // of a plate the face that is seen: the upper one
    const v = this.part.faces_z_mm ? point + this.part.points : point;
    return new Vector3().fromBufferAttribute(
      this.geometry.attributes.position, v);
  }
}

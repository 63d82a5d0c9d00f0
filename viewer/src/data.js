// What clevis stored in the page, decoded (docs/results.md).
import { number } from "./format.js";

const ARRAYS = { f32: Float32Array, i8: Int8Array, i16: Int16Array,
                 u16: Uint16Array, u32: Uint32Array };

function bytesOf(base64) {
  const text = atob(base64);
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
  return bytes;
}

function numbers({ type, base64 }) {
  return new ARRAYS[type](bytesOf(base64).buffer);
}

/** A list of a packed part: its bytes by planes, its numbers by their code. */
function unpackedNumbers({ type, count, code, at }, bytes) {
  const list = new ARRAYS[type](count);
  const width = list.BYTES_PER_ELEMENT;
  const whole = new Uint8Array(list.buffer);
  for (let plane = 0; plane < width; ++plane) {
    for (let i = 0; i < count; ++i) {
      whole[width * i + plane] = bytes[at + plane * count + i];
    }
  }
  if (code === "firsts") {
    for (let i = 0, next = 0; i < count; ++i) {
      list[i] = next - list[i];
      if (list[i] === next) ++next;
    }
  } else if (code === "steps") {
    const bits = 8 * width;
    for (let i = 0, before = 0; i < count; ++i) {
      const folded = bits === 32 ? list[i] >>> 0 : list[i] & ((1 << bits) - 1);
      before += folded & 1 ? ~(folded >>> 1) : folded >>> 1;
      list[i] = before;  // in the type's own width
      before = list[i];
    }
  }
  return list;
}

function stored(id) {
  const element = document.getElementById(id);
  return element ? JSON.parse(element.textContent) : null;
}

/** A part, stored compressed (zlib, as base 64): the length of a header, the
 * header, and the lists of numbers that it tells of. */
async function unpacked(id) {
  const element = document.getElementById(id);
  if (!element) return null;
  const stream = new Blob([bytesOf(element.textContent)]).stream()
    .pipeThrough(new DecompressionStream("deflate"));
  const bytes = new Uint8Array(await new Response(stream).arrayBuffer());
  const end = 4 + new DataView(bytes.buffer).getUint32(0, true);
  const lists = bytes.subarray(end);
  return JSON.parse(new TextDecoder().decode(bytes.subarray(4, end)),
    (_, value) => value?.code ? unpackedNumbers(value, lists) : value);
}

/** A field of points over instants: Σ scale · column · coefficient. */
class Field {
  constructor(json, size) {
    this.size = size;
    this.columns = json.columns;
    this.scale = json.scale;
    this.coefficients = json.coefficients;
  }

  /** Weights of the columns between two frames. */
  weights({ frame, next, part }) {
    const n = this.columns.length;
    return this.scale.map((scale, k) =>
      scale * ((1 - part) * this.coefficients[frame * n + k] +
               part * this.coefficients[next * n + k]));
  }

  /** All values at a moment, written into `target`. */
  fill(moment, target) {
    target.fill(0);
    this.weights(moment).forEach((weight, k) => {
      const column = this.columns[k];
      if (weight === 0) return;
      for (let i = 0; i < this.size; ++i) target[i] += weight * column[i];
    });
    return target;
  }

  /** One value at a frame. */
  value(index, frame) {
    const n = this.columns.length;
    let sum = 0;
    for (let k = 0; k < n; ++k) {
      sum += this.scale[k] * this.coefficients[frame * n + k] *
             this.columns[k][index];
    }
    return sum;
  }
}

/** Place of a time between ascending ones. */
export function moment(times, t) {
  let low = 0, high = times.length - 1;
  if (high <= 0 || t <= times[0]) return { frame: 0, next: 0, part: 0 };
  if (t >= times[high]) return { frame: high, next: high, part: 0 };
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (times[middle] <= t) low = middle; else high = middle;
  }
  return { frame: low, next: high,
           part: (t - times[low]) / (times[high] - times[low]) };
}

export class Part {
  constructor(json, result) {
    Object.assign(this, json);
    this.name = json.part;
    this.result = result;
    this.placeOf = json.point_places;
    this.positions = this.#positions();
    this.corners = json.triangles;
    this.edges = json.outline;
    this.stress = new Field(json.von_mises_MPa, json.points);
    this.shift = new Field(json.displacement_mm,
                           json.places * json.displacement_components);
    this.times = json.frames.t_s;
    this.shownCase = json.peak_frame;  // where cases load it, not the motion
  }

  /** x, y, z of the points, one after another [mm]. */
  #positions() {
    const { integers, scale, origin } = this.positions_mm;
    const positions = new Float32Array(3 * this.points);
    for (let p = 0; p < this.points; ++p) {
      for (let d = 0; d < 3; ++d) {
        positions[3 * p + d] = origin[d] +
          scale * integers[this.placeOf[p] + d * this.places];
      }
    }
    return positions;
  }

  /** Whether its frames follow one another in a time of their own: a blow. */
  get isBlow() {
    return !this.is_motion && this.times.length > 2 &&
           this.times.every((t, i) => i === 0 || t > this.times[i - 1]);
  }

  /** The peak that is judged, of result.json. */
  get peak() {
    return this.result.peak_outside_singular_zones ??
           this.result.peak_von_mises;
  }

  /** What its stress is held against the limit by: that of its vibration where
   * it governs, else the peak. */
  get governing() {
    const { vibration } = this.result;
    if (!vibration?.governs || !vibration.band_MPa) return this.peak;
    return { value_MPa: vibration.peak_MPa, band_MPa: vibration.band_MPa,
             group: vibration.group,
             case: `vibrating, t = ${number(vibration.instant_s)} s` };
  }

  /** Frames at a time of the motion, or at a case. */
  moment(t) {
    return this.is_motion ? moment(this.times, t)
                          : { frame: this.shownCase, next: this.shownCase,
                              part: 0 };
  }

  /** Stress of a point over the frames [MPa]. */
  historyOf(point) {
    return this.times.map((_, frame) =>
      Math.max(0, this.stress.value(point, frame)));
  }
}

/** Yield strength over the safety factor wanted [MPa], or null. */
export function stressLimit(part) {
  const factor = part.result.limits?.safety_factor;
  return factor ? part.definition.material.yield_strength_MPa / factor : null;
}

/** The moving part that the verdict hangs on: of those with the worst verdict
 * the one with the least safety over what is wanted. */
export function decisivePart(parts) {
  const rank = ({ result }) => ["fail", "not_judged"].indexOf(
    result.verdict.replace(/\W/g, "_"));
  const order = (part) => rank(part) < 0 ? 2 : rank(part);
  const safety = ({ result }) => (result.safety_factor || Infinity) /
    (result.limits?.safety_factor || 1);
  return parts.filter((part) => part.is_motion).sort((a, b) =>
    order(a) - order(b) || safety(a) - safety(b))[0];
}

/** Everything of the page. */
export async function load() {
  const result = stored("result");
  const motion = stored("motion");
  for (const key of ["t_s", "poses", "joint_states", "drive_states",
                     "force_states", "force_actions", "energies_J"]) {
    motion[key] = numbers(motion[key]);
  }
  const parts = [];
  for (let p = 0; ; ++p) {
    const json = await unpacked(`part-${p}`);
    if (!json) break;
    parts.push(new Part(json, result.parts[p]));
  }
  const shapes = [];  // of parts that could not be computed
  for (let s = 0; ; ++s) {
    const json = await unpacked(`shape-${s}`);
    if (!json) break;
    shapes.push(new Part(json, {}));
  }
  return { result, motion, parts, shapes, isCheck: "verdict" in result,
           watch: stored("watch") };
}

// What clevis stored in the page, decoded (docs/results.md).

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

function stored(id) {
  const element = document.getElementById(id);
  return element ? JSON.parse(element.textContent) : null;
}

/** What is stored compressed (zlib, as base 64). */
async function unpacked(id) {
  const element = document.getElementById(id);
  if (!element) return null;
  const stream = new Blob([bytesOf(element.textContent)]).stream()
    .pipeThrough(new DecompressionStream("deflate"));
  return JSON.parse(await new Response(stream).text());
}

/** A field of points over instants: Σ scale · column · coefficient. */
class Field {
  constructor(json, size) {
    this.size = size;
    this.columns = json.columns.map(numbers);
    this.scale = json.scale;
    this.coefficients = numbers(json.coefficients);
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
    this.positions = numbers(json.positions_mm);
    this.corners = numbers(json.triangles);
    this.edges = numbers(json.outline);
    this.stress = new Field(json.von_mises_MPa, json.points);
    this.shift = new Field(json.displacement_mm,
                           json.points * json.displacement_components);
    this.times = json.frames.t_s;
    this.shownCase = json.peak_frame;  // where cases load it, not the motion
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
  return { result, motion, parts, isCheck: "verdict" in result,
           watch: stored("watch") };
}

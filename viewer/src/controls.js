// Controls below the picture: time, what is shown, and how.
import { h } from "./dom.js";
import { number } from "./format.js";
import { moment } from "./data.js";

const SPEEDS = [0.1, 0.25, 0.5, 1, 2, 4];
const SECONDS = 6;  // that a motion takes at speed 1 on the screen

export class Timeline {
  /** @param times  instants that are stepped through [s] */
  constructor(times, onTime) {
    this.times = times;
    this.onTime = onTime;
    this.t = times[0] ?? 0;
    const button = (label, title, action) => h("button",
      { type: "button", "aria-label": title, title, onclick: action }, label);
    this.playing = button("Play", "Play", () => this.toggle());
    this.slider = h("input", { type: "range", min: 0, step: 1, value: 0,
      max: Math.max(0, times.length - 1), "aria-label": "Instant",
      oninput: () => this.go(times[this.slider.valueAsNumber]) });
    this.clock = h("output", { class: "clock" });
    this.speed = h("select", { "aria-label": "Speed" }, SPEEDS.map((s) =>
      h("option", { value: s, selected: s === 1 }, `${number(s)} ×`)));
    this.element = h("div", { class: "timeline", role: "group",
                              "aria-label": "Time" },
      button("|‹", "First instant", () => this.go(times[0])),
      button("‹", "Previous instant", () => this.step(-1)),
      this.playing,
      button("›", "Next instant", () => this.step(1)),
      button("›|", "Last instant", () => this.go(times[times.length - 1])),
      this.slider, this.clock, this.speed);
  }

  /** Stops at a time [s]. */
  go(t) {
    this.stop();
    this.#set(t);
  }

  step(by) {
    const { frame, next, part } = moment(this.times, this.t);
    const at = by > 0 ? (part > 0 ? next : frame + 1) : part > 0 ? frame : frame - 1;
    this.go(this.times[Math.min(this.times.length - 1, Math.max(0, at))]);
  }

  toggle() {
    if (this.request) return this.stop();
    const last = this.times[this.times.length - 1];
    if (this.t >= last) this.#set(this.times[0]);
    this.#label("Pause");
    let before = null;
    const tick = (now) => {
      const rate = (last - this.times[0]) / SECONDS * Number(this.speed.value);
      const t = this.t + (before === null ? 0 : (now - before) / 1000 * rate);
      before = now;
      if (t >= last) return this.go(last);
      this.#set(t);
      this.request = requestAnimationFrame(tick);
    };
    this.request = requestAnimationFrame(tick);
  }

  stop() {
    cancelAnimationFrame(this.request);
    this.request = null;
    this.#label("Play");
  }

  #label(text) {
    this.playing.textContent = this.playing.title = text;
    this.playing.setAttribute("aria-label", text);
  }

  #set(t) {
    this.t = t;
    const { frame, next, part } = moment(this.times, t);
    this.slider.value = part > 0.5 ? next : frame;
    this.slider.setAttribute("aria-valuetext", `${number(t, 5)} s`);
    this.clock.textContent = `t = ${number(t, 5)} s`;
    this.onTime(t);
  }

  start() { this.#set(this.t); }
}

/** Which case of a part is shown. */
function caseControl(part, stage) {
  const select = h("select", { onchange: () => {
    part.shownCase = Number(select.value);
    stage.show();
  } }, part.frames.label.map((label, index) => h("option",
    { value: index, selected: index === part.shownCase }, label)));
  return h("label", {}, `Case of ${part.name} `, select);
}

/** When in the blow on a part. */
function blowControl(part, stage) {
  const shown = h("output", {}, part.frames.label[part.shownCase]);
  const slider = h("input", { type: "range", min: 0, step: 1,
    max: part.times.length - 1, value: part.shownCase, oninput: () => {
      part.shownCase = slider.valueAsNumber;
      shown.textContent = part.frames.label[part.shownCase];
      slider.setAttribute("aria-valuetext", shown.textContent);
      stage.show();
    } });
  return h("label", {}, `Blow on ${part.name} `, slider, shown);
}

/** Which parts, exploded, deformed, with what. */
export function viewControls(stage, data, names, onPart) {
  const check = (label, initial, change) => h("label", {},
    h("input", { type: "checkbox", checked: initial,
                 onchange: (event) => change(event.target.checked) }), label);
  const part = h("select", { "aria-label": "Part shown", onchange: () =>
    onPart(data.parts[Number(part.value)] ?? null) },
    h("option", { value: -1 }, "Whole mechanism"),
    data.parts.map((p, index) => h("option", { value: index }, p.name)));
  const explode = h("input", { type: "range", min: 0, max: 1, step: 0.02,
    value: 0, oninput: () => stage.show({ explode: explode.valueAsNumber }) });
  const scale = h("input", { type: "number", min: 0, step: "any", value: 1,
    onchange: () => stage.show({ scale: Math.max(0, Number(scale.value) || 0) }) });
  const cases = data.parts.filter((p) => !p.is_motion && p.times.length > 1)
    .map((p) => p.isBlow ? blowControl(p, stage) : caseControl(p, stage));
  const moves = data.motion.bodies.length > 0;
  return { part, element: h("div", { class: "view", role: "group",
                                     "aria-label": "View" },
    data.parts.length > 1 && h("label", {}, "Show ", part),
    cases,
    moves && h("label", {}, "Exploded ", explode),
    data.parts.length > 0 && h("label", {}, "Deformation × ", scale),
    data.parts.length > 0 && check("Light", true, (on) => {
      stage.shading = on ? 1 : 0;
      stage.draw();
    }),
    moves && check("Joints", true, (on) => {
      stage.showJoints = names.shown = on;
      stage.show();
    }),
    moves && check("Forces", data.parts.length === 0, (on) => {
      stage.showForces = on;
      stage.show();
    }),
    h("button", { type: "button", onclick: () => stage.fit() }, "Fit")) };
}

// What a point says: numbers now, its worst instant, its stress over time.
import { Chart } from "./charts.js";
import { h } from "./dom.js";
import { number, vector, withUnit } from "./format.js";

export class Picked {
  constructor(stage, onTime) {
    this.stage = stage;
    this.onTime = onTime;
    this.element = h("section", { class: "picked", "aria-live": "polite",
                                  "aria-label": "Picked point" },
      h("p", {}, "Click on a part, or on the mark of its worst point."));
    this.chart = null;
  }

  /** @param point  of the part's surface */
  show(part, point, { worst = false } = {}) {
    Object.assign(this, { part, point });
    const history = part.historyOf(point);
    const frame = history.indexOf(Math.max(...history));
    const { positions } = part;
    this.now = h("dd");
    const entries = [
      ["Part", part.name],
      ["At (x; y; z), frame of the part",
       `${vector(positions.slice(3 * point, 3 * point + 3))} mm`],
      ["Stress now", this.now],
      ["Largest here", withUnit(history[frame], "MPa")],
      ["When", part.frames.label[frame]]];
    if (worst) {
      const { peak } = part;
      entries.push(["Peak of the part, judged",
        `${number(peak.value_MPa, 6)} MPa at (${vector(peak.at_mm)}) mm, ` +
        `${peak.group}, ${peak.case}`]);
      if (peak.field_maximum_MPa) {
        entries.push(["Largest stress of the field as solved",
                      withUnit(peak.field_maximum_MPa, "MPa", 6)]);
      }
    }
    const inTime = part.is_motion || part.isBlow;
    const times = inTime ? part.times : part.times.map((_, i) => i);
    this.chart = new Chart(`von Mises here${inTime ? "" : ", by case"}`,
      "MPa", times, [{ label: part.name, values: history }],
      { onTime: part.is_motion ? this.onTime : undefined });
    this.element.replaceChildren(...[
      h("h3", {}, worst ? `Worst point of ${part.name}` : `Point of ${part.name}`),
      h("dl", {}, entries.map(([name, value]) =>
        [h("dt", {}, name), value instanceof Node ? value : h("dd", {}, value)])),
      this.chart.element,
      part.is_motion && h("button", { type: "button", onclick: () =>
        this.onTime(part.times[frame]) }, "Go to its worst instant")].filter(Boolean));
    this.chart.resize();
    this.update(this.stage.state.t);
  }

  update(t) {
    if (!this.part) return;
    const surface = this.stage.surfaces.find((s) => s.part === this.part);
    this.now.textContent = withUnit(Math.max(0, surface.mises[this.point]), "MPa");
    if (this.part.is_motion) this.chart.time = t;
  }
}

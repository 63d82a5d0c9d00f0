// Quantities over time, with the moment that is shown; a click goes there.
import uPlot from "uplot";
import { DASHES, SERIES } from "./colour.js";
import { h } from "./dom.js";
import { number } from "./format.js";

const LIMIT = "#8c1d00";  // as in the stylesheet

/** @param series  [{ label, values }], over `times` [s]
 *  @param limits  [{ label, value }]: level lines
 *  @param bands  [{ series, low, high }]: in which the largest value of series
 *    number `series` lies, over all times */
export class Chart {
  constructor(title, unit, times, series, { onTime, limits = [], bands = [] } = {}) {
    this.title = title;
    this.t = null;
    this.bands = bands;
    this.holder = h("div", { class: "plot" });
    this.element = h("figure", { class: "chart" },
      h("figcaption", {}, `${title} [${unit}] over time [s]`), this.holder);
    const all = [...series.map((one, k) => ({ ...one,
      stroke: SERIES[k % SERIES.length],
      dash: DASHES[Math.floor(k / SERIES.length) % DASHES.length || k % 4] })),
    ...limits.map(({ label, value }) => ({
      label, values: times.map(() => value), stroke: LIMIT, dash: [6, 4] }))];
    this.plot = new uPlot({
      width: 420, height: 220,
      scales: { x: { time: false },
                y: bands.length > 0 ? { range: (_, low, high) => uPlot.rangeNum(
                  Math.min(low, ...bands.map((band) => band.low)),
                  Math.max(high, ...bands.map((band) => band.high)), 0.1, true) } : {} },
      cursor: { drag: { x: false, y: false } },
      axes: [0, 1].map((axis) => ({
        stroke: "#222", size: axis ? 64 : 34,
        values: (_, splits) => splits.map((value) => number(value, 6)) })),
      series: [{ label: "t [s]", value: (_, t) => number(t, 6) },
        ...all.map(({ label, stroke, dash }) => ({
          label, width: 1.6, stroke, dash,
          points: { show: times.length === 1 },
          value: (_, value) => number(value) }))],
      hooks: { drawAxes: [(plot) => this.#draw_bands(plot)],
               draw: [(plot) => this.#draw_moment(plot)] },
    }, [Float64Array.from(times), ...all.map(({ values }) => values)],
    this.holder);
    this.plot.over.addEventListener("click", () => {
      const at = this.plot.cursor.idx;
      if (at !== null && at !== undefined) onTime?.(times[at]);
    });
  }

  /** Strips behind the curves, in their colours; 2 px at least. */
  #draw_bands(plot) {
    const { ctx, bbox } = plot;
    const least = 2 * devicePixelRatio;
    ctx.save();
    ctx.globalAlpha = 0.25;
    for (const { series, low, high } of this.bands) {
      const top = Math.floor(plot.valToPos(high, "y", true));
      const tall = Math.max(least, plot.valToPos(low, "y", true) - top);
      ctx.fillStyle = SERIES[series % SERIES.length];
      ctx.fillRect(bbox.left, top, bbox.width, tall);
    }
    ctx.restore();
  }

  #draw_moment(plot) {
    if (this.t === null) return;
    const x = Math.round(plot.valToPos(this.t, "x", true));
    const { ctx, bbox } = plot;
    ctx.save();
    ctx.strokeStyle = "#000";
    ctx.lineWidth = devicePixelRatio;
    ctx.setLineDash([]);
    ctx.beginPath();
    ctx.moveTo(x, bbox.top);
    ctx.lineTo(x, bbox.top + bbox.height);
    ctx.stroke();
    ctx.restore();
  }

  resize() {
    const width = this.holder.clientWidth;
    if (width > 0) this.plot.setSize({ width, height: 220 });
  }

  set time(t) {
    this.t = t;
    this.plot.redraw(false);
  }
}

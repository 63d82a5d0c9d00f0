// Small drawings: the band of a peak beside its limit, and how it converged.
import { h, svg } from "./dom.js";
import { number } from "./format.js";

/** Peak and band of a part beside its limit, on a scale that `most` ends. */
export function bandBar({ value, low, high, limit, most, unit }) {
  const width = 180, height = 26, x = (v) => 4 + (width - 8) * v / most;
  const label = `${number(value)} ${unit}, band ${number(low)} to ` +
    `${number(high)} ${unit}` +
    (limit ? `, limit ${number(limit)} ${unit}` : "");
  return svg("svg", { viewBox: `0 0 ${width} ${height}`, class: "bar",
                      role: "img", "aria-label": label },
    svg("line", { x1: x(0), x2: x(most), y1: 13, y2: 13, class: "axis" }),
    svg("rect", { x: x(low), width: Math.max(2, x(high) - x(low)), y: 5,
                  height: 16, class: "band" }),
    svg("line", { x1: x(value), x2: x(value), y1: 3, y2: 23, class: "value" }),
    limit && svg("line", { x1: x(limit), x2: x(limit), y1: 0, y2: height,
                           class: "limit" }));
}

/** What the lines of these bars mean. */
export function barLegend(hasLimits) {
  const key = (mark, text) => h("span", {},
    svg("svg", { viewBox: "0 0 14 26", "aria-hidden": "true" }, mark),
    text);
  const upright = (name) => svg("line", { x1: 7, x2: 7, y1: 2, y2: 24, class: name });
  return h("p", { class: "keys" },
    key(upright("value"), "peak"),
    key(svg("rect", { x: 1, width: 12, y: 5, height: 16, class: "band" }),
        "its band"),
    hasLimits && key(upright("limit"),
                     "limit: yield strength over the safety factor wanted"));
}

/** The peak by degree, its band as a band. */
export function convergence(peak) {
  const { sequence } = peak;
  if (!sequence || sequence.length < 2) return null;
  const width = 360, height = 190, left = 62, bottom = 34, top = 10;
  const peaks = sequence.map((member) => member.peak_MPa);
  const low = Math.min(...peaks, peak.band_MPa[0]);
  const high = Math.max(...peaks, peak.band_MPa[1]);
  const margin = 0.08 * (high - low || high || 1);
  const y = (v) => top + (height - top - bottom) *
    (high + margin - v) / (high - low + 2 * margin);
  const x = (k) => left + 20 + (width - left - 40) * k / (sequence.length - 1);
  const line = sequence.map((member, k) => `${x(k)},${y(member.peak_MPa)}`);
  return svg("svg", { viewBox: `0 0 ${width} ${height}`, class: "convergence",
    role: "img", "aria-label": "peak stress by degree: " + sequence.map(
      (m) => `p = ${m.degree}: ${number(m.peak_MPa)} MPa`).join(", ") },
    svg("rect", { x: left, width: width - left, y: y(peak.band_MPa[1]),
      height: Math.max(1, y(peak.band_MPa[0]) - y(peak.band_MPa[1])),
      class: "band" }),
    svg("polyline", { points: line.join(" "), class: "sequence" }),
    [low, high].map((v) => svg("text",
      { x: left - 6, y: y(v) + 4, "text-anchor": "end" }, number(v))),
    sequence.map((member, k) => [
      svg("circle", { cx: x(k), cy: y(member.peak_MPa), r: 3.5 }),
      svg("text", { x: x(k), y: height - 18, "text-anchor": "middle" },
        `p = ${member.degree}`),
      svg("text", { x: x(k), y: height - 4, "text-anchor": "middle" },
        `${member.dofs} dofs`)]));
}

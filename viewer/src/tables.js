// The result as tables.
import { h, table } from "./dom.js";
import { bandBar, barLegend, convergence } from "./figures.js";
import { stressLimit } from "./data.js";
import { band, number, vector, withUnit } from "./format.js";

const WORDS = { pass: "passes", fail: "fails", not_judged: "not judged",
                "not judged": "not judged" };

export const verdictWord = (verdict) => h("strong",
  { class: `verdict ${verdict.replace(/\W/g, "_")}` }, WORDS[verdict] ?? verdict);

/** One line per part: verdict, peak in its band beside the limit, why. */
export function verdicts(data, onPart) {
  const most = 1.05 * Math.max(...data.parts.map((part) =>
    Math.max(part.governing.band_MPa[1], stressLimit(part) ?? 0)));
  const rows = data.parts.map((part) => {
    const { governing: peak, result } = part;
    return [
      h("button", { type: "button", class: "link",
                    onclick: () => onPart(part) }, part.name),
      verdictWord(result.verdict),
      h("span", { class: "keep" }, `${number(peak.value_MPa)} MPa in ` +
        band(peak.band_MPa), bandBar({
        value: peak.value_MPa, low: peak.band_MPa[0], high: peak.band_MPa[1],
        limit: stressLimit(part), most, unit: "MPa" })),
      h("span", { class: "keep" }, `${peak.group}, ${peak.case}`),
      number(result.safety_factor),
      result.why || result.stopped_because];
  });
  for (const failure of data.result.failures ?? []) {
    rows.push([failure.part, verdictWord("not judged"), "–", "–", "–",
      `${failure.code}: ${failure.problem} ${failure.remedy}`]);
  }
  return [table("Verdict by part: peak von Mises stress, its band and its limit",
    ["Part", "Verdict", "Peak in its band", "Where and when", "Safety", "Why"], rows),
    data.parts.length > 0 && barLegend(data.parts.some(stressLimit))];
}

function pairs(caption, entries) {
  return table(caption, ["Quantity", "Value"],
               entries.filter(([, value]) => value !== null));
}

function beam(part) {
  const { beam: b } = part.result;
  return pairs("Beam theory beside finite elements", [
    ["Peak by finite elements", withUnit(part.peak.value_MPa, "MPa")],
    ["Peak by beam theory", withUnit(b.peak_stress_MPa, "MPa")],
    ["Ratio", number(b.ratio_fe_to_beam)],
    ["Governing formula", b.governing || "–"],
    ["Deflection by finite elements", withUnit(part.result.deflection_mm, "mm")],
    ["Deflection by beam theory", withUnit(b.deflection_mm, "mm")],
    ["Euler's factor", number(b.buckling_safety)],
    ["Why they differ", b.reason || null]]);
}

function summary(part) {
  const { result: r, definition: d } = part;
  const { buckling: k } = r;
  return pairs(`Part ${part.name}`, [
    ["Verdict", `${WORDS[r.verdict] ?? r.verdict}. ${r.why}`],
    ["Model", `${r.model}, ${r.dofs} degrees of freedom, ${r.cells} cells`],
    ["Mesh", d.mesh],
    ["Stopped because", r.stopped_because],
    ["Material", `${d.material.name}: E ${number(d.material.youngs_modulus_GPa)}` +
      ` GPa, ν ${number(d.material.poissons_ratio)}, ` +
      `${number(d.material.density_kg_per_m3)} kg/m³, yield ` +
      `${number(d.material.yield_strength_MPa)} MPa`],
    ["Mass", withUnit(r.mass_kg, "kg")],
    ["Limits", Object.entries(r.limits ?? {}).filter(([, v]) => v !== null)
      .map(([key, v]) => `${key} ${typeof v === "number" ? number(v) : v}`)
      .join(", ")],
    ["Deflection", `${withUnit(r.deflection_mm, "mm")}, band ` +
      `${band(r.deflection_band_mm)} mm`],
    ["Strain energy", withUnit(r.strain_energy_mJ, "mJ")],
    ["Buckling factor", k?.factor ? `${k.is_lower_bound ? "above " : ""}` +
      `${number(k.factor)}, band ${band(k.band)}, ${k.case}` : k?.remark || null],
    ["Held by", part.definition.cases.flatMap((c) => [
      ...Object.entries(c.fixed).map(([group, axes]) =>
        `${c.name}: ${group} fixed in ${axes}`),
      ...c.held_by_pin.map((group) => `${c.name}: ${group} by its pin`)])
      .join("; ") || (part.body ? "nothing: free, its loads balance" : "–")],
    ["Loaded by", [...d.seats.map((seat) => `${seat.from} on ${seat.group}`),
      ...d.cases.flatMap((c) => [
        ...Object.entries(c.pins_N).map(([g, f]) =>
          `${c.name}: pin in ${g} (${vector(f)}) N`),
        ...Object.entries(c.pressure_MPa).map(([g, p]) =>
          `${c.name}: ${number(p)} MPa on ${g}`),
        ...Object.entries(c.traction_MPa).map(([g, t]) =>
          `${c.name}: (${vector(t)}) MPa on ${g}`),
        ...[[c.acceleration_m_per_s2, "acceleration less gravity", "m/s²"],
            [c.angular_velocity_rad_per_s, "angular velocity", "rad/s"],
            [c.angular_acceleration_rad_per_s2, "angular acceleration", "rad/s²"]]
          .filter(([values]) => values?.some((value) => value !== 0))
          .map(([values, what, unit]) =>
            `${c.name}: ${what} (${vector(values)}) ${unit}`)])].join("; ") || "–"],
    ["Notes", r.notes.join(" ") || null]]);
}

function zones(part) {
  const list = part.result.singular_zones ?? [];
  return list.length > 0 && table(
    "Singular zones: the model's stress has no bound there",
    ["Zone", "Exponent", "At [mm]", "Radius [mm]", "Above the peak elsewhere"],
    list.map((zone) => [zone.name, number(zone.exponent), vector(zone.at_mm),
      number(zone.radius_mm), zone.governs ? "yes" : "no"]));
}

/** Records with the same keys, as they are: keys name their units. */
function records(caption, list) {
  if (!list || list.length === 0) return null;
  const keys = Object.keys(list[0]).filter((key) =>
    list.every((record) => typeof record[key] !== "object" ||
                           Array.isArray(record[key]) || record[key] === null));
  const shown = (value) => typeof value === "number" ? number(value)
    : Array.isArray(value) ? value.map(shown).join("; ")
    : value === null || value === undefined ? "–" : String(value);
  return table(caption, keys.map((key) => key.replaceAll("_", " ")),
    list.map((record) => keys.map((key) => shown(record[key]))));
}

export const bearings = (data) => records("Bearings", data.result.bearings);

function blows(part) {
  return (part.result.impacts ?? []).map((blow) => table(
    `Blow ${blow.name} on ${part.name}`,
    ["Model", "Stress [MPa]", "Deflection [mm]", "Over the judged", "Remark"],
    (blow.models ?? []).map((row) => [row.model,
      number(row.stress_MPa ?? row.root_stress_MPa),
      number(row.deflection_mm), number(row.ratio), row.remark ?? ""])));
}

/** All that is told of a part. */
export function partSection(part) {
  const drawing = convergence(part.peak);
  return h("details", { class: "part" },
    h("summary", {}, `Part ${part.name}`),
    summary(part),
    drawing && h("figure", {}, h("figcaption", {},
      "The peak by degree [MPa]; its band is shaded"), drawing),
    beam(part), zones(part), blows(part),
    part.result.vibration &&
      records("Vibration under the loads of the motion", [part.result.vibration]),
    records("Impacts of the mechanism, as they load it", part.result.impact_durations),
    records("Probes", part.result.probes),
    records("Pins that hold it", part.result.pin_reactions));
}

export function mechanismTable(data) {
  const m = data.result.mechanism;
  const joints = m?.joints ?? data.result.joints ?? [];
  if (joints.length === 0) return null;
  return table("Joints: largest reactions",
    ["Joint", "Type", "Force [N]", "at [s]", "Moment [N m]", "at [s]"],
    joints.map((joint) => [joint.name,
      data.motion.joints.find((j) => j.name === joint.name)?.type ?? "",
      number(joint.peak_force_N), number(joint.at_s ?? joint.peak_force_at_s),
      number(joint.peak_moment_Nm ?? joint.peak_moment_N_m),
      number(joint.moment_at_s ?? joint.peak_moment_at_s)]));
}

export function checks(data) {
  return table("Self-checks of each part, relative",
    ["Part", "Equilibrium", "Residual", "Energy", "Compression",
     "Peak is the field's maximum"],
    data.parts.map(({ name, result: { self_checks: c } }) => [name,
      number(c.equilibrium, 2), number(c.residual, 2), number(c.energy, 2),
      number(c.compression, 2),
      c.reported_peak_is_field_maximum ? "yes" : "no"]));
}

export function inputs(data) {
  return table("Inputs",
    ["File", "What", "Changed last (UTC)", "Bytes", "Fingerprint"],
    data.motion.inputs.map((input) => [input.file, input.role,
      input.modified.replace("T", " ").replace("Z", ""), input.bytes,
      input.fnv1a]));
}

// Which charts a result has.
import { Chart } from "./charts.js";
import { stressLimit } from "./data.js";

const norm = (array, at) =>
  Math.hypot(array[at], array[at + 1], array[at + 2]);

/** Values of one of `count` items of `step` numbers each, over the instants. */
function column(times, array, step, count, item, value) {
  return Array.from(times, (_, i) => value(array, (i * count + item) * step));
}

/** The band of a part's peak over all times, if its curve shows that peak: not
 * where a singular zone is left out. */
function bandOf(part, series) {
  const { peak } = part;
  if (peak !== part.result.peak_von_mises) return [];
  return [{ series, low: peak.band_MPa[0], high: peak.band_MPa[1] }];
}

/** A level line per limit that the parts' stress comes near to: one far above
 * would press the curves flat. */
function limitsOf(parts) {
  const far = 4 * Math.max(...parts.map(({ peak }) => peak.band_MPa[1]));
  const names = new Map();
  for (const part of parts) {
    const limit = stressLimit(part);
    if (limit === null || limit > far) continue;
    names.set(limit, [...names.get(limit) ?? [], part.name]);
  }
  return [...names].map(([value, of]) => ({
    value, label: of.length === parts.length ? "limit" : `limit of ${of.join(", ")}` }));
}

/** Peak stress of the parts, each at its own times, on one axis of times. */
function peaks(parts, onTime) {
  const moving = parts.filter((part) => part.is_motion && part.times.length > 1);
  if (moving.length === 0) return [];
  const times = [...new Set(moving.flatMap((part) => part.times))]
    .sort((a, b) => a - b);
  const series = moving.map((part) => {
    const at = new Map(part.times.map((t, i) =>
      [t, part.frames.peak_von_mises_MPa[i]]));
    return { label: part.name, values: times.map((t) => at.get(t)) };
  });
  const bands = moving.flatMap((part, k) => bandOf(part, k));
  return [new Chart(`Peak von Mises stress${bands.length > 0 ? ", bands shaded" : ""}`,
                    "MPa", times, series, { onTime, bands, limits: limitsOf(moving) })];
}

export function charts({ motion, parts }, onTime) {
  const times = Array.from(motion.t_s);
  const list = peaks(parts, onTime);
  for (const part of parts.filter((p) => p.isBlow)) {
    list.push(new Chart(`Peak von Mises stress of ${part.name} in the blow`,
      "MPa", part.times, [{ label: part.name,
                            values: part.frames.peak_von_mises_MPa }],
      { bands: bandOf(part, 0), limits: limitsOf([part]) }));
  }
  if (times.length < 2) return list;
  const add = (title, unit, series) => {
    if (series.length > 0) {
      list.push(new Chart(title, unit, times, series, { onTime }));
    }
  };
  const joints = motion.joints;
  add("Joint forces", "N", joints.map((joint, j) => ({ label: joint.name,
    values: column(times, motion.joint_states, 9, joints.length, j,
                   (array, at) => norm(array, at + 3)) })));
  const driven = (turns) => motion.drives.flatMap((drive, d) =>
    drive.turns !== turns ? [] : [{ label: drive.name,
      values: column(times, motion.drive_states, 3, motion.drives.length, d,
                     (array, at) => array[at + 2]) }]);
  add("Drive forces", "N", driven(false));
  add("Drive torques", "N m", driven(true));
  const acting = (turns) => motion.forces.flatMap((force, e) =>
    force.turns !== turns ? [] : [{ label: force.name,
      values: column(times, motion.force_states, 3, motion.forces.length, e,
                     (array, at) => array[at + 1]) }]);
  add("Forces", "N", acting(false));
  add("Moments of forces", "N m", acting(true));
  if (motion.bodies.length > 0) {
    const [kinetic, potential] = [0, 1].map((k) =>
      column(times, motion.energies_J, 2, 1, 0, (array, at) => array[at + k]));
    const level = potential[0];
    add("Energies of the bodies", "J", [
      { label: "kinetic", values: kinetic },
      { label: "of gravity, from the start",
        values: potential.map((value) => value - level) },
      { label: "both", values: kinetic.map((value, i) =>
        value + potential[i] - level) }]);
  }
  return list;
}

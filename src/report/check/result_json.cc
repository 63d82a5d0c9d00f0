#include "report/check/result_json.h"

#include <nlohmann/json.hpp>

#include "report/parts/buckling_output.h"
#include "report/parts/part_impact_output.h"
#include "report/text/json_text.h"
#include "report/text/units.h"

namespace clevis::report {
namespace {

using assessment::PartResult;
using nlohmann::ordered_json;

ordered_json vector_mm(const Eigen::Vector3d& position) {
  const Eigen::Vector3d mm = millimetres(position);
  return {mm.x(), mm.y(), mm.z()};
}

ordered_json mechanism_json(const MechanismSummary& mechanism) {
  ordered_json joints = ordered_json::array();
  for (const JointPeaks& joint : mechanism.joints) {
    joints.push_back({{"name", joint.name},
                      {"peak_force_N", joint.force.value},
                      {"at_s", joint.force.at},
                      {"peak_moment_Nm", joint.moment.value},
                      {"moment_at_s", joint.moment.at}});
  }
  ordered_json drives = ordered_json::array();
  for (const DrivePeak& drive : mechanism.drives) {
    const char* key =
        drive.kind == EffortKind::kForce ? "peak_effort_N" : "peak_effort_Nm";
    drives.push_back({{"name", drive.name},
                      {key, drive.effort.value},
                      {"at_s", drive.effort.at}});
  }
  ordered_json change_points = ordered_json::array();
  for (const PassedChangePoint& point : mechanism.change_points) {
    change_points.push_back({{"at_s", point.at}});
    if (point.joint.empty()) continue;
    change_points.back()["compliant_force_N"] = point.largest_force;
    change_points.back()["joint"] = point.joint;
  }
  return {{"mobility", mechanism.mobility},
          {"redundant_constraints", mechanism.redundant_constraints},
          {"reactions_not_unique", mechanism.not_unique},
          {"instants", mechanism.instants},
          {"notes", mechanism.notes},
          {"change_points", change_points},
          {"drive_jumps", drive_jumps_json(mechanism.drive_jumps)},
          {"instants_left_out", mechanism.instants_left_out},
          {"impacts", impacts_json(mechanism.impacts)},
          {"max_closure_error_mm", millimetres(mechanism.max_closure_error)},
          {"max_power_balance_error", mechanism.max_power_balance_error},
          {"joints", joints},
          {"drives", drives}};
}

ordered_json shares_json(const assessment::ErrorShares& shares) {
  return {{"mesh", megapascals(shares.mesh)},
          {"model", megapascals(shares.model)},
          {"time", megapascals(shares.time)},
          {"sharing", megapascals(shares.sharing)}};
}

ordered_json peak_json(const assessment::PeakStress& peak) {
  ordered_json sequence = ordered_json::array();
  for (const assessment::SequenceMember& member : peak.sequence) {
    sequence.push_back({{"degree", member.degree},
                        {"dofs", member.dofs},
                        {"peak_MPa", megapascals(member.peak)},
                        {"strain_energy_mJ", millijoules(member.strain_energy)},
                        {"deflection_mm", millimetres(member.deflection)}});
  }
  return {
      {"value_MPa", megapascals(peak.value)},
      {"band_MPa", {megapascals(peak.band_low), megapascals(peak.band_high)}},
      {"discretization_error_MPa", megapascals(peak.discretization_error)},
      {"model_error_MPa", megapascals(peak.model_error)},
      {"errors_MPa", shares_json(peak.shares)},
      {"verdict", text(peak.verdict)},
      {"at_mm", vector_mm(peak.at)},
      {"group", peak.group},
      {"instant_s", peak.instant},
      {"case", peak.label},
      {"degree_nearby", peak.degree_nearby},
      {"field_maximum_MPa", megapascals(peak.field_maximum)},
      {"jump_MPa", megapascals(peak.jump)},
      {"sequence", sequence}};
}

ordered_json zones_json(const std::vector<assessment::ZoneResult>& zones) {
  ordered_json list = ordered_json::array();
  for (const assessment::ZoneResult& zone : zones) {
    ordered_json measured;  // null: the mesh is not graded there
    if (zone.exponent_measured != 0.0) measured = zone.exponent_measured;
    list.push_back({{"name", zone.name},
                    {"exponent", zone.exponent},
                    {"exponent_measured", measured},
                    {"at_mm", vector_mm(zone.at)},
                    {"radius_mm", millimetres(zone.radius)},
                    {"governs", zone.governs}});
  }
  return list;
}

ordered_json above_zero(double value) {
  return value > 0.0 ? ordered_json(value) : ordered_json();
}

ordered_json beam_json(const assessment::BeamComparison& beam,
                       const BeamImpactSummary& impact) {
  ordered_json buckling;  // null: the part is not in pressure
  if (beam.buckling_safety > 0.0) buckling = beam.buckling_safety;
  return {{"peak_stress_MPa", megapascals(beam.peak_stress)},
          {"governing", beam.governing},
          {"deflection_mm", millimetres(beam.deflection)},
          {"buckling_safety", buckling},
          {"impact_factor", above_zero(impact.factor)},
          {"impact_stress_MPa", above_zero(megapascals(impact.stress))},
          {"ratio_fe_to_beam", beam.ratio_fe_to_beam},
          {"reason", beam.reason}};
}

ordered_json probes_json(const std::vector<assessment::ProbeResult>& probes) {
  ordered_json list = ordered_json::array();
  for (const assessment::ProbeResult& probe : probes) {
    const bool length = is_displacement(probe);
    const auto in_unit = [length](double value) {
      return length ? millimetres(value) : megapascals(value);
    };
    list.push_back({{"name", probe.name},
                    {"quantity", probe.quantity},
                    {length ? "value_mm" : "value_MPa", in_unit(probe.value)},
                    {length ? "band_mm" : "band_MPa",
                     {in_unit(probe.band_low), in_unit(probe.band_high)}}});
  }
  return list;
}

ordered_json pin_reactions_json(const PartResult& part) {
  ordered_json list = ordered_json::array();
  for (const assessment::PinReaction& pin : part.pin_reactions) {
    const auto vector = [](const Eigen::Vector3d& v) {
      return ordered_json{v.x(), v.y(), v.z()};
    };
    list.push_back({{"case", pin.label},
                    {"bore", pin.group},
                    {"force_N", vector(pin.force)},
                    {"moment_Nm", vector(pin.moment)},
                    {"unique", pin.unique}});
  }
  return list;
}

ordered_json limits_json(const CheckReport& report, const std::string& part) {
  ordered_json limits = {{"safety_factor", nullptr},
                         {"deflection_mm", nullptr},
                         {"buckling", nullptr},
                         {"singular_zones", "count"}};
  const auto found = report.limits.find(part);
  if (found == report.limits.end()) return limits;
  if (found->second.safety_factor) {
    limits["safety_factor"] = *found->second.safety_factor;
  }
  if (found->second.deflection) {
    limits["deflection_mm"] = millimetres(*found->second.deflection);
  }
  if (found->second.buckling) limits["buckling"] = *found->second.buckling;
  if (found->second.exclude_singular_zones) {
    limits["singular_zones"] = "exclude";
  }
  return limits;
}

ordered_json part_json(const CheckReport& report, const PartResult& part) {
  const assessment::SelfChecks& checks = part.self_checks;
  const assessment::PartSeconds& seconds = part.seconds;
  ordered_json energy_error;  // null: too few degrees at one instant
  if (part.strain_energy_error >= 0.0) {
    energy_error = 100.0 * part.strain_energy_error;
  }
  ordered_json json = {
      {"name", part.name},
      {"verdict", text(part.verdict)},
      {"why", part.why},
      {"model", part.model},
      {"stopped_because", part.stopped_because},
      {"notes", part.notes},
      {"dofs", part.dofs},
      {"cells", part.cells},
      {"load_columns", part.load_columns},
      {"mass_kg", part.mass},
      {"peak_von_mises", peak_json(part.peak)},
      {"singular_zones", zones_json(part.singular_zones)},
      {"held_section", held_section_json(part.held)},
      {"safety_factor", part.safety_factor},
      {"deflection_mm", millimetres(part.deflection)},
      {"deflection_band_mm",
       {millimetres(part.deflection_low), millimetres(part.deflection_high)}},
      {"deflection_at_mm", vector_mm(part.deflection_at)},
      {"deflection_instant_s", part.deflection_instant},
      {"strain_energy_mJ", millijoules(part.strain_energy)},
      {"strain_energy_error_percent", energy_error},
      {"finite_motion", finite_motion_json(part.finite_motion)},
      {"buckling", buckling_json(part.buckling)},
      {"limits", limits_json(report, part.name)},
      {"beam", beam_json(part.beam, beam_impact(part))},
      {"impacts", part_impacts_json(part)},
      {"load_paces", load_paces_json(part)},
      {"vibration", vibration_json(part)},
      {"self_checks",
       {{"equilibrium", checks.equilibrium},
        {"residual", checks.residual},
        {"energy", checks.energy},
        {"compression", checks.compression},
        {"reported_peak_is_field_maximum",
         checks.reported_peak_is_field_maximum}}},
      {"probes", probes_json(part.probes)},
      {"seconds",
       {{"mesh", seconds.mesh},
        {"assemble", seconds.assemble},
        {"factor", seconds.factor},
        {"solve", seconds.solve},
        {"recover", seconds.recover},
        {"write", seconds.write},
        {"total", seconds.total}}}};
  if (!part.peak_outside.sequence.empty()) {
    json["peak_outside_singular_zones"] = peak_json(part.peak_outside);
  }
  if (!part.pin_reactions.empty()) {
    json["pin_reactions"] = pin_reactions_json(part);
  }
  return json;
}

ordered_json failure_json(const PartFailure& failure) {
  return {{"part", failure.name},
          {"code", failure.error.code()},
          {"place", failure.error.place()},
          {"problem", failure.error.problem()},
          {"remedy", failure.error.remedy()},
          {"exit_code", static_cast<int>(failure.error.exit_code())}};
}

}  // namespace

std::string result_json(const CheckReport& report) {
  ordered_json seconds = ordered_json::object();
  for (const auto& [phase, value] : report.seconds) seconds[phase] = value;
  ordered_json parts = ordered_json::array();
  for (const PartResult& part : report.parts) {
    parts.push_back(part_json(report, part));
    refuse_non_finite(parts.back(), "part " + part.name);
  }
  ordered_json failures = ordered_json::array();
  for (const PartFailure& failure : report.failures) {
    failures.push_back(failure_json(failure));
  }
  ordered_json document = {{"schema", kResultSchema},
                           {"version", report.version},
                           {"scene", report.scene},
                           {"file", report.file.string()},
                           {"verdict", text(overall_verdict(report))},
                           {"complete", report.complete},
                           {"seconds", seconds}};
  if (report.mechanism) {
    document["mechanism"] = mechanism_json(*report.mechanism);
    refuse_non_finite(document["mechanism"], "mechanism");
  }
  document["parts"] = parts;
  document["failures"] = failures;
  if (!report.bearings.empty()) {
    document["bearings"] = bearings_json(report.bearings);
    refuse_non_finite(document["bearings"], "bearings");
  }
  return json_text(document);
}

}  // namespace clevis::report

#include "report/check/result_json.h"

#include <nlohmann/json.hpp>

#include "report/check/check_quantities.h"
#include "report/parts/limit_quantities.h"
#include "report/parts/part_impact_output.h"
#include "report/parts/part_quantities.h"
#include "report/parts/peak_quantities.h"
#include "report/parts/probe_quantities.h"
#include "report/quantities/quantity_json.h"
#include "report/summary/mechanism_quantities.h"
#include "report/text/json_text.h"
#include "report/text/units.h"

namespace clevis::report {
namespace {

using assessment::PartResult;
using nlohmann::ordered_json;

ordered_json mechanism_json(const MechanismSummary& mechanism) {
  ordered_json json = quantities_json(mechanism, mechanism_quantities());
  json["joints"] = json["drives"] = ordered_json::array();
  for (const JointPeaks& joint : mechanism.joints) {
    json["joints"].push_back(quantities_json(joint, joint_quantities()));
  }
  for (const DrivePeak& drive : mechanism.drives) {
    json["drives"].push_back(
        quantities_json(drive, drive_quantities(), Unknown::kLeftOut));
  }
  ordered_json change_points = ordered_json::array();
  for (const PassedChangePoint& point : mechanism.change_points) {
    change_points.push_back({{"at_s", point.at}});
    if (point.joint.empty()) continue;
    change_points.back()["compliant_force_N"] = point.largest_force;
    change_points.back()["joint"] = point.joint;
  }
  json["reactions_not_unique"] = mechanism.not_unique;
  json["notes"] = mechanism.notes;
  json["change_points"] = change_points;
  json["drive_jumps"] = drive_jumps_json(mechanism.drive_jumps);
  json["impacts"] = impacts_json(mechanism.impacts);
  return json;
}

/// The p-sequence behind a peak.
ordered_json sequence_json(const assessment::PeakStress& peak) {
  ordered_json sequence = ordered_json::array();
  for (const assessment::SequenceMember& member : peak.sequence) {
    sequence.push_back({{"degree", member.degree},
                        {"dofs", member.dofs},
                        {"peak_MPa", megapascals(member.peak)},
                        {"strain_energy_mJ", millijoules(member.strain_energy)},
                        {"deflection_mm", millimetres(member.deflection)}});
  }
  return sequence;
}

ordered_json zones_json(const std::vector<assessment::ZoneResult>& zones) {
  ordered_json list = ordered_json::array();
  for (const assessment::ZoneResult& zone : zones) {
    ordered_json measured;  // null: the mesh is not graded there
    if (zone.exponent_measured) measured = *zone.exponent_measured;
    const Eigen::Vector3d at = millimetres(zone.at);
    list.push_back({{"name", zone.name},
                    {"exponent", zone.exponent},
                    {"exponent_measured", measured},
                    {"at_mm", {at.x(), at.y(), at.z()}},
                    {"radius_mm", millimetres(zone.radius)},
                    {"governs", zone.governs}});
  }
  return list;
}

ordered_json probes_json(const std::vector<assessment::ProbeResult>& probes) {
  ordered_json list = ordered_json::array();
  for (const assessment::ProbeResult& probe : probes) {
    list.push_back(
        quantities_json(probe, probe_quantities(), Unknown::kLeftOut));
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

/// The peak away from the zones, whose numbers are there already.
void add_outside_peak(const PartResult& part, ordered_json& json) {
  constexpr const char* kKey = "peak_outside_singular_zones";
  json.erase(kKey);
  if (!part.peak_outside) return;
  json[kKey] = quantities_json(*part.peak_outside, peak_quantities());
  json[kKey]["sequence"] = sequence_json(*part.peak_outside);
}

ordered_json part_json(const CheckReport& report, const PartResult& part) {
  ordered_json json = quantities_json(part, part_quantities());
  json["peak_von_mises"]["sequence"] = sequence_json(part.peak);
  add_outside_peak(part, json);
  json["notes"] = part.notes;
  json["singular_zones"] = zones_json(part.singular_zones);
  const auto limits = report.limits.find(part.name);
  json["limits"] = quantities_json(
      limits != report.limits.end() ? limits->second : part::Limits{},
      limit_quantities());
  json["impacts"] = part_impacts_json(part);
  json["impact_durations"] = duration_ratios_json(part);
  json["vibration"] = vibration_json(part);
  json["probes"] = probes_json(part.probes);
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
  ordered_json document = {{"schema", kSchema}};
  document.update(quantities_json(report, check_quantities()));
  document["inputs"] = inputs_json(report.inputs);
  document["seconds"] = seconds;
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

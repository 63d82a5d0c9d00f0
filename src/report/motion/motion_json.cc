#include "report/motion/motion_json.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <nlohmann/json.hpp>

#include "mechanism/definition/drive_names.h"
#include "mechanism/joints/joint_types.h"
#include "report/forces/coupling_output.h"
#include "report/forces/element_output.h"
#include "report/motion/motion_csv.h"
#include "report/summary/impact_output.h"
#include "report/summary/mechanism_summary.h"
#include "report/text/atomic_file.h"
#include "report/text/json_text.h"
#include "report/text/units.h"

namespace clevis::report {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using nlohmann::ordered_json;

constexpr double kDegree = std::numbers::pi / 180.0;

ordered_json vector_json(const Vector3d& v) {
  return {v.x() + 0.0, v.y() + 0.0, v.z() + 0.0};  // + 0.0: no −0
}

ordered_json plane_json(const Vector2d& v) {
  return {v.x(), v.y()};
}

ordered_json structure_json(const mechanism::Structure& s) {
  ordered_json json = {{"planar", s.planar},
                       {"moving_links", s.moving_links},
                       {"pairs", s.pairs},
                       {"mobility_chebyshev", s.chebyshev},
                       {"mobility_rank", s.mobility},
                       {"redundant_constraints", s.redundant},
                       {"redundant_in", s.redundant_in},
                       {"as_spatial",
                        {{"mobility_chebyshev", s.spatial_chebyshev},
                         {"mobility_rank", s.spatial_mobility},
                         {"redundant_constraints", s.spatial_redundant},
                         {"redundant_in", s.spatial_redundant_in}}}};
  if (!s.assur_corrected.empty()) {
    json["assur_corrected"] = {{"formula", s.assur_corrected},
                               {"class", s.assur_class_corrected},
                               {"inputs_taken", s.assur_inputs}};
  }
  if (!s.assur_none.empty()) json["assur_none"] = s.assur_none;
  if (!s.assur_published.empty()) {
    json["assur_published"] = {{"formula", s.assur_published},
                               {"class", s.assur_class_published}};
  }
  return json;
}

bool unique_throughout(const mechanism::Motion& motion, std::size_t joint) {
  return std::ranges::all_of(motion.instants, [joint](const auto& instant) {
    return instant.joints[joint].unique;
  });
}

ordered_json open_components_json(const MechanismSummary& summary,
                                  const std::string& joint) {
  ordered_json components = ordered_json::array();
  for (const OpenComponent& open : summary.open_components) {
    if (open.joint != joint) continue;
    const std::string unit = open.is_moment ? "_N_m" : "_N";
    components.push_back({{"component", open.component},
                          {"peak" + unit, open.peak.value},
                          {"at_s", open.peak.at},
                          {"spread" + unit, open.spread}});
  }
  return components;
}

ordered_json joints_json(const MotionReport& report,
                         const MechanismSummary& summary) {
  ordered_json joints = ordered_json::array();
  for (std::size_t j = 0; j < summary.joints.size(); ++j) {
    const JointPeaks& peaks = summary.joints[j];
    joints.push_back(
        {{"name", peaks.name},
         {"peak_force_N", peaks.force.value},
         {"peak_force_at_s", peaks.force.at},
         {"peak_moment_N_m", peaks.moment.value},
         {"peak_moment_at_s", peaks.moment.at},
         {"unique", unique_throughout(report.motion, j)},
         {"open_components", open_components_json(summary, peaks.name)}});
  }
  return joints;
}

/// How far the instants tell what loads lie between them.
ordered_json search_json(const MotionReport& report) {
  const mechanism::LoadSearch& search = *report.motion.search;
  ordered_json unseen = ordered_json::object();
  for (std::size_t i = 0; i < search.bodies.size(); ++i) {
    unseen[report.definition.bodies[i].name] = search.bodies[i];
  }
  return {{"looks", search.looks},
          {"complete", !search.ended},
          {"unseen_of_largest_load", unseen}};
}

ordered_json drives_json(const MotionReport& report,
                         const MechanismSummary& summary) {
  ordered_json drives = ordered_json::array();
  for (std::size_t d = 0; d < summary.drives.size(); ++d) {
    const DrivePeak& peak = summary.drives[d];
    const bool force = peak.kind == EffortKind::kForce;
    ordered_json shown = ordered_json::array();
    for (const std::size_t i : shown_instants(report.motion)) {
      const auto& drive = report.motion.instants[i].drives[d];
      shown.push_back(
          {{"t_s", report.motion.instants[i].t},
           {force ? "position_mm" : "position_deg",
            force ? millimetres(drive.position) : drive.position / kDegree},
           {force ? "effort_N" : "effort_N_m", drive.effort}});
    }
    drives.push_back(
        {{"joint", peak.name},
         {force ? "peak_effort_N" : "peak_effort_N_m", peak.effort.value},
         {"peak_effort_at_s", peak.effort.at},
         {"instants", shown}});
  }
  return drives;
}

ordered_json markers_json(const MotionReport& report) {
  ordered_json markers = ordered_json::array();
  for (const auto& marker : report.definition.markers) {
    ordered_json path = ordered_json::array();
    for (const std::size_t i : shown_instants(report.motion)) {
      const auto& instant = report.motion.instants[i];
      path.push_back({{"t_s", instant.t},
                      {"at_mm", vector_json(millimetres(
                                    marker_position(marker, instant)))}});
    }
    markers.push_back({{"name", marker.name}, {"path", path}});
  }
  return markers;
}

ordered_json slide_lever_json(const SlideLeverComparison& lever) {
  ordered_json rows = ordered_json::array();
  for (const SlideLeverRow& row : lever.rows) {
    rows.push_back(
        {{"t_s", row.t},
         {"cylinder_mm", millimetres(row.cylinder_length)},
         {"C_simulated_mm", plane_json(millimetres(row.simulated))},
         {"C_corrected_mm", plane_json(millimetres(row.corrected.C))},
         {"C_published_mm", plane_json(millimetres(row.published.C))},
         {"DC_simulated_mm", millimetres(row.simulated_DC)},
         {"DC_corrected_mm", millimetres(row.corrected.DC)},
         {"DC_published_mm", millimetres(row.published.DC)},
         {"q3_deg", row.corrected.q3 / kDegree},
         {"speed_ratio_simulated", row.simulated_ratio},
         {"speed_ratio_corrected", row.corrected.C_rate.norm()},
         {"speed_ratio_published", row.published.C_rate.norm()}});
  }
  return {{"marker", lever.marker},
          {"body", lever.body},
          {"rotation_deg", lever.rotation / kDegree},
          {"link_DC_mm", millimetres(lever.link_DC)},
          {"largest_DC_error_rel", lever.largest_DC_error},
          {"largest_C_distance_mm", millimetres(lever.largest_C_distance)},
          {"instants", rows}};
}

}  // namespace

std::string motion_json(const MotionReport& report) {
  const MechanismSummary summary =
      summarise(report.definition, report.structure, report.motion);
  ordered_json change_points = ordered_json::array();
  for (const auto& point : report.motion.change_points) {
    change_points.push_back({{"after_s", point.t_before},
                             {"before_s", point.t_after},
                             {"at_s", point.t}});
    if (!point.at) continue;
    ordered_json& json = change_points.back();
    for (std::size_t d = 0; d < report.definition.drives.size(); ++d) {
      const auto& drive = report.definition.drives[d];
      const bool turns = mechanism::drives_angle(report.definition, drive);
      const double q = point.at->drives[d].position;
      json["drives"].push_back(
          {{"joint", mechanism::drive_name(report.definition, drive)},
           {turns ? "position_deg" : "position_mm",
            turns ? q / kDegree : millimetres(q)}});
    }
    for (std::size_t j = 0; j < report.definition.joints.size(); ++j) {
      json["compliant_forces_N"][report.definition.joints[j].name] =
          point.at->joints[j].f_W.norm();
    }
  }
  ordered_json json = {
      {"schema", kSchema},
      {"version", report.version},
      {"scene", report.scene},
      {"structure", structure_json(report.structure)},
      {"motion",
       {{"instants", summary.instants},
        {"duration_s", report.motion.instants.back().t},
        {"max_closure_error_mm", millimetres(summary.max_closure_error)},
        {"max_power_balance_error", summary.max_power_balance_error},
        {"notes", summary.notes},
        {"change_points", change_points},
        {"drive_jumps", drive_jumps_json(summary.drive_jumps)}}},
      {"joints", joints_json(report, summary)},
      {"drives", drives_json(report, summary)},
      {"couplings", couplings_json(report)},
      {"markers", markers_json(report)}};
  if (const auto& run = report.motion.integration) {
    json["motion"]["integration"] = {
        {"method", run->method},
        {"steps", run->steps},
        {"implicit_steps", run->implicit_steps},
        {"rejected_steps", run->rejected},
        {"evaluations", run->evaluations},
        {"factorisations", run->factorisations},
        {"energy_error_J", run->energy_error},
        {"relative_energy_error", run->relative_energy_error}};
  }
  if (report.motion.search) {
    json["motion"]["search"] = search_json(report);
  }
  json["forces"] = forces_json(report);
  json["events"] = events_json(report);
  const auto impacts = named_impacts(report.definition, report.motion);
  json["impacts"] = impacts_json(impacts);
  if (!report.bearings.empty()) {
    json["bearings"] = bearings_json(report.bearings);
  }
  if (report.slide_lever) {
    json["slide_lever"] = slide_lever_json(*report.slide_lever);
  }
  refuse_non_finite(json, "simulate");
  return json_text(json);
}

}  // namespace clevis::report

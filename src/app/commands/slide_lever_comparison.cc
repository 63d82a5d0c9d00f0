#include "app/commands/slide_lever_comparison.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "base/messages/errors.h"
#include "mechanism/simulate.h"

namespace clevis::app {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector2d;
using machine::SlideLeverForm;
using mechanism::Instant;

machine::SlideLever lever_of(const scene::SlideLeverClosedForm& given) {
  return {.FD = given.FD,
          .ED = given.ED,
          .DC = given.DC,
          .EC = given.EC,
          .AD = given.AD,
          .DD1 = given.DD1};
}

const mechanism::MarkerDefinition& find_marker(
    const mechanism::MechanismDefinition& definition, const std::string& name) {
  const auto found = std::ranges::find(definition.markers, name,
                                       &mechanism::MarkerDefinition::name);
  if (found == definition.markers.end()) {
    throw Error("S007", "closed_form.slide_lever",
                "there is no marker \"" + name + "\"",
                "Add a [[marker]] of this name.");
  }
  return *found;
}

double cylinder_length(const scene::SlideLeverClosedForm& given,
                       const Instant& instant) {
  const double l_x =
      instant.drives[static_cast<std::size_t>(given.drive)].position;
  if (l_x > std::abs(given.FD - given.ED) && l_x < given.FD + given.ED &&
      given.DD1 <= given.FD) {
    return l_x;
  }
  throw Error(
      "S006", given.place,
      fmt::format("closed_form.slide_lever: FD = {:.6g} mm, ED = {:.6g} mm, "
                  "DD1 = {:.6g} mm "
                  "and l_x = {:.6g} mm make no triangle",
                  1e3 * given.FD, 1e3 * given.ED, 1e3 * given.DD1, 1e3 * l_x),
      "Give the lengths of the mechanism.");
}

/// The link that turns beside the triangle of the cylinder.
void require_link(const scene::SlideLeverClosedForm& given) {
  if (given.DC > std::abs(given.ED - given.EC) &&
      given.DC < given.ED + given.EC) {
    return;
  }
  throw Error(
      "S006", given.place,
      fmt::format("closed_form.slide_lever: ED = {:.6g} mm, EC = {:.6g} "
                  "mm and DC = {:.6g} mm make no triangle",
                  1e3 * given.ED, 1e3 * given.EC, 1e3 * given.DC),
      "Give the lengths of the mechanism.");
}

/// Turn of a body about world z over the motion, counted through.
double rotation(const mechanism::Motion& motion, std::size_t body) {
  double sum = 0.0;
  for (std::size_t i = 1; i < motion.instants.size(); ++i) {
    const Matrix3d step =
        motion.instants[i].bodies[body].pose.R_WL *
        motion.instants[i - 1].bodies[body].pose.R_WL.transpose();
    sum += std::atan2(step(1, 0), step(0, 0));
  }
  return sum;
}

/// Speed of the marker over the rate of the drive at a position of the motion,
/// also where the drive rests: from there the drive sets out at 1 m/s.
double speed_ratio(const scene::Scene& scene, const Instant& instant,
                   const mechanism::MarkerDefinition& marker) {
  mechanism::MechanismDefinition definition = scene.mechanism;
  for (std::size_t i = 0; i < definition.bodies.size(); ++i) {
    definition.bodies[i].placement = instant.bodies[i].pose;
  }
  for (std::size_t d = 0; d < definition.drives.size(); ++d) {
    mechanism::DriveDefinition& drive = definition.drives[d];
    drive.law = mechanism::DriveLaw::kConstant;
    drive.from = instant.drives[d].position;
  }
  auto& cylinder =
      definition.drives[static_cast<std::size_t>(scene.slide_lever->drive)];
  cylinder.law = mechanism::DriveLaw::kRamp;
  constexpr double kMoment = 1e-6;  // [s]
  cylinder.to = cylinder.from + kMoment;
  cylinder.start = 0.0;
  cylinder.duration = kMoment;
  const mechanism::Motion start =
      mechanism::simulate(definition, {.duration = kMoment, .instants = 1});
  const auto& body =
      start.instants[0].bodies[static_cast<std::size_t>(marker.body)];
  return (body.v_WLo + body.w_WL.cross(body.pose.R_WL * marker.p_LP)).norm();
}

}  // namespace

report::SlideLeverComparison compare_slide_lever(
    const scene::Scene& scene, const mechanism::Motion& motion) {
  const scene::SlideLeverClosedForm& given = *scene.slide_lever;
  const machine::SlideLever lever = lever_of(given);
  require_link(given);
  const auto& marker = find_marker(scene.mechanism, given.marker);
  const auto body = static_cast<std::size_t>(marker.body);
  const Vector2d D(0.0, given.AD);
  report::SlideLeverComparison result;
  result.marker = marker.name;
  result.body = scene.mechanism.bodies[body].name;
  result.rotation = rotation(motion, body);
  result.link_DC = given.DC;
  for (const Instant& instant : motion.instants) {
    const auto p =
        machine::slide_lever_position(lever, cylinder_length(given, instant),
                                      machine::SlideLeverForm::kCorrected);
    const Vector2d C = report::marker_position(marker, instant).head<2>();
    result.largest_DC_error =
        std::max(result.largest_DC_error, std::abs(p.DC / given.DC - 1.0));
    result.largest_C_distance =
        std::max(result.largest_C_distance, (p.C - C).norm());
  }
  for (const std::size_t i : report::shown_instants(motion)) {
    const Instant& instant = motion.instants[i];
    const double l_x = cylinder_length(given, instant);
    report::SlideLeverRow row;
    row.t = instant.t;
    row.cylinder_length = l_x;
    row.simulated = report::marker_position(marker, instant).head<2>();
    row.simulated_DC = (row.simulated - D).norm();
    row.corrected = machine::slide_lever_position(
        lever, l_x, machine::SlideLeverForm::kCorrected);
    row.published = machine::slide_lever_position(
        lever, l_x, machine::SlideLeverForm::kPublished);
    row.simulated_ratio = speed_ratio(scene, instant, marker);
    result.rows.push_back(row);
  }
  return result;
}

}  // namespace clevis::app

#include "report/view/motion_view.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <Eigen/Geometry>
#include <nlohmann/json.hpp>

#include "base/bytes/fingerprint.h"
#include "mechanism/definition/drive_names.h"
#include "mechanism/force_elements/force_element.h"
#include "mechanism/joints/joint_types.h"
#include "report/summary/line_refinement.h"
#include "report/text/json_text.h"
#include "report/text/units.h"
#include "report/view/input_file.h"
#include "report/view/mechanism_energy.h"
#include "report/view/view_numbers.h"

namespace clevis::report {
namespace {

using Eigen::Vector3d;
using mechanism::Instant;
using nlohmann::ordered_json;

constexpr std::size_t kMostInstants = 600;

void add(std::vector<float>& numbers, const Vector3d& vector) {
  for (const double value : vector) {
    numbers.push_back(static_cast<float>(value));
  }
}

ordered_json vector_json(const Vector3d& vector) {
  return {vector.x(), vector.y(), vector.z()};
}

std::string body_name(const MotionView& view, mechanism::BodyIndex body) {
  return body == mechanism::kGround
             ? "ground"
             : view.definition.bodies[static_cast<std::size_t>(body)].name;
}

ordered_json inputs_json(const MotionView& view) {
  ordered_json inputs = ordered_json::array();
  for (const ViewInput& input : view.inputs) {
    const std::string text = file_text(input.file);
    inputs.push_back({{"role", input.role},
                      {"file", input.file.filename().string()},
                      {"modified", modified_at(input.file)},
                      {"bytes", text.size()},
                      {"fnv1a", fingerprint(text)}});
  }
  return inputs;
}

ordered_json bodies_json(const MotionView& view) {
  ordered_json bodies = ordered_json::array();
  for (const auto& body : view.definition.bodies) {
    bodies.push_back(
        {{"name", body.name},
         {"part", body.part},
         {"mass_kg", body.mass_properties.mass},
         {"centre_mm", vector_json(millimetres(body.mass_properties.p_LCm))}});
  }
  return bodies;
}

/// Axes of a frame, one after another.
ordered_json axes_json(const Eigen::Matrix3d& R) {
  return {vector_json(R.col(0)), vector_json(R.col(1)), vector_json(R.col(2))};
}

ordered_json joints_json(const MotionView& view) {
  ordered_json joints = ordered_json::array();
  for (const auto& joint : view.definition.joints) {
    joints.push_back({{"name", joint.name},
                      {"type", mechanism::name_of(joint.type)},
                      {"a", joint.body_a},
                      {"b", joint.body_b},
                      {"on_a_mm", vector_json(millimetres(joint.frame_a.p_LJ))},
                      {"on_b_mm", vector_json(millimetres(joint.frame_b.p_LJ))},
                      {"axes_on_a", axes_json(joint.frame_a.R_LJ)},
                      {"axes_on_b", axes_json(joint.frame_b.R_LJ)}});
  }
  return joints;
}

ordered_json drives_json(const MotionView& view) {
  ordered_json drives = ordered_json::array();
  for (const auto& drive : view.definition.drives) {
    drives.push_back(
        {{"name", mechanism::drive_name(view.definition, drive)},
         {"joint", drive.joint},
         {"turns", mechanism::drives_angle(view.definition, drive)}});
  }
  return drives;
}

ordered_json elements_json(const MotionView& view) {
  ordered_json elements = ordered_json::array();
  for (const auto& element : view.definition.elements) {
    const auto bodies = mechanism::bodies_of(element, view.definition.joints);
    elements.push_back(
        {{"name", mechanism::name_of(element)},
         {"type", mechanism::properties(element).type},
         {"a", body_name(view, bodies[0])},
         {"b", body_name(view, bodies[1])},
         {"turns", mechanism::is_angle(element, view.definition.joints)}});
  }
  return elements;
}

ordered_json markers_json(const MotionView& view) {
  ordered_json markers = ordered_json::array();
  for (const auto& marker : view.definition.markers) {
    markers.push_back({{"name", marker.name},
                       {"body", marker.body},
                       {"at_mm", vector_json(millimetres(marker.p_LP))}});
  }
  return markers;
}

ordered_json events_json(const MotionView& view) {
  constexpr std::size_t kMost = 500;
  ordered_json events = ordered_json::array();
  for (const auto& event : view.motion.events) {
    if (events.size() == kMost) break;
    const auto& element =
        view.definition.elements[static_cast<std::size_t>(event.element)];
    events.push_back({{"t_s", event.t},
                      {"force", mechanism::name_of(element)},
                      {"what", event.what}});
  }
  return events;
}

/// Instant after instant.
struct Histories {
  std::vector<float> times;
  std::vector<float> poses;     ///< x y z [mm], quaternion w x y z, by body
  std::vector<float> joints;    ///< p [mm], f on b [N], t [N m], by joint
  std::vector<float> drives;    ///< q [mm, rad], rate [m/s, rad/s], effort
  std::vector<float> elements;  ///< q [mm, rad], effort, power [W]
  std::vector<float> actions;   ///< p [mm], f [N] on a, then on b, by element
  std::vector<float> energies;  ///< kinetic, potential [J]
};

void add_bodies(const Instant& instant, Histories& histories) {
  for (const auto& body : instant.bodies) {
    add(histories.poses, millimetres(body.pose.p_WL));
    const Eigen::Quaterniond turn(body.pose.R_WL);
    for (const double q : {turn.w(), turn.x(), turn.y(), turn.z()}) {
      histories.poses.push_back(static_cast<float>(q));
    }
  }
}

void add_forces(const MotionView& view, const Instant& instant,
                Histories& histories) {
  for (const auto& joint : instant.joints) {
    add(histories.joints, millimetres(joint.p_WJ));
    add(histories.joints, joint.f_W);
    add(histories.joints, joint.t_W);
  }
  for (std::size_t d = 0; d < instant.drives.size(); ++d) {
    const auto& drive = instant.drives[d];
    const bool turns =
        mechanism::drives_angle(view.definition, view.definition.drives[d]);
    add(histories.drives, {turns ? drive.position : millimetres(drive.position),
                           drive.rate, drive.effort});
  }
  for (std::size_t e = 0; e < instant.elements.size(); ++e) {
    const auto& state = instant.elements[e];
    const bool turns = mechanism::is_angle(view.definition.elements[e],
                                           view.definition.joints);
    add(histories.elements,
        {turns ? state.position : millimetres(state.position), state.effort,
         state.power});
    for (const auto& action : state.actions) {
      add(histories.actions, millimetres(action.p_W));
      add(histories.actions, action.f_W);
    }
  }
}

Histories histories_of(const MotionView& view) {
  Histories histories;
  for (const std::size_t i : kept_instants(view, kMostInstants)) {
    const Instant& instant = view.motion.instants[i];
    histories.times.push_back(static_cast<float>(instant.t));
    add_bodies(instant, histories);
    add_forces(view, instant, histories);
    const MechanismEnergy energy = mechanism_energy(view.definition, instant);
    histories.energies.push_back(static_cast<float>(energy.kinetic));
    histories.energies.push_back(static_cast<float>(energy.potential));
  }
  return histories;
}

/// The first instant at which a number is largest.
template <class Number>
void keep_largest(const std::vector<Instant>& instants, Number number,
                  std::set<std::size_t>& kept) {
  std::size_t at = 0;
  for (std::size_t i = 1; i < instants.size(); ++i) {
    if (number(instants[i]) > number(instants[at])) at = i;
  }
  kept.insert(at);
}

/// Between the kept instants, those at which a joint's force or an element's
/// effort leaves the straight line by more than 1 % of its largest.
void refine_blows(const MotionView& view, std::size_t most,
                  std::set<std::size_t>& kept) {
  constexpr double kTolerance = 0.01;
  const auto& instants = view.motion.instants;
  std::vector<double> times(instants.size()), values(instants.size());
  std::ranges::transform(instants, times.begin(), &Instant::t);
  const auto refine = [&](const auto& number) {
    std::ranges::transform(instants, values.begin(), number);
    const auto [low, high] = std::ranges::minmax(values);
    refine_lines(kept, times, values, kTolerance * std::max(-low, high), most);
  };
  for (std::size_t e = 0; e < view.definition.elements.size(); ++e) {
    refine([e](const Instant& i) {
      return i.elements[e].effort;
    });
  }
  for (std::size_t j = 0; j < view.definition.joints.size(); ++j) {
    refine([j](const Instant& i) {
      return i.joints[j].f_W.norm();
    });
  }
}

std::size_t nearest(const std::vector<Instant>& instants, double t) {
  std::size_t at = 0;
  for (std::size_t i = 1; i < instants.size(); ++i) {
    if (std::abs(instants[i].t - t) < std::abs(instants[at].t - t)) at = i;
  }
  return at;
}

}  // namespace

std::vector<std::size_t> kept_instants(const MotionView& view,
                                       std::size_t most) {
  const auto& instants = view.motion.instants;
  if (instants.empty()) return {};
  std::set<std::size_t> kept;
  const std::size_t last = instants.size() - 1;
  const std::size_t steps = std::min(last, std::max<std::size_t>(most, 2) - 1);
  for (std::size_t k = 0; k <= steps; ++k) {
    kept.insert(steps == 0 ? 0 : last * k / steps);
  }
  for (std::size_t j = 0; j < view.definition.joints.size(); ++j) {
    keep_largest(
        instants,
        [j](const Instant& i) {
          return i.joints[j].f_W.norm();
        },
        kept);
    keep_largest(
        instants,
        [j](const Instant& i) {
          return i.joints[j].t_W.norm();
        },
        kept);
  }
  for (std::size_t d = 0; d < view.definition.drives.size(); ++d) {
    keep_largest(
        instants,
        [d](const Instant& i) {
          return std::abs(i.drives[d].effort);
        },
        kept);
  }
  for (std::size_t e = 0; e < view.definition.elements.size(); ++e) {
    keep_largest(
        instants,
        [e](const Instant& i) {
          return std::abs(i.elements[e].effort);
        },
        kept);
  }
  for (const double t : view.worst_times) kept.insert(nearest(instants, t));
  refine_blows(view, kept.size() + most / 2, kept);
  return {kept.begin(), kept.end()};
}

std::string motion_view_json(const MotionView& view) {
  const Histories histories = histories_of(view);
  const ordered_json json = {
      {"schema", kSchema},
      {"version", view.version},
      {"scene", view.scene},
      {"inputs", inputs_json(view)},
      {"scene_text",
       view.inputs.empty() ? "" : file_text(view.inputs.front().file)},
      {"instants_of_motion", view.motion.instants.size()},
      {"gravity_m_per_s2", vector_json(view.definition.gravity_W)},
      {"bodies", bodies_json(view)},
      {"joints", joints_json(view)},
      {"drives", drives_json(view)},
      {"forces", elements_json(view)},
      {"markers", markers_json(view)},
      {"events", events_json(view)},
      {"t_s", packed(histories.times)},
      {"poses", packed(histories.poses)},
      {"joint_states", packed(histories.joints)},
      {"drive_states", packed(histories.drives)},
      {"force_states", packed(histories.elements)},
      {"force_actions", packed(histories.actions)},
      {"energies_J", packed(histories.energies)}};
  refuse_non_finite(json, "view of the mechanism");
  return json.dump(-1, ' ', false, ordered_json::error_handler_t::replace) +
         "\n";
}

}  // namespace clevis::report

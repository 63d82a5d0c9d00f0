#include "report/motion/motion_csv.h"

#include <iterator>
#include <limits>
#include <string>

#include <Eigen/Geometry>
#include <fmt/compile.h>
#include <fmt/format.h>

#include "mechanism/definition/drive_names.h"
#include "mechanism/joints/joint_types.h"
#include "report/summary/motion_report.h"

namespace clevis::report {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using mechanism::BodyIndex;
using mechanism::Instant;
using mechanism::JointReaction;

using Text = fmt::memory_buffer;

void add(Text& text, double value) {
  // + 0.0 turns −0 into 0
  fmt::format_to(std::back_inserter(text), FMT_COMPILE(",{:.12g}"),
                 value + 0.0);
}

void add(Text& text, const Vector3d& value) {
  for (const double component : value) add(text, component);
}

/// ",name_x_unit,name_y_unit,name_z_unit"
void add_vector_title(Text& text, const std::string& name, const char* unit) {
  for (const char axis : {'x', 'y', 'z'}) {
    fmt::format_to(std::back_inserter(text), ",{}_{}_{}", name, axis, unit);
  }
}

Matrix3d rotation(const Instant& instant, BodyIndex body) {
  return body == mechanism::kGround
             ? Matrix3d(Matrix3d::Identity())
             : instant.bodies[static_cast<std::size_t>(body)].pose.R_WL;
}

std::string body_name(const MotionReport& report, BodyIndex body) {
  return body == mechanism::kGround
             ? "ground"
             : report.definition.bodies[static_cast<std::size_t>(body)].name;
}

void add_reaction(Text& text, const MotionReport& report,
                  const Instant& instant, std::size_t joint) {
  const auto& definition = report.definition.joints[joint];
  const JointReaction& reaction = instant.joints[joint];
  const Matrix3d R_aW = rotation(instant, definition.body_a).transpose();
  const Matrix3d R_bW = rotation(instant, definition.body_b).transpose();
  fmt::format_to(std::back_inserter(text), "{:.12g},{},{},{}", instant.t,
                 definition.name, body_name(report, definition.body_a),
                 body_name(report, definition.body_b));
  add(text, Vector3d(1e3 * reaction.p_WJ));
  add(text, reaction.f_W);
  add(text, reaction.t_W);
  add(text, Vector3d(-(R_aW * reaction.f_W)));
  add(text, Vector3d(-(R_aW * reaction.t_W)));
  add(text, Vector3d(R_bW * reaction.f_W));
  add(text, Vector3d(R_bW * reaction.t_W));
  fmt::format_to(std::back_inserter(text), ",{}",
                 reaction.unique ? "yes" : "no");
  const auto in_joint_frame = reaction.components();
  add(text, Vector3d(in_joint_frame.head<3>()));
  add(text, Vector3d(in_joint_frame.tail<3>()));
  for (const bool unique : reaction.unique_components) {
    fmt::format_to(std::back_inserter(text), ",{}", unique ? "yes" : "no");
  }
  for (const double spread : reaction.spread) add(text, spread);
  fmt::format_to(std::back_inserter(text), ",{}\n",
                 instant.is_change_point ? "yes" : "no");
}

const char* coupling_unit(const mechanism::MechanismDefinition& definition,
                          const mechanism::CouplingDefinition& coupling) {
  const auto joint = static_cast<std::size_t>(coupling.joint_1);
  return mechanism::coordinate_row(definition.joints[joint].type,
                                   coupling.coordinate_1)
                 .is_angle()
             ? "N_m"
             : "N";
}

void add_motion_titles(Text& text, const MotionReport& report) {
  fmt::format_to(std::back_inserter(text), "t_s");
  for (const auto& body : report.definition.bodies) {
    const std::string& name = body.name;
    add_vector_title(text, name + ".position", "mm");
    fmt::format_to(std::back_inserter(text),
                   ",{0}.quaternion_w,{0}.quaternion_x,{0}.quaternion_y,"
                   "{0}.quaternion_z",
                   name);
    add_vector_title(text, name + ".velocity", "m_per_s");
    add_vector_title(text, name + ".angular_velocity", "rad_per_s");
    add_vector_title(text, name + ".acceleration", "m_per_s2");
    add_vector_title(text, name + ".angular_acceleration", "rad_per_s2");
  }
  for (const auto& marker : report.definition.markers) {
    add_vector_title(text, marker.name + ".marker", "mm");
  }
  for (const auto& drive : report.definition.drives) {
    const bool slides = !mechanism::drives_angle(report.definition, drive);
    fmt::format_to(std::back_inserter(text),
                   ",{0}.drive_{1},{0}.drive_rate_{2},"
                   "{0}.drive_acceleration_{2}2,{0}.drive_effort_{3}",
                   mechanism::drive_name(report.definition, drive),
                   slides ? "mm" : "rad", slides ? "m_per_s" : "rad_per_s",
                   slides ? "N" : "N_m");
  }
  for (const auto& coupling : report.definition.couplings) {
    fmt::format_to(std::back_inserter(text), ",{}.coupling_effort_{}",
                   coupling.name, coupling_unit(report.definition, coupling));
    if (!coupling.teeth) continue;
    add_vector_title(text, coupling.name + ".tooth_force", "N");
  }
  fmt::format_to(std::back_inserter(text),
                 ",closure_error_mm,power_balance_error_rel\n");
}

}  // namespace

std::string reactions_csv(const MotionReport& report) {
  Text text;
  fmt::format_to(std::back_inserter(text), "t_s,joint,body_a,body_b");
  add_vector_title(text, "point_world", "mm");
  add_vector_title(text, "force_on_b_world", "N");
  add_vector_title(text, "moment_on_b_world", "N_m");
  add_vector_title(text, "force_on_a_frame_a", "N");
  add_vector_title(text, "moment_on_a_frame_a", "N_m");
  add_vector_title(text, "force_on_b_frame_b", "N");
  add_vector_title(text, "moment_on_b_frame_b", "N_m");
  fmt::format_to(std::back_inserter(text), ",unique");
  add_vector_title(text, "force_on_b_joint_frame", "N");
  add_vector_title(text, "moment_on_b_joint_frame", "N_m");
  for (const char* name : {"force", "moment"}) {
    for (const char axis : {'x', 'y', 'z'}) {
      fmt::format_to(std::back_inserter(text), ",unique_{}_{}", name, axis);
    }
  }
  add_vector_title(text, "spread_force", "N");
  add_vector_title(text, "spread_moment", "N_m");
  fmt::format_to(std::back_inserter(text), ",change_point\n");
  for (const Instant& instant : report.motion.instants) {
    for (std::size_t j = 0; j < instant.joints.size(); ++j) {
      add_reaction(text, report, instant, j);
    }
  }
  return fmt::to_string(text);
}

std::string motion_csv(const MotionReport& report) {
  Text text;
  add_motion_titles(text, report);
  for (const Instant& instant : report.motion.instants) {
    fmt::format_to(std::back_inserter(text), "{:.12g}", instant.t);
    for (const mechanism::BodyState& body : instant.bodies) {
      const Eigen::Quaterniond q(body.pose.R_WL);
      add(text, Vector3d(1e3 * body.pose.p_WL));
      add(text, q.w());
      add(text, Vector3d(q.vec()));
      add(text, body.v_WLo);
      add(text, body.w_WL);
      add(text, body.a_WLo);
      add(text, body.alpha_WL);
    }
    for (const auto& marker : report.definition.markers) {
      add(text, Vector3d(1e3 * marker_position(marker, instant)));
    }
    for (std::size_t d = 0; d < instant.drives.size(); ++d) {
      const mechanism::DriveState& drive = instant.drives[d];
      const bool slides = !mechanism::drives_angle(report.definition,
                                                   report.definition.drives[d]);
      add(text, (slides ? 1e3 : 1.0) * drive.position);
      add(text, drive.rate);
      add(text, drive.acceleration);
      add(text, drive.effort);
    }
    for (std::size_t k = 0; k < instant.couplings.size(); ++k) {
      const auto& coupling = instant.couplings[k];
      add(text, coupling.effort);
      if (!report.definition.couplings[k].teeth) continue;
      constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
      add(text, coupling.teeth ? coupling.teeth->f_W
                               : Vector3d(Vector3d::Constant(kUnknown)));
    }
    add(text, 1e3 * instant.closure_error);
    add(text, instant.power_balance_error);
    text.push_back('\n');
  }
  return fmt::to_string(text);
}

}  // namespace clevis::report

#include "multibody/scene_text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string_view>
#include <utility>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <fmt/format.h>

#include "base/messages/errors.h"
#include "multibody/body_hosts.h"
#include "multibody/names.h"

namespace clevis::multibody {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

/// How a joint's word stands in a scene.
struct TypeRow {
  std::string_view word, scene_type;
  std::array<std::string_view, 2> coordinates;  ///< of its axes
  bool has_axis = true;
};

constexpr TypeRow kTypes[] = {
    {"revolute", "revolute", {"angle", ""}},
    {"continuous", "revolute", {"angle", ""}},
    {"prismatic", "prismatic", {"distance", ""}},
    {"fixed", "weld", {"", ""}, false},
    {"ball", "spherical", {"", ""}, false},
    {"universal", "universal", {"angle_1", "angle_2"}},
    {"screw", "screw", {"angle", ""}},
    {"planar", "planar", {"", ""}}};

constexpr const TypeRow& kWeld = kTypes[3];

struct Units {
  std::string_view coordinate, effort, stiffness, damping;
};

constexpr Units kAngle{"rad", "N m", "N m/rad", "N m s/rad"};
constexpr Units kLength{"m", "N", "N/m", "N s/m"};

/// Shortest text that is read as the same number.
std::string quantity(double value, std::string_view unit) {
  return fmt::format("\"{} {}\"", value + 0.0, unit);
}

std::string quantities(const Vector3d& v, std::string_view unit) {
  return fmt::format("[{}, {}, {}]", quantity(v.x(), unit),
                     quantity(v.y(), unit), quantity(v.z(), unit));
}

std::string direction(const Vector3d& v) {
  constexpr double kRoundOff = 1e-15;  // of turns by a rounded pi/2
  const auto clean = [](double x) {
    return std::abs(x) < kRoundOff ? 0.0 : x;
  };
  return fmt::format("[{}, {}, {}]", clean(v.x()), clean(v.y()), clean(v.z()));
}

/// At right angles to the axis, near a world's axis.
Vector3d normal_of(const Vector3d& axis) {
  Eigen::Index smallest = 0;
  axis.cwiseAbs().minCoeff(&smallest);
  const Vector3d unit = Vector3d::Unit(smallest);
  return (unit - unit.dot(axis) * axis).normalized();
}

class Writer {
 public:
  Writer(const Model& model, const std::string& file)
      : model_(model), file_(file) {}

  SceneText write() {
    hosts_ = body_hosts(model_, file_, told_);
    for (std::size_t i = 0; i < model_.links.size(); ++i) add_body(i);
    if (result_.bodies == 0) {
      throw Error("S015", file_, "nothing in the model moves",
                  "Give a model with a link that is neither static nor "
                  "without mass.");
    }
    for (const Joint& joint : model_.joints) add_joint(joint);
    tell_loose_bodies();
    for (const auto* lines : {&model_.told, &std::as_const(told_)}) {
      for (const std::string& line : *lines) {
        result_.told.push_back(one_line(line));
      }
    }
    result_.text = head() + body_ + forces_ +
                   "\n# Assumed: a model says neither how long nor how it "
                   "starts; here from rest, joints at zero.\n"
                   "[simulation]\nduration = \"1 s\"\ninstants = 101\n"
                   "motion = \"dynamic\"\n";
    return std::move(result_);
  }

 private:
  std::string head() {
    // As SDF has it for a world that says nothing.
    const Vector3d gravity = model_.gravity.value_or(Vector3d(0.0, 0.0, -9.8));
    if (!model_.gravity) {
      result_.told.emplace_back(
          "gravity: not in the file; (0, 0, -9.8) m/s^2 assumed, as SDF does");
    }
    std::string text =
        fmt::format("# Made by `clevis import` of {}.\n", one_line(file_));
    if (!result_.told.empty()) text += "# Lost or assumed:\n";
    for (const std::string& line : result_.told) {
      text += fmt::format("#   {}\n", line);
    }
    constexpr std::size_t kLongestTitle = 64;  // [bytes]
    text += fmt::format("schema = 1\nname = {}\n\n[world]\ngravity = {}\n",
                        toml_text(one_line(model_.name, kLongestTitle)),
                        quantities(gravity, "m/s^2"));
    return text;
  }

  /// Bodies that no joints lead to from the ground fall.
  void tell_loose_bodies() {
    std::set<int> held{kGround};
    for (std::size_t before = 0; before != held.size();) {
      before = held.size();
      for (const auto& [a, b] : pairs_) {
        if (held.contains(a) || held.contains(b)) held.insert({a, b});
      }
    }
    for (std::size_t i = 0; i < hosts_.size(); ++i) {
      if (hosts_[i] != int(i) || held.contains(int(i))) continue;
      told_.push_back(fmt::format(
          "link {}: no joint leads from it to the ground; it moves freely",
          model_.links[i].name));
    }
  }

  void add_body(std::size_t index) {
    const Link& link = model_.links[index];
    if (hosts_[index] != int(index)) {
      names_.emplace_back();
      return;
    }
    require_possible(link);
    names_.push_back(link_names_.add(link.name, told_));
    const Matrix3d inertia =
        0.5 * (link.inertia_LCm + link.inertia_LCm.transpose());
    body_ += fmt::format(
        "\n[[body]]\nname = \"{}\"\nmass = {}\ncenter_of_mass = {}\n"
        "inertia = {}\n",
        names_.back(), quantity(link.mass, "kg"), quantities(link.p_LCm, "m"),
        inertia.isDiagonal(0.0) ? quantities(inertia.diagonal(), "kg m^2")
                                : rows(inertia));
    body_ +=
        fmt::format("placement = {{ origin = {}", quantities(link.p_WL, "m"));
    if (link.R_WL != Matrix3d::Identity()) {
      body_ +=
          fmt::format(", x_axis = {}, y_axis = {}", direction(link.R_WL.col(0)),
                      direction(link.R_WL.col(1)));
    }
    body_ += " }\n";
    ++result_.bodies;
  }

  static std::string rows(const Matrix3d& m) {
    return fmt::format("[{}, {}, {}]", quantities(m.row(0), "kg m^2"),
                       quantities(m.row(1), "kg m^2"),
                       quantities(m.row(2), "kg m^2"));
  }

  void require_possible(const Link& link) const {
    const std::string place = fmt::format("{}, link {}", file_, link.name);
    if (!(link.mass > 0.0)) {
      throw Error("S015", place, fmt::format("its mass is {} kg", link.mass),
                  "Give it a mass above zero.");
    }
    const Matrix3d inertia =
        0.5 * (link.inertia_LCm + link.inertia_LCm.transpose());
    const bool is_finite = inertia.allFinite() && link.p_LCm.allFinite() &&
                           link.p_WL.allFinite() && link.R_WL.allFinite();
    if (!is_finite) {
      throw Error("S015", place, "a number of its mass or pose is not finite",
                  "Repair the model, or export it again.");
    }
    const Vector3d principal =
        Eigen::SelfAdjointEigenSolver<Matrix3d>(inertia).eigenvalues();
    if (principal[0] > 0.0) return;
    throw Error("S015", place,
                fmt::format("its principal moments of inertia are {}, {} and "
                            "{} kg m^2",
                            principal[0], principal[1], principal[2]),
                "Give it an inertia above zero about every axis.");
  }

  int host(const std::string& link) const {
    const int index = link_index(model_, link, file_);
    return index == kGround ? kGround : hosts_[std::size_t(index)];
  }

  std::string body_name(int host_index) const {
    return host_index == kGround ? "ground" : names_[std::size_t(host_index)];
  }

  void tell(const Joint& joint, std::string_view what) {
    told_.push_back(fmt::format("joint {}: {}", joint.name, what));
  }

  void add_joint(const Joint& joint) {
    const int parent = host(joint.parent), child = host(joint.child);
    if (parent == child || parent == kNoBody || child == kNoBody) return;
    const auto* type = std::ranges::find(kTypes, joint.type, &TypeRow::word);
    if (type == std::end(kTypes)) {
      tell(joint, "clevis has no " + joint.type +
                      " joint; left out, its links move freely");
      return;
    }
    if (!is_finite(joint)) {
      throw Error("S015", fmt::format("{}, joint {}", file_, joint.name),
                  "a number of its place, axis, limits, dynamics or thread is "
                  "not finite",
                  "Correct it; a screw needs a thread_pitch that is not 0.");
    }
    if (is_locked(joint)) {
      tell(joint, "both limits are one; a weld");
      type = &kWeld;
    }
    if (type->has_axis && joint.axes.empty()) {
      throw Error("S015", fmt::format("{}, joint {}", file_, joint.name),
                  "it has no axis", "Give it one.");
    }
    const std::string name = joint_names_.add(joint.name, told_);
    body_ += fmt::format(
        "\n[[joint]]\nname = \"{}\"\ntype = \"{}\"\nbetween = [\"{}\", "
        "\"{}\"]\npoint = {}\n",
        name, type->scene_type, body_name(parent), body_name(child),
        quantities(joint.point, "m"));
    ++result_.joints;
    pairs_.push_back({parent, child});
    if (!type->has_axis) return;
    const Vector3d& axis = joint.axes[0].direction;
    const bool has_second =
        type->scene_type == "universal" && joint.axes.size() > 1;
    body_ += fmt::format(
        "axis = {}\nnormal = {}\n", direction(axis),
        direction(has_second ? joint.axes[1].direction : normal_of(axis)));
    if (type->scene_type == "screw") {
      body_ += fmt::format("lead = {}\n", quantity(joint.lead, "m"));
    }
    if (has_second && std::abs(axis.dot(joint.axes[1].direction)) > 1e-9) {
      tell(joint, "its axes are not at right angles; the second is turned");
    }
    for (std::size_t k = 0; k < joint.axes.size() && k < 2; ++k) {
      if (!type->coordinates[k].empty()) {
        add_forces(joint, name, joint.axes[k], type->coordinates[k]);
      }
    }
  }

  static bool is_finite(const Joint& joint) {
    return joint.point.allFinite() && std::isfinite(joint.lead) &&
           std::ranges::all_of(joint.axes, [](const Axis& axis) {
             return axis.direction.allFinite() &&
                    std::isfinite(axis.lower.value_or(0.0)) &&
                    std::isfinite(axis.upper.value_or(0.0)) &&
                    std::isfinite(axis.stop_stiffness + axis.stop_damping +
                                  axis.damping + axis.friction +
                                  axis.spring_stiffness +
                                  axis.spring_reference);
           });
  }

  static bool is_locked(const Joint& joint) {
    if (joint.axes.size() != 1 || joint.type == "continuous") return false;
    const Axis& axis = joint.axes[0];
    return axis.lower && axis.upper && *axis.lower == *axis.upper &&
           *axis.lower == 0.0;
  }

  void add_force(std::string_view type, const std::string& joint,
                 std::string_view coordinate, const std::string& keys) {
    const bool is_second = coordinate == "angle_2";
    forces_ += fmt::format(
        "\n[[force]]\ntype = \"{}\"\nname = \"{}_{}{}\"\njoint = \"{}\"\n"
        "coordinate = \"{}\"\n{}",
        type, joint, type, is_second ? "_2" : "", joint, coordinate, keys);
    ++result_.forces;
  }

  void add_forces(const Joint& joint, const std::string& name, const Axis& axis,
                  std::string_view coordinate) {
    const Units& units = coordinate == "distance" ? kLength : kAngle;
    if (axis.spring_stiffness != 0.0 || axis.damping != 0.0) {
      std::string keys;
      if (axis.spring_stiffness != 0.0) {
        keys = fmt::format("stiffness = {}\nfree = {}\n",
                           quantity(axis.spring_stiffness, units.stiffness),
                           quantity(axis.spring_reference, units.coordinate));
      }
      if (axis.damping != 0.0) {
        keys += fmt::format("damping = {}\n",
                            quantity(axis.damping, units.damping));
      }
      add_force("spring", name, coordinate, keys);
    }
    if (axis.friction != 0.0) {
      const std::string effort = quantity(axis.friction, units.effort);
      add_force("friction", name, coordinate,
                fmt::format("breakaway = {}\nkinetic = {}\n", effort, effort));
    }
    add_stop(joint, name, axis, coordinate, units);
  }

  void add_stop(const Joint& joint, const std::string& name, const Axis& axis,
                std::string_view coordinate, const Units& units) {
    if (!axis.lower && !axis.upper) return;
    if (axis.lower && axis.upper && *axis.lower > *axis.upper) {
      tell(joint, fmt::format("its limits are reversed, lower {:g} and upper "
                              "{:g}, and left out",
                              *axis.lower, *axis.upper));
      return;
    }
    if (axis.lower.value_or(0.0) > 0.0 || axis.upper.value_or(0.0) < 0.0) {
      tell(joint, "zero is beyond its limits, which are left out");
      return;
    }
    std::string keys;
    if (axis.lower) {
      keys +=
          fmt::format("lower = {}\n", quantity(*axis.lower, units.coordinate));
    }
    if (axis.upper) {
      keys +=
          fmt::format("upper = {}\n", quantity(*axis.upper, units.coordinate));
    }
    add_force("stop", name, coordinate,
              keys + fmt::format("stiffness = {}\ndamping = {}\n",
                                 quantity(axis.stop_stiffness, units.stiffness),
                                 quantity(axis.stop_damping, units.damping)));
  }

  const Model& model_;
  const std::string& file_;
  std::vector<std::string> told_;
  std::vector<int> hosts_;
  std::vector<std::array<int, 2>> pairs_;  ///< bodies that a joint holds
  std::vector<std::string> names_;         ///< of the links' bodies
  Names link_names_{"link", {"ground"}}, joint_names_{"joint", {}};
  std::string body_, forces_;
  SceneText result_;
};

}  // namespace

SceneText scene_text(const Model& model, const std::string& file) {
  return Writer(model, file).write();
}

}  // namespace clevis::multibody

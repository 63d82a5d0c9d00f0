#include "loads/history/balance.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <fmt/format.h>

#include "base/messages/errors.h"

namespace clevis::loads {

using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

constexpr double kBalanceTolerance = 1e-9;
constexpr double kSmallestLoadRatio = 1e-3;

struct LoadScale {
  double force{};   // [N]
  double moment{};  // [N m]
};

// Magnitudes are added, not vectors: a free body that only tumbles has a load
// though its resultant is zero.
LoadScale load_scale(const InstantLoad& instant,
                     const part::MassProperties& mass, double size) {
  const RigidAcceleration& rigid = instant.rigid;
  LoadScale scale;
  scale.force =
      mass.mass * (rigid.acceleration.norm() +
                   size * (rigid.alpha.norm() + rigid.omega.squaredNorm()));
  for (const Wrench& wrench : instant.wrenches) {
    scale.force += wrench.force.norm();
    scale.moment += wrench.moment.norm();
  }
  for (const SurfaceLoad& load : instant.surface_loads) {
    scale.force += load.total;
  }
  const double all = scale.force + scale.moment / size;  // couples press, too
  return {.force = all, .moment = size * all};
}

/// Gives the part the acceleration by which its inertia balances a residual.
void take_up(const Wrench& left, const part::MassProperties& mass,
             InstantLoad& instant) {
  const RigidAcceleration more = relieving_acceleration(left, mass);
  instant.rigid.acceleration += more.acceleration;
  instant.rigid.alpha += more.alpha;
}

}  // namespace

Wrench inertia_load(const RigidAcceleration& rigid,
                    const part::MassProperties& mass) {
  const Vector3d& c = mass.p_LCm;
  const Vector3d& omega = rigid.omega;
  const Matrix3d inertia_Lo =
      mass.inertia_LCm +
      mass.mass * (c.squaredNorm() * Matrix3d::Identity() - c * c.transpose());
  const Vector3d a_Cm =
      rigid.acceleration + rigid.alpha.cross(c) + omega.cross(omega.cross(c));
  const Vector3d spin = inertia_Lo * omega;
  return {.force = -mass.mass * a_Cm,
          .moment = -(mass.mass * c.cross(rigid.acceleration) +
                      inertia_Lo * rigid.alpha + omega.cross(spin))};
}

double part_size(const std::vector<GroupGeometry>& groups,
                 const part::MassProperties& mass) {
  Eigen::AlignedBox3d box(mass.p_LCm);
  for (const GroupGeometry& group : groups) {
    box.extend(group.centroid);
    if (group.is_cylinder) {
      const Vector3d reach =
          group.cylinder.radius * Vector3d::Ones() +
          0.5 * group.cylinder.length * group.cylinder.axis_L.cwiseAbs();
      box.extend(Vector3d(group.cylinder.p_LC - reach));
      box.extend(Vector3d(group.cylinder.p_LC + reach));
    }
  }
  // A ring's faces may all have their middle in its centre.
  const double gyration = std::sqrt(0.5 * mass.inertia_LCm.trace() / mass.mass);
  return std::max(box.diagonal().norm(), 2.0 * gyration);
}

const GroupGeometry& find_group(const std::vector<GroupGeometry>& groups,
                                const std::string& name,
                                const std::string& place) {
  const auto found = std::ranges::find(groups, name, &GroupGeometry::name);
  if (found != groups.end()) return *found;
  std::string known;
  for (const GroupGeometry& group : groups) {
    known += fmt::format("{}{}", known.empty() ? "" : ", ", group.name);
  }
  throw Error("M003", place,
              fmt::format("the mesh has no physical group \"{}\"; it has {}",
                          name, known.empty() ? "none" : known),
              "Use one of these names, or name the surface in the geometry.");
}

Wrench about(const Vector3d& force, const Vector3d& moment,
             const Vector3d& from, const Vector3d& to) {
  return {.force = force, .moment = moment + (from - to).cross(force)};
}

bool is_full_cylinder(const GroupGeometry& group) {
  return group.is_cylinder &&
         part::is_whole_wall(group.cylinder, {group.area, group.area_vector,
                                              group.normal_square});
}

bool closes_about_pin(const GroupGeometry& group) {
  return group.is_cylinder && group.area_vector.norm() < kOpenFace * group.area;
}

void require_cylinder(const GroupGeometry& group, const std::string& place) {
  if (group.is_cylinder) return;
  throw Error(
      "L002", place,
      fmt::format("a pin cannot press on \"{}\": it is not a circular "
                  "cylinder called bore_* or round_*",
                  group.name),
      "Call a cylinder so, or load the surface otherwise: in a history by "
      "`faces`, in a case by `traction`.");
}

std::string vector_text(const Vector3d& v, double scale) {
  const double small = 1e-12 * scale;
  const Vector3d shown = v.unaryExpr([&](double x) {
    return std::abs(x) <= small ? 0.0 : x;
  });
  return fmt::format("({:.6g}, {:.6g}, {:.6g})", shown.x(), shown.y(),
                     shown.z());
}

double Imbalance::relative() const {
  const auto over = [](double value, double scale) {
    return value == 0.0 ? 0.0 : value / scale;
  };
  return std::max(over(left.force.norm(), force_scale),
                  over(left.moment.norm(), moment_scale));
}

Imbalance imbalance(const LoadHistory& history, const InstantLoad& instant,
                    const part::MassProperties& mass, double size) {
  const LoadScale scale = load_scale(instant, mass, size);
  return {residual(history, instant, mass), scale.force, scale.moment};
}

RigidAcceleration relieving_acceleration(const Wrench& left,
                                         const part::MassProperties& mass) {
  const Vector3d about_Cm = left.moment - mass.p_LCm.cross(left.force);
  RigidAcceleration rigid;
  rigid.alpha = mass.inertia_LCm.ldlt().solve(about_Cm);
  rigid.acceleration = left.force / mass.mass - rigid.alpha.cross(mass.p_LCm);
  return rigid;
}

void relieve(const LoadHistory& history, const part::MassProperties& mass,
             double size, const std::string& place, InstantLoad& instant) {
  const Imbalance rest = imbalance(history, instant, mass, size);
  const double relative = rest.relative();
  if (relative <= kBalanceTolerance) return;
  // Written so that a NaN is refused, too.
  if (!(relative <= kLargestRelief)) {
    throw Error("L001", place,
                fmt::format("{}: the loads leave a force of {} N and a moment "
                            "about the part's origin of {} N m, {:.3g} % of "
                            "the load",
                            instant.label,
                            vector_text(rest.left.force, rest.force_scale),
                            vector_text(rest.left.moment, rest.moment_scale),
                            100.0 * relative),
                fmt::format("Give the missing load or acceleration, or hold "
                            "the part with `held_by_pin`, `fixed` or a "
                            "`foundation`; inertia takes up {:.3g} % at most.",
                            100.0 * kLargestRelief));
  }
  take_up(rest.left, mass, instant);
  instant.relief = rest.left;
}

void float_on(const part::MassProperties& mass, LoadHistory& history) {
  for (InstantLoad& instant : history.instants) {
    take_up(residual(history, instant, mass), mass, instant);
  }
}

Wrench residual(const LoadHistory& history, const InstantLoad& instant,
                const part::MassProperties& mass) {
  Wrench sum = inertia_load(instant.rigid, mass);
  for (std::size_t i = 0; i < history.seats.size(); ++i) {
    const Wrench& wrench = instant.wrenches[i];
    sum.force += wrench.force;
    sum.moment += wrench.moment + history.seats[i].p_LS.cross(wrench.force);
  }
  for (const SurfaceLoad& load : instant.surface_loads) {
    sum.force += load.resultant.force;
    sum.moment += load.resultant.moment;
  }
  return sum;
}

void require_balance(const LoadHistory& history,
                     const part::MassProperties& mass, double size,
                     const std::string& place, double of_mechanism) {
  constexpr double kOfMechanism = 1e-6;
  std::vector<LoadScale> scales;
  LoadScale floor;
  floor.force = kOfMechanism * of_mechanism;
  floor.moment = floor.force * size;
  for (const InstantLoad& instant : history.instants) {
    scales.push_back(load_scale(instant, mass, size));
    floor.force =
        std::max(floor.force, kSmallestLoadRatio * scales.back().force);
    floor.moment =
        std::max(floor.moment, kSmallestLoadRatio * scales.back().moment);
  }
  for (std::size_t i = 0; i < history.instants.size(); ++i) {
    const InstantLoad& instant = history.instants[i];
    const Wrench left = residual(history, instant, mass);
    const double force_scale = std::max(scales[i].force, floor.force);
    const double moment_scale = std::max(scales[i].moment, floor.moment);
    // Written so that a NaN is refused, too.
    if (left.force.norm() <= kBalanceTolerance * force_scale &&
        left.moment.norm() <= kBalanceTolerance * moment_scale) {
      continue;
    }
    throw Error("L001", place,
                fmt::format("{}: the loads leave a force of {} N and a moment "
                            "about the part's origin of {} N m",
                            instant.label, vector_text(left.force, force_scale),
                            vector_text(left.moment, moment_scale)),
                "Give the missing load or acceleration, or hold the part with "
                "`fixed`.");
  }
}

}  // namespace clevis::loads

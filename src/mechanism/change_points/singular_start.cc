#include "mechanism/change_points/singular_start.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <Eigen/QR>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/messages/errors.h"
#include "mechanism/definition/drive_names.h"
#include "mechanism/drives/drive_law.h"

namespace clevis::mechanism {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// Motion of one joint coordinate per unknown, not scaled.
VectorXd coordinate_motion(const SolvingFrame& frame, Motions motions,
                           const Configuration& x,
                           const DriveDefinition& coordinate) {
  const ConstraintSystem probe(frame, {coordinate}, motions,
                               ConstraintSystem::Drives::kAll);
  const MatrixXd J = probe.jacobian(probe.place(x));
  return J.bottomRows(1).transpose() / probe.scale(probe.row_list().back());
}

/// "A1 (4 or 0 rad/s)": coordinates whose rates differ among the velocities.
/// @param with_rates  else "A1".
std::vector<std::string> deciding(const MechanismDefinition& definition,
                                  const SolvingFrame& frame,
                                  const ConstraintSystem& joints,
                                  const Configuration& x,
                                  const std::vector<VectorXd>& velocities,
                                  bool with_rates) {
  constexpr std::size_t kMost = 4;
  std::vector<std::string> result;
  for (std::size_t j = 0; j < frame.joints.size(); ++j) {
    if (result.size() == kMost) break;
    const JointType type = definition.joints[j].type;
    if (coordinates(type).size() != 1) continue;  // what [[initial]] takes
    DriveDefinition coordinate;
    coordinate.joint = static_cast<int>(j);
    const VectorXd motion =
        coordinate_motion(frame, joints.motions(), x, coordinate);
    std::vector<double> rates;
    for (const VectorXd& v : velocities) {
      const double size = motion.norm() * v.norm();
      double rate = motion.dot(v);
      if (std::abs(rate) < 1e-6 * size) rate = 0.0;
      const bool is_known = std::ranges::any_of(rates, [&](double other) {
        return std::abs(rate - other) <= 0.01 * size;
      });
      if (!is_known) rates.push_back(rate);
    }
    if (rates.size() < 2) continue;
    rates.resize(std::min<std::size_t>(rates.size(), 3));
    if (!with_rates) {
      result.push_back(definition.joints[j].name);
      continue;
    }
    result.push_back(fmt::format("{} ({:.4g} {})", definition.joints[j].name,
                                 fmt::join(rates, " or "),
                                 traits(type).is_hinge() ? "rad/s" : "m/s"));
  }
  return result;
}

[[noreturn]] void refuse_undecided(std::string_view why,
                                   const std::vector<std::string>& joints) {
  throw Error(
      "K010", "mechanism",
      fmt::format("the motion starts at a change point, {}", why),
      joints.empty()
          ? std::string("Give [[initial]] rates that decide, or start a "
                        "thousandth of a radian beside the change point, on "
                        "the branch that is meant.")
          : fmt::format("Give an [[initial]] rate that decides, of {}, or "
                        "start a thousandth of a radian beside the change "
                        "point, on the branch that is meant.",
                        fmt::join(joints, ", ")));
}

/// The branch on which a position beside the change point lies: it is a
/// hundred times nearer than the next, by more than coordinates are off.
std::optional<BranchPoint> branch_of(const ConstraintSystem& joints,
                                     const Configuration& x,
                                     const std::vector<VectorXd>& velocities,
                                     int freedom) {
  constexpr double kNearer = 0.01, kSmallest = 1e-9;
  const double length = joints.scale({JointRow::Kind::kRotation});
  std::optional<BranchPoint> best;
  double nearest = 0.0, next = 0.0;  // 0: none yet
  for (const VectorXd& v : velocities) {
    auto point = branch_point(joints, x, v, freedom);
    if (!point) continue;
    const double off = joints.distance(x, point->x);
    if (!best || off < nearest) {
      next = best ? nearest : 0.0;
      nearest = off;
      best = std::move(point);
    } else if (next == 0.0 || off < next) {
      next = off;
    }
  }
  if (velocities.size() == 1) return best;
  if (next < kSmallest * length || nearest > kNearer * next) return {};
  return best;
}

/// Without rates: any velocities of branches.
std::vector<VectorXd> all_branches(const SingularPosition& here, Index size) {
  MatrixXd mix(1, size);
  for (Index i = 0; i < size; ++i) {
    mix(0, i) = 1.0 + std::cos(1.0 + 2.0 * static_cast<double>(i));
  }
  return here.velocities(mix, VectorXd::Ones(1));
}

}  // namespace

void refuse_rates(const MechanismDefinition& definition, double violation) {
  throw Error("K007",
              definition.initial_joints.empty()
                  ? std::string("mechanism")
                  : definition.initial_joints.front().place,
              fmt::format("the initial rates contradict the joints, the drives "
                          "or one another by {:.3g} m/s",
                          violation),
              "Give one rate per degree of freedom.");
}

WantedRates wanted_rates(const MechanismDefinition& definition,
                         const SolvingFrame& frame, Motions motions,
                         const Configuration& x) {
  std::vector<VectorXd> rows;
  std::vector<double> rates;
  const double length = frame.length;
  const auto add = [&](const DriveDefinition& drive, double rate) {
    const double scale = drives_angle(definition, drive) ? length : 1.0;
    rows.push_back(scale * coordinate_motion(frame, motions, x, drive));
    rates.push_back(scale * rate);
  };
  for (const DriveDefinition& drive : definition.drives) {
    add(drive, drive_target(drive, 0.0).rate);
  }
  for (const InitialJointState& initial : definition.initial_joints) {
    if (!initial.rate) continue;
    DriveDefinition drive;
    drive.joint = initial.joint;
    add(drive, *initial.rate);
  }
  const auto components = twist_components(motions);
  const auto per_body = static_cast<Index>(components.size());
  const Index columns = per_body * static_cast<Index>(definition.bodies.size());
  for (const InitialBodyState& initial : definition.initial_bodies) {
    const auto slot = static_cast<std::size_t>(initial.body) + 1;
    const Vector3d w = frame.R_WP.transpose() * initial.w_WL;
    const Vector3d v = frame.R_WP.transpose() * initial.v_WLo +
                       w.cross(Vector3d(x[slot].R * frame.p_LM[slot - 1]));
    for (Index k = 0; k < per_body; ++k) {
      const int component = components[static_cast<std::size_t>(k)];
      rows.push_back(VectorXd::Unit(columns, per_body * initial.body + k));
      rates.push_back(component < 3 ? v[component] : length * w[component - 3]);
    }
  }
  WantedRates wanted{MatrixXd(static_cast<Index>(rows.size()), columns),
                     VectorXd(static_cast<Index>(rows.size()))};
  for (std::size_t i = 0; i < rows.size(); ++i) {
    wanted.rows.row(static_cast<Index>(i)) = rows[i].transpose();
    wanted.rates[static_cast<Index>(i)] = rates[i];
  }
  return wanted;
}

SingularStart singular_start(const MechanismDefinition& definition,
                             const SolvingFrame& frame,
                             const ConstraintSystem& joints,
                             const Configuration& x, const WantedRates& wanted,
                             int freedom) {
  const SingularPosition here(joints, x);
  const double size =
      wanted.at_rest() ? 0.0 : wanted.rates.lpNorm<Eigen::Infinity>();
  const auto found = wanted.at_rest()
                         ? all_branches(here, joints.columns())
                         : here.velocities(wanted.rows, wanted.rates);
  if (found.empty() && !wanted.at_rest()) refuse_rates(definition, size);
  auto point = branch_of(joints, x, found, freedom);
  if (!point) {
    refuse_undecided(
        wanted.at_rest() ? "at rest, and forces do not choose among branches"
        : found.size() > 1
            ? "where more than one branch moves by the rates given"
            : "and the rates given lead along no regular branch "
              "on both sides",
        deciding(definition, frame, joints, x, found, !wanted.at_rest()));
  }
  if (wanted.at_rest()) {
    return {std::move(*point), VectorXd::Zero(joints.columns())};
  }
  const MatrixXd moved = wanted.rows * point->tangents;
  const VectorXd y =
      moved.completeOrthogonalDecomposition().solve(wanted.rates);
  const double violation = (moved * y - wanted.rates).lpNorm<Eigen::Infinity>();
  if (violation > 1e-6 * size) refuse_rates(definition, violation);
  VectorXd v = point->tangents * y;
  return {std::move(*point), std::move(v)};
}

}  // namespace clevis::mechanism

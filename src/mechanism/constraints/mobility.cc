#include "mechanism/constraints/mobility.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/messages/errors.h"
#include "mechanism/constraints/assembly.h"
#include "mechanism/definition/drive_names.h"
#include "numerics/factors/jacobian_factor.h"

namespace clevis::mechanism {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// A closed configuration a little away along what the joints leave free.
/// @param which  of some directions: where branches meet, one may lead along a
///   branch that stays singular.
Configuration neighbour(const SolvingFrame& frame, const Configuration& closed,
                        int which) {
  const Motions motions = frame.planar ? Motions::kInPlane : Motions::kSpatial;
  const ConstraintSystem joints(frame, {}, motions,
                                ConstraintSystem::Drives::kNone);
  const MatrixXd freedom =
      numerics::null_space(joints.jacobian(joints.place(closed)));
  if (freedom.cols() == 0) return closed;
  VectorXd mix(freedom.cols());
  for (Eigen::Index i = 0; i < mix.size(); ++i) {
    // any fixed mix
    mix[i] = std::cos(1.0 + 1.7 * which + 2.0 * static_cast<double>(i));
  }
  Configuration moved = closed;
  joints.move(moved, 0.02 * frame.length / mix.norm() * (freedom * mix));
  const Assembled back = assemble(joints, std::move(moved), VectorXd(),
                                  1e-10 * frame.length, frame.rank_threshold());
  return back.closed ? back.x : closed;
}

Mobility mobility_at(const SolvingFrame& frame, const ConstraintSystem& system,
                     const Configuration& x) {
  const MatrixXd all = system.jacobian(system.place(x));
  const MatrixXd joints = all.topRows(system.joint_rows());
  const int n = system.columns();
  const numerics::RowDependence closure = numerics::row_dependence(joints);
  const bool has_drives = system.rows() > system.joint_rows();
  const numerics::RowDependence driven =
      has_drives ? numerics::row_dependence(all) : closure;
  Mobility result;
  result.joints = n - closure.rank;
  result.with_drives = n - driven.rank;
  result.redundant = system.joint_rows() - closure.rank;
  result.dependent_rows = closure.dependent;
  for (int i = system.joint_rows(); i < system.rows(); ++i) {
    if (driven.dependent[static_cast<std::size_t>(i)]) {
      result.dependent_drives.push_back(i - system.joint_rows());
    }
  }
  if (result.with_drives == 0) return result;
  const MatrixXd freedom = numerics::null_space(all);
  const auto placed = system.place(x);
  for (std::size_t j = 0; j < frame.joints.size(); ++j) {
    DriveDefinition probe;
    probe.joint = static_cast<int>(j);
    const auto count = coordinates(frame.joints[j].type).size();
    for (; probe.coordinate < static_cast<int>(count); ++probe.coordinate) {
      const ConstraintSystem with_probe(frame, {probe}, system.motions(),
                                        ConstraintSystem::Drives::kAll);
      const MatrixXd row = with_probe.jacobian(placed).bottomRows(1);
      if ((row * freedom).norm() > 1e-6) {
        result.free_coordinates.push_back(probe);
      }
    }
  }
  return result;
}

/// Whether the joints, and with the drives, leave there no less freedom.
bool leaves_as_much(const ConstraintSystem& system, const Configuration& x,
                    const Mobility& than) {
  const MatrixXd all = system.jacobian(system.place(x));
  const int n = system.columns();
  const int joints =
      n - numerics::numerical_rank(all.topRows(system.joint_rows()));
  const int with_drives = system.rows() > system.joint_rows()
                              ? n - numerics::numerical_rank(all)
                              : joints;
  return than.joints <= joints && than.with_drives <= with_drives;
}

}  // namespace

Mobility mobility(const SolvingFrame& frame, const ConstraintSystem& system,
                  const Configuration& closed) {
  constexpr int kNeighbours = 6;
  Mobility general = mobility_at(frame, system, closed);
  // the rows of a tree's joints never depend on one another
  const bool has_drives = system.rows() > system.joint_rows();
  if (frame.is_tree && frame.couplings.empty() && !has_drives) return general;
  // the highest rank is the general one; a regular place has it already
  for (int which = 0; which < kNeighbours; ++which) {
    const Configuration near = neighbour(frame, closed, which);
    const bool is_regular = leaves_as_much(system, near, general);
    if (is_regular && which == 0 && general.joints <= 1) break;
    if (!is_regular) general = mobility_at(frame, system, near);
  }
  return general;
}

void require_driven(const MechanismDefinition& definition,
                    const Mobility& mobility) {
  const int drives = static_cast<int>(definition.drives.size());
  if (!mobility.dependent_drives.empty()) {
    std::vector<std::string> names;
    for (const int i : mobility.dependent_drives) {
      const DriveDefinition& drive =
          definition.drives[static_cast<std::size_t>(i)];
      names.push_back(drive_name(definition, drive));
    }
    const DriveDefinition& last =
        definition
            .drives[static_cast<std::size_t>(mobility.dependent_drives.back())];
    const std::string why =
        mobility.joints == 0 ? std::string("the joints alone fix the position")
        : names.size() == 1
            ? fmt::format("{} has no motion of its own to prescribe", names[0])
            : fmt::format("{} prescribe the same motion",
                          fmt::join(names, ", "));
    throw Error("K003", last.place,
                fmt::format("{} drive(s) for {} degree(s) of freedom: {}",
                            drives, mobility.joints, why),
                names.size() == 1
                    ? std::string("Drive another joint, and look for joints "
                                  "that coincide, or nearly do: then put them "
                                  "on one axis.")
                    : fmt::format("Remove {} of these drives.",
                                  std::max(1, drives - mobility.joints +
                                                  mobility.with_drives)));
  }
  if (mobility.with_drives > 0) {
    std::vector<std::string> names;
    for (const DriveDefinition& drive : mobility.free_coordinates) {
      names.push_back(drive_name(definition, drive));
    }
    throw Error(
        "K002", "mechanism",
        fmt::format("{} degree(s) of freedom, {} drive(s): {} motion(s) are "
                    "left unprescribed",
                    mobility.joints, drives, mobility.with_drives),
        names.empty()
            ? std::string("Join or weld the loose bodies to the mechanism.")
            : fmt::format("Add a [[drive]] on one of the joints {}.",
                          fmt::join(names, ", ")));
  }
}

}  // namespace clevis::mechanism

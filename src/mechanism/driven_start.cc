// Where a driven motion starts.
#include <fmt/format.h>

#include "base/errors.h"
#include "mechanism/assembly.h"
#include "mechanism/closed_joints.h"
#include "mechanism/drive_law.h"
#include "mechanism/driven_motion.h"
#include "mechanism/mobility.h"
#include "mechanism/singular_start.h"

namespace clevis::mechanism {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

[[noreturn]] void refuse_initial(const std::string& place,
                                 std::string_view what, double miss) {
  throw Error("K007", place,
              fmt::format("the drives fix the motion, and its {} at the start "
                          "is another than this one by {:.4g} mm{}",
                          what, 1e3 * miss, what == "velocity" ? "/s" : ""),
              "leave this [[initial]] out, or change the drive");
}

}  // namespace

VectorXd drive_positions(const MechanismDefinition& definition, double t) {
  VectorXd q(static_cast<Index>(definition.drives.size()));
  for (Index i = 0; i < q.size(); ++i) {
    q[i] = drive_target(definition.drives[static_cast<std::size_t>(i)], t)
               .position;
  }
  return q;
}

/// What [[initial]] says must be what the drives make of the start.
/// @throws Error K007.
void DrivenMotion::require_agreement(const ClosedConfiguration& at) const {
  constexpr double kAgrees = 1e-6;
  for (const InitialJointState& initial : definition_.initial_joints) {
    if (!initial.position) continue;
    DriveDefinition drive;
    drive.joint = initial.joint;
    const ConstraintSystem probe(frame_, {drive}, system_.motions(),
                                 ConstraintSystem::Drives::kAll);
    const VectorXd position = VectorXd::Constant(1, *initial.position);
    const double miss =
        std::abs(probe.residual(probe.place(at.x), position).tail(1)[0]);
    if (miss > kAgrees * frame_.length) {
      refuse_initial(initial.place, "position", miss);
    }
  }
  if (!at.factor.full_column_rank()) return;
  const WantedRates wanted =
      wanted_rates(definition_, frame_, system_.motions(), at.x);
  const auto drives = static_cast<Index>(definition_.drives.size());
  VectorXd rate = VectorXd::Zero(system_.rows());
  rate.tail(drives) = wanted.rates.head(drives);
  const VectorXd v = at.factor.solve(rate);
  const double size = std::max(v.lpNorm<Eigen::Infinity>(),
                               wanted.rates.lpNorm<Eigen::Infinity>());
  Index row = drives;
  const auto compare = [&](const std::string& place, Index rows) {
    const double miss = (wanted.rows.middleRows(row, rows) * v -
                         wanted.rates.segment(row, rows))
                            .lpNorm<Eigen::Infinity>();
    if (miss > kAgrees * size) refuse_initial(place, "velocity", miss);
    row += rows;
  };
  for (const InitialJointState& initial : definition_.initial_joints) {
    if (initial.rate) compare(initial.place, 1);
  }
  const auto bodies = static_cast<Index>(definition_.bodies.size());
  for (const InitialBodyState& initial : definition_.initial_bodies) {
    compare(initial.place, system_.columns() / bodies);
  }
}

ClosedConfiguration DrivenMotion::start() const {
  require_driven(definition_,
                 mobility(frame_, system_,
                          closed_joints(definition_, frame_, tolerance_)));
  const VectorXd targets = drive_positions(definition_, 0.0);
  const Assembled assembled =
      assemble(system_, frame_.placement, targets, tolerance_);
  if (!assembled.closed) {
    refuse_open(
        open_joints(definition_, system_, assembled.residual, tolerance_),
        "all joints with the drives at their start");
  }
  ClosedConfiguration closed = continuation_.close(assembled.x, targets);
  require_agreement(closed);
  return closed;
}

}  // namespace clevis::mechanism

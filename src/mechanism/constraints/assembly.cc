#include "mechanism/constraints/assembly.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "numerics/factors/jacobian_factor.h"

namespace clevis::mechanism {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int kIterations = 200;
constexpr double kRoundOff = 1e-14;  // of the length, reachable residual

struct Trial {
  Configuration x;
  VectorXd residual;
};

Trial try_step(const ConstraintSystem& system, const Configuration& x,
               const VectorXd& targets, const VectorXd& step) {
  Trial trial{x, {}};
  system.move(trial.x, step);
  trial.residual = system.residual(system.place(trial.x), targets);
  return trial;
}

/// The first of the shortened steps that brings the residual down, or the
/// damped steps of Levenberg and Marquardt where the pure ones fail.
bool improve(const ConstraintSystem& system, const VectorXd& targets,
             const MatrixXd& J, const VectorXd& gauss_newton, Trial& best) {
  for (double part = 1.0; part > 1e-3; part *= 0.5) {
    Trial trial = try_step(system, best.x, targets, part * gauss_newton);
    if (trial.residual.norm() < (1.0 - 1e-3 * part) * best.residual.norm()) {
      best = std::move(trial);
      return true;
    }
  }
  const VectorXd gradient = J.transpose() * best.residual;
  for (double damping = 1e-4; damping < 1e6; damping *= 10.0) {
    MatrixXd normal = J.transpose() * J;
    normal.diagonal().array() += damping;
    Trial trial =
        try_step(system, best.x, targets, -normal.ldlt().solve(gradient));
    if (trial.residual.norm() < (1.0 - 1e-6) * best.residual.norm()) {
      best = std::move(trial);
      return true;
    }
  }
  return false;
}

}  // namespace

Assembled assemble(const ConstraintSystem& system, Configuration guess,
                   const VectorXd& targets, double tolerance,
                   double rank_threshold) {
  Trial best =
      try_step(system, guess, targets, VectorXd::Zero(system.columns()));
  const double longest_step = 0.3 * system.scale({JointRow::Kind::kRotation});
  numerics::JacobianFactor factor;
  for (int i = 0; i < kIterations; ++i) {
    const double gap = largest_gap(best.residual);
    if (gap < kRoundOff * longest_step) break;
    const MatrixXd J = system.jacobian(system.place(best.x));
    factor.compute(J, nullptr, rank_threshold);
    VectorXd step = -factor.solve(best.residual);
    const double size = step.size() > 0 ? step.cwiseAbs().maxCoeff() : 0.0;
    if (size > longest_step) step *= longest_step / size;
    if (gap < tolerance) {  // polish to round-off, as far as it goes
      Trial trial = try_step(system, best.x, targets, step);
      if (!(largest_gap(trial.residual) < 0.5 * gap)) break;
      best = std::move(trial);
      continue;
    }
    if (!improve(system, targets, J, step, best)) break;
  }
  const bool closed = largest_gap(best.residual) <= tolerance;
  return {std::move(best.x), closed, std::move(best.residual)};
}

OpenJoints open_joints(const MechanismDefinition& definition,
                       const ConstraintSystem& system, const VectorXd& residual,
                       double tolerance) {
  struct Gap {
    std::string name;
    double square = 0.0, along_square = 0.0;  // [m²]
  };
  std::vector<Gap> gaps;
  for (int i = 0; i < system.rows(); ++i) {
    const auto& row = system.row_list()[static_cast<std::size_t>(i)];
    const auto joint = static_cast<std::size_t>(row.joint);
    std::string name =
        row.coupling < 0
            ? definition.joints[joint].name
            : definition.couplings[static_cast<std::size_t>(row.coupling)].name;
    if (i >= system.joint_rows()) name += " (drive)";
    auto gap = std::ranges::find(gaps, name, &Gap::name);
    if (gap == gaps.end()) gap = gaps.insert(gap, Gap{.name = name});
    const double square = residual[i] * residual[i];
    gap->square += square;
    const bool is_along = row.coupling < 0 && i < system.joint_rows() &&
                          row.row.kind == JointRow::Kind::kTranslation &&
                          row.row.axis == 2 &&
                          traits(definition.joints[joint].type).axis ==
                              JointTraits::Axis::kNeeded;
    if (is_along) gap->along_square += square;
  }
  std::ranges::stable_sort(gaps, std::ranges::greater{}, &Gap::square);
  OpenJoints open;
  open.tolerance = tolerance;
  for (const Gap& gap : gaps) {
    constexpr double kAlone = 0.9999;
    if (std::sqrt(gap.square) <= tolerance) break;
    const bool is_along = gap.along_square > kAlone * gap.square;
    if (is_along) open.along_axes.push_back(gap.name);
    open.text += fmt::format(
        "{}{} by {:.4g} mm{}", open.text.empty() ? "" : ", ", gap.name,
        1e3 * std::sqrt(gap.square), is_along ? " along its axis" : "");
  }
  return open;
}

}  // namespace clevis::mechanism

#include "elasticity/buckling/buckling_on_springs.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include <Eigen/Eigenvalues>

#include "base/algebra/append_columns.h"
#include "base/algebra/singular_vectors.h"
#include "base/algebra/unit_columns.h"
#include "base/messages/errors.h"
#include "elasticity/algebra/dense_product.h"
#include "elasticity/algebra/principal_columns.h"
#include "elasticity/nodal_loads/seat_means.h"
#include "loads/holds/seat_hold.h"

namespace clevis::elasticity {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kRoundOff = 1e-9;
constexpr double kNoEnergy = 1e-12;  // not what is soft beside others

/// Rows of held conditions on motions of the seats.
MatrixXd conditions(const loads::SeatHold& hold, const MatrixXd& motions) {
  return unit_columns(hold.held).transpose() * motions;
}

/// The largest 1/λ; 0: the loads push none of the shapes. @throws Error F003.
double largest_yield(const VectorXd& eigenvalues, const std::string& part) {
  if (!eigenvalues.allFinite()) {
    throw Error("F003", "part " + part,
                "its buckling on springs is not a finite number",
                "Please report the scene.");
  }
  return std::max(0.0, eigenvalues.maxCoeff());
}

/// Whether loads push any of some rigid motions.
/// @param inertia  of these, times the square of the speed at which the part
///   turns: what throws it over more slowly than that counts as not pushed.
bool is_pushed(const MatrixXd& motions, const MatrixXd& form,
               const MatrixXd& inertia) {
  constexpr double kPushes = 1e-3;  // of what the loads bring to any motion
  if (motions.cols() == 0) return false;
  const Eigen::SelfAdjointEigenSolver<MatrixXd> pushed(
      motions.transpose() * (form - inertia) * motions, Eigen::EigenvaluesOnly);
  return pushed.eigenvalues().maxCoeff() > kPushes * form.norm();
}

/// Of a part that turns, on its rigid motions, times the square of its speed.
/// @param motions  of the seats by these, about their points.
MatrixXd turning_inertia(const BucklingProblem& problem,
                         const MatrixXd& motions) {
  const auto& history = problem.history;
  const double square = history.instants.back().rigid.omega.squaredNorm();
  if (problem.mass == nullptr || motions.rows() < 6 || square == 0.0) {
    return MatrixXd::Zero(motions.cols(), motions.cols());
  }
  const part::MassProperties& mass = *problem.mass;
  const auto turn = motions.middleRows<3>(3);
  MatrixXd way = motions.topRows<3>();
  const Eigen::Vector3d arm = mass.p_LCm - history.seats.front().p_LS;
  for (Index k = 0; k < way.cols(); ++k) {
    way.col(k) += Eigen::Vector3d(turn.col(k)).cross(arm);
  }
  return square * (mass.mass * way.transpose() * way +
                   turn.transpose() * mass.inertia_LCm * turn);
}

/// Whether a part keeps its direction over a motion, and no blow throws it
/// about: what turns, or is thrown, moves as its loads have it. What guides the
/// loads of cases and files is not known.
bool keeps_place(const loads::LoadHistory& history) {
  constexpr double kTurn = 0.05;    // [rad]
  constexpr double kThrown = 50.0;  // [m/s²]
  const auto& instants = history.instants;
  if (instants.front().is_case || history.rows) return false;
  if (std::ranges::any_of(instants, [](const loads::InstantLoad& load) {
        return load.rigid.acceleration.norm() > kThrown;
      })) {
    return false;
  }
  double turned = 0.0;
  for (std::size_t i = 1; i < instants.size(); ++i) {
    turned += 0.5 * (instants[i].time - instants[i - 1].time) *
              (instants[i].rigid.omega + instants[i - 1].rigid.omega).norm();
  }
  return turned < kTurn &&
         (instants.size() > 1 || instants.front().rigid.omega.isZero(0.0));
}

}  // namespace

BucklingOnSprings::BucklingOnSprings(const BucklingProblem& problem,
                                     const StressedPart& stressed)
    : problem_(problem),
      history_(problem.history),
      stressed_(stressed),
      name_(problem.name) {
  constexpr std::size_t kMost = 65;
  const HeldPart& part = stressed.part();
  const std::size_t all = history_.instants.size();
  if (!history_.hold || !part.is_free() || all == 0) return;
  stands_ = keeps_place(history_);
  hold_alone_ = std::ranges::all_of(problem.holds, [](const auto& hold) {
    return hold.groups.empty() && hold.held.empty();
  });
  const std::size_t count = std::min(kMost, all);
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t i = count == 1 ? 0 : k * (all - 1) / (count - 1);
    if (is_sprung(static_cast<Index>(i))) {
      instants_.push_back(static_cast<Index>(i));
    }
  }
  if (instants_.empty() && !stands_) return;
  rigid_ = part.rigid();
  motions_ = transposed_product(means_at(0), rigid_);
}

MatrixXd BucklingOnSprings::means_at(Index instant) const {
  return seat_means(problem_.discretization, history_.seats,
                    history_.instants[static_cast<std::size_t>(instant)].zones,
                    name_);
}

bool BucklingOnSprings::is_sprung(Index instant) const {
  return !hold_at(instant).sprung.isZero(0.0);
}

loads::SeatHold BucklingOnSprings::hold_at(Index instant) const {
  loads::SeatHold hold = history_.hold_that_lasts(
      history_.instants[static_cast<std::size_t>(instant)].time);
  // In a motion bodies on springs are not at rest between them.
  return stands_ ? loads::held_slowly(std::move(hold)) : hold;
}

double BucklingOnSprings::of_rigid(Index instant, const MatrixXd& form) const {
  return rigid_yield(hold_at(instant), form);
}

double BucklingOnSprings::rigid_yield(const loads::SeatHold& hold,
                                      const MatrixXd& form) const {
  const MatrixXd left = null_space(conditions(hold, motions_), kRoundOff);
  if (left.cols() == 0) return 0.0;
  const MatrixXd springs = hold.sprung.transpose() * motions_ * left;
  if (springs.isZero(0.0)) return 0.0;
  const MatrixXd unit =
      left * orthonormal_combinations(springs.transpose() * springs, kNoEnergy);
  const Eigen::SelfAdjointEigenSolver<MatrixXd> pushed(
      unit.transpose() * form * unit, Eigen::EigenvaluesOnly);
  return largest_yield(pushed.eigenvalues(), name_);
}

std::optional<double> BucklingOnSprings::factor_of_position(
    const loads::SeatHold& hold, const MatrixXd& form) const {
  const MatrixXd left = null_space(conditions(hold, motions_), kRoundOff);
  const bool is_sprung = !hold.sprung.isZero(0.0) && left.cols() > 0;
  const MatrixXd free =
      is_sprung ? MatrixXd(left *
                           null_space(hold.sprung.transpose() * motions_ * left,
                                      kRoundOff))
                : left;
  if (is_pushed(free, form, turning_inertia(problem_, motions_))) return 0.0;
  const double yield = rigid_yield(hold, form);
  if (yield == 0.0) return std::nullopt;
  return 1.0 / yield;
}

BucklingOnSprings::Position BucklingOnSprings::position(
    const MatrixXd& form) const {
  if (!stands_) return {};
  const Index last = std::ssize(history_.instants) - 1;
  const loads::SeatHold hold = hold_at(last);
  Position position{.stands = true};
  if (hold.is_pressed_meanwhile) {
    const MatrixXd left = null_space(conditions(hold, motions_), kRoundOff);
    position.is_open =
        is_pushed(left, form, turning_inertia(problem_, motions_));
    return position;
  }
  const auto factor = factor_of_position(hold, form);
  if (factor && *factor <= 1.0) {
    position.topples = factor;
    return position;
  }
  if (!history_.hold_at_rest) return position;
  auto at_rest = history_.hold_at_rest(history_.instants.back().time);
  if (!at_rest) return position;
  position.topples =
      factor_of_position(loads::held_slowly(std::move(*at_rest)), form);
  position.yields_slowly = position.topples.has_value();
  return position;
}

/// Rigid motions and shapes, which grow.
class BucklingOnSprings::Space {
 public:
  Space(const BucklingOnSprings& of, Index instant)
      : of_(of),
        part_(of.stressed_.part()),
        means_(of.means_at(instant)),
        hold_(of.hold_at(instant)),
        pushing_(of.stressed_.pushing(instant)),
        rigid_(of.rigid_.cols()),
        shapes_(of.rigid_),
        pushed_(pushing_(shapes_)),
        motions_(of.motions_) {}

  /// @param unknowns  equations × columns [√J].
  void add(const MatrixXd& unknowns) {
    const MatrixXd more = part_.displacements(unknowns, 0);
    append_columns(unknowns, unknowns_);
    append_columns(more, shapes_);
    append_columns(pushing_(more), pushed_);
    append_columns(transposed_product(means_, more), motions_);
  }
  /// What unit reactions of joints, drives and springs bend.
  void add_reactions() {
    for (const MatrixXd* wrenches : {&hold_.held, &hold_.sprung}) {
      if (wrenches->cols() == 0) continue;
      add(part_.answer_in_balance(product(means_, unit_columns(*wrenches)), 0));
    }
  }

  struct Solution {
    double yield{};  ///< largest 1/λ [1]
    /// Joints hold nothing twice, and nothing moves freely.
    bool is_known = false;
    MatrixXd forces;  ///< what loads bring to the largest few's shapes [N]
  };
  Solution solve() const {
    constexpr double kDependent = 1e-9;
    const MatrixXd combine = orthonormal_combinations(
        transposed_product(unknowns_, unknowns_), kDependent);
    const Index bent = combine.cols(), all = rigid_ + bent;
    MatrixXd motions(motions_.rows(), all);
    motions << motions_.leftCols(rigid_),
        motions_.rightCols(unknowns_.cols()) * combine;
    // Bent by 1 √J the seats move far less than by a rigid motion of 1.
    const double scale =
        motions.leftCols(rigid_).cwiseAbs().maxCoeff() /
        std::max(motions.rightCols(bent).cwiseAbs().maxCoeff(), 1e-300);
    motions.rightCols(bent) *= scale;
    const MatrixXd left = null_space(conditions(hold_, motions), kRoundOff);
    const MatrixXd springs = hold_.sprung.transpose() * motions * left;
    const MatrixXd strained = scale * left.bottomRows(bent);
    MatrixXd unit =
        left * orthonormal_combinations(strained.transpose() * strained +
                                            springs.transpose() * springs,
                                        kNoEnergy);
    const Index held_of_rigid =
        rigid_ -
        null_space(conditions(hold_, motions_.leftCols(rigid_)), kRoundOff)
            .cols();
    Solution solution;
    solution.is_known =
        all - left.cols() == held_of_rigid && unit.cols() == left.cols();
    MatrixXd of_shapes(shapes_.cols(), unit.cols());
    of_shapes << unit.topRows(rigid_), scale * combine * unit.bottomRows(bent);
    const MatrixXd form = of_shapes.transpose() *
                          transposed_product(shapes_, pushed_) * of_shapes;
    const Eigen::SelfAdjointEigenSolver<MatrixXd> pushed(
        0.5 * (form + form.transpose()));
    constexpr Index kShapes = 2;
    const Index n = std::min(kShapes, unit.cols());
    solution.yield = largest_yield(pushed.eigenvalues(), of_.name_);
    solution.forces =
        product(pushed_, of_shapes * pushed.eigenvectors().rightCols(n));
    return solution;
  }

 private:
  const BucklingOnSprings& of_;
  const HeldPart& part_;
  MatrixXd means_;  ///< of the seats at this instant
  loads::SeatHold hold_;
  std::function<MatrixXd(const MatrixXd&)> pushing_;
  Index rigid_;
  MatrixXd unknowns_;
  MatrixXd shapes_;   ///< rigid ones, then those of the unknowns
  MatrixXd pushed_;   ///< what loads bring to them [N]
  MatrixXd motions_;  ///< of the seats
};

BucklingOnSprings::Together BucklingOnSprings::together(
    Index instant, const MatrixXd& start) const {
  constexpr int kMostSteps = 12;
  constexpr double kSettled = 1e-4;
  Space space(*this, instant);
  space.add_reactions();
  space.add(start);
  double before = 0.0;
  for (int step = 0;; ++step) {
    const Space::Solution found = space.solve();
    const bool settled =
        step > 0 && std::abs(found.yield - before) <= kSettled * before;
    if (settled || step == kMostSteps) {
      return {found.yield, settled && found.is_known};
    }
    before = found.yield;
    space.add(stressed_.part().answer_in_balance(found.forces, 0));
  }
}

}  // namespace clevis::elasticity

#include "elasticity/buckling/buckling.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include <Eigen/Eigenvalues>

#include "base/algebra/append_columns.h"
#include "base/algebra/singular_vectors.h"
#include "base/algebra/unit_columns.h"
#include "dynamics/systems/block_krylov.h"
#include "elasticity/algebra/dense_product.h"
#include "elasticity/algebra/principal_columns.h"
#include "elasticity/assembly/initial_stress.h"
#include "elasticity/buckling/buckling_on_springs.h"
#include "elasticity/buckling/stressed_part.h"

namespace clevis::elasticity {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr Index kBlock = 4;

/// Unknowns that yield most to stress of 1 Pa in all directions: what bends or
/// twists easily, whatever the loads.
MatrixXd yielding_shapes(const StressedPart& stressed) {
  const HeldPart& part = stressed.part();
  constexpr int kSteps = 3;
  constexpr Index kShapes = 8;
  const MassMatrix unit = stressed.stress().unit_stiffness(part.pairs());
  dynamics::BlockKrylov space(
      part.answer_to(
          [&](const MatrixXd& u) {
            return multiply(unit, u);
          },
          0),
      dynamics::random_block(part.equations(),
                             std::min(kBlock, part.equations())),
      {});
  for (int step = 0; step < kSteps && !space.is_closed(); ++step) {
    space.extend();
  }
  const auto ritz = space.ritz_values();
  const Index n = std::min(kShapes, space.size());
  return space.basis() * ritz.vectors.leftCols(n);
}

/// Shapes that are tried with the stresses of every instant and every hold. The
/// holds' differ by motions of the whole part, which are among them.
class TrialSpace {
 public:
  TrialSpace(const StressedPart& stressed, const MatrixXd& unknowns)
      : stressed_(stressed),
        part_(stressed.part()),
        shapes_(part_.rigid()),
        forms_(0, stressed.coefficients().rows()) {
    add(unknowns);
  }
  void add(const MatrixXd& unknowns) {
    const Index before = unknowns_.cols() > 0 ? shapes_.cols() : 0;
    append_columns(unknowns, unknowns_);
    append_columns(part_.displacements(unknowns, 0), shapes_);
    motions_ = stressed_.pushes().motions(shapes_);
    const MatrixXd more =
        stressed_.stress().forms(part_.pairs(), shapes_, before);
    forms_.conservativeResize(forms_.rows() + more.rows(), Eigen::NoChange);
    forms_.bottomRows(more.rows()) = more;
    orthonormalise();
  }
  /// Largest 1/λ of an instant in the space, and of its loads turned about.
  struct Ends {
    double yield{}, stiffening{};
  };
  Ends ends(Index instant, std::size_t hold) const {
    if (of_hold_[hold].cols() == 0) return {};
    const VectorXd all =
        solved(instant, hold, Eigen::EigenvaluesOnly).eigenvalues();
    return {all.tail<1>()[0], std::max(0.0, -all[0])};
  }
  /// Of motions of the rigid part, what its loads bring.
  MatrixXd form_of_rigid(Index instant) const {
    const Index rigid = part_.rigid().cols();
    return form(instant).topLeftCorner(rigid, rigid);
  }
  /// Unknowns of the shapes with the largest.
  MatrixXd best(Index instant, std::size_t hold, Index count) const {
    const MatrixXd& shapes = of_hold_[hold];
    if (shapes.cols() == 0) {
      return dynamics::random_block(part_.equations(),
                                    std::min(count, part_.equations()));
    }
    return unknowns_ * shapes.bottomRows(unknowns_.cols()) *
           solved(instant, hold, Eigen::ComputeEigenvectors)
               .eigenvectors()
               .rightCols(std::min(count, shapes.cols()));
  }

 private:
  void orthonormalise() {
    constexpr double kSame = 1e-9;  // what is dependent is left out
    const MatrixXd to_orthonormal = orthonormal_combinations(
        transposed_product(unknowns_, unknowns_), kSame);
    of_hold_.clear();
    for (std::size_t hold = 0; hold < part_.holds(); ++hold) {
      const MatrixXd held = to_orthonormal * left_free(to_orthonormal, hold);
      const MatrixXd rigid =
          part_.broken(shapes_.rightCols(unknowns_.cols()), hold);
      MatrixXd shapes(shapes_.cols(), held.cols());
      shapes << -rigid * held, held;
      of_hold_.push_back(std::move(shapes));
    }
  }
  /// Of orthonormal shapes the combinations that a hold beyond six conditions
  /// leaves free, orthonormal.
  MatrixXd left_free(const MatrixXd& to_orthonormal, std::size_t hold) const {
    constexpr double kHeld = 1e-6;
    const MatrixXd& beyond = part_.beyond(hold);
    if (beyond.cols() == 0) {
      return MatrixXd::Identity(to_orthonormal.cols(), to_orthonormal.cols());
    }
    const SingularVectors by_hold = singular_vectors(
        transposed_product(beyond, unknowns_) * to_orthonormal);
    return by_hold.left(by_hold.count_above(kHeld));
  }
  /// −K_G and what the mechanism adds.
  MatrixXd form(Index instant) const {
    const VectorXd entries = forms_ * stressed_.coefficients().col(instant);
    const Index m = shapes_.cols();
    MatrixXd found(m, m);
    Index pair = 0;
    for (Index b = 0; b < m; ++b) {
      for (Index a = 0; a <= b; ++a) {
        found(a, b) = found(b, a) = -entries[pair++];
      }
    }
    if (!stressed_.pushes().is_empty()) {
      found +=
          motions_.transpose() * stressed_.pushes().gain(instant) * motions_;
    }
    return found;
  }
  Eigen::SelfAdjointEigenSolver<MatrixXd> solved(
      Index instant, std::size_t hold, Eigen::DecompositionOptions what) const {
    const MatrixXd& shapes = of_hold_[hold];
    return Eigen::SelfAdjointEigenSolver<MatrixXd>(
        shapes.transpose() * form(instant) * shapes, what);
  }

  const StressedPart& stressed_;
  const HeldPart& part_;
  MatrixXd unknowns_;
  MatrixXd shapes_;   ///< rigid ones, then those of the unknowns with one hold
  MatrixXd forms_;    ///< of the shapes, a column per load column
  MatrixXd motions_;  ///< of seats that are pushed, in the shapes
  /// Of each hold its orthonormal shapes, of shapes_.
  std::vector<MatrixXd> of_hold_;
};

/// The largest 1/λ of one instant.
struct Yield {
  double value{};     ///< 1/λ; 0: below 1/highest()
  double residual{};  ///< relative
  MatrixXd shapes;    ///< unknowns of the largest few, the largest first
};

/// @param fewest  times that the stresses are applied to the start.
Yield largest_yield(const StressedPart& stressed, std::size_t hold,
                    Index instant, const MatrixXd& start, int fewest) {
  constexpr double kTolerance = 3e-4;  // λ has its square as error
  constexpr int kMostSteps = 40;
  const HeldPart& part = stressed.part();
  dynamics::BlockKrylov space(part.answer_to(stressed.pushing(instant), hold),
                              start, {});
  for (int step = 1;; ++step) {
    space.extend();
    const auto ritz = space.ritz_values();
    const double theta = ritz.theta[0];
    const double rest = ritz.residual[0];
    const bool is_low = theta + rest < 1.0 / stressed.highest();
    const bool settled = rest < kTolerance * theta;
    const bool is_last = space.is_closed() || step == kMostSteps;
    if (!is_last && (step < fewest || !(settled || is_low))) continue;
    const Index n = std::min<Index>(2, space.size());
    return {theta, rest / std::abs(theta),
            space.basis() * ritz.vectors.leftCols(n)};
  }
}

VectorXd to_unit(VectorXd shape) {
  double largest = 0.0;
  for (Index row = 0; row < shape.size(); row += 3) {
    largest = std::max(largest, shape.segment<3>(row).norm());
  }
  return largest > 0.0 ? VectorXd(shape / largest) : shape;
}

/// A shape that is known, and others at random beside it.
MatrixXd start_near(const HeldPart& part, const VectorXd& shape) {
  MatrixXd start = dynamics::random_block(part.equations(),
                                          std::min(kBlock, part.equations()));
  start.col(0) = part.unknowns(shape);
  return unit_columns(start);
}

/// Puts an instant's shape in the place of what was the best.
void take(const StressedPart& part, const Yield& yield, Index instant,
          BucklingMode& best) {
  best.instant = instant;
  best.residual = yield.residual;
  best.shape = to_unit(part.part().shapes(yield.shapes.leftCols(1), best.hold));
  best.is_above = !(yield.value > 1.0 / part.highest());
  best.factor = best.is_above ? part.highest() : 1.0 / yield.value;
}

BucklingMode none_below(double highest) {
  BucklingMode none;
  none.is_above = true;
  none.factor = highest;
  return none;
}

/// The largest 1/λ of one instant with one hold, from a shape that is near.
BucklingMode lowest_near(const StressedPart& part, const VectorXd& shape) {
  constexpr int kFewest = 4;  // for the random ones to come near
  BucklingMode best = none_below(part.highest());
  const Yield yield =
      largest_yield(part, 0, 0, start_near(part.part(), shape), kFewest);
  if (yield.value > 0.0) take(part, yield, 0, best);
  return best;
}

/// The largest 1/λ of all instants with their holds; one is solved for whatever
/// the trial says.
/// @param space  takes in what is found.
BucklingMode lowest_of_all(const StressedPart& part, TrialSpace& space) {
  constexpr double kGain = 1.0 + 1e-3;
  // By trial factors are too high, of shapes near the right ones little.
  const double far_above = 0.1 / part.highest();
  constexpr int kFewest = 2;
  BucklingMode best = none_below(part.highest());
  std::set<std::pair<std::size_t, Index>> solved;
  double largest = 0.0;
  while (true) {
    std::optional<std::pair<std::size_t, Index>> next;
    double expected = -1.0;
    for (std::size_t hold = 0; hold < part.part().holds(); ++hold) {
      for (Index i = 0; i < part.instants(); ++i) {
        if (!part.part().is_held(hold, i) || solved.contains({hold, i})) {
          continue;
        }
        const auto [yield, stiffening] = space.ends(i, hold);
        best.stiffening = std::max(best.stiffening, stiffening);
        if (next && yield <= expected) continue;
        next = {hold, i};
        expected = yield;
      }
    }
    if (!next ||
        (!solved.empty() && expected <= std::max(kGain * largest, far_above))) {
      return best;
    }
    const auto [hold, instant] = *next;
    if (solved.empty()) {
      best.hold = hold;
      best.instant = instant;
    }
    const Yield yield = largest_yield(
        part, hold, instant, space.best(instant, hold, kBlock), kFewest);
    solved.insert(*next);
    space.add(yield.shapes);
    if (yield.value > largest) {
      largest = yield.value;
      best.hold = hold;
      take(part, yield, instant, best);
    }
  }
}

/// The instants with the largest sums are solved for, until none is left whose
/// sum is larger than what they have together. @param enough  as of
/// BucklingProblem.
BucklingMode::OnSprings on_springs(const StressedPart& part,
                                   const BucklingOnSprings& springs,
                                   const TrialSpace& space, double enough) {
  constexpr double kSofterAlone = 4.0;
  constexpr std::size_t kMost = 6;
  struct Apart {
    Index instant{};
    std::size_t hold{};
    double own{}, springs{};
  };
  const double counts = 1.0 / enough;
  const double softer = springs.hold_alone() ? kSofterAlone : 1.0;
  const auto own = [&](Index i) {
    Apart apart{.instant = i};
    for (std::size_t hold = 0; hold < part.part().holds(); ++hold) {
      if (!part.part().is_held(hold, i)) continue;
      const double yield = space.ends(i, hold).yield;
      if (yield <= apart.own) continue;
      apart.hold = hold;
      apart.own = yield;
    }
    return apart;
  };
  std::vector<Apart> found;
  for (const Index i : springs.instants()) {
    Apart apart = own(i);
    if (apart.own < counts && !springs.stands()) continue;
    apart.springs = springs.of_rigid(i, space.form_of_rigid(i));
    if (softer * apart.own + apart.springs < counts) continue;
    if (apart.springs < 1.0) found.push_back(apart);
  }
  std::ranges::sort(found, std::greater{}, [&](const Apart& apart) {
    return softer * apart.own + apart.springs;
  });
  BucklingMode::OnSprings most;
  double largest = 0.0;  // own of those that are solved for
  for (std::size_t k = 0; k < std::min(kMost, found.size()); ++k) {
    const Apart& apart = found[k];
    const double sum = softer * apart.own + apart.springs;
    if (sum <= most.yield()) break;
    const BucklingMode::OnSprings next{
        apart.own, apart.springs, softer,
        springs.together(apart.instant,
                         space.best(apart.instant, apart.hold, kBlock))};
    largest = std::max(largest, apart.own);
    if (next.yield() > most.yield()) most = next;
  }
  // Where it rises no other instant may have more: one as hard on springs of
  // its own has not.
  constexpr double kLarger = 1.02;
  for (Index i = 0; most.rises() && i < part.instants(); ++i) {
    const double yield = own(i).own;
    if (yield <= most.yield()) continue;
    if (yield > kLarger * largest || !springs.is_sprung(i) ||
        springs.of_rigid(i, space.form_of_rigid(i)) >= 1.0) {
      most.may_be_larger = true;
      break;
    }
  }
  return most;
}

}  // namespace

BucklingMode lowest_buckling(const BucklingProblem& problem) {
  const HeldPart held(problem);
  const StressedPart part(problem, held);
  // Without stress, what the mechanism brings may still push it over.
  if (part.coefficients().rows() == 0 && part.pushes().is_empty()) {
    return none_below(problem.highest);
  }
  if (problem.known != nullptr && part.instants() == 1 &&
      part.part().holds() == 1) {
    return lowest_near(part,
                       carried_over<3>(*problem.known, problem.discretization));
  }
  TrialSpace space(part, yielding_shapes(part));
  BucklingMode mode = lowest_of_all(part, space);
  const BucklingOnSprings springs(problem, part);
  mode.on_springs = on_springs(part, springs, space, problem.enough);
  mode.position = springs.position(space.form_of_rigid(part.instants() - 1));
  return mode;
}

}  // namespace clevis::elasticity

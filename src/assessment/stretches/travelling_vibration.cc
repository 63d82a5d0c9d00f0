#include "assessment/stretches/travelling_vibration.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "assessment/pace/load_pace.h"
#include "assessment/stretches/excited_modes.h"
#include "base/algebra/singular_vectors.h"
#include "base/algebra/unit_columns.h"
#include "dynamics/load_vibration/moving_constraints.h"
#include "loads/history/motion_instants.h"
#include "stress/field/stress_history.h"

namespace clevis::assessment {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// What a hold holds, orthonormal, and what it weighs, springs and damps as
/// independent wrenches, 6 n × columns.
struct HoldColumns {
  MatrixXd held, weighed, sprung, damped;
  MatrixXd free;  ///< motions of the rigid part that none of them feels
};

/// Independent columns W' with W' W'ᵀ = W Wᵀ, or of its span orthonormal ones.
MatrixXd independent(const MatrixXd& columns, Index rows, bool orthonormal) {
  constexpr double kRoundOff = 1e-9;
  if (columns.size() == 0) return MatrixXd(rows, 0);
  const SingularVectors found = singular_vectors(columns);
  const Index rank = found.rank(kRoundOff);
  MatrixXd some = found.U.leftCols(rank);
  if (!orthonormal) some *= found.sigma.head(rank).asDiagonal();
  return some;
}

/// Turns columns among themselves so that they go on from others.
/// @return by what they differ then [1]; nothing: they do not go on.
std::optional<double> go_on(const MatrixXd& before, MatrixXd& columns) {
  constexpr double kFar = 0.3;
  if (before.cols() != columns.cols()) return std::nullopt;
  if (before.cols() == 0) return 0.0;
  const SingularVectors overlap =
      singular_vectors(columns.transpose() * before);
  columns = (columns * overlap.U * overlap.V.transpose()).eval();
  const double apart = (columns - before).norm() / before.norm();
  return apart <= kFar ? std::optional(apart) : std::nullopt;
}

/// A part's shapes, and behind them coordinates for what its seats weigh,
/// spring and damp, which constraints tie to them.
class TravellingPart {
 public:
  TravellingPart(const PartJob& job, const LoadSet& motion,
                 const loads::SpreadSeats& seats,
                 const elasticity::SeatShapes& shapes)
      : job_(job), motion_(motion), seats_(seats), shapes_(shapes) {}

  /// @return false: it cannot be followed.
  bool take(const std::function<loads::SeatHold(std::size_t)>& hold_of) {
    constexpr Index kMostNumbers = 50'000'000;  // 400 MB of rows
    const auto& instants = motion_.history.instants;
    const auto count = static_cast<Index>(instants.size());
    time_.resize(count);
    std::vector<MatrixXd> rows, forces, all_forces;
    HoldColumns before;
    for (Index i = 0; i < count; ++i) {
      const auto at = static_cast<std::size_t>(i);
      if (!instants[at].surface_loads.empty()) return false;
      const loads::SeatHold hold = hold_of(at);
      if (hold.swinging) return false;
      const VectorXd wrenches = seat_wrenches(instants[at]);
      HoldColumns columns{independent(hold.held, wrenches.size(), true),
                          independent(hold.weighed, wrenches.size(), false),
                          independent(hold.sprung, wrenches.size(), false),
                          independent(hold.damped, wrenches.size(), false)};
      columns.free = free_motions(columns, at);
      time_[i] = instants[at].time;
      if (i > 0 && !go_on_from(before, i, columns)) return false;
      if (i == 0) set_system(columns);
      rows.push_back(rows_of(columns, at));
      if (rows.back().size() * count > kMostNumbers) return false;
      forces.push_back(VectorXd::Zero(system_.mass.size()));
      forces.back().topRows(shapes()) = forces_on_shapes(columns, wrenches, at);
      all_forces.push_back(VectorXd::Zero(system_.mass.size()));
      all_forces.back().middleRows(shapes_.rigid(),
                                   shapes() - shapes_.rigid()) =
          on_shapes(wrenches, at).tail(shapes() - shapes_.rigid());
      before = std::move(columns);
    }
    const double sides =
        loads::kEventSides * loads::motion_duration(motion_.history);
    rows_.emplace(time_, std::move(rows), sides, motion_.history.bends,
                  dynamics::SmoothPath::Slopes::kLimited);
    const auto slopes = motion_.history.rows
                            ? dynamics::SmoothPath::Slopes::kOfSecants
                            : dynamics::SmoothPath::Slopes::kLimited;
    const auto& bends = motion_.history.bends;
    forces_.emplace(time_, std::move(forces), sides, bends, slopes);
    all_forces_.emplace(time_, std::move(all_forces), sides, bends, slopes);
    return true;
  }

  /// Forces of what turns beside the part, which are not followed, over those
  /// of inertia in a vibration that bends it as its loads at rest do [1].
  /// @param period  of the vibration [s].
  double turning(double period) const {
    constexpr double kCoriolis = 2.0;
    double most = 0.0;
    for (const auto& [instant, rate] : turned_) {
      const MatrixXd& rows = rows_->value(instant);
      const VectorXd q =
          dynamics::at_rest(system_, rows, forces_->value(instant))
              .head(shapes());
      const MatrixXd weighed = rows.block(held_, 0, rate.rows(), shapes());
      const double moved = std::hypot(q.norm(), (weighed * q).norm());
      if (moved > 0.0) most = std::max(most, (rate * q).norm() / moved);
    }
    return kCoriolis * most * period / 2.0 / std::numbers::pi;
  }

  Index shapes() const { return shapes_.squares().size(); }
  double duration() const { return time_[time_.size() - 1] - time_[0]; }

  /// Where it is bent most.
  struct Bends {
    MatrixXd coordinates;  ///< shapes × times
    VectorXd time;         ///< [s]
  };
  /// By its loads at rest. @param times  as of swings().
  Bends resting(double step, Index times) const {
    Largest kept(*this, shapes_.squares(), times);
    dynamics::follow_at_rest(system_, *rows_, *forces_, step,
                             [&](double t, const VectorXd& q) {
                               kept.take(t, q);
                             });
    return std::move(kept.bends);
  }
  /// As it swings. @param step  [s]. @param times  equal ones, of each of which
  ///   the step with the most strain energy is kept.
  /// @param stiffer  times as stiff as the shapes are [1].
  Bends swings(double step, Index times, double stiffer) const {
    return swung(*rows_, *forces_, step, times, stiffer);
  }
  /// As if it always were held and weighed as at an instant. @pre no seat
  ///   travels.
  Bends swings_held(Index instant, double step, Index times) const {
    const std::vector<MatrixXd> same(2, rows_->value(instant));
    const dynamics::SmoothPath rows(
        Eigen::Vector2d(time_[0], time_[time_.size() - 1]), same);
    return swung(rows, *all_forces_, step, times, 1.0);
  }
  /// At rest at some times, shapes × times.
  MatrixXd resting_at(const VectorXd& times) const {
    MatrixXd all(shapes(), times.size());
    for (Index k = 0; k < times.size(); ++k) {
      all.col(k) =
          dynamics::at_rest(system_, rows_->at(times[k]), forces_->at(times[k]))
              .head(shapes());
    }
    return all;
  }

 private:
  Bends swung(const dynamics::SmoothPath& rows,
              const dynamics::SmoothPath& forces, double step, Index times,
              double stiffer) const {
    const VectorXd squares = stiffer * shapes_.squares();
    dynamics::DiagonalSystem system = system_;
    system.stiffness.head(shapes()) = squares;
    // Those that steps do not follow are at rest: they would ring.
    constexpr double kOfStep = 3.0;
    for (Index k = 0; k < shapes(); ++k) {
      if (squares[k] * step * step < kOfStep * kOfStep) continue;
      system.mass[k] = system.damping[k] = 0.0;
    }
    Largest kept(*this, squares, times);
    dynamics::follow(system, rows, forces, step,
                     [&](double t, const VectorXd& q) {
                       kept.take(t, q);
                     });
    return std::move(kept.bends);
  }

  /// Of equal times what has the most strain energy.
  struct Largest {
    Largest(const TravellingPart& part, VectorXd of_shapes, Index times)
        : squares(std::move(of_shapes)),
          from(part.time_[0]),
          each(part.duration() / static_cast<double>(times)),
          most(VectorXd::Constant(times, -1.0)),
          bends{MatrixXd::Zero(squares.size(), times), VectorXd::Zero(times)} {}

    void take(double t, const VectorXd& q) {
      const auto own = q.head(squares.size());
      const double energy = own.cwiseAbs2().dot(squares);
      const Index k = std::clamp<Index>(static_cast<Index>((t - from) / each),
                                        0, most.size() - 1);
      if (energy <= most[k]) return;
      most[k] = energy;
      bends.coordinates.col(k) = own;
      bends.time[k] = t;
    }

    VectorXd squares;
    double from, each;
    VectorXd most;
    Bends bends;
  };
  /// @return false: they do not.
  bool go_on_from(const HoldColumns& before, Index instant,
                  HoldColumns& columns) {
    constexpr double kRoundOff = 1e-6;  // at the two sides of an event
    const double interval = time_[instant] - time_[instant - 1];
    for (MatrixXd HoldColumns::*of :
         {&HoldColumns::held, &HoldColumns::weighed, &HoldColumns::sprung,
          &HoldColumns::damped, &HoldColumns::free}) {
      const auto apart = go_on(before.*of, columns.*of);
      if (!apart) return false;
      if (*apart < kRoundOff) continue;
      // What changes at once was struck.
      if (interval <=
          loads::kEventSides * loads::motion_duration(motion_.history)) {
        return false;
      }
      if (of != &HoldColumns::weighed) continue;
      turned_.emplace_back(instant,
                           shapes_.along_shapes(seats_.spread(
                               (columns.weighed - before.weighed) / interval,
                               static_cast<std::size_t>(instant))));
    }
    return true;
  }

  /// Orthonormal, shapes of the rigid part × motions.
  MatrixXd free_motions(const HoldColumns& columns, std::size_t instant) const {
    constexpr double kFelt = 1e-9;
    MatrixXd felt(columns.held.cols() + columns.sprung.cols(), shapes_.rigid());
    if (felt.rows() == 0) {
      return MatrixXd::Identity(shapes_.rigid(), shapes_.rigid());
    }
    MatrixXd both(columns.held.rows(), felt.rows());
    both << columns.held, columns.sprung;
    felt = shapes_.along_shapes(seats_.spread(unit_columns(both), instant))
               .leftCols(shapes_.rigid());
    return null_space(felt, kFelt);
  }

  /// Constraints × coordinates.
  MatrixXd rows_of(const HoldColumns& columns, std::size_t instant) const {
    const auto along = [&](const MatrixXd& wrenches) {
      return shapes_.along_shapes(seats_.spread(wrenches, instant));
    };
    const Index held = columns.held.cols();
    const Index free = columns.free.cols();
    const Index tied =
        columns.weighed.cols() + columns.sprung.cols() + columns.damped.cols();
    MatrixXd rows = MatrixXd::Zero(held + free + tied, shapes() + tied);
    rows.topLeftCorner(held, shapes()) = along(columns.held);
    // Vibrations have no momentum along what the rigid part is free to do, and
    // its loads none that changes it.
    const MatrixXd weighed = along(columns.weighed);
    rows.block(held, 0, free, shapes_.rigid()) = columns.free.transpose();
    rows.block(held, 0, free, shapes()) +=
        (weighed.leftCols(shapes_.rigid()) * columns.free).transpose() *
        weighed;
    Index from = held + free;
    for (const MatrixXd* some :
         {&columns.weighed, &columns.sprung, &columns.damped}) {
      rows.block(from, 0, some->cols(), shapes()) = along(*some);
      from += some->cols();
    }
    rows.bottomRightCorner(tied, tied).diagonal().setConstant(-1.0);
    return rows;
  }

  void set_system(const HoldColumns& columns) {
    const Index weighed = columns.weighed.cols();
    const Index sprung = columns.sprung.cols();
    const Index damped = columns.damped.cols();
    const Index all = shapes() + weighed + sprung + damped;
    held_ = columns.held.cols() + columns.free.cols();
    system_.mass = system_.damping = system_.stiffness = VectorXd::Zero(all);
    system_.mass.head(shapes() + weighed).setOnes();
    system_.stiffness.head(shapes()) = shapes_.squares();
    system_.stiffness.segment(shapes() + weighed, sprung).setOnes();
    system_.damping.tail(damped).setOnes();
    system_.damping.head(shapes()) =
        2.0 * job_.part.damping * shapes_.squares().cwiseMax(0.0).cwiseSqrt();
  }

  /// Reactions of what is held do no work on what moves: they are left out.
  /// Loads are in balance, so that what they and inertia do on the rigid part
  /// is what those would.
  VectorXd forces_on_shapes(const HoldColumns& columns,
                            const VectorXd& wrenches,
                            std::size_t instant) const {
    const VectorXd reactions =
        columns.held * (columns.held.transpose() * wrenches);
    VectorXd forces = on_shapes(wrenches - reactions, instant);
    forces.head(shapes_.rigid()) =
        -on_shapes(reactions, instant).head(shapes_.rigid());
    return forces;
  }
  VectorXd on_shapes(const VectorXd& wrenches, std::size_t instant) const {
    return shapes_.along_shapes(seats_.spread(wrenches, instant)).transpose();
  }

  const PartJob& job_;
  const LoadSet& motion_;
  const loads::SpreadSeats& seats_;
  const elasticity::SeatShapes& shapes_;
  VectorXd time_;
  dynamics::DiagonalSystem system_;
  std::optional<dynamics::SmoothPath> rows_, forces_;
  std::optional<dynamics::SmoothPath> all_forces_;  ///< reactions among them
  Index held_{};  ///< constraints that hold, before those that tie
  std::vector<std::pair<Index, MatrixXd>> turned_;  ///< by instant
};

/// Largest stress and deflection of some coordinates.
struct Peak {
  double stress{}, deflection{};
  stress::FieldPoint at;
  Index instant{};
};

class Fields {
 public:
  static constexpr int kSubdivisions = 2;
  Fields(const PartJob& job, const elasticity::SeatShapes& shapes)
      : material_(job.part.material), basis_(shapes.fields()) {}

  Peak largest(const MatrixXd& coordinates) {
    basis_.coefficients = coordinates;
    const auto history =
        stress::stress_history<3>(basis_, material_, kSubdivisions);
    Peak found{history.largest(), 0.0, history.peak_at, history.peak_instant};
    const MatrixXd moved = basis_.columns * coordinates;
    for (Index node = 0; node < moved.rows() / 3; ++node) {
      found.deflection = std::max(
          found.deflection,
          moved.middleRows<3>(3 * node).colwise().squaredNorm().maxCoeff());
    }
    found.deflection = std::sqrt(found.deflection);
    return found;
  }
  Eigen::Vector3d position(const stress::FieldPoint& at) const {
    return stress::position<3>(basis_.discretization, at, kSubdivisions);
  }
  std::string group(const stress::FieldPoint& at) const {
    return stress::surface_group<3>(basis_.discretization, at, kSubdivisions);
  }

 private:
  const part::Material& material_;
  elasticity::DisplacementBasis<3> basis_;
};

}  // namespace

std::optional<TravellingVibration> follow_holds(
    const PartJob& job, const LoadSet& motion, const loads::SpreadSeats& seats,
    const elasticity::SeatShapes& shapes,
    const std::function<loads::SeatHold(std::size_t)>& hold_of,
    const CountedPeriods& periods, const std::vector<std::size_t>& as_if_held) {
  constexpr double kSteps = 80.0;  // of a period
  constexpr double kMostSteps = 4e5;
  constexpr Index kTimes = 512;  // that are kept
  constexpr double kSame = 0.1;
  constexpr double kOfShapes = 0.02;  // their stress, beside the hold's
  constexpr double kOff = 0.02;  // squares of the shapes, by twice a per cent
  TravellingPart part(job, motion, seats, shapes);
  if (motion.history.instants.size() < 2 || !part.take(hold_of)) return {};
  const double step = periods.shortest / kSteps;
  if (part.duration() > kMostSteps * step) return {};
  Fields fields(job, shapes);
  const Peak rest = fields.largest(part.resting(step, kTimes).coordinates);
  if (!(rest.stress > 0.0 && rest.deflection > 0.0)) return {};
  const auto by = [&](double stiffer) {
    return fields.largest(part.swings(2.0 * step, kTimes, stiffer).coordinates);
  };
  const Peak coarse = by(1.0);
  double held = 0.0;
  for (const std::size_t instant : as_if_held) {
    const auto there =
        part.swings_held(static_cast<Index>(instant), 2.0 * step, kTimes);
    held = std::max(held, fields.largest(there.coordinates).stress);
  }
  // What stretches tell they tell more exactly.
  if (held > 0.0 && std::abs(coarse.stress - held) <= kSame * held) return {};
  const auto swung = part.swings(step, kTimes, 1.0);
  const Peak most = fields.largest(swung.coordinates);
  TravellingVibration found{.stress = most.stress / rest.stress,
                            .deflection = most.deflection / rest.deflection,
                            .error = 0.0,
                            .still = rest.stress,
                            .at = fields.position(most.at),
                            .group = fields.group(most.at),
                            .time = swung.time[most.instant],
                            .shapes = static_cast<int>(part.shapes()),
                            .highest = std::sqrt(shapes.squares().maxCoeff()) /
                                       2.0 / std::numbers::pi};
  found.beyond_rest =
      fields.largest(swung.coordinates - part.resting_at(swung.time)).stress;
  const auto change = [](const Peak& a, const Peak& b) {
    return std::max(std::abs(a.stress / b.stress - 1.0),
                    std::abs(a.deflection / b.deflection - 1.0));
  };
  // The scheme is of second order. Bodies that turn beside the part have forces
  // of their turning, which are not followed.
  found.error = kOfShapes + change(coarse, most) / 3.0 +
                change(by(1.0 - kOff), coarse) + part.turning(periods.longest);
  return found;
}

}  // namespace clevis::assessment

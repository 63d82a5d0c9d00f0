#include "loads/parts/held_pins.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <Eigen/QR>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/algebra/singular_vectors.h"
#include "base/messages/errors.h"
#include "loads/history/balance.h"

namespace clevis::loads {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

namespace {

constexpr Index kComponents = 5;  // of one pin
constexpr double kRank = 1e-9;    // of directions and of lengths over the size

/// Force along two axes across the pin's and along its own, moments about the
/// first two: columns, force and moment below each other.
Eigen::Matrix<double, 6, kComponents> pin_action(const Vector3d& axis) {
  const Vector3d first = axis.unitOrthogonal();
  const Vector3d second = axis.cross(first);
  Eigen::Matrix<double, 6, kComponents> action;
  action.setZero();
  action.block<3, 1>(0, 0) = action.block<3, 1>(3, 3) = first;
  action.block<3, 1>(0, 1) = action.block<3, 1>(3, 4) = second;
  action.block<3, 1>(0, 2) = axis;
  return action;
}

Vector3d mean_point(const std::vector<part::Bore>& pins) {
  Vector3d sum = Vector3d::Zero();
  for (const part::Bore& pin : pins) sum += pin.p_LC;
  return sum / static_cast<double>(pins.size());
}

/// What pins hold on their seats, the last of each bore: SeatHold::held.
MatrixXd held_by(const std::vector<std::string>& bores,
                 const std::vector<GroupGeometry>& groups,
                 const std::string& place, const std::vector<Seat>& seats) {
  MatrixXd held =
      MatrixXd::Zero(6 * std::ssize(seats), kComponents * std::ssize(bores));
  for (std::size_t i = 0; i < bores.size(); ++i) {
    const Vector3d& axis = find_group(groups, bores[i], place).cylinder.axis_L;
    Index seat = std::ssize(seats) - 1;
    while (seats[static_cast<std::size_t>(seat)].group != bores[i]) --seat;
    held.block<6, kComponents>(6 * seat, kComponents * static_cast<Index>(i)) =
        pin_action(axis);
  }
  return held;
}

/// The only mode that pins leave free: all turn about the same axis.
[[noreturn]] void refuse_turn(const std::vector<std::string>& bores,
                              const Vector3d& axis, const Imbalance& rest,
                              const std::string& place) {
  throw Error(
      "L001", place,
      fmt::format("the loads turn the part about the axis {} of the {} in {}: "
                  "a moment of {:.6g} N m is left, {:.3g} % of the load",
                  vector_text(axis, 1.0), bores.size() == 1 ? "pin" : "pins",
                  fmt::join(bores, ", "), rest.left.moment.norm(),
                  100.0 * rest.relative()),
      "A pin takes no moment about its axis: hold the part by a pin in another "
      "bore too, give the missing load, or angular_acceleration.");
}

/// Components that the mesh's own asymmetry leaves of none.
void clean(double force, double size, Wrench& wrench) {
  constexpr double kAsymmetry = 1e-6;
  const auto without = [](Vector3d& v, double small) {
    v = v.unaryExpr([small](double x) {
      return std::abs(x) <= small ? 0.0 : x;
    });
  };
  without(wrench.force, kAsymmetry * force);
  without(wrench.moment, kAsymmetry * force * size);
}

/// The history with amounts of the open patterns added to the pins' wrenches.
LoadHistory with_open(const PinReactions& pins, const LoadHistory& history,
                      const part::MassProperties& mass, double size,
                      const VectorXd& amounts) {
  LoadHistory result = history;
  InstantLoad& instant = result.instants.front();
  const std::size_t first = result.seats.size() - pins.size();
  const auto patterns = pins.open();
  double largest = 0.0;
  for (std::size_t i = 0; i < pins.size(); ++i) {
    Wrench& wrench = instant.wrenches[first + i];
    for (std::size_t k = 0; k < patterns.size(); ++k) {
      const double z = amounts[static_cast<Index>(k)];
      wrench.force += z * patterns[k][i].force;
      wrench.moment += z * patterns[k][i].moment;
    }
    largest = std::max(largest, wrench.force.norm());
  }
  for (std::size_t i = 0; i < pins.size(); ++i) {
    clean(largest, size, instant.wrenches[first + i]);
  }
  const auto rest = pins.balancing(residual(result, instant, mass));
  for (std::size_t i = 0; i < pins.size(); ++i) {
    instant.wrenches[first + i].force += rest[i].force;
    instant.wrenches[first + i].moment += rest[i].moment;
  }
  return result;
}

}  // namespace

PinReactions::PinReactions(std::vector<part::Bore> pins, double size)
    : pins_(std::move(pins)), size_(size), middle_(mean_point(pins_)) {
  const auto n = static_cast<Index>(pins_.size());
  acting_ = MatrixXd::Zero(6 * n, kComponents * n);
  sum_.resize(6, kComponents * n);
  for (Index i = 0; i < n; ++i) {
    const part::Bore& pin = pins_[static_cast<std::size_t>(i)];
    const auto action = pin_action(pin.axis_L);
    acting_.block<6, kComponents>(6 * i, kComponents * i) = action;
    auto sum = sum_.middleCols<kComponents>(kComponents * i);
    sum = action;
    const Vector3d arm = (pin.p_LC - middle_) / size_;
    for (Index k = 0; k < 3; ++k) {
      sum.block<3, 1>(3, k) = arm.cross(Vector3d(action.block<3, 1>(0, k)));
    }
  }
}

std::vector<Wrench> PinReactions::wrenches(const VectorXd& components) const {
  const VectorXd all = acting_ * components;
  std::vector<Wrench> result;
  for (Index i = 0; i < static_cast<Index>(pins_.size()); ++i) {
    result.push_back({.force = all.segment<3>(6 * i),
                      .moment = size_ * all.segment<3>(6 * i + 3)});
  }
  return result;
}

std::vector<Wrench> PinReactions::balancing(const Wrench& rest) const {
  const Wrench here = about(rest.force, rest.moment, Vector3d::Zero(), middle_);
  VectorXd wanted(6);
  wanted << -here.force, -here.moment / size_;
  Eigen::CompleteOrthogonalDecomposition<MatrixXd> factor;
  factor.setThreshold(kRank);
  factor.compute(sum_);
  return wrenches(factor.solve(wanted));
}

std::vector<std::vector<Wrench>> PinReactions::open() const {
  const MatrixXd N = null_space(sum_, kRank);
  std::vector<std::vector<Wrench>> result;
  for (Index k = 0; k < N.cols(); ++k) result.push_back(wrenches(N.col(k)));
  return result;
}

MatrixXd PinReactions::open_components(std::size_t pin) const {
  return null_space(sum_, kRank)
      .middleRows(kComponents * static_cast<Index>(pin), kComponents);
}

VectorXd PinReactions::components(std::size_t pin, const Wrench& wrench) const {
  const auto i = static_cast<Index>(pin);
  Eigen::Matrix<double, 6, 1> scaled;
  scaled << wrench.force, wrench.moment / size_;
  return acting_.block<6, kComponents>(6 * i, kComponents * i).transpose() *
         scaled;
}

bool PinReactions::is_unique(std::size_t pin) const {
  constexpr double kRoundOff = 1e-7;
  return open_components(pin).norm() <= kRoundOff;
}

PinReactions pins_in(const std::vector<std::string>& bores,
                     const std::vector<GroupGeometry>& groups, double size,
                     const std::string& place) {
  std::vector<part::Bore> pins;
  for (const std::string& name : bores) {
    const GroupGeometry& group = find_group(groups, name, place);
    require_cylinder(group, place);
    pins.push_back(group.cylinder);
  }
  return {std::move(pins), size};
}

void hold_by_loaded_pins(const std::vector<std::string>& bores,
                         const std::vector<GroupGeometry>& groups,
                         const std::string& place, LoadHistory& history) {
  history.hold = [held =
                      held_by(bores, groups, place, history.seats)](double t) {
    return SeatHold{
        .time = t, .held = held, .weighed = MatrixXd(held.rows(), 0)};
  };
}

void hold_by_pins(const std::vector<std::string>& bores,
                  const std::vector<GroupGeometry>& groups,
                  const part::MassProperties& mass, double size,
                  const std::string& place, LoadHistory& history,
                  InstantLoad& instant) {
  const PinReactions pins = pins_in(bores, groups, size, place);
  const auto reactions = pins.balancing(residual(history, instant, mass));
  for (std::size_t i = 0; i < bores.size(); ++i) {
    const GroupGeometry& group = find_group(groups, bores[i], place);
    history.seats.push_back({.name = bores[i],
                             .group = bores[i],
                             .kind = SeatKind::kBearing,
                             .p_LS = group.cylinder.p_LC});
    instant.wrenches.push_back(reactions[i]);
  }
  hold_by_loaded_pins(bores, groups, place, history);
  const Imbalance rest = imbalance(history, instant, mass, size);
  if (rest.relative() <= kLargestRelief) return;
  refuse_turn(bores, find_group(groups, bores.front(), place).cylinder.axis_L,
              rest, place);
}

SharedPins share(const PinReactions& pins, const LoadHistory& history,
                 const part::MassProperties& mass, double size, double unit,
                 const MatrixXd& A, const VectorXd& b) {
  const auto with = [&](const MatrixXd& stiff, const VectorXd& load) {
    const VectorXd amounts = -unit * stiff.ldlt().solve(load);
    return with_open(pins, history, mass, size, amounts);
  };
  SharedPins result{with(A, b), {}};
  const std::size_t first = history.seats.size() - pins.size();
  const double weight = A.trace() / static_cast<double>(A.rows());
  for (std::size_t i = 0; i < pins.size(); ++i) {
    const MatrixXd N = pins.open_components(i);
    const VectorXd w =
        pins.components(i, history.instants.front().wrenches[first + i]);
    result.others.push_back(with(A + weight * N.transpose() * N,
                                 b + weight / unit * N.transpose() * w));
  }
  return result;
}

}  // namespace clevis::loads

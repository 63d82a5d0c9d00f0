#include "stress/displacement/touched_reference.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "elasticity/assembly/supports.h"
#include "elasticity/holds/pin_hold.h"
#include "stress/displacement/held_reference.h"

namespace clevis::stress {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

/// What of the columns the hold takes out, by instant of a motion.
template <int dim>
class TouchedMotions {
 public:
  TouchedMotions(const loads::LoadHistory& history,
                 std::vector<std::string> groups,
                 const elasticity::DisplacementBasis<dim>& basis)
      : history_(history), groups_(std::move(groups)), basis_(basis) {
    for (std::size_t k = 0; k < history.seats.size(); ++k) {
      if (history.seats[k].slide &&
          std::ranges::find(groups_, loads::holder_of(history.seats, k)) !=
              groups_.end()) {
        slides_.push_back(k);
      }
    }
    if (slides_.empty()) return;
    for (const loads::InstantLoad& instant : history.instants) {
      if (!instant.zones.empty()) ++count_;  // cases, behind them, have none
    }
    broken_.resize(count_);
    displacement_ = basis.columns.norm() /
                    std::sqrt(static_cast<double>(basis.discretization.nodes));
    if (count_ == 0) return;
    motions_.emplace(basis.discretization);
    solve(0);
    if (count_ == 1) return;
    solve(count_ - 1);
    fill(0, count_ - 1);
  }

  std::size_t count() const { return count_; }
  /// Rigid motions × columns.
  const MatrixXd& broken(std::size_t i) const { return broken_[i]; }
  /// Of rigid motions, dofs × motions. @pre count() > 0.
  const MatrixXd& rigid() const { return motions_->rigid(); }

 private:
  const std::vector<loads::ContactZone>& zones(std::size_t i) const {
    return history_.instants[i].zones;
  }

  void solve(std::size_t i) {
    auto held =
        loads::reference_at(history_, groups_, history_.instants[i].time);
    const elasticity::HoldingSeats seats{
        std::move(held.groups),
        elasticity::TouchedSeats{history_.seats, zones(i)},
        std::move(held.held), std::move(held.sprung)};
    const elasticity::PinHold<dim> hold(*motions_, seats);
    broken_[i] = hold.broken(basis_.columns);
  }

  /// Share of the way of the slides from one instant to another; nothing where
  /// their zones do not lie on a straight line between these.
  std::optional<double> share(std::size_t i, std::size_t from,
                              std::size_t to) const {
    constexpr double kOff = 1e-6;
    double along = 0.0, square = 0.0, rest = 0.0;
    std::vector<std::pair<double, double>> ways;  // to i, to the end
    for (const std::size_t k : slides_) {
      const auto add = [&](double at, double start, double end) {
        if (at == start && at == end) return true;  // an end of the wall, too
        ways.emplace_back(at - start, end - start);
        return std::isfinite(at - start) && std::isfinite(end - start);
      };
      for (int d = 0; d < 2; ++d) {
        if (!add(zones(i)[k].low[d], zones(from)[k].low[d],
                 zones(to)[k].low[d]) ||
            !add(zones(i)[k].high[d], zones(from)[k].high[d],
                 zones(to)[k].high[d])) {
          return std::nullopt;
        }
      }
    }
    for (const auto& [here, all] : ways) {
      along += here * all;
      square += all * all;
    }
    if (!(square > 0.0)) {
      return ways.empty() ? std::optional(0.0) : std::nullopt;
    }
    const double share = along / square;
    for (const auto& [here, all] : ways) {
      rest += (here - share * all) * (here - share * all);
    }
    if (rest > kOff * square) return std::nullopt;
    return share;
  }

  MatrixXd between(std::size_t from, std::size_t to, double share) const {
    return (1.0 - share) * broken_[from] + share * broken_[to];
  }

  /// What lies between two that are known.
  void fill(std::size_t from, std::size_t to) {
    constexpr double kEven = 5e-4;
    if (to - from < 2) return;
    std::vector<double> shares;
    for (std::size_t i = from + 1; i < to; ++i) {
      const auto here = share(i, from, to);
      if (!here) break;
      shares.push_back(*here);
    }
    const std::size_t middle = (from + to) / 2;
    const bool is_line = shares.size() == to - from - 1;
    const bool stands = is_line && std::ranges::all_of(shares, [](double here) {
                          return here == 0.0;
                        });
    if (!stands) solve(middle);
    const auto at = [&](std::size_t i) {
      return shares[i - from - 1];
    };
    const auto off = [&] {
      return (between(from, to, at(middle)) - broken_[middle]).norm();
    };
    if (is_line &&
        (stands ||
         off() <= kEven * std::max(displacement_, broken_[middle].norm()))) {
      for (std::size_t i = from + 1; i < to; ++i) {
        if (i != middle || stands) broken_[i] = between(from, to, at(i));
      }
      return;
    }
    fill(from, middle);
    fill(middle, to);
  }

  const loads::LoadHistory& history_;
  std::vector<std::string> groups_;
  const elasticity::DisplacementBasis<dim>& basis_;
  std::vector<std::size_t> slides_;  ///< seats that hold
  std::size_t count_ = 0;            ///< instants of the motion
  std::vector<MatrixXd> broken_;
  double displacement_ = 0.0;  ///< of a node, in the mean, over the columns [m]
  std::optional<elasticity::MeanMotions<dim>> motions_;
};

}  // namespace

template <int dim>
bool refer_to_touched(const loads::LoadHistory& history,
                      const std::vector<std::string>& groups,
                      elasticity::DisplacementBasis<dim>& basis) {
  constexpr Index kRigid = elasticity::kRigidModes<dim>;
  if (basis.columns.cols() == 0) return false;
  const TouchedMotions<dim> motions(history, groups, basis);
  if (motions.count() == 0) return false;
  MatrixXd moved = MatrixXd::Zero(kRigid, basis.coefficients.cols());
  for (std::size_t i = 0; i < motions.count(); ++i) {
    const auto at = static_cast<Index>(i);
    moved.col(at) = -motions.broken(i) * basis.coefficients.col(at);
  }
  add_rigid_motions(motions.rigid(), moved, basis);
  return true;
}

template bool refer_to_touched<2>(const loads::LoadHistory&,
                                  const std::vector<std::string>&,
                                  elasticity::DisplacementBasis<2>&);
template bool refer_to_touched<3>(const loads::LoadHistory&,
                                  const std::vector<std::string>&,
                                  elasticity::DisplacementBasis<3>&);

template <int dim>
void refer_to_holds(const loads::LoadHistory& history,
                    const loads::PartHold& hold,
                    elasticity::DisplacementBasis<dim>& basis) {
  remove_rigid_motion<dim>(basis, hold);
  if (!refer_to_touched<dim>(history, hold.groups, basis)) {
    refer_to_instants<dim>(history, hold.groups, basis);
  }
}

template void refer_to_holds<2>(const loads::LoadHistory&,
                                const loads::PartHold&,
                                elasticity::DisplacementBasis<2>&);
template void refer_to_holds<3>(const loads::LoadHistory&,
                                const loads::PartHold&,
                                elasticity::DisplacementBasis<3>&);

}  // namespace clevis::stress

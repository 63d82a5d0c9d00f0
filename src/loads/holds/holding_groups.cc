#include "loads/holds/holding_groups.h"

#include <algorithm>

#include <Eigen/Geometry>
#include <Eigen/SVD>

namespace clevis::loads {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;

constexpr Index kWrench = 6;
// Of a unit wrench: what is held at so small an angle gives way as a whole.
constexpr double kHolds = 0.1;

/// Each two of some groups; fewer than two: those.
std::vector<HoldingGroups> pairs_of(const HoldingGroups& groups) {
  if (groups.size() < 2) return {groups};
  std::vector<HoldingGroups> pairs;
  for (std::size_t a = 0; a < groups.size(); ++a) {
    for (std::size_t b = a + 1; b < groups.size(); ++b) {
      pairs.push_back({groups[a], groups[b]});
    }
  }
  return pairs;
}

HoldingGroups bearing_groups(const LoadHistory& history) {
  HoldingGroups groups;
  for (const Seat& seat : history.seats) {
    if (seat.kind == SeatKind::kBearing &&
        std::ranges::find(groups, seat.group) == groups.end()) {
      groups.push_back(seat.group);
    }
  }
  return groups;
}

/// Largest distance between seats [m].
double size_of(const std::vector<Seat>& seats) {
  constexpr double kOfOne = 0.01;  // whatever it is
  double size = 0.0;
  for (const Seat& one : seats) {
    for (const Seat& other : seats) {
      size = std::max(size, (one.p_LS - other.p_LS).norm());
    }
  }
  return size > 0.0 ? size : kOfOne;
}

/// Columns that span the same, orthonormal.
MatrixXd orthonormal(const MatrixXd& columns) {
  constexpr double kRoundOff = 1e-9;
  if (columns.size() == 0) return columns;
  Eigen::JacobiSVD<MatrixXd> svd(columns, Eigen::ComputeThinU);
  svd.setThreshold(kRoundOff);
  return svd.matrixU().leftCols(svd.rank());
}

/// At a time [s]; moments over the size [N].
std::vector<GroupHold> holds_of(const LoadHistory& history, double time) {
  const double size = size_of(history.seats);
  MatrixXd held = history.hold(time).held;
  for (Index row = 0; row < held.rows(); ++row) {
    if (row % kWrench >= 3) held.row(row) /= size;
  }
  held = orthonormal(held);
  std::vector<GroupHold> holds;
  for (std::size_t s = 0; s < history.seats.size(); ++s) {
    const Seat& seat = history.seats[s];
    auto hold = std::ranges::find(holds, seat.group, &GroupHold::group);
    if (hold == holds.end()) {
      holds.push_back(
          {seat.group, seat.p_LS, MatrixXd::Zero(kWrench, held.cols())});
      hold = std::prev(holds.end());
    }
    const MatrixXd here =
        held.middleRows<kWrench>(kWrench * static_cast<Index>(s));
    hold->wrenches += here;
    const Vector3d arm = (seat.p_LS - hold->p_LS) / size;
    for (Index k = 0; k < here.cols(); ++k) {
      const Vector3d force = here.col(k).head<3>();
      hold->wrenches.col(k).tail<3>() += arm.cross(force);
    }
  }
  return holds;
}

/// Whether rows of wrenches are held, each direction of them.
bool holds_all(const MatrixXd& rows) {
  if (rows.cols() < rows.rows()) return false;
  return Eigen::JacobiSVD<MatrixXd>(rows).singularValues().minCoeff() > kHolds;
}

bool holds_across(const GroupHold& hold, const Vector3d& line) {
  Eigen::Matrix<double, 2, 3> across;
  across.row(0) = line.unitOrthogonal();
  across.row(1) = line.cross(line.unitOrthogonal()).normalized();
  return holds_all(across * hold.wrenches.topRows<3>());
}

bool holds_place(const GroupHold& hold) {
  return hold.wrenches.topRows<3>().norm() > kHolds;
}

/// A group's wrenches with what others hold that bends nothing between: moments
/// of those that hold nothing else, as the face of a drive that turns the part
/// at a pin, and forces along the line to them, as of a drive along a slide.
MatrixXd with_rest_of_others(const GroupHold& hold,
                             const std::vector<GroupHold>& all) {
  MatrixXd wrenches = hold.wrenches;
  for (const GroupHold& other : all) {
    if (other.group == hold.group) continue;
    if (!holds_place(other)) {
      wrenches.bottomRows<3>() += other.wrenches.bottomRows<3>();
      continue;
    }
    const Vector3d along = (other.p_LS - hold.p_LS).normalized();
    wrenches.topRows<3>() +=
        along * (along.transpose() * other.wrenches.topRows<3>());
  }
  return wrenches;
}

}  // namespace

std::vector<GroupHold> held_groups(const LoadHistory& history, double time) {
  auto held = holds_of(history, time);
  const double size = size_of(history.seats);
  for (GroupHold& hold : held) hold.wrenches.bottomRows<3>() *= size;
  return held;
}

bool hold_by_themselves(const std::vector<GroupHold>& held,
                        const HoldingGroups& groups) {
  constexpr double kMixed = 0.1;  // of a unit force
  if (groups.empty()) return true;
  const auto at = [&](const std::string& group) {
    return std::ranges::find(held, group, &GroupHold::group) - held.begin();
  };
  const auto first = at(groups.front());
  const GroupHold& one = held[static_cast<std::size_t>(first)];
  if (groups.size() == 1) return holds_all(with_rest_of_others(one, held));
  const auto second = at(groups.back());
  const Vector3d line =
      (held[static_cast<std::size_t>(second)].p_LS - one.p_LS).normalized();
  if (!(line.norm() > 0.0)) return false;
  // What is held along the line, and about it, bends nothing.
  const Index rows = kWrench * std::ssize(held);
  MatrixXd all = MatrixXd::Zero(rows, one.wrenches.cols() + 4);
  for (std::size_t g = 0; g < held.size(); ++g) {
    all.block(kWrench * static_cast<Index>(g), 0, kWrench,
              one.wrenches.cols()) = held[g].wrenches;
  }
  Index column = one.wrenches.cols();
  for (const auto of : {first, second}) {
    all.block<3, 1>(kWrench * of, column++) = line;
    all.block<3, 1>(kWrench * of + 3, column++) = line;
  }
  const MatrixXd span = orthonormal(all);
  for (const auto of : {first, second}) {
    for (const Vector3d& across :
         {line.unitOrthogonal(), line.cross(line.unitOrthogonal()).eval()}) {
      Eigen::VectorXd force = Eigen::VectorXd::Zero(rows);
      force.segment<3>(kWrench * of) = across;
      if ((force - span * (span.transpose() * force)).norm() > kMixed) {
        return false;
      }
    }
  }
  return true;
}

bool are_more_than_six(const std::vector<GroupHold>& held) {
  return !held.empty() && held.front().wrenches.cols() > kWrench;
}

std::vector<HoldingGroups> holding_groups(const LoadHistory& history) {
  if (!history.hold) return pairs_of(bearing_groups(history));
  constexpr double kNearest = 1e-3;  // of the size: no line between them
  const std::vector<GroupHold> holds = holds_of(history, history.hold_time);
  const double size = size_of(history.seats);
  std::vector<HoldingGroups> found;
  for (auto one = holds.begin(); one != holds.end(); ++one) {
    for (auto other = std::next(one); other != holds.end(); ++other) {
      const Vector3d line = other->p_LS - one->p_LS;
      if (line.norm() > kNearest * size && holds_across(*one, line) &&
          holds_across(*other, line)) {
        found.push_back({one->group, other->group});
      }
    }
  }
  if (!found.empty()) return found;
  HoldingGroups some;
  for (const GroupHold& hold : holds) {
    if (!holds_place(hold)) continue;
    some.push_back(hold.group);
    if (holds_all(with_rest_of_others(hold, holds))) {
      found.push_back({hold.group});
    }
  }
  return found.empty() ? pairs_of(some) : found;
}

}  // namespace clevis::loads

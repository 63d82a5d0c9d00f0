#include "loads/pressure/load_scale.h"

#include <algorithm>

namespace clevis::loads {

LoadScale::LoadScale(const LoadHistory& history, std::size_t seat) {
  double reach = 0.0;
  for (const Seat& other : history.seats) {
    reach = std::max(reach, (other.p_LS - history.seats[seat].p_LS).norm());
  }
  for (const InstantLoad& instant : history.instants) {
    for (const Wrench& wrench : instant.wrenches) {
      largest_force_ = std::max(largest_force_, wrench.force.norm());
      largest_moment_ = std::max(largest_moment_, wrench.moment.norm());
    }
  }
  largest_moment_ += reach * largest_force_;
}

bool LoadScale::is_negligible(const Wrench& wrench) const {
  constexpr double kNegligible = 1e-7;  // of the largest over the motion
  return wrench.force.norm() <= kNegligible * largest_force_ &&
         wrench.moment.norm() <= kNegligible * largest_moment_;
}

}  // namespace clevis::loads

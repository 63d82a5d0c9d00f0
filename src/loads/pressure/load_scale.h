#pragma once

#include <cstddef>

#include "loads/history/load_history.h"

namespace clevis::loads {

/// What is round-off of a seat's load, beside the largest of all seats: a joint
/// that only guides carries nothing else.
class LoadScale {
 public:
  LoadScale(const LoadHistory& history, std::size_t seat);

  bool is_negligible(const Wrench& wrench) const;

 private:
  double largest_force_{}, largest_moment_{};
};

}  // namespace clevis::loads

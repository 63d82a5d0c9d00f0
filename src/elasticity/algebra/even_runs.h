#pragma once

#include <algorithm>
#include <cstddef>
#include <future>
#include <system_error>
#include <type_traits>
#include <vector>

#include "base/system/processor_share.h"
#include "elasticity/algebra/blas_space.h"

namespace clevis::elasticity {

/// Cuts 0 … count − 1 into runs of even length, one for each processor that
/// this process may keep busy, works on all at once, and returns what is found
/// of each, in their order. Nothing may depend on where they are cut.
/// @param least  shortest run that is worth a thread.
/// @param work   of a run's first number and the one behind its last.
/// @pre no other thread of the process calls this or OpenBLAS meanwhile.
template <class Work>
auto in_even_runs(std::ptrdiff_t count, std::ptrdiff_t least, const Work& work)
    -> std::vector<
        std::invoke_result_t<const Work&, std::ptrdiff_t, std::ptrdiff_t>> {
  using Found =
      std::invoke_result_t<const Work&, std::ptrdiff_t, std::ptrdiff_t>;
  std::ptrdiff_t runs = std::clamp<std::ptrdiff_t>(
      count / least, 1, static_cast<std::ptrdiff_t>(own_processors()));
  if (runs > 1 && !take_blas_space(static_cast<int>(runs))) runs = 1;
  std::vector<std::future<Found>> others;
  for (std::ptrdiff_t r = 1; r < runs; ++r) {
    const auto of_run = [&work, from = count * r / runs,
                         to = count * (r + 1) / runs] {
      return work(from, to);
    };
    try {
      others.push_back(std::async(std::launch::async, of_run));
    } catch (const std::system_error&) {  // no more threads: when it is asked
      others.push_back(std::async(std::launch::deferred, of_run));
    }
  }
  std::vector<Found> found;
  found.push_back(work(0, count / runs));
  for (auto& other : others) found.push_back(other.get());
  return found;
}

}  // namespace clevis::elasticity

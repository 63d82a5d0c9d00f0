#pragma once

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <functional>
#include <string>
#include <vector>

#include "benchmarks/reference_trajectories.h"

/// The table that work_precision and its companions print.
namespace clevis::benchmarks {

struct PrecisionRow {
  std::string problem, method, setting;
  double seconds{};
  long steps = -1, implicit_steps = -1, rejected = -1, evaluations = -1;
  TrajectoryErrors errors;
};

inline void print_header() {
  std::printf(
      "problem,method,setting,cpu_ms,steps,implicit_steps,rejected,"
      "evaluations,position_or_time_error,energy_error_J,gap_m,"
      "reaction_error_N,branch_error\n");
}

inline void print(const PrecisionRow& row) {
  std::printf("%s,%s,%s,%.4f", row.problem.c_str(), row.method.c_str(),
              row.setting.c_str(), 1e3 * row.seconds);
  for (const long count :
       {row.steps, row.implicit_steps, row.rejected, row.evaluations}) {
    if (count < 0) {
      std::printf(",");
    } else {
      std::printf(",%ld", count);
    }
  }
  const TrajectoryErrors& e = row.errors;
  for (const double error :
       {e.position, e.energy, e.gap, e.reaction, e.branch}) {
    if (error < 0.0) {
      std::printf(",");
    } else {
      std::printf(",%.2e", error);
    }
  }
  std::printf("\n");
  std::fflush(stdout);
}

/// A run that ended with an error, in words or a code.
inline void print_failure(const std::string& problem, const std::string& method,
                          const std::string& setting, const std::string& why) {
  std::printf("%s,%s,%s,%s\n", problem.c_str(), method.c_str(), setting.c_str(),
              why.c_str());
  std::fflush(stdout);
}

inline std::string power_of_ten(double value) {
  char text[16];
  std::snprintf(text, sizeof text, "%.0e", value);
  return text;
}

/// What the command line asks for: `[PROBLEM]...`, of all methods and settings
/// (all problems without a name), or with `--run PROBLEM METHOD SETTING` one
/// motion of one setting.
class Request {
 public:
  Request(int argc, char** argv) : words_(argv + 1, argv + argc) {
    once_ = words_.size() == 4 && words_[0] == "--run";
  }

  bool wants(const std::string& problem) const {
    if (once_) return words_[1] == problem;
    return words_.empty() ||
           std::find(words_.begin(), words_.end(), problem) != words_.end();
  }
  bool wants(const std::string& method, const std::string& setting) const {
    return !once_ || (words_[2] == method && words_[3] == setting);
  }

  /// Least processor time of a run on this thread [s], of as many as take a
  /// quarter of a second, at most 20, or of one. (The clock of the process
  /// counts in ticks where its time is limited.)
  double seconds(const std::function<void()>& run) const {
    double least = 1e300, all = 0.0;
    for (int i = 0; i < (once_ ? 1 : 20) && (i == 0 || all + least < 0.25);
         ++i) {
      timespec a{}, b{};
      clock_gettime(CLOCK_THREAD_CPUTIME_ID, &a);
      run();
      clock_gettime(CLOCK_THREAD_CPUTIME_ID, &b);
      const double took = static_cast<double>(b.tv_sec - a.tv_sec) +
                          1e-9 * static_cast<double>(b.tv_nsec - a.tv_nsec);
      least = std::min(least, took);
      all += took;
    }
    return least;
  }

 private:
  std::vector<std::string> words_;
  bool once_{};
};

}  // namespace clevis::benchmarks

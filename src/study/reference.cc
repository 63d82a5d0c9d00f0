#include "study/reference.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <functional>
#include <utility>

namespace clevis::study {
namespace {

constexpr double kSteady = 0.5;

std::vector<const Run*> runs_of(const PartStudy& study,
                                const std::string& series) {
  std::vector<const Run*> runs;
  for (const Run& run : study.runs) {
    if (run.series == series && run.left_out.empty()) runs.push_back(&run);
  }
  return runs;
}

/// The last series with at least three runs, else with two, else with any: two
/// tell nothing of how the changes shrink.
std::vector<const Run*> finest_of(const PartStudy& study,
                                  std::span<const std::string> series) {
  constexpr std::size_t kTellsTheRate = 3;
  std::vector<const Run*> finest;
  for (const std::string& name : series) {
    auto runs = runs_of(study, name);
    if (!runs.empty() &&
        (runs.size() >= std::min(finest.size(), kTellsTheRate))) {
      finest = std::move(runs);
    }
  }
  return finest;
}

Reference extrapolate_runs(const std::vector<const Run*>& runs,
                           const std::function<double(const Run&)>& value) {
  std::vector<double> sequence;
  for (const Run* run : runs) sequence.push_back(value(*run));
  return extrapolate(sequence);
}

}  // namespace

double relative_error(double value, const Reference& reference) {
  const double difference = std::abs(value - reference.value);
  return reference.value != 0.0 ? difference / std::abs(reference.value)
                                : difference;
}

Reference extrapolate(std::span<const double> sequence) {
  assert(!sequence.empty());
  const std::size_t n = sequence.size();
  const double last = sequence[n - 1];
  if (n == 1) return {last, std::abs(last)};
  const double change = last - sequence[n - 2];
  Reference reference{last, 0.5 * std::abs(change)};
  if (n == 2) return reference;
  const double before = sequence[n - 2] - sequence[n - 3];
  const double ratio = before != 0.0 ? change / before : 0.0;
  if (ratio > 0.0 && ratio <= kSteady) {
    const double rest = change * ratio / (1.0 - ratio);
    reference.value += rest;
    reference.uncertainty = std::max(std::abs(rest), reference.uncertainty);
  }
  return reference;
}

void set_references(std::span<const std::string> series,
                    std::span<const std::optional<double>> published,
                    PartStudy& study) {
  const auto finest = finest_of(study, series);
  if (finest.empty()) return;
  study.reference_run = finest.back()->series + ", " + finest.back()->setting;
  study.peak = extrapolate_runs(finest, [](const Run& r) {
    return r.peak;
  });
  study.energy = extrapolate_runs(finest, [](const Run& r) {
    return r.energy;
  });
  study.probes.clear();
  for (std::size_t p = 0; p < study.probe_names.size(); ++p) {
    study.probes.push_back(published[p]
                               ? Reference{*published[p], 0.0}
                               : extrapolate_runs(finest, [p](const Run& r) {
                                   return r.probes.at(p);
                                 }));
  }
}

}  // namespace clevis::study

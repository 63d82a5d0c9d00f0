#include "app/solids/mesh_rounds.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "base/messages/errors.h"
#include "base/values/stopwatch.h"

namespace clevis::app {
namespace {

using assessment::PartJob;
using assessment::PartResult;
using assessment::PartSeconds;
using assessment::PeakStress;
using assessment::PeakVerdict;

constexpr std::size_t kMostCells = 20000;
constexpr double kFarOpen = 0.25;  // once more as many cells will not do

bool is_open(const PartResult& result) {
  return judged_peak(result).verdict == PeakVerdict::kNotConverged;
}

/// How far the mesh leaves the judged peak open, if that is above the tolerance
/// [1].
std::optional<double> open_by_mesh(const PartResult& result, double tolerance) {
  const PeakStress& peak = judged_peak(result);
  const double open = peak.shares.mesh / peak.value;
  if (!is_open(result) || !(open > tolerance)) return std::nullopt;
  return open;
}

/// Whether the last mesh will do: a finer one cannot be made, or has too many
/// unknowns for --max-dofs.
bool keeps_the_last(const Error& error) {
  return error.code().starts_with('M') || error.code() == "F007";
}

/// Whether a mesh that was to be finer has come out as it was.
bool is_same(const mesh::PartMesh<3>& a, const mesh::PartMesh<3>& b) {
  return a.cells == b.cells && a.vertices == b.vertices;
}

/// Whether a mesh of hardly more cells than before leaves little for another:
/// the next degree, which costs less than one more round, closes it.
bool is_for_next_degree(std::size_t before, std::size_t now, double open,
                        double tolerance) {
  constexpr double kHardlyMore = 1.1, kCloses = 3.0;
  return static_cast<double>(now) < kHardlyMore * static_cast<double>(before) &&
         open < kCloses * tolerance;
}

void add(const PartSeconds& before, PartSeconds& seconds) {
  seconds.mesh += before.mesh;
  seconds.choose += before.choose;
  seconds.assemble += before.assemble;
  seconds.factor += before.factor;
  seconds.solve += before.solve;
  seconds.recover += before.recover;
  seconds.total += before.total;
}

}  // namespace

cad::Refinement finer_mesh(cad::Refinement last,
                           const std::vector<assessment::OpenPlace>& places,
                           const Eigen::Vector3d& peak) {
  constexpr double kEverywhere = 1.25, kAtPeak = 3.0;
  constexpr double kLeast = 2.5, kMost = 6.0;
  if (places.empty()) {
    last.everywhere *= kEverywhere;
    last.at.push_back({peak, kAtPeak});
  }
  for (const auto& [at, excess] : places) {
    // Errors fall with the square of the cells' size at least, and a few small
    // cells are cheaper than another round.
    last.at.push_back({at, std::clamp(2.5 * std::sqrt(excess), kLeast, kMost)});
  }
  return last;
}

CheckedPart check_in_rounds(
    PartJob job, RoundLimits limits,
    const std::function<assessment::PartAssessment(const PartJob&)>& check,
    const std::function<PartJob(const cad::Refinement&, bool)>& mesh_again) {
  cad::Refinement finer;
  PartSeconds before;
  std::vector<std::string> told;
  bool takes_all_degrees = false, in_space = false;
  for (int made = 0;; ++made) {
    const std::size_t cells = job.mesh.cells.size();
    const bool has_rounds = made < limits.rounds && cells <= kMostCells;
    job.may_be_meshed_finer = has_rounds && !takes_all_degrees;
    job.judges_open_peak = !job.may_be_meshed_finer;
    if (limits.seconds) job.late_after = *limits.seconds - before.total;
    auto assessment = check(job);
    add(before, assessment.result.seconds);
    const auto open = open_by_mesh(assessment.result, job.tolerance);
    const bool is_late =
        limits.seconds && assessment.result.seconds.total > *limits.seconds;
    if (is_late && is_open(assessment.result) && has_rounds) {
      told.push_back(fmt::format(
          "no finer mesh{}: the part took {:.3g} s, --max-time allows {:.3g} s",
          job.may_be_meshed_finer ? " and no higher degree" : "",
          assessment.result.seconds.total, *limits.seconds));
    } else if (open && has_rounds) {
      Stopwatch watch;
      before = assessment.result.seconds;
      finer = finer_mesh(std::move(finer), assessment.open_places,
                         judged_peak(assessment.result).at);
      job.tell("meshing finer");
      const auto listener = job.listener;
      try {
        // Once it is, it stays so: a swept mesh would be coarser again.
        in_space |= assessment.fields.dim == 3 && *open > kFarOpen;
        PartJob again = mesh_again(finer, in_space);
        const bool is_finer = !is_same(job.mesh, again.mesh);
        job = std::move(again);
        job.mesh_round = made + 1;
        job.listener = listener;
        if (!is_finer) limits.rounds = made;
        takes_all_degrees = is_for_next_degree(cells, job.mesh.cells.size(),
                                               *open, job.tolerance);
        told.push_back(
            is_finer
                ? fmt::format("meshed finer where its error stands: {} cells "
                              "left {:.3g} % open, now {}",
                              cells, 100.0 * *open, job.mesh.cells.size())
                : "not meshed finer: the mesh comes out as it was");
      } catch (const Error& error) {
        if (!keeps_the_last(error)) throw;
        limits.rounds = made;  // what there is will do
        told.push_back("not meshed finer: " + error.problem());
      }
      const double meshing = watch.lap();
      before.mesh += meshing;
      before.total += meshing;
      continue;
    }
    if (is_open(assessment.result) && !job.judges_open_peak &&
        !assessment.is_judged) {
      // No other mesh comes. Degrees that are wanted but late are left out.
      job.may_be_meshed_finer = is_late;
      job.judges_open_peak = true;
      before = assessment.result.seconds;
      assessment = check(job);
      add(before, assessment.result.seconds);
    }
    if (open && made < limits.rounds && cells > kMostCells) {
      told.push_back(fmt::format(
          "{} cells leave {:.3g} % open; a finer mesh would take minutes: give "
          "the part a mesh_size if it may",
          cells, 100.0 * *open));
    }
    auto& notes = assessment.result.notes;
    notes.insert(notes.end(), told.begin(), told.end());
    return {std::move(job), std::move(assessment)};
  }
}

}  // namespace clevis::app

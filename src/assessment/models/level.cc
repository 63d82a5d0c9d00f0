#include "assessment/models/level.h"

#include <algorithm>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "base/messages/errors.h"
#include "base/values/stopwatch.h"
#include "elasticity/problem/elastic_problem.h"
#include "loads/holds/holding_groups.h"
#include "stress/displacement/deflection.h"
#include "stress/displacement/touched_reference.h"
#include "stress/peaks/peak_zoom.h"
#include "stress/sections/support_face.h"

namespace clevis::assessment {
namespace {

// Where walls bulge out of cells, over their size [1]: an eighth of a circle
// out of its chord; one that cells of the mesh's degree follow.
constexpr double kChord = 0.1, kCurved = 2e-3;

/// Value of one probe of a case.
template <int dim>
stress::PointValue probe_value(const PartJob& job, const Level<dim>& level,
                               const part::LoadCaseDefinition& load_case,
                               const part::Probe& probe) {
  for (std::size_t s = 0; s < job.load_sets.size(); ++s) {
    const auto& instants = job.load_sets[s].history.instants;
    const auto instant =
        std::ranges::find(instants, load_case.name, &loads::InstantLoad::label);
    if (instant == instants.end()) continue;
    const auto& discretization = level.bases[s]->discretization;
    const bool is_coarse = discretization.geometry_degree < job.mesh.degree;
    const auto location = stress::locate<dim>(discretization, probe.at,
                                              is_coarse ? kChord : kCurved);
    if (location.empty()) {
      throw Error(
          "L005", "part " + job.part.name + ", probe " + probe.name,
          fmt::format("({:.6g}, {:.6g}, {:.6g}) mm is outside the part",
                      probe.at.x() * 1e3, probe.at.y() * 1e3,
                      probe.at.z() * 1e3),
          "Give `at` in the part's frame, inside it or on its surface.");
    }
    return stress::probe<dim>(*level.bases[s], job.part.material, location,
                              probe.quantity,
                              static_cast<int>(instant - instants.begin()));
  }
  throw Error("X001", "part " + job.part.name,
              "no load set holds case " + load_case.name,
              "Please report this scene.");
}

template <int dim>
std::vector<stress::PointValue> probe_values(const PartJob& job,
                                             const Level<dim>& level) {
  std::vector<stress::PointValue> values;
  for (const auto& load_case : job.part.cases) {
    for (const auto& probe : load_case.probes) {
      values.push_back(probe_value<dim>(job, level, load_case, probe));
    }
  }
  return values;
}

/// "12 480": thousands apart.
std::string grouped(std::size_t number) {
  std::string text = std::to_string(number);
  for (auto at = std::ssize(text) - 3; at > 0; at -= 3) {
    text.insert(static_cast<std::size_t>(at), 1, ' ');
  }
  return text;
}

/// "degree 3, 12 480 cells, 214 k unknowns".
std::string stage_of(int degree, std::size_t cells, double dofs) {
  constexpr double kThousand = 1e3, kMillion = 1e6;
  const std::string unknowns =
      dofs < 10.0 * kThousand ? grouped(static_cast<std::size_t>(dofs))
      : dofs < kMillion       ? fmt::format("{:.0f} k", dofs / kThousand)
                              : fmt::format("{:.3g} M", dofs / kMillion);
  return fmt::format("degree {}, {} cells, {} unknowns", degree, grouped(cells),
                     unknowns);
}

template <int dim>
void note_held(const PartJob& job, const LoadSet& set,
               const elasticity::DisplacementBasis<dim>& basis,
               Level<dim>& level) {
  std::optional<SupportStress>& held = level.held;
  for (const auto& face : stress::support_faces<dim>(
           basis, job.part.material, set.fixed, set.history, job.part.name)) {
    level.support_sections.insert(level.support_sections.end(),
                                  face.groups.begin(), face.groups.end());
    Eigen::Index at = 0;
    const double value = face.nominal.maxCoeff(&at);
    if (value <= (held ? held->value : 0.0)) continue;
    const auto& instant = set.history.instants[static_cast<std::size_t>(at)];
    held = SupportStress{value,     value,        value,
                         face.name, instant.time, instant.label};
  }
}

}  // namespace

loads::PartHold reference_hold(const LoadSet& set) {
  const loads::LoadHistory& history = set.history;
  return loads::reference_at(history, loads::reference_groups(history),
                             history.hold_time);
}

template <int dim>
Level<dim> solve_level(const PartJob& job, const std::vector<LoadSet>& sets,
                       const mesh::PartMesh<dim>& mesh,
                       const FeModel<dim>& model, int degree,
                       PartSeconds& seconds,
                       const std::vector<Eigen::VectorXd>& admitted) {
  Level<dim> level;
  level.admitted = admitted;
  const std::size_t cells =
      model.cells_in_plane ? static_cast<std::size_t>(*model.cells_in_plane)
                           : mesh.cells.size();
  for (std::size_t s = 0; s < sets.size(); ++s) {
    const LoadSet& set = sets[s];
    auto basis = std::make_shared<elasticity::DisplacementBasis<dim>>(
        model.solve({mesh, job.part.material, set.history, set.fixed,
                     job.part.name, elasticity::LinearSolver::kAuto,
                     set.foundations, job.engine, job.is_shared, job.max_dofs,
                     admitted.empty() ? Eigen::VectorXd() : admitted[s],
                     [&](double dofs) {
                       job.tell(stage_of(degree, cells, dofs));
                     }},
                    degree));
    seconds.assemble += basis->seconds.assemble;
    seconds.factor += basis->seconds.factor;
    seconds.solve += basis->seconds.solve;
    if (set.fixed.empty() && set.foundations.empty()) {
      stress::refer_to_holds<dim>(set.history, reference_hold(set), *basis);
    }
    Stopwatch watch;
    note_held<dim>(job, set, *basis, level);
    auto history = stress::stress_history<dim>(*basis, job.part.material,
                                               model.subdivisions);
    if constexpr (dim == 2) {
      level.deflections.push_back(
          stress::largest_deflection_of_plate(*basis, job.part.material));
    } else {
      level.deflections.push_back(stress::largest_deflection<dim>(*basis));
    }
    level.member.deflection =
        std::max(level.member.deflection, level.deflections.back().value);
    seconds.recover += watch.lap();
    level.bases.push_back(basis);
    level.histories.push_back(std::move(history));
    if (level.governing &&
        level.histories[s].largest() <= level.history().largest()) {
      continue;
    }
    level.governing = basis;
    level.set = s;
  }
  level.probes = probe_values<dim>(job, level);
  level.member.degree = degree;
  level.member.dofs = level.governing->equations > 0
                          ? level.governing->equations
                          : level.governing->discretization.dofs();
  level.member.peak = level.history().largest();
  if (model.looks_nearby) {
    level.member.field_peak = stress::field_maximum<dim>(
        *level.governing, job.part.material, level.history());
  }
  level.member.label =
      sets[level.set]
          .history
          .instants[static_cast<std::size_t>(level.history().peak_instant)]
          .label;
  level.member.strain_energy =
      level.governing->strain_energy[level.history().peak_instant];
  return level;
}

template Level<2> solve_level<2>(const PartJob&, const std::vector<LoadSet>&,
                                 const mesh::PartMesh<2>&, const FeModel<2>&,
                                 int, PartSeconds&,
                                 const std::vector<Eigen::VectorXd>&);
template Level<3> solve_level<3>(const PartJob&, const std::vector<LoadSet>&,
                                 const mesh::PartMesh<3>&, const FeModel<3>&,
                                 int, PartSeconds&,
                                 const std::vector<Eigen::VectorXd>&);

}  // namespace clevis::assessment

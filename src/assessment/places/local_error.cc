#include "assessment/places/local_error.h"

#include "base/messages/errors.h"
#include "elasticity/assembly/supports.h"
#include "elasticity/nodal_loads/load_vectors.h"
#include "elasticity/solid/neighbourhood.h"
#include "stress/peaks/local_peak.h"

namespace clevis::assessment {
namespace {

using Eigen::MatrixXd;

/// Discrete load of one instant with a higher degree.
template <int dim>
struct FineLoad {
  elasticity::Discretization<dim> discretization;
  MatrixXd load;
  std::vector<int> held;
};

template <int dim>
FineLoad<dim> fine_load(const PartJob& job, const LoadSet& set, int instant,
                        const mesh::PartMesh<dim>& mesh, int degree) {
  FineLoad<dim> fine;
  fine.discretization = elasticity::discretize<dim>(mesh, degree);
  const loads::LoadHistory one{
      set.history.seats,
      {set.history.instants[static_cast<std::size_t>(instant)]}};
  fine.load = elasticity::assemble_loads<dim>(
      fine.discretization, one, job.part.material.density, job.part.name);
  if (!set.fixed.empty()) {
    fine.held = elasticity::fixed_supports<dim>(
        fine.discretization,
        elasticity::node_positions<dim>(fine.discretization), set.fixed,
        job.part.name);
  }
  return fine;
}

}  // namespace

template <int dim>
std::optional<stress::LocalValues> local_peak(const PartJob& job,
                                              const std::vector<LoadSet>& sets,
                                              const mesh::PartMesh<dim>& mesh,
                                              const Level<dim>& level,
                                              double before) {
  if (!sets[level.set].foundations.empty()) return std::nullopt;
  const auto& history = level.history();
  const auto& basis = *level.governing;
  const MatrixXd u =
      basis.columns * basis.coefficients.col(history.peak_instant);
  const auto cells = stress::peak_cells(history);
  const auto peak_with = [&](int more) {
    const auto fine = fine_load<dim>(job, sets[level.set], history.peak_instant,
                                     mesh, level.member.degree + more);
    const auto enriched = elasticity::enrich<dim>(
        {basis.discretization, u, fine.discretization, fine.load, fine.held,
         job.part.material},
        elasticity::with_neighbours<dim>(fine.discretization, cells));
    return stress::enriched_peak<dim>(enriched, cells, job.part.material,
                                      history.subdivisions);
  };
  try {
    return stress::LocalValues{before, level.member.field_peak.value(),
                               peak_with(2), peak_with(3)};
  } catch (const Error&) {
    return std::nullopt;  // a neighbourhood that folds or is loose
  }
}

template std::optional<stress::LocalValues> local_peak<2>(
    const PartJob&, const std::vector<LoadSet>&, const mesh::PartMesh<2>&,
    const Level<2>&, double);
template std::optional<stress::LocalValues> local_peak<3>(
    const PartJob&, const std::vector<LoadSet>&, const mesh::PartMesh<3>&,
    const Level<3>&, double);

}  // namespace clevis::assessment

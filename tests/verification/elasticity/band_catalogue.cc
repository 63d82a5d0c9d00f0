#include "band_catalogue.h"

#include <utility>

#include "elasticity/problem/elastic_problem.h"
#include "elasticity/solid/neighbourhood.h"
#include "stress/field/probe.h"
#include "stress/field/stress_history.h"
#include "stress/peaks/local_peak.h"
#include "stress/peaks/peak_zoom.h"

namespace clevis::support {
namespace {

using elasticity::DisplacementBasis;

template <int dim>
constexpr int kSubdivisions = dim == 2 ? 8 : 4;

template <int dim>
elasticity::ElasticProblem<dim> elastic(const BandProblem<dim>& problem,
                                        const part::Material& material) {
  return {problem.mesh, material, problem.history, {}, "patch"};
}

template <int dim>
DisplacementBasis<dim> solved(const BandProblem<dim>& problem, int degree) {
  const auto material = band_material();
  return solve_field<dim>(elastic<dim>(problem, material), problem.tractions,
                          degree, {}, problem.body);
}

template <int dim>
double peak_of(const DisplacementBasis<dim>& basis) {
  const auto material = band_material();
  return stress::field_maximum<dim>(
      basis, material,
      stress::stress_history<dim>(basis, material, kSubdivisions<dim>));
}

template <int dim>
double probe_of(const DisplacementBasis<dim>& basis, const BandProbe& probe) {
  return stress::probe<dim>(
             basis, band_material(),
             stress::locate<dim>(basis.discretization, probe.at, 0.0),
             probe.quantity, 0)
      .value;
}

/// The field nearby with higher degrees.
template <int dim>
class Nearby {
 public:
  Nearby(const BandProblem<dim>& problem, const DisplacementBasis<dim>& basis,
         int more)
      : basis_(basis),
        fine_(elasticity::discretize<dim>(problem.mesh,
                                          basis.discretization.degree + more)),
        load_(field_load<dim>(fine_, elastic<dim>(problem, material_),
                              problem.tractions, problem.body)) {}

  elasticity::Enriched<dim> at(const std::vector<int>& cells) const {
    return elasticity::enrich<dim>(
        {basis_.discretization, basis_.columns, fine_, load_, {}, material_},
        elasticity::with_neighbours<dim>(fine_, cells));
  }
  double peak() const {
    const auto cells = stress::peak_cells(
        stress::stress_history<dim>(basis_, material_, kSubdivisions<dim>));
    return stress::enriched_peak<dim>(at(cells), cells, material_,
                                      kSubdivisions<dim>);
  }
  double probe(const BandProbe& probe) const {
    std::vector<int> cells;
    for (const auto& [cell, xi] :
         stress::locate<dim>(basis_.discretization, probe.at, 0.0)) {
      cells.push_back(cell);
    }
    return probe_of<dim>(at(cells).basis, probe);
  }

 private:
  part::Material material_ = band_material();
  const DisplacementBasis<dim>& basis_;
  elasticity::Discretization<dim> fine_;
  Eigen::MatrixXd load_;
};

/// Values of the peak, then of the probes.
template <int dim>
std::vector<double> values_of(const BandProblem<dim>& problem,
                              const DisplacementBasis<dim>& basis) {
  std::vector<double> values = {peak_of<dim>(basis)};
  for (const auto& probe : problem.probes) {
    values.push_back(probe_of<dim>(basis, probe));
  }
  return values;
}

template <int dim>
std::vector<double> values_nearby(const BandProblem<dim>& problem,
                                  const DisplacementBasis<dim>& basis,
                                  int more) {
  const Nearby<dim> nearby(problem, basis, more);
  std::vector<double> values = {nearby.peak()};
  for (const auto& probe : problem.probes) {
    values.push_back(nearby.probe(probe));
  }
  return values;
}

/// One case per quantity, named.
template <int dim>
std::vector<BandCase> named(const BandProblem<dim>& problem, int degree) {
  std::vector<BandCase> cases(1 + problem.probes.size());
  for (std::size_t k = 0; k < cases.size(); ++k) {
    const bool is_peak = k == 0;
    cases[k].problem = problem.problem;
    cases[k].variant =
        problem.variant + ", " +
        (is_peak ? "peak" : problem.probes[k - 1].quantity.c_str());
    cases[k].degree = degree;
    cases[k].exact = is_peak ? problem.peak : problem.probes[k - 1].exact;
    cases[k].uncertainty = is_peak ? problem.uncertainty : 1e-9 * problem.peak;
  }
  return cases;
}

}  // namespace

template <int dim>
double solved_peak(const BandProblem<dim>& problem, int degree) {
  return peak_of<dim>(solved<dim>(problem, degree));
}

template <int dim>
void add_cases(const BandProblem<dim>& problem, std::vector<BandCase>& all) {
  constexpr int kFirst = dim == 2 ? 2 : 1;
  constexpr int kHighest = 4;
  std::vector<std::vector<double>> values;
  for (int degree = kFirst; degree <= kHighest; ++degree) {
    const auto basis = solved<dim>(problem, degree);
    values.push_back(values_of<dim>(problem, basis));
    if (degree < 3) continue;
    auto cases = named<dim>(problem, degree);
    std::vector<double> finer;
    std::vector<double> finest;
    if (dim == 2) {
      finer = values_nearby<dim>(problem, basis, 2);
      finest = values_nearby<dim>(problem, basis, 3);
    }
    for (std::size_t k = 0; k < cases.size(); ++k) {
      cases[k].is_nearby = dim == 2;
      if (dim == 2) {
        const auto& before = values[values.size() - 2];
        cases[k].local = {before[k], values.back()[k], finer[k], finest[k],
                          k == 0 ? 0.0 : finest[0] - values.back()[0]};
      }
      for (std::size_t n = 0; n < values.size(); ++n) {
        cases[k].sequence.push_back(
            {kFirst + static_cast<int>(n), values[n][k]});
      }
      all.push_back(std::move(cases[k]));
    }
  }
}

#define CLEVIS_INSTANTIATE(dim)                         \
  template void add_cases<dim>(const BandProblem<dim>&, \
                               std::vector<BandCase>&); \
  template double solved_peak<dim>(const BandProblem<dim>&, int);
CLEVIS_INSTANTIATE(2)
CLEVIS_INSTANTIATE(3)
#undef CLEVIS_INSTANTIATE

}  // namespace clevis::support

#pragma once

#include <functional>
#include <string>

#include "assessment/job/part_job.h"
#include "elasticity/problem/displacement_basis.h"
#include "elasticity/problem/elastic_problem.h"

namespace clevis::assessment {

/// One model of the ladder: what it is called, how it solves a problem with a
/// degree, and how its field is looked at.
template <int dim>
struct Rung {
  std::string name;  ///< "2-D x thickness 3+3"
  std::function<elasticity::DisplacementBasis<dim>(
      const elasticity::ElasticProblem<dim>&, int degree)>
      solve;
  int first_degree{}, highest_degree{};
  /// Lattice on which the peak is sought: the same for every degree, so that
  /// the sequence compares like with like.
  int subdivisions{};
  double model_error{};  ///< over the peak, where known beforehand [1]
  /// Whether higher degrees near the peak alone tell the error of the last.
  bool looks_nearby = false;
  /// Whether finer solutions near all places where the peak may stand give the
  /// value and its error (nearby_peak).
  bool looks_at_places = false;
};

Rung<2> plane_stress_rung(const mesh::PartMesh<2>& plate);
/// @param plate  outlives the rung.
/// @param terms  of the in-plane and of the transverse field.
Rung<3> layered_rung(const mesh::PartMesh<2>& plate, int terms,
                     int subdivisions);
Rung<3> solid_rung(const mesh::PartMesh<3>& mesh);

}  // namespace clevis::assessment

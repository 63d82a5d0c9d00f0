#pragma once

#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "assessment/job/part_job.h"
#include "elasticity/assembly/stiffness.h"
#include "elasticity/problem/displacement_basis.h"
#include "elasticity/problem/elastic_problem.h"
#include "stress/peaks/peak_band.h"
#include "stress/zones/singular_zone.h"

namespace clevis::assessment {

/// Finite-element model of one part: how it is called, how it solves a problem
/// with a degree, and how its field is looked at.
template <int dim>
struct FeModel {
  std::string name;                   ///< "2-D x thickness 3+3"
  const mesh::PartMesh<dim>* mesh{};  ///< of its field; outlives it
  std::optional<int> cells_in_plane;  ///< of the mid-plane or the meridian, if
                                      ///< these are solved, not `mesh`
  std::function<elasticity::DisplacementBasis<dim>(
      const elasticity::ElasticProblem<dim>&, int degree)>
      solve;
  /// The singular zones of a load set.
  std::function<std::vector<stress::SingularZone>(const LoadSet&)> zones;
  int first_degree{}, highest_degree{};
  /// Lattice on which the peak is sought: the same for every degree, so that
  /// the sequence compares like with like.
  int subdivisions{};
  double model_error{};  ///< over the peak, where known beforehand [1]
  /// Of stress::peak_band() [1].
  double share_of_change_before = stress::kShareOfChangeBefore;
  /// Whether higher degrees near the peak alone tell the error of the last.
  bool looks_nearby = false;
  /// Whether finer solutions near all places where the peak may stand give the
  /// value and its error (nearby_peak).
  bool looks_at_places = false;
  /// Tells in the part's result what the solutions say beside their fields;
  /// empty: nothing. Called after the last degree.
  std::function<void(PartResult&)> remark;
};

/// Of whichever dimension.
using AnyFeModel = std::variant<FeModel<2>, FeModel<3>>;

/// How a model is set up for a part.
struct ModelSettings {
  int terms{};         ///< through the thickness; 0 of a model without
  int subdivisions{};  ///< of the lattice; 0: the model's own
  /// Against the next model, over the peak, where known before a solution [1].
  std::optional<double> error = std::nullopt;
  /// Instants that the first degrees are content with; empty: all.
  std::vector<LoadSet> governing = {};
};

/// Raises a degree with which the interpolated geometry of a cell folds.
template <int dim>
int unfolded(const mesh::PartMesh<dim>& mesh, int degree, int highest) {
  while (degree < highest &&
         elasticity::folds<dim>(elasticity::discretize<dim>(mesh, degree))) {
    ++degree;
  }
  return degree;
}

}  // namespace clevis::assessment

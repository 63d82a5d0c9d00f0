#pragma once

#include <functional>
#include <string>
#include <vector>

#include "elasticity/problem/displacement_basis.h"
#include "mesh/cells/part_mesh.h"
#include "stress/peaks/peak_band.h"
#include "support/elastic_field_problem.h"
#include "support/field_error.h"

namespace clevis::support {

/// A quantity with its exact value, computed with one degree on one mesh.
struct BandCase {
  std::string problem;  ///< "Kirsch"
  std::string variant;  ///< mesh and quantity: "quads 3x4, peak"
  int degree{};
  double exact{}, uncertainty{};
  bool is_nearby{};  ///< `local` is filled, else `sequence`
  stress::LocalValues local;
  std::vector<stress::SequenceValue> sequence;

  stress::Band band(double tolerance) const {
    return is_nearby ? stress::local_band(local, tolerance)
                     : stress::peak_band(sequence, tolerance);
  }
};

struct BandProbe {
  Eigen::Vector3d at;
  std::string quantity;
  double exact{};
};

/// A mesh, all that loads it, and what is known of its stress.
template <int dim>
struct BandProblem {
  std::string problem, variant;
  mesh::PartMesh<dim> mesh;
  std::vector<TractionField<dim>> tractions;
  BodyField<dim> body;
  loads::LoadHistory history;
  double peak{}, uncertainty{};  ///< of von Mises
  std::vector<BandProbe> probes;
};

/// Solves with degrees 2 to 4: bands with higher degrees nearby for degrees 3
/// and 4 of plane problems, bands of the sequence from degree 1 in 3-D.
template <int dim>
void add_cases(const BandProblem<dim>& problem, std::vector<BandCase>& all);

/// Largest von Mises stress that a problem has with a degree, between the
/// points of a lattice too.
template <int dim>
double solved_peak(const BandProblem<dim>& problem, int degree);

/// Problems with stress fields in closed form: the patch that a mesh covers is
/// loaded by their tractions all round.
std::vector<BandCase> closed_form_cases();
/// Others of their kind.
std::vector<BandCase> held_out_closed_form_cases();

/// Problems whose peak is that of a much finer mesh.
std::vector<BandCase> converged_cases();

inline part::Material band_material() {
  return {"steel", 210e9, 0.3, 7850.0, 355e6};
}

}  // namespace clevis::support

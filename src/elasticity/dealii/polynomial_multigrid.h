#pragma once

#include <memory>
#include <string>
#include <vector>

#include "elasticity/dealii/coarse_solver.h"

namespace clevis::elasticity {

/// Operators and transfers of the levels of a multigrid.
template <int dim>
struct LevelSetup {
  const MeshShare<dim>& share;
  const Discretization<dim>& discretization;
  const std::vector<int>& held;
  CellStiffness stiffness;
  const std::vector<BedFace>& beds;
  std::string name;  ///< for messages
};

/// One V-cycle over falling degrees in single precision, smoothed by Chebyshev
/// polynomials of the diagonally scaled stiffness.
template <int dim>
class PolynomialMultigrid {
 public:
  using Vector = dealii::LinearAlgebra::distributed::Vector<double>;

  /// @param finest  space of the solution; outlives this.
  PolynomialMultigrid(const LevelSetup<dim>& setup,
                      const DegreeSpace<dim>& finest);
  ~PolynomialMultigrid();
  PolynomialMultigrid(const PolynomialMultigrid&) = delete;
  PolynomialMultigrid& operator=(const PolynomialMultigrid&) = delete;

  void vmult(Vector& solution, const Vector& residual) const;

  std::size_t levels() const;

 private:
  struct Levels;
  std::unique_ptr<Levels> levels_;
};

}  // namespace clevis::elasticity

#pragma once

#include <memory>

#include "elasticity/dealii_levels/coarse_solver.h"

namespace clevis::elasticity {

/// One V-cycle over falling degrees in single precision, smoothed by Chebyshev
/// polynomials of the diagonally scaled stiffness.
template <int dim>
class PolynomialMultigrid {
 public:
  using Vector = dealii::LinearAlgebra::distributed::Vector<double>;

  /// @param finest  space of the solution; outlives this.
  PolynomialMultigrid(const EnginePart& part, const DegreeSpace<dim>& finest);
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

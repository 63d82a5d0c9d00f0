#pragma once

#include <memory>

#include <Eigen/Core>

#include "elasticity/dealii_space/dealii_task.h"

namespace clevis::elasticity {

/// The part of DealiiSolver, loads [N] and displacements [m], that is in the
/// library of deal.II and PETSc.
class DealiiEngine {
 public:
  virtual ~DealiiEngine() = default;
  virtual Eigen::MatrixXd solve(const Eigen::MatrixXd& loads) = 0;
  virtual Eigen::MatrixXd multiply_absolute_diagonal(
      const Eigen::MatrixXd& columns) const = 0;
  virtual const DealiiReport& report() const = 0;
};

/// The library's function that makes one, and its name.
template <int dim>
using DealiiEntry = std::unique_ptr<DealiiEngine>(const DealiiTask<dim>& task);
template <int dim>
inline constexpr const char* kDealiiEntry =
    dim == 2 ? "clevis_dealii_2" : "clevis_dealii_3";

}  // namespace clevis::elasticity

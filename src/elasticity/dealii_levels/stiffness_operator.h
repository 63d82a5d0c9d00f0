#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/la_parallel_vector.h>

#include "elasticity/dealii_space/degree_space.h"

namespace clevis::elasticity {

/// y = K x without K, deal.II's cells in SIMD lanes. The rows of held
/// components are those of the unit matrix. Its sources alone know the number
/// of lanes: that of solids is compiled once for each instruction set.
template <int dim, typename Number>
class StiffnessOperator : public dealii::Subscriptor {
 public:
  using value_type = Number;
  using Vector = dealii::LinearAlgebra::distributed::Vector<Number>;

  StiffnessOperator();
  ~StiffnessOperator() override;

  /// @param space   outlives the operator.
  /// @param points  Gauss points a direction.
  void reinit(const DegreeSpace<dim>& space, int points,
              const CellStiffness& stiffness, const std::vector<BedFace>& beds);

  void initialize_dof_vector(Vector& vector) const;
  dealii::types::global_dof_index m() const;

  /// What the rank sends in a product: of each row that it shares and another
  /// rank owns, the part of its sum; of its own rows, x to those that share
  /// them [bytes].
  std::size_t bytes_sent() const;

  void vmult(Vector& y, const Vector& x) const;
  void Tvmult(Vector& y, const Vector& x) const { vmult(y, x); }
  /// Of a symmetric matrix that is never stored: asked for by interfaces, not
  /// by what calls them.
  Number el(unsigned, unsigned) const { return Number(0); }

  /// Diagonal [N/m], one in held rows.
  Vector diagonal() const;

  using Entries = dealii::FullMatrix<double>;
  using Numbers = std::vector<dealii::types::global_dof_index>;
  /// Visits the stiffness of the rank's cells and of the beds under them
  /// [N/m], with the numbers of their rows.
  void visit_cells(
      const std::function<void(const Entries&, const Numbers&)>& visit) const;

 private:
  struct Lanes;
  std::unique_ptr<Lanes> lanes_;
};

}  // namespace clevis::elasticity

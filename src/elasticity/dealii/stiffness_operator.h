#pragma once

#include <functional>
#include <vector>

#include <deal.II/lac/full_matrix.h>
#include <deal.II/lac/la_parallel_vector.h>
#include <deal.II/matrix_free/matrix_free.h>

#include "elasticity/assembly/foundation.h"
#include "elasticity/assembly/stiffness.h"
#include "elasticity/dealii/degree_space.h"

namespace clevis::elasticity {

/// Lamé's constants times the thickness of a plate.
struct CellStiffness {
  double lambda{}, mu{};  ///< [Pa], for dim = 2 [N/m]
};

/// Stiffness of a bed under one face, at the discretisation's nodes.
struct BedFace {
  std::size_t cell{};                 ///< of the discretisation
  std::vector<int> nodes;             ///< of the face, numbers within the cell
  dealii::FullMatrix<double> matrix;  ///< dim nodes × dim nodes [N/m]
};

/// y = K x without K, deal.II's cells in SIMD lanes. The rows of held
/// components are those of the unit matrix.
template <int dim, typename Number>
class StiffnessOperator : public dealii::Subscriptor {
 public:
  using value_type = Number;
  using Vector = dealii::LinearAlgebra::distributed::Vector<Number>;

  /// @param space   outlives the operator.
  /// @param points  Gauss points a direction.
  void reinit(const DegreeSpace<dim>& space, int points,
              const CellStiffness& stiffness, const std::vector<BedFace>& beds);

  void initialize_dof_vector(Vector& vector) const;
  dealii::types::global_dof_index m() const;

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
  struct Bed {
    std::vector<unsigned> rows;  ///< in the rank's vectors, ghosts behind
    Numbers numbers;             ///< over all ranks
    dealii::FullMatrix<double> matrix;  ///< [N/m]
  };
  using Range = std::pair<unsigned, unsigned>;
  using Cells = dealii::MatrixFree<dim, Number>;
  void take_bed(const DegreeSpace<dim>& space, const BedFace& face);
  void apply_cells(const Cells& cells, Vector& y, const Vector& x,
                   const Range& range) const;
  void apply_beds(Vector& y, const Vector& x) const;

  Cells cells_;
  dealii::AffineConstraints<Number> held_;
  std::vector<unsigned> held_rows_;
  std::vector<Bed> beds_;  ///< under the rank's cells
  bool has_beds_ = false;  ///< under any rank's
  Number lambda_{}, two_mu_{};
};

}  // namespace clevis::elasticity

#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "elasticity/assembly/stiffness.h"
#include "elasticity/fe_space/discretization.h"
#include "part/part_definition.h"

namespace clevis::elasticity {

/// Stiffness of the elastic beds under a part's faces, face by face:
/// ∫ N_i N_j (k_n n nᵀ + k_t (1 − n nᵀ)) dA, n the normal at each point.
template <int dim>
class FoundationStiffness {
 public:
  struct Face {
    int cell{};
    std::vector<int> nodes;
    Eigen::MatrixXd matrix;  ///< dim nodes × dim nodes [N/m]
  };

  /// @throws Error M003 if the mesh lacks a group.
  FoundationStiffness(const Discretization<dim>& discretization,
                      const part::Foundations& foundations,
                      const std::string& part_name);

  /// Leaves out the faces of all but these cells.
  /// @param cells  ascending.
  void keep(const std::vector<int>& cells);

  /// @param node  the number that each node has instead.
  void renumber(const std::vector<int>& node);

  bool empty() const { return faces_.empty(); }

  /// Adds it to the stiffness of the body.
  void add_to(StiffnessMatrix<dim>& stiffness) const;

  /// Adds its forces on displacements [N], dofs × columns.
  void add_forces(const Eigen::MatrixXd& columns,
                  Eigen::MatrixXd& forces) const;

  /// Modesᵀ F modes: what it takes to move the part as `modes` do, modes ×
  /// modes [N/m].
  /// @param modes  displacements, dofs × modes [1].
  Eigen::MatrixXd on_modes(const Eigen::MatrixXd& modes) const;

  const std::vector<Face>& faces() const { return faces_; }

 private:
  std::vector<Face> faces_;
};

}  // namespace clevis::elasticity

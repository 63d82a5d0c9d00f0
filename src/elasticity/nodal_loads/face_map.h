#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/Core>

#include "elasticity/fe_space/discretization.h"

namespace clevis::elasticity {

/// Points of a face's own coordinates: one for the side of a plane cell, two
/// for the face of a solid one.
template <int dim>
using FacePoint = Eigen::Matrix<double, dim - 1, 1>;
template <int dim>
using FacePoints = Eigen::Matrix<double, dim - 1, Eigen::Dynamic>;

/// Polynomials [1] in the own coordinates of a cell's local face that span the
/// basis of displacement and geometry on it: at many points they take far less
/// than the functions of the whole cell.
template <int dim>
class FaceBasis {
 public:
  FaceBasis(const Discretization<dim>& discretization, int face);

  /// Points × polynomials.
  struct Table {
    Eigen::MatrixXd value;
    std::vector<Eigen::MatrixXd> slope;  ///< along each own coordinate
  };
  Table at(const FacePoints<dim>& own) const;
  Eigen::MatrixXd values(const FacePoints<dim>& own) const;

  /// Of the cell's displacement, that do not vanish on the face.
  const std::vector<std::size_t>& functions() const { return functions_; }
  /// Polynomials × functions.
  const Eigen::MatrixXd& displacement() const { return displacement_; }
  /// Polynomials × functions of the cell's geometry.
  const Eigen::MatrixXd& geometry() const { return geometry_; }
  /// 1 if the own coordinates turn round the outward normal, else -1.
  double sense() const { return sense_; }

 private:
  FacePoints<dim> support_points() const;

  mesh::CellShape shape_;
  int degree_;
  Eigen::VectorXd nodes_;  ///< of the polynomials along a tensor cell's side
  std::vector<std::size_t> functions_;
  Eigen::MatrixXd displacement_, geometry_;
  double sense_;
};

/// The face of a cell in space.
template <int dim>
class FaceMap {
 public:
  /// @param basis  of the local face; outlives this.
  FaceMap(const Discretization<dim>& discretization,
          const FaceBasis<dim>& basis, int cell);

  const FaceBasis<dim>& basis() const { return *basis_; }

  Eigen::Matrix3Xd points(const FacePoints<dim>& own) const;  ///< [m]

  /// Points [m] and area vectors, outward, per measure of the own coordinates
  /// [m²].
  struct Surface {
    Eigen::Matrix3Xd points, areas;
  };
  Surface surface(const typename FaceBasis<dim>::Table& table) const;

 private:
  const FaceBasis<dim>* basis_;
  Eigen::Matrix3Xd coefficients_;  ///< of the polynomials
  double thickness_;
};

}  // namespace clevis::elasticity

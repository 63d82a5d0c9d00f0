#pragma once

#include <vector>

#include <Eigen/Core>

#include "elasticity/fe_space/discretization.h"
#include "elasticity/revolution/harmonic.h"
#include "mesh/derived/revolution.h"

namespace clevis::elasticity {

/// How a Fourier series about the axis is put on hexahedra: sectors of equal
/// angle, polynomials of degree kDegree along the circumference.
struct AngularGrid {
  static constexpr int kDegree = 10;
  int sectors{};
  Eigen::VectorXd angles;  ///< of the planes of nodes, once round

  /// As many sectors as the highest order needs: its polynomial is off by
  /// 5e-2 of the term's stress (whose share falls like 1/order²), that of half
  /// the order by 5e-5, that of order 2 by 5e-11.
  explicit AngularGrid(int highest_order);
};

/// The meridian's discretisation turned round the axis: hexahedra whose third
/// direction runs along the circumference with degree AngularGrid::kDegree.
/// Node `i` of the meridian in plane `a` is number a·nodes + i. At the axis
/// cells have an edge of no length.
Discretization<3> revolve(const Discretization<2>& meridian,
                          const mesh::Revolution& solid,
                          const AngularGrid& grid);

/// Displacements at the nodes of the revolved discretisation, in L, dofs ×
/// columns [m].
/// @param amplitudes  per term 3·nodes × columns (u_x, u_+, u_−) [m].
Eigen::MatrixXd sum_harmonics(const std::vector<Harmonic>& harmonics,
                              const std::vector<Eigen::MatrixXd>& amplitudes,
                              const mesh::Revolution& solid,
                              const AngularGrid& grid);

}  // namespace clevis::elasticity

#pragma once

#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "elasticity/fe_space/discretization.h"
#include "elasticity/revolution/harmonic.h"
#include "loads/history/load_history.h"
#include "mesh/derived/revolution.h"

namespace clevis::elasticity {

/// Nodal loads of one Fourier term at some nodes of the meridian [N].
struct HarmonicLoad {
  Harmonic harmonic;
  std::vector<int> nodes;  ///< ascending
  Eigen::MatrixXd values;  ///< 3·nodes × instants, amplitudes (u_x, u_+, u_−)
};

/// Consistent nodal loads of a solid of revolution: terms up to `highest` that
/// something loads [N]. The bearing pressure's series is exact term by term,
/// the discrete resultant of every seat and surface is the wanted one.
/// @param density [kg/m³].
/// @throws Error M003 if the meridian lacks a group, L002 if a bearing seat's
///   group is no cylinder.
std::vector<HarmonicLoad> assemble_harmonic_loads(
    const Discretization<2>& meridian, const mesh::Revolution& solid,
    const loads::LoadHistory& history, double density, int highest,
    const std::string& part_name);

/// Rigid modes in one term of order 0 or 1 [1]: 3·nodes × 6, translations along
/// the frame's axes, then rotations about them over `length` [m]; zero for
/// others.
Eigen::MatrixXd harmonic_rigid_modes(const Harmonic& harmonic,
                                     const Discretization<2>& meridian,
                                     double length);

/// Balances the loads of a free part by a rigid acceleration of its mass, as
/// balance_loads does.
/// @return the largest residual before and after, over the loads' size [1].
std::pair<double, double> balance_harmonic_loads(
    const Discretization<2>& meridian, double density, double length,
    std::vector<HarmonicLoad>& loads);

}  // namespace clevis::elasticity

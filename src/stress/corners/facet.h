#pragma once

#include <vector>

#include <Eigen/Core>

#include "mesh/cells/part_mesh.h"
#include "mesh/derived/revolution.h"
#include "part/supports.h"
#include "stress/corners/held_corner.h"

namespace clevis::stress {

inline constexpr double kFacetKink = 52.0;  ///< over straight [degrees]

/// Which corners are those between facets of a curve: kinks of a few degrees
/// beside another like them or a face that bends much more, larger ones in a
/// row of three and more with one facet between each two. Others are notches,
/// however blunt: a groove or a chamfer has two of them.
std::vector<bool> facets_of_curves(const std::vector<HeldCorner>& corners);

/// Largest kink of a facet of a curve beside a point, within a facet of it;
/// 0: there is none [rad]. Between facets that kink by δ the stress of the
/// surface behind them is (2δ/π) ln(2 sin(πs/ℓ)) of itself off at the way s
/// along a facet ℓ: theory.md.
/// @param stress  there, in L [Pa]: a kink counts as far as it flows across
///   the kink's edge or shears along it, over its von Mises stress; zero: as a
///   whole.
/// @param turned  of a model that turns a section: round its axis the facets
///   are round; null: of none.
double facet_kink(const mesh::PartMesh<3>& mesh, const part::Supports& fixed,
                  const Eigen::Vector3d& at, const Eigen::Matrix3d& stress,
                  const mesh::Revolution* turned = nullptr);

}  // namespace clevis::stress

#pragma once

#include <array>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "loads/pressure/surface_shear.h"
#include "mesh/cells/part_mesh.h"
#include "mesh/derived/revolution.h"
#include "part/material.h"
#include "part/supports.h"

namespace clevis::stress {

/// A re-entrant corner, a crack, the end of a support or of a surface's shear:
/// a vertex of a plane mesh or a chain of edges of a solid one where the stress
/// of the model has no bound.
struct SingularZone {
  std::string name;  ///< "edge of root at (0, 10, 2) mm", "notch at …"
  std::string edge_of = {};  ///< the held group whose edge it is; empty: none
  /// Smallest Williams exponent λ: stress goes like distance^(λ − 1); 1: like
  /// the distance's logarithm [1].
  double exponent{};
  Eigen::Vector3d at = Eigen::Vector3d::Zero();  ///< vertex, mid-edge, L [m]
  double radius{};  ///< of what is left out around it [m]
  double reach{};   ///< of the cells at its edges [m]
  /// By which shear that ends here may raise the stress beyond what cells show,
  /// as that of a surface load [Pa].
  double rise{};
  std::vector<unsigned> vertices;  ///< of the mesh
  /// Its edges by their ends in L (both ends the vertex in 2-D) [m].
  std::vector<std::pair<Eigen::Vector3d, Eigen::Vector3d>> edges;
};

/// Zones of a part from its shape, supports and the shear on its surface.
///
/// At every boundary vertex (dim = 2: plane stress) or surface edge (dim = 3:
/// plane strain and antiplane shear across the edge) the angle of the
/// material, from the true tangents of its cells, and what is held on both
/// sides give the exponent. Counted from kSmoothExponent down; kinks
/// between sides that are held alike are facets of a smooth surface if they are
/// of up to 15° beside another like them or a face that itself bends four times
/// as far in their sense, or of up to kFacetKink in a row of three and more
/// with one facet between each two; else notches. Edges that
/// meet and have like sides are one zone. The radius is a tenth of the wall,
/// the way through the material from the zone along the bisector of its angle,
/// however large the cells: what lies farther away has to be resolved. It ends
/// half way to a bore or round that the zone does not touch.
/// @param shear  on groups, of solids: it ends at their edges, without bound
///   where the surface is smooth there.
template <int dim>
std::vector<SingularZone> singular_zones(const mesh::PartMesh<dim>& mesh,
                                         const part::Material& material,
                                         const part::Supports& fixed,
                                         const loads::SurfaceShear& shear = {});

/// By how much shear that ends at an edge of the part, where the stress is
/// bounded but steep, may change the stress at a point within the cells at that
/// edge: π/2 of what does not meet its like on the other face [Pa].
double rise_at_edges(const mesh::PartMesh<3>& mesh,
                     const loads::SurfaceShear& shear,
                     const Eigen::Vector3d& at);

inline constexpr double kSmoothExponent = 0.97;
inline constexpr double kFacetKink = 52.0;  ///< over straight [degrees]
inline constexpr double kRadiusOfWall = 0.1;

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

/// Distance of a point from a zone's edges [m].
double distance(const SingularZone& zone, const Eigen::Vector3d& point);

}  // namespace clevis::stress

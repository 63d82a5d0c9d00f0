#pragma once

#include <array>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "loads/pressure/surface_shear.h"
#include "mesh/cells/part_mesh.h"
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
/// half way to a bore or round that the zone does not touch, and to any other
/// hollow surface that does not begin at it.
/// @param shear  on groups, of solids: it ends at their edges, without bound
///   where the surface is smooth there.
template <int dim>
std::vector<SingularZone> singular_zones(const mesh::PartMesh<dim>& mesh,
                                         const part::Material& material,
                                         const part::Supports& fixed,
                                         const loads::SurfaceShear& shear = {});

inline constexpr double kSmoothExponent = 0.97;
inline constexpr double kRadiusOfWall = 0.1;

/// Distance of a point from a zone's edges [m].
double distance(const SingularZone& zone, const Eigen::Vector3d& point);

}  // namespace clevis::stress

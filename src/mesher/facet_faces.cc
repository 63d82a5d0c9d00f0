#include "mesher/facet_faces.h"

#include <utility>

#include <BRepBndLib.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <Poly_Triangulation.hxx>
#include <TopExp.hxx>
#include <TopLoc_Location.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>

namespace clevis::mesher {
namespace {

constexpr double kMillimetre = 1e-3;  // [m]

cad::Facets facets_of(const TopoDS_Face& face) {
  cad::Facets facets;
  TopLoc_Location location;
  const auto found = BRep_Tool::Triangulation(face, location);
  if (found.IsNull()) return facets;
  for (int i = 1; i <= found->NbNodes(); ++i) {
    const gp_Pnt p = found->Node(i).Transformed(location.Transformation());
    facets.points.push_back(kMillimetre * Eigen::Vector3d(p.X(), p.Y(), p.Z()));
  }
  for (int i = 1; i <= found->NbTriangles(); ++i) {
    int a{}, b{}, c{};
    found->Triangle(i).Get(a, b, c);
    if (face.Orientation() == TopAbs_REVERSED) std::swap(b, c);
    facets.triangles.push_back({a - 1, b - 1, c - 1});
  }
  return facets;
}

}  // namespace

std::vector<cad::Facets> facets_of(const TopoDS_Solid& solid) {
  constexpr double kShare = 1e-3;  // of the solid's size
  constexpr double kTurn = 0.2;    // [rad]
  Bnd_Box box;
  BRepBndLib::Add(solid, box);
  const double size = box.CornerMin().Distance(box.CornerMax());
  const BRepMesh_IncrementalMesh mesh(solid, kShare * size, false, kTurn);
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(solid, TopAbs_FACE, faces);
  std::vector<cad::Facets> all;
  for (int i = 1; i <= faces.Extent(); ++i) {
    all.push_back(facets_of(TopoDS::Face(faces(i))));
  }
  return all;
}

}  // namespace clevis::mesher

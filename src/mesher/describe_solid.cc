#include "mesher/describe_solid.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepExtrema_DistShapeShape.hxx>
#include <BRepGProp.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <GProp_GProps.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS.hxx>
#include <fmt/format.h>
#include <gp_Cone.hxx>
#include <gp_Cylinder.hxx>
#include <gp_Mat.hxx>
#include <gp_Sphere.hxx>
#include <gp_Torus.hxx>

#include "base/messages/errors.h"
#include "mesher/fitted_surface.h"

namespace clevis::mesher {
namespace {

using Eigen::Vector3d;

constexpr double kMillimetre = 1e-3;  // [m]
// Error of integrals over splines [1], which OpenCASCADE does not keep
// everywhere.
constexpr double kOfArea = 1e-8, kOfVolume = 1e-6;

Vector3d metres(const gp_Pnt& p) {
  return kMillimetre * Vector3d(p.X(), p.Y(), p.Z());
}

Vector3d unit(const gp_Dir& d) {
  return {d.X(), d.Y(), d.Z()};
}

void set_axis(const gp_Ax1& axis, cad::Face& face) {
  face.axis_point = metres(axis.Location());
  face.axis = unit(axis.Direction());
}

/// Kind, axis, radius, turn and extent of the surface under a face.
void set_surface(const BRepAdaptor_Surface& surface, const Patch& patch,
                 cad::Face& face) {
  using enum cad::SurfaceKind;
  const double turn = patch.u1 - patch.u0;
  const double middle = (patch.v0 + patch.v1) / 2;
  const auto along = [&face](double from, double to) {
    face.low = kMillimetre * std::min(from, to);
    face.high = kMillimetre * std::max(from, to);
  };
  switch (surface.GetType()) {
    case GeomAbs_Plane:
      face.kind = kPlane;
      break;
    case GeomAbs_Cylinder:
      face.kind = kCylinder;
      set_axis(surface.Cylinder().Axis(), face);
      face.radius = kMillimetre * surface.Cylinder().Radius();
      face.angle = turn;
      along(patch.v0, patch.v1);
      break;
    case GeomAbs_Cone: {
      const gp_Cone cone = surface.Cone();
      const double slope = cone.SemiAngle();
      face.kind = kCone;
      set_axis(cone.Axis(), face);
      face.radius =
          kMillimetre * std::abs(cone.RefRadius() + middle * std::sin(slope));
      face.angle = turn;
      along(patch.v0 * std::cos(slope), patch.v1 * std::cos(slope));
      break;
    }
    case GeomAbs_Sphere:
      face.kind = kSphere;
      face.axis_point = metres(surface.Sphere().Location());
      face.radius = kMillimetre * surface.Sphere().Radius();
      break;
    case GeomAbs_Torus:
      face.kind = kTorus;
      set_axis(surface.Torus().Axis(), face);
      face.radius = kMillimetre * surface.Torus().MinorRadius();
      face.angle = turn;
      break;
    default:
      fit_surface(surface, patch, face);
      break;
  }
}

/// Normal out of the part half-way along both parameters, and on which side of
/// a round surface the part lies.
void set_side(const BRepAdaptor_Surface& surface, const Patch& patch,
              bool reversed, cad::Face& face) {
  gp_Pnt p;
  gp_Vec du, dv;
  surface.D1((patch.u0 + patch.u1) / 2, (patch.v0 + patch.v1) / 2, p, du, dv);
  const gp_Vec normal = du.Crossed(dv);
  if (normal.Magnitude() <= 0.0) return;
  face.normal = (reversed ? -1.0 : 1.0) * unit(gp_Dir(normal));
  Vector3d from_axis = metres(p) - face.axis_point;
  if (face.kind == cad::SurfaceKind::kTorus) {
    const gp_Torus torus = surface.Torus();
    from_axis -= face.axis.dot(from_axis) * face.axis;
    from_axis =
        metres(p) - (face.axis_point + kMillimetre * torus.MajorRadius() *
                                           from_axis.normalized());
  } else if (face.kind != cad::SurfaceKind::kSphere) {
    from_axis -= face.axis.dot(from_axis) * face.axis;
  }
  face.hollow = face.radius > 0.0 && from_axis.dot(face.normal) < 0.0;
}

/// Of a cylinder's normals ∫ n nᵀ dA [m²], n the way from its axis over its
/// radius.
/// @param inertia  ∫ (|r|² 1 − r rᵀ) dA about the area's centre [mm⁴].
Eigen::Matrix3d normal_square(const cad::Face& face, const gp_Mat& inertia) {
  Eigen::Matrix3d about_centre;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) about_centre(i, j) = inertia(i + 1, j + 1);
  }
  about_centre *= std::pow(kMillimetre, 4.0);
  const Eigen::Matrix3d one = Eigen::Matrix3d::Identity();
  const Vector3d off = face.centre - face.axis_point;
  const Eigen::Matrix3d square = 0.5 * about_centre.trace() * one -
                                 about_centre +
                                 face.area * off * off.transpose();
  const Eigen::Matrix3d across = one - face.axis * face.axis.transpose();
  return across * square * across / (face.radius * face.radius);
}

/// OpenCASCADE integrates exactly over what lines and circles bound on planes,
/// cylinders, cones, spheres and tori.
bool is_exact(const TopoDS_Face& face) {
  if (!is_elementary(face)) return false;
  for (TopExp_Explorer edge(face, TopAbs_EDGE); edge.More(); edge.Next()) {
    const TopoDS_Edge& outline = TopoDS::Edge(edge.Current());
    if (BRep_Tool::Degenerated(outline)) continue;
    const GeomAbs_CurveType type = BRepAdaptor_Curve(outline).GetType();
    if (type != GeomAbs_Line && type != GeomAbs_Circle) return false;
  }
  return true;
}

cad::Face described(const TopoDS_Face& shape, int number) {
  cad::Face face;
  face.number = number;
  GProp_GProps area;
  if (is_exact(shape)) {
    BRepGProp::SurfaceProperties(shape, area);
  } else {
    BRepGProp::SurfaceProperties(shape, area, kOfArea);
  }
  face.area = kMillimetre * kMillimetre * area.Mass();
  face.centre = metres(area.CentreOfMass());
  const BRepAdaptor_Surface surface(shape);
  Patch patch;
  BRepTools::UVBounds(shape, patch.u0, patch.u1, patch.v0, patch.v1);
  set_surface(surface, patch, face);
  set_side(surface, patch, shape.Orientation() == TopAbs_REVERSED, face);
  if (face.kind == cad::SurfaceKind::kCylinder) {
    face.normal_square = normal_square(face, area.MatrixOfInertia());
  }
  return face;
}

void add_neighbours(const TopoDS_Solid& solid,
                    const TopTools_IndexedMapOfShape& shapes,
                    std::vector<cad::Face>& faces) {
  TopTools_IndexedDataMapOfShapeListOfShape faces_of;
  TopExp::MapShapesAndAncestors(solid, TopAbs_EDGE, TopAbs_FACE, faces_of);
  std::vector<std::set<int>> beside(faces.size());
  for (int i = 1; i <= faces_of.Extent(); ++i) {
    const int a = shapes.FindIndex(faces_of(i).First());
    const int b = shapes.FindIndex(faces_of(i).Last());
    if (a == b) continue;
    beside[std::size_t(a) - 1].insert(b);
    beside[std::size_t(b) - 1].insert(a);
  }
  for (std::size_t f = 0; f < faces.size(); ++f) {
    faces[f].neighbours.assign(beside[f].begin(), beside[f].end());
  }
}

std::vector<double> distances(const Vector3d& point,
                              const TopTools_IndexedMapOfShape& faces) {
  const Vector3d p = point / kMillimetre;
  const TopoDS_Vertex vertex =
      BRepBuilderAPI_MakeVertex(gp_Pnt(p.x(), p.y(), p.z()));
  std::vector<double> found;
  for (int i = 1; i <= faces.Extent(); ++i) {
    found.push_back(kMillimetre *
                    BRepExtrema_DistShapeShape(vertex, faces(i)).Value());
  }
  return found;
}

void set_box(const TopoDS_Solid& solid, const std::string& file,
             cad::Solid& described) {
  constexpr double kLeast = 1e-5, kMost = 100.0;  // [m]
  Bnd_Box box;
  BRepBndLib::AddOptimal(solid, box, false, false);
  described.low = metres(box.CornerMin());
  described.high = metres(box.CornerMax());
  const double size = (described.high - described.low).maxCoeff();
  if (kLeast <= size && size <= kMost) return;
  throw Error("M007", file,
              fmt::format("the solid is {:.4g} mm large", size / kMillimetre),
              "Check the unit of lengths in the file.");
}

}  // namespace

cad::Solid describe(const TopoDS_Solid& solid,
                    const std::vector<Vector3d>& points,
                    const std::string& file) {
  cad::Solid result;
  set_box(solid, file, result);
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(solid, TopAbs_FACE, faces);
  bool all_exact = true;
  for (int i = 1; i <= faces.Extent(); ++i) {
    all_exact = all_exact && is_exact(TopoDS::Face(faces(i)));
  }
  GProp_GProps volume;
  if (all_exact) {
    BRepGProp::VolumeProperties(solid, volume);
  } else {  // by Gauss and Kronrod: the other method errs more
    BRepGProp::VolumePropertiesGK(solid, volume, kOfVolume);
  }
  result.volume = std::pow(kMillimetre, 3) * volume.Mass();
  for (int i = 1; i <= faces.Extent(); ++i) {
    result.faces.push_back(described(TopoDS::Face(faces(i)), i));
  }
  add_neighbours(solid, faces, result.faces);
  for (const Vector3d& point : points) {
    result.distances.push_back(distances(point, faces));
  }
  return result;
}

void add_labels(const TopoDS_Solid& solid,
                const std::vector<std::pair<TopoDS_Shape, std::string>>& labels,
                cad::Solid& described) {
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(solid, TopAbs_FACE, faces);
  for (const auto& [shape, label] : labels) {
    TopTools_IndexedMapOfShape named;
    TopExp::MapShapes(shape, TopAbs_FACE, named);
    for (int n = 1; n <= named.Extent(); ++n) {
      for (int f = 1; f <= faces.Extent(); ++f) {
        // The part may stand elsewhere in its file than its faces do.
        if (!faces(f).IsPartner(named(n))) continue;
        described.faces[std::size_t(f) - 1].label = label;
      }
    }
  }
}

}  // namespace clevis::mesher

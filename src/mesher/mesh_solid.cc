#include "mesher/mesh_solid.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <BRepGProp.hxx>
#include <GProp_GProps.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <fmt/format.h>
#include <gmsh.h>
#include <gp_Pnt.hxx>

#include "base/messages/errors.h"
#include "mesher/mesh_sizes.h"
#include "mesher/surface_flips.h"

namespace clevis::mesher {
namespace {

using Eigen::Vector3d;

constexpr double kMillimetre = 1e-3;  // [m]

[[noreturn]] void refuse(const cad::Request& request,
                         const std::string& problem) {
  throw Error("M010", request.file.string(), problem,
              "Give the part a smaller mesh_size, or repair the faces there.");
}

/// Of the integral of 1/size along a curve, which gives its number of cells: at
/// gmsh's own 1e-9 curves take most of the time.
constexpr double kOfSizes = 1e-4;

/// gmsh for as long as it lives, without anybody's options.
class Gmsh {
 public:
  Gmsh() {
    gmsh::initialize(0, nullptr, false);
    for (const auto& [name, value] :
         std::initializer_list<std::pair<const char*, double>>{
             {"General.Terminal", 1},
             {"General.NumThreads", 1},
             // After an exception out of its meshing gmsh makes no cells.
             {"General.AbortOnError", 1},
             {"Geometry.OCCAutoFix", 0},
             {"Mesh.LcIntegrationPrecision", kOfSizes},
             {"Mesh.MeshSizeFromCurvature", 0},
             {"Mesh.MeshSizeFromPoints", 0},
             {"Mesh.MeshSizeExtendFromBoundary", 0},
             {"Mesh.ElementOrder", 2},
             {"Mesh.HighOrderOptimize", 1},
             {"Mesh.MshFileVersion", 4.1},
             {"Mesh.Binary", 0}}) {
      gmsh::option::setNumber(name, value);
    }
  }
  ~Gmsh() { gmsh::finalize(); }
  Gmsh(const Gmsh&) = delete;
  Gmsh& operator=(const Gmsh&) = delete;
};

/// gmsh's tag of each face; they are told by area and centre.
std::vector<int> surface_tags(const TopoDS_Solid& solid, double size,
                              const cad::Request& request) {
  gmsh::vectorpair surfaces;
  gmsh::model::getEntities(surfaces, 2);
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(solid, TopAbs_FACE, faces);
  std::vector<GProp_GProps> wanted(static_cast<std::size_t>(faces.Extent()));
  for (std::size_t f = 0; f < wanted.size(); ++f) {
    // As gmsh integrates them: on splines that is not exact.
    BRepGProp::SurfaceProperties(faces(static_cast<int>(f) + 1), wanted[f]);
  }
  std::vector<int> tags(wanted.size(), 0);
  for (const auto& [dim, tag] : surfaces) {
    double x{}, y{}, z{}, area{};
    gmsh::model::occ::getCenterOfMass(dim, tag, x, y, z);
    gmsh::model::occ::getMass(dim, tag, area);
    const gp_Pnt centre(x, y, z);
    for (std::size_t f = 0; f < tags.size(); ++f) {
      const double face = wanted[f].Mass();
      const bool same =
          centre.Distance(wanted[f].CentreOfMass()) < 1e-7 * size &&
          std::abs(area - face) < 1e-7 * face + 1e-14 * size * size;
      if (same && tags[f] == 0) {
        tags[f] = tag;
        break;
      }
    }
  }
  if (std::ranges::count(tags, 0) > 0) {
    refuse(request, "gmsh has other faces than OpenCASCADE");
  }
  return tags;
}

/// The bottom of a plate, pulled up to its top in one layer of cells.
void import_plate(const TopoDS_Solid& solid, const cad::Plate& plate) {
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(solid, TopAbs_FACE, faces);
  const TopoDS_Shape bottom = faces(plate.bottom);
  gmsh::vectorpair imported, pulled;
  gmsh::model::occ::importShapesNativePointer(&bottom, imported, true);
  const Vector3d way = plate.thickness / kMillimetre * plate.normal;
  gmsh::model::occ::extrude(imported, way.x(), way.y(), way.z(), pulled, {1},
                            {}, true);
  constexpr double kSubdivided = 2.0;  // all triangles, to quadrangles
  // It would move nodes of the middle away from those below and above them.
  gmsh::option::setNumber("Mesh.HighOrderOptimize", 0);
  gmsh::option::setNumber("Mesh.RecombineAll", 1);
  gmsh::option::setNumber("Mesh.RecombinationAlgorithm", kSubdivided);
}

std::vector<int> cell_types() {
  std::vector<int> types;
  gmsh::model::mesh::getElementTypes(types, 3);
  return types;
}

/// @throws Error M010 if there are none, or of a plate others than hexahedra.
void require_cells(const cad::Request& request) {
  constexpr int kHexahedra27 = 12;  // gmsh's number of the type
  const std::vector<int> types = cell_types();
  if (types.empty()) refuse(request, "gmsh makes no cells of it");
  if (request.plate && types != std::vector{kHexahedra27}) {
    refuse(request, "its plane is not all quadrangles");
  }
}

void add_groups(const cad::Request& request, const std::vector<int>& tags) {
  for (const auto& [name, faces] : request.groups) {
    std::vector<int> entities;
    for (const int face : faces) {
      entities.push_back(tags[static_cast<std::size_t>(face) - 1]);
    }
    const int group = gmsh::model::addPhysicalGroup(2, entities);
    gmsh::model::setPhysicalName(2, group, name);
  }
  gmsh::vectorpair volumes;
  gmsh::model::getEntities(volumes, 3);
  const int body = gmsh::model::addPhysicalGroup(3, {volumes.at(0).second});
  gmsh::model::setPhysicalName(3, body, "body");
}

/// Largest size on each curve: the smaller one of its two faces'.
std::vector<double> sizes_on_curves(const std::vector<int>& tags,
                                    const MeshSizes& sizes) {
  std::vector<double> result;
  for (std::size_t f = 0; f < tags.size(); ++f) {
    gmsh::vectorpair curves;
    gmsh::model::getBoundary({{2, tags[f]}}, curves, false, false);
    for (const auto& [dim, tag] : curves) {
      const auto at = static_cast<std::size_t>(tag);
      if (result.size() <= at) result.resize(at + 1, sizes.largest());
      result[at] = std::min(result[at], sizes.on_face(static_cast<int>(f) + 1));
    }
  }
  return result;
}

void set_sizes(const std::vector<int>& tags, const MeshSizes& sizes) {
  std::vector<double> on_surface;
  for (std::size_t f = 0; f < tags.size(); ++f) {
    const auto at = static_cast<std::size_t>(tags[f]);
    if (on_surface.size() <= at) on_surface.resize(at + 1, sizes.largest());
    on_surface[at] = sizes.on_face(static_cast<int>(f) + 1);
  }
  gmsh::model::mesh::setSizeCallback(
      [&sizes, on_surface, on_curve = sizes_on_curves(tags, sizes)](
          int dim, int tag, double x, double y, double z) {
        const double here = sizes.at(gp_Pnt(x, y, z));
        const auto at = static_cast<std::size_t>(tag);
        if (dim == 1 && at < on_curve.size()) {
          return std::min(here, on_curve[at]);
        }
        if (dim == 2 && at < on_surface.size()) {
          return std::min(here, on_surface[at]);
        }
        return here;
      });
}

/// One step of gmsh's. Curved cells that it cannot better are no reason to
/// stop: those that fold are found when the mesh is read.
/// @throws std::runtime_error of any other error.
template <class Step>
void take_step(Step&& step) {
  constexpr const char* kError = "Error";
  constexpr const char* kSummary = "-----";  // of all, line by line
  constexpr const char* kNotBettered = "critical value";
  std::vector<std::string> said;
  gmsh::logger::start();
  step();
  gmsh::logger::get(said);
  gmsh::logger::stop();
  for (const std::string& line : said) {
    if (line.find(kSummary) != std::string::npos) break;
    if (line.starts_with(kError) &&
        line.find(kNotBettered) == std::string::npos) {
      throw std::runtime_error(line);
    }
  }
}

void generate() {
  take_step([] {
    gmsh::model::mesh::generate(3);
  });
}

/// Tetrahedra of degree 2.
void generate_curved() {
  gmsh::option::setNumber("Mesh.ElementOrder", 1);
  generate();
  take_step([] {
    flip_surface_edges();
    gmsh::model::mesh::setOrder(2);
    gmsh::model::mesh::optimize("HighOrder");
  });
}

/// How far middle nodes of edges on the surface stand off the edge's middle,
/// along it, over its length [1].
double farthest_shift() {
  constexpr int kTriangle6 = 9;  // gmsh's number of the type
  std::vector<std::size_t> tags, nodes;
  std::vector<double> points, unused;
  gmsh::model::mesh::getNodes(tags, points, unused);
  std::vector<Vector3d> at(tags.empty() ? 0
                                        : *std::ranges::max_element(tags) + 1);
  for (std::size_t i = 0; i < tags.size(); ++i) {
    at[tags[i]] = {points[3 * i], points[3 * i + 1], points[3 * i + 2]};
  }
  double farthest = 0.0;
  tags.clear();  // gmsh would keep what stands there
  gmsh::model::mesh::getElementsByType(kTriangle6, tags, nodes);
  for (std::size_t first = 0; first < nodes.size(); first += 6) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector3d& a = at[nodes[first + k]];
      const Vector3d along = at[nodes[first + (k + 1) % 3]] - a;
      const Vector3d arm = at[nodes[first + 3 + k]] - a;
      const double part = along.dot(arm) / along.squaredNorm();
      farthest = std::max(farthest, std::abs(part - 0.5));
    }
  }
  return farthest;
}

/// Where a cell has no volume beside an edge on a smooth surface gmsh moves
/// middle nodes until the surface kinks, which looks like a notch: at an edge
/// of the model between two that are tangent, say. Cells a little smaller or
/// larger rarely do.
void generate_without_kinks() {
  constexpr double kShifted = 0.05;
  constexpr double kFactors[] = {1.0, 0.97, 1.03, 0.94};
  const auto attempt = [](double factor) -> std::optional<double> {
    gmsh::option::setNumber("Mesh.MeshSizeFactor", factor);
    gmsh::model::mesh::clear();
    try {
      generate_curved();
    } catch (...) {
      if (factor == 1.0) throw;
      return std::nullopt;
    }
    if (cell_types().empty()) return std::nullopt;
    return farthest_shift();
  };
  double best = 0.0, least = 0.0, last = 0.0;
  for (const double factor : kFactors) {
    const auto shift = attempt(factor);
    last = shift ? factor : 0.0;  // of what fails nothing is left
    if (!shift) continue;
    if (best == 0.0 || *shift < least) {
      best = factor;
      least = *shift;
    }
    if (*shift <= kShifted) return;
  }
  if (best > 0.0 && best != last) attempt(best);
}

}  // namespace

void mesh_solid(const TopoDS_Solid& solid, const cad::Solid& described,
                const cad::Request& request) {
  const Gmsh gmsh;
  const MeshSizes sizes(solid, request);
  try {
    gmsh::model::add("part");
    if (request.plate) {
      import_plate(solid, *request.plate);
    } else {
      gmsh::vectorpair imported;
      gmsh::model::occ::importShapesNativePointer(&solid, imported, true);
    }
    gmsh::model::occ::synchronize();
    const double size = (described.high - described.low).norm() / kMillimetre;
    const std::vector<int> tags = surface_tags(solid, size, request);
    add_groups(request, tags);
    set_sizes(tags, sizes);
    request.plate ? generate() : generate_without_kinks();
    require_cells(request);
    gmsh::model::mesh::removeSizeCallback();
    gmsh::write(request.mesh.string());
  } catch (const Error&) {
    throw;
  } catch (...) {  // gmsh throws numbers and texts
    std::string said;
    gmsh::logger::getLastError(said);
    refuse(request, "gmsh says: " + said);
  }
}

}  // namespace clevis::mesher

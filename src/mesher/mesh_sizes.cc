#include "mesher/mesh_sizes.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <set>
#include <vector>

#include <BRepAdaptor_Surface.hxx>
#include <BRepBndLib.hxx>
#include <BRepLProp_SLProps.hxx>
#include <BRepTools.hxx>
#include <BRepTopAdaptor_FClass2d.hxx>
#include <Bnd_Box.hxx>
#include <IntCurvesFace_ShapeIntersector.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <gp_Lin.hxx>

#include "cad/face_groups.h"
#include "mesher/bent_face.h"
#include "mesher/fitted_surface.h"

namespace clevis::mesher {
namespace {

constexpr double kMillimetre = 1e-3;                   // [m]
constexpr double kTurn = std::numbers::pi / 4;         // of a cell on a curve
constexpr double kTurnOfSeat = std::numbers::pi / 10;  // which loads press on
constexpr double kGrowth = 0.5;                        // per distance
constexpr double kPerSize = 6.0;                       // cells along the part
constexpr double kThinnest = 1.0 / 200.0;              // of the part's size
constexpr int kSamples = 7;                            // per parameter
constexpr double kFar = 1e100;

double diagonal(const TopoDS_Shape& shape) {
  Bnd_Box box;
  BRepBndLib::Add(shape, box);
  return std::sqrt(box.SquareExtent());
}

/// Size that a cell may have where the surface bends as it does there [mm].
double curved_size(BRepLProp_SLProps& surface, double turn) {
  if (!surface.IsCurvatureDefined()) return kFar;
  const double bend = std::max(std::abs(surface.MaxCurvature()),
                               std::abs(surface.MinCurvature()));
  return bend > 1e-9 ? turn / bend : kFar;
}

/// Depth of the material under a point of the surface [mm].
double wall(IntCurvesFace_ShapeIntersector& solid, const gp_Pnt& from,
            const gp_Dir& inwards, double reach) {
  const double start = 1e-5 * reach;
  solid.PerformNearest(gp_Lin(from, inwards), start, reach);
  return solid.IsDone() && solid.NbPnt() > 0 ? solid.WParameter(1) : kFar;
}

/// A place on a face.
struct Sample {
  gp_Pnt at;        ///< [mm]
  double curved{};  ///< curved_size() [mm]
  double thick{};   ///< wall() [mm]
};

/// Of most of a face, where it is so thin beside the way from sample to sample
/// that these would be islands of small cells [mm].
/// @param apart  of samples [mm].
std::optional<double> thin_wall(std::vector<Sample> samples, double apart) {
  constexpr double kThin = 0.15;
  if (samples.empty()) return std::nullopt;
  const auto middle =
      samples.begin() + static_cast<std::ptrdiff_t>(samples.size() / 2);
  std::ranges::nth_element(samples, middle, {}, &Sample::thick);
  if (!(middle->thick < kThin * apart)) return std::nullopt;
  return middle->thick;
}

/// Size on a wall that is thin beside the face: cells may be longer than it is
/// thick, but not bulge out of their chords by more than a quarter of it [mm].
double thin_size(double thick, double curved, double turn) {
  constexpr double kLong = 3.0;
  const double radius = curved / turn;
  return std::min(kLong * thick, std::sqrt(2.0 * radius * thick));
}

/// Numbers of the faces that joints and selectors name: loads press on them,
/// and the peak most often stands there.
std::set<int> seats(const cad::Request& request) {
  std::set<int> faces;
  for (const auto& [name, of_group] : request.groups) {
    if (!name.starts_with(cad::kRound)) {
      faces.insert(of_group.begin(), of_group.end());
    }
  }
  return faces;
}

/// Place on a plate's bottom below a point, which cells stand upon [mm].
Eigen::Vector3d on_bottom(const TopoDS_Solid& solid, const cad::Plate& plate,
                          const Eigen::Vector3d& point) {
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(solid, TopAbs_FACE, faces);
  const gp_Pnt p =
      BRepAdaptor_Surface(TopoDS::Face(faces(plate.bottom))).Plane().Location();
  const Eigen::Vector3d above = point - Eigen::Vector3d(p.X(), p.Y(), p.Z());
  return point - above.dot(plate.normal) * plate.normal;
}

}  // namespace

MeshSizes::MeshSizes(const TopoDS_Solid& solid, const cad::Request& request) {
  largest_ = request.mesh_size ? *request.mesh_size / kMillimetre
                               : diagonal(solid) / kPerSize;
  largest_ /= request.finer.everywhere;
  add_faces(solid, request.finer.everywhere, request);
  thin_out();
  refine(solid, request);
}

void MeshSizes::add_faces(const TopoDS_Solid& solid, double fineness,
                          const cad::Request& request) {
  const std::set<int> seats = clevis::mesher::seats(request);
  const double reach = diagonal(solid);
  IntCurvesFace_ShapeIntersector intersector;
  intersector.Load(solid, 1e-7 * reach);
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(solid, TopAbs_FACE, faces);
  for (int f = 1; f <= faces.Extent(); ++f) {
    // A plate's cells are as high as it is thick, whatever their size.
    if (request.plate &&
        (f == request.plate->bottom || f == request.plate->top)) {
      on_face_.push_back(largest_);
      continue;
    }
    const TopoDS_Face& face = TopoDS::Face(faces(f));
    const BRepAdaptor_Surface surface(face);
    BRepTopAdaptor_FClass2d outline(face, 1e-7);
    const double turn = seats.contains(f) ? kTurnOfSeat : kTurn;
    double u0{}, u1{}, v0{}, v1{}, finest = largest_;
    BRepTools::UVBounds(face, u0, u1, v0, v1);
    std::vector<Sample> samples;
    for (int i = 0; i < kSamples * kSamples; ++i) {
      const double u = u0 + (u1 - u0) * (i % kSamples) / (kSamples - 1);
      const double v = v0 + (v1 - v0) * (i / kSamples) / (kSamples - 1);
      if (outline.Perform(gp_Pnt2d(u, v)) == TopAbs_OUT) continue;
      BRepLProp_SLProps here(surface, u, v, 2, 1e-9);
      if (!here.IsNormalDefined()) continue;
      const gp_Dir normal = face.Orientation() == TopAbs_REVERSED
                                ? here.Normal()
                                : here.Normal().Reversed();
      const double thick = std::max(
          wall(intersector, here.Value(), normal, reach), kThinnest * reach);
      samples.push_back({here.Value(), curved_size(here, turn), thick});
      finest = std::min(finest, samples.back().curved / fineness);
    }
    constexpr double kThinner = 0.5;  // than most
    const auto thin = thin_wall(samples, diagonal(face) / (kSamples - 1));
    for (const Sample& sample : samples) {
      const double size = std::min(sample.curved, sample.thick) / fineness;
      if (thin && sample.thick > kThinner * *thin) {
        finest =
            std::min(finest, thin_size(*thin, sample.curved, turn) / fineness);
      } else if (size < largest_) {
        sources_.push_back({sample.at, size, 0.0});
      }
    }
    if (!is_elementary(face)) {
      finest = add_bends(face, turn / fineness);
    }
    on_face_.push_back(finest);
  }
}

/// A spline may bend in one place alone: cells are small there, not all over
/// the face.
/// @return the largest size on it [mm].
double MeshSizes::add_bends(const TopoDS_Face& face, double turn) {
  // Cells follow a spline by parabolas, which kink; over as much of a turn as
  // on a cylinder, which is exact, that looks like a notch.
  constexpr double kLocal = 0.8, kOfTurn = 0.5;
  const BendSizes bends = bend_sizes(face, turn, largest_);
  for (const auto& [at, size] : bends.places) {
    if (size < kLocal * bends.coarsest) {
      sources_.push_back({at, kOfTurn * size, 0.0});
    }
  }
  return bends.coarsest;
}

/// Keeps what says more than its neighbours do.
void MeshSizes::thin_out() {
  constexpr double kSame = 1.1;
  std::ranges::sort(sources_, {}, &SizeSource::size);
  std::vector<SizeSource> all;
  all.swap(sources_);
  for (const SizeSource& source : all) {
    if (at(source.at) > kSame * source.size) sources_.push_back(source);
  }
}

void MeshSizes::refine(const TopoDS_Solid& solid, const cad::Request& request) {
  for (const auto& [place, times] : request.finer.at) {
    Eigen::Vector3d p = place / kMillimetre;
    if (request.plate) p = on_bottom(solid, *request.plate, p);
    const gp_Pnt point(p.x(), p.y(), p.z());
    const double size = at(point);
    sources_.push_back({point, size / times, 0.5 * size});
    std::ranges::sort(sources_, {}, &SizeSource::size);
  }
}

double MeshSizes::at(const gp_Pnt& point) const {
  double size = largest_;
  for (const SizeSource& source : sources_) {
    if (source.size >= size) break;  // they rise
    const double beyond = point.Distance(source.at) - source.reach;
    size = std::min(size, source.size + kGrowth * std::max(0.0, beyond));
  }
  return size;
}

}  // namespace clevis::mesher

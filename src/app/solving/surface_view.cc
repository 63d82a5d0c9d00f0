#include "app/solving/surface_view.h"

#include <algorithm>
#include <set>
#include <span>

#include "elasticity/fe_space/discretization.h"
#include "elasticity/problem/displacement_basis.h"
#include "report/summary/line_refinement.h"
#include "stress/field/surface_mesh.h"

namespace clevis::app {
namespace {

using assessment::PartAssessment;
using assessment::PartFields;
using Eigen::Index;

constexpr int kMostColumns = 64;

/// Lattice of a cell: finer for flat cells, of which there are fewer, and of
/// simplices so fine that a face has a point inside.
int subdivisions_of(const PartFields& fields, std::size_t cells) {
  constexpr std::size_t kMany = 3000;
  const bool is_simplex = fields.shape == mesh::CellShape::kSimplex;
  if (is_simplex || fields.dim == 2) return 3;
  return cells > kMany ? 1 : 2;
}

/// How many instants a part's fields are looked at: their cost is cells times
/// instants.
std::size_t most_frames(std::size_t cells) {
  constexpr std::size_t kMost = 240, kFewest = 60, kCells = 200000;
  return std::clamp(kCells / std::max<std::size_t>(cells, 1), kFewest, kMost);
}

/// First row of the history that tells the governing loads.
std::size_t governing_rows(const PartFields& fields) {
  const auto& history = fields.history;
  const auto peak = static_cast<std::size_t>(fields.peak_instant);
  for (std::size_t row = 0; row + fields.times.size() <= history.size();
       ++row) {
    if (history[row + peak].peak == fields.worst.largest() &&
        history[row + peak].time == fields.times[peak]) {
      return row;
    }
  }
  return 0;
}

/// Between the frames, those at which the peak leaves the straight line by more
/// than 1 % of its largest: blows, which uniform frames miss.
void refine_blows(const PartFields& fields, std::size_t count, std::size_t most,
                  std::set<std::size_t>& frames) {
  constexpr double kTolerance = 0.01;
  const auto row = static_cast<std::ptrdiff_t>(governing_rows(fields));
  std::vector<double> peaks(count);
  std::transform(
      fields.history.begin() + row,
      fields.history.begin() + row + static_cast<std::ptrdiff_t>(count),
      peaks.begin(), [](const auto& instant) {
        return instant.peak;
      });
  report::refine_lines(frames, std::span(fields.times).first(count), peaks,
                       kTolerance * std::ranges::max(peaks), most);
}

/// Uniform ones of the first `count` instants up to `most`, those among them at
/// which the part is worst, and half as many more where blows ask for them.
std::vector<int> frames_of(const PartFields& fields,
                           const assessment::PartResult& result,
                           std::size_t count, std::size_t most) {
  std::set<std::size_t> frames{static_cast<std::size_t>(fields.peak_instant)};
  const std::size_t last = count - 1;
  const std::size_t steps = std::min(last, most - 1);
  for (std::size_t k = 0; k <= steps; ++k) {
    frames.insert(steps == 0 ? 0 : last * k / steps);
  }
  for (const double t :
       {result.deflection_instant, result.strain_energy_instant,
        judged_peak(result).instant, result.buckling.instant}) {
    const auto at = std::ranges::find(fields.times, t) - fields.times.begin();
    if (at < static_cast<std::ptrdiff_t>(count)) {
      frames.insert(static_cast<std::size_t>(at));
    }
  }
  refine_blows(fields, count, frames.size() + most / 2, frames);
  return {frames.begin(), frames.end()};
}

report::ViewInstant view_instant(const assessment::InstantRow& row) {
  return {row.label, row.time, row.peak, row.strain_energy};
}

report::PackedField packed(Eigen::MatrixXd values, Index first) {
  const double largest = values.lpNorm<Eigen::Infinity>();
  return report::pack(std::move(values), first,
                      report::kViewTolerance * largest, kMostColumns);
}

/// Surface of a lattice of all cells, with its fields.
struct Skin {
  int subdivisions{};
  stress::InstantField field;  ///< at the worst instant
  stress::SurfaceMesh surface;
  Eigen::MatrixX3d positions;   ///< of the places [m]
  std::vector<int> places;      ///< of the points
  stress::PointHistory values;  ///< stress of points, displacement of places
  std::vector<int> cell_triangles;  ///< how many of each cell
  /// Point that stands in for the peak; absent: the peak is inside.
  std::optional<Index> peak;
};

/// The surface's point of the cell of the peak that may stand in for it, if the
/// peak stands on the surface.
std::optional<Index> point_of_peak(const PartFields& fields, const Skin& skin) {
  if (skin.subdivisions == 1) return std::nullopt;
  const auto& worst = fields.worst;
  const auto stand_in =
      fields.dim == 2 ? stress::stand_in<2> : stress::stand_in<3>;
  const int point = stand_in(fields.shape, worst.subdivisions,
                             worst.peak_at.point, skin.subdivisions);
  const auto& points = skin.surface.points;
  const auto found =
      std::ranges::find_if(points, [&](const stress::FieldPoint& at) {
        return at.cell == worst.peak_at.cell && at.point == point;
      });
  if (found == points.end()) return std::nullopt;
  return found - points.begin();
}

/// Moves a point of the coarse lattice to the peak, which is then told as it
/// was found.
void show_peak(const PartFields& fields, const std::vector<int>& frames,
               Index point, Skin& skin) {
  const auto& worst = fields.worst;
  const auto fine = fields.at(fields.peak_instant, worst.subdivisions);
  const Index place = skin.places[static_cast<std::size_t>(point)];
  skin.positions.row(place) =
      fine.points[static_cast<std::size_t>(worst.peak_at.cell)].row(
          worst.peak_at.point);
  const auto peak = fields.over({worst.peak_at}, worst.subdivisions, frames);
  skin.values.von_mises.row(point) = peak.von_mises;
  const Index places = skin.positions.rows();
  for (int d = 0; d < fields.dim; ++d) {
    skin.values.displacement.row(place + d * places) = peak.displacement.row(d);
  }
}

/// How many triangles of each cell there are.
std::vector<int> cell_triangles(const stress::SurfaceMesh& surface) {
  std::vector<int> counts;
  int last = -1;
  for (const auto& triangle : surface.triangles) {
    const int cell = surface.points[static_cast<std::size_t>(triangle[0])].cell;
    if (cell != last) counts.push_back(0);
    ++counts.back();
    last = cell;
  }
  return counts;
}

/// Positions of a surface's points [m], points × 3.
Eigen::MatrixX3d positions_of(const Skin& skin) {
  const auto& points = skin.surface.points;
  Eigen::MatrixX3d positions(static_cast<Index>(points.size()), 3);
  for (std::size_t p = 0; p < points.size(); ++p) {
    positions.row(static_cast<Index>(p)) =
        skin.field.points[static_cast<std::size_t>(points[p].cell)].row(
            points[p].point);
  }
  return positions;
}

/// Makes points of cells one where the stress does not jump by more than it is
/// told to.
/// @param positions  of all points [m].
void share_stresses(const Eigen::MatrixX3d& positions, Skin& skin) {
  auto& von_mises = skin.values.von_mises;
  const auto shared = stress::share_points(
      positions, von_mises,
      report::kViewTolerance * von_mises.lpNorm<Eigen::Infinity>());
  std::vector<stress::FieldPoint> kept;
  std::vector<int> places;
  for (const int point : shared.kept) {
    kept.push_back(skin.surface.points[static_cast<std::size_t>(point)]);
    places.push_back(skin.places[static_cast<std::size_t>(point)]);
  }
  von_mises = von_mises(shared.kept, Eigen::all).eval();
  skin.surface.points = std::move(kept);
  skin.places = std::move(places);
  const auto renumber = [&](auto& pieces) {
    for (auto& piece : pieces) {
      for (int& point : piece) {
        point = shared.number[static_cast<std::size_t>(point)];
      }
    }
  };
  renumber(skin.surface.triangles);
  renumber(skin.surface.outline);
  if (skin.peak) {
    skin.peak = shared.number[static_cast<std::size_t>(*skin.peak)];
  }
}

/// Makes one place of all points that stand there: the displacement does not
/// jump.
/// @param positions  of all points [m].
void share_places(int dim, const Eigen::MatrixX3d& positions, Skin& skin) {
  auto& displacement = skin.values.displacement;
  const Index points = positions.rows();
  const auto shared =
      stress::share_points(positions, Eigen::MatrixXd(points, 0), 0.0);
  std::vector<Index> rows;
  for (int d = 0; d < dim; ++d) {
    for (const int point : shared.kept) rows.push_back(point + d * points);
  }
  displacement = displacement(rows, Eigen::all).eval();
  skin.positions = positions(shared.kept, Eigen::all);
  skin.places = shared.number;
}

Skin skin_of(const PartFields& fields, const std::vector<int>& frames,
             int subdivisions) {
  Skin skin;
  skin.subdivisions = subdivisions;
  skin.field = fields.at(fields.peak_instant, subdivisions);
  skin.surface = fields.dim == 2
                     ? stress::surface_mesh<2>(fields.shape, skin.field)
                     : stress::surface_mesh<3>(fields.shape, skin.field);
  skin.values = fields.over(skin.surface.points, subdivisions, frames);
  skin.cell_triangles = cell_triangles(skin.surface);
  skin.peak = point_of_peak(fields, skin);
  const Eigen::MatrixX3d positions = positions_of(skin);
  share_places(fields.dim, positions, skin);
  share_stresses(positions, skin);
  return skin;
}

void fill_surface(const assessment::PartJob& job, const PartFields& fields,
                  const Skin& skin, report::PartView& view) {
  view.positions = skin.positions;
  view.places = skin.places;
  view.triangles = skin.surface.triangles;
  view.cell_triangles = skin.cell_triangles;
  view.outline = skin.surface.outline;
  if (fields.dim == 3) return;
  double low = job.mesh.vertices.front().z(), high = low;
  for (const auto& vertex : job.mesh.vertices) {
    low = std::min(low, vertex.z());
    high = std::max(high, vertex.z());
  }
  view.faces_z = {low, high};
}

/// Stress, displacement, and where and when the largest stress stands.
void fill_fields(const PartFields& fields, const std::vector<int>& frames,
                 Skin& skin, report::PartView& view) {
  const auto worst = std::ranges::find(frames, fields.peak_instant);
  view.peak_frame = static_cast<int>(worst - frames.begin());
  Index at = 0;
  skin.values.von_mises.col(view.peak_frame).maxCoeff(&at);
  if (skin.peak) {
    at = *skin.peak;
    show_peak(fields, frames, at, skin);
  }
  view.peak_point = static_cast<int>(at);
  view.stress = packed(std::move(skin.values.von_mises), view.peak_frame);
  view.displacement =
      packed(std::move(skin.values.displacement), view.peak_frame);
}

}  // namespace

report::PartView surface_view(const assessment::PartJob& job,
                              const PartAssessment& assessment,
                              const std::optional<MovingPart>& moving,
                              const std::string& body) {
  const PartFields& fields = assessment.fields;
  const auto cells = static_cast<std::size_t>(fields.worst.worst.cols());
  const bool is_motion = moving &&
                         begins_with_motion(fields, *moving->motion) &&
                         static_cast<std::size_t>(fields.peak_instant) <
                             moving->motion->instants.size();
  const auto frames = frames_of(
      fields, assessment.result,
      is_motion ? moving->motion->instants.size() : fields.times.size(),
      most_frames(cells));
  Skin skin = skin_of(fields, frames, subdivisions_of(fields, cells));
  report::PartView view;
  view.definition = job.part;
  view.body = body;
  view.is_motion = is_motion;
  fill_fields(fields, frames, skin, view);
  fill_surface(job, fields, skin, view);
  const std::size_t row = governing_rows(fields);
  for (const int frame : frames) {
    view.frames.push_back(
        view_instant(fields.history[row + static_cast<std::size_t>(frame)]));
  }
  for (const auto& instant : fields.history) {
    view.history.push_back(view_instant(instant));
  }
  return view;
}

report::PartView shape_view(const assessment::PartJob& job,
                            const std::string& body) {
  constexpr int kSubdivisions = 2;  // rounds are seen as such
  elasticity::DisplacementBasis<3> still;
  still.discretization = elasticity::discretize<3>(job.mesh, 1);
  still.columns = Eigen::MatrixXd::Zero(still.discretization.dofs(), 1);
  still.coefficients = Eigen::MatrixXd::Zero(1, 1);
  Skin skin;
  skin.field =
      stress::instant_field<3>(still, job.part.material, kSubdivisions, 0);
  skin.surface = stress::surface_mesh<3>(job.mesh.shape, skin.field);
  const Eigen::MatrixX3d positions = positions_of(skin);
  const auto shared = stress::share_points(
      positions, Eigen::MatrixXd(positions.rows(), 0), 0.0);
  report::PartView view;
  view.definition = job.part;
  view.body = body;
  view.positions = positions(shared.kept, Eigen::all);
  view.cell_triangles = cell_triangles(skin.surface);
  view.triangles = skin.surface.triangles;
  for (auto& triangle : view.triangles) {
    for (int& point : triangle) {
      point = shared.number[static_cast<std::size_t>(point)];
    }
  }
  for (int place = 0; place < static_cast<int>(shared.kept.size()); ++place) {
    view.places.push_back(place);
  }
  return view;
}

}  // namespace clevis::app

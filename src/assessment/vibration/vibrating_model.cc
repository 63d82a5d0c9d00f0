#include "assessment/vibration/vibrating_model.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

#include "assessment/job/part_zones.h"
#include "assessment/pace/load_pace.h"
#include "assessment/stretches/excited_modes.h"
#include "loads/history/motion_instants.h"
#include "stress/field/stress_history.h"
#include "stress/many_instants/field_reduction.h"
#include "stress/many_instants/point_stress.h"

namespace clevis::assessment {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Times, of them within a period of the lowest shape.
constexpr int kDriven = 2400, kSwing = 4000;
constexpr double kDrivenPerPeriod = 400.0, kSwingPerPeriod = 20.0;

/// Of the spread of a sharp change: times the angular frequency of the highest
/// shape. What is sharper runs apart on the mesh, and a wave that is thrown
/// back a few times tops its true height (6: by 10 %, 9: 2.5 %, 12: 0.2 %).
constexpr double kFront = 12.0;

/// The same of what shapes cannot follow without it, on the safe side of
/// √(π/2): that bell curve is as high as the kernel of all frequencies below
/// the highest.
constexpr double kUnspread = 1.5 / kFront;
/// The same of a spread that the mesh carries: times the time of a wave over a
/// node's spacing.
constexpr double kNodes = 2.5;

template <int dim>
constexpr int kSubdivisions = dim == 2 ? 4 : 2;

/// Of the static columns and of the shapes, × times.
MatrixXd coefficients_of(const dynamics::LoadAnswer& moving) {
  MatrixXd both(moving.path.rows() + moving.added.rows(), moving.time.size());
  both << moving.path, moving.added;
  return both;
}

/// What of an answer lies in windows.
dynamics::LoadAnswer within(const std::vector<VibrationWindow>& windows,
                            const dynamics::LoadAnswer& whole) {
  std::vector<Index> in;
  for (Index i = 0; i < whole.time.size(); ++i) {
    if (lies_in(windows, whole.time[i])) in.push_back(i);
  }
  return {whole.time(in), whole.path(Eigen::all, in),
          whole.added(Eigen::all, in), whole.energy(in)};
}

/// Whether two corners of a cell are the ends of an edge.
bool is_edge(mesh::CellShape shape, unsigned a, unsigned b) {
  return shape == mesh::CellShape::kSimplex || std::has_single_bit(a ^ b);
}

/// Mean of the cells' longest edges over the degree [m].
template <int dim>
double node_spacing(const mesh::PartMesh<dim>& mesh, int degree) {
  double sum = 0.0;
  for (const auto& cell : mesh.cells) {
    double longest = 0.0;
    for (unsigned a = 0; a < cell.size(); ++a) {
      for (unsigned b = 0; b < a; ++b) {
        if (!is_edge(mesh.shape, a, b)) continue;
        longest = std::max(
            longest, (mesh.vertices[cell[a]] - mesh.vertices[cell[b]]).norm());
      }
    }
    sum += longest;
  }
  return sum / static_cast<double>(mesh.cells.size()) / degree;
}

/// What is left of a peak whose fronts are spread, from those with two and four
/// times the spread. A plateau does not change. What waves make sharper and
/// sharper, as behind a spring, goes on to rise: as a geometric series, or, if
/// that does not end, as the logarithm of the spread over four octaves more.
/// @return over the peak [1].
double error_of_spread(double peak, double twice, double fourfold) {
  constexpr double kEnds = 0.7, kOctaves = 4.0, kRises = 0.25;
  const double last = std::abs(peak - twice),
               before = std::abs(twice - fourfold);
  double more = 1.0;
  if (before > kRises * last) {
    const double ratio = last / before;
    more = ratio < kEnds ? std::max(1.0, ratio / (1.0 - ratio)) : kOctaves;
  }
  return more * last / peak;
}

/// Zones whose stress grows by a power of the distance: those where shear ends
/// are a matter of the peak at rest.
template <int dim>
std::vector<stress::SingularZone> steep_zones(const PartJob& job,
                                              const mesh::PartMesh<dim>& mesh,
                                              const LoadSet& set) {
  auto zones = part_zones<dim>(job, mesh, set);
  std::erase_if(zones, [](const stress::SingularZone& zone) {
    return zone.exponent > stress::kSmoothExponent;
  });
  return zones;
}

template <int dim>
dynamics::ModeDamping damping_of(
    const typename elasticity::LoadVibration<dim>::Shapes& shapes,
    double of_part) {
  return {of_part * shapes.own_share.array().max(0.0), shapes.dampers};
}

loads::LoadHistory held_at(double time, loads::LoadHistory history) {
  history.hold_time = time;
  return history;
}

}  // namespace

template <int dim>
RestingModel<dim>::RestingModel(const PartJob& job,
                                const mesh::PartMesh<dim>& mesh,
                                const LoadSet& set, int degree)
    : job_(job),
      set_(set),
      degree_(degree),
      part_(elasticity::part_at_rest<dim>({.mesh = mesh,
                                           .material = job.part.material,
                                           .history = set.history,
                                           .fixed = set.fixed,
                                           .name = job.part.name,
                                           .foundations = set.foundations},
                                          degree)),
      mesh_front_(kNodes * node_spacing(mesh, degree) *
                  std::sqrt(job.part.material.density /
                            job.part.material.youngs_modulus)),
      zones_(steep_zones<dim>(job, mesh, set)),
      path_(make_path()),
      peak_(make_peak()) {}

template <int dim>
dynamics::LoadPath RestingModel<dim>::make_path() const {
  const auto& instants = set_.history.instants;
  VectorXd time(static_cast<Index>(instants.size()));
  for (Index i = 0; i < time.size(); ++i) {
    time[i] = instants[static_cast<std::size_t>(i)].time;
  }
  return {time, part_.statics.coefficients,
          loads::kEventSides * loads::motion_duration(set_.history),
          between_instants(set_), set_.history.bends};
}

template <int dim>
stress::PartialPeak RestingModel<dim>::make_peak() const {
  const auto& basis = part_.statics;
  const auto history = stress::stress_history<dim>(basis, job_.part.material,
                                                   kSubdivisions<dim>);
  const auto zone_of = stress::zone_of_points<dim>(basis.discretization,
                                                   kSubdivisions<dim>, zones_);
  return stress::peak_outside(history, zone_of,
                              std::vector<bool>(zones_.size(), true), dim);
}

template <int dim>
VibratingModel<dim>::VibratingModel(const RestingModel<dim>& rest,
                                    double hold_time,
                                    const VibrationTimes& times)
    : rest_(rest),
      times_(times),
      part_(rest.part(), held_at(hold_time, rest.loads().history),
            rest.job().part.name,
            instants_within(times.driven, rest.loads().history.instants),
            instants_within(times.swing, rest.loads().history.instants)) {}

template <int dim>
VectorXd VibratingModel<dim>::even_times(double lowest) const {
  return merged(
      times_within(times_.driven, 1.0 / (kDrivenPerPeriod * lowest), kDriven),
      times_within(times_.swing, 1.0 / (kSwingPerPeriod * lowest), kSwing));
}

template <int dim>
std::vector<Index> VibratingModel<dim>::times_to_look_at(
    const VectorXd& time) const {
  constexpr Index kSixth = 6;
  const double peak =
      rest_.loads()
          .history.instants[static_cast<std::size_t>(rest_.peak().instant)]
          .time;
  std::vector<Index> all;
  for (Index i = 0; i < time.size(); ++i) {
    if (i % kSixth == 0 || time[i] == peak) all.push_back(i);
  }
  return all;
}

template <int dim>
std::vector<stress::FieldPoint> VibratingModel<dim>::points_near_peak(
    const Basis& basis) const {
  constexpr double kNear = 0.75;
  const auto zone_of = stress::zone_of_points<dim>(
      basis.discretization, kSubdivisions<dim>, rest_.zones());
  const auto coarse = stress::stress_history<dim>(
      stress::reduced_field<dim>(basis, rest_.job().part.material),
      rest_.job().part.material, kSubdivisions<dim>);
  const Eigen::ArrayXXd outside =
      (zone_of.array() >= 0).select(-1.0, coarse.worst.array());
  const double least = kNear * outside.maxCoeff();
  std::vector<stress::FieldPoint> points;
  for (Index c = 0; c < outside.cols(); ++c) {
    for (Index q = 0; q < outside.rows(); ++q) {
      if (outside(q, c) < 0.0 || outside(q, c) < least) continue;
      points.push_back({static_cast<int>(c), static_cast<int>(q)});
    }
  }
  return points;
}

template <int dim>
elasticity::DisplacementBasis<dim> VibratingModel<dim>::basis_of(
    const typename elasticity::LoadVibration<dim>::Shapes& shapes,
    const dynamics::LoadAnswer& moving) const {
  const auto& still = rest_.part().statics;
  Basis basis;
  basis.discretization = still.discretization;
  basis.columns.resize(still.columns.rows(),
                       still.columns.cols() + shapes.columns.cols());
  basis.columns << still.columns, shapes.columns;
  basis.coefficients = coefficients_of(moving);
  return basis;
}

template <int dim>
VibratingAnswer<dim> VibratingModel<dim>::answer(int count,
                                                 const dynamics::LoadPath& path,
                                                 Fronts fronts) {
  if (count != count_) {
    shapes_ = part_.shapes(count);
    points_.clear();
    count_ = count;
  }
  const auto& shapes = shapes_;
  const VectorXd hertz = shapes.squares.cwiseSqrt() / (2.0 * std::numbers::pi);
  VibratingAnswer<dim> found;
  found.shapes = static_cast<int>(hertz.size());
  found.lowest = 1.0 / longest_of_part(hertz.cwiseInverse(), shapes.own_share);
  found.highest = hertz.maxCoeff();
  const double shape_front = kFront / shapes.squares.cwiseSqrt().maxCoeff();
  const double front = std::max(shape_front, rest_.mesh_front());
  found.mesh_spreads_more = rest_.mesh_front() >= shape_front;
  const auto damping = damping_of<dim>(shapes, rest_.job().part.damping);
  const auto answer_at = [&](const VectorXd& times, double spread) {
    auto moving = dynamics::answer_to(path, shapes.participation,
                                      shapes.squares, damping, times, spread);
    return times_.is_stretch ? within(times_.swing, moving) : moving;
  };
  const auto cut = [&](double spread) {
    return dynamics::cut_by_spread(path, shapes.participation, shapes.squares,
                                   spread);
  };
  const VectorXd even = even_times(found.lowest);
  auto moving = answer_at(even, front);
  found.basis = basis_of(shapes, moving);
  found.basis.coefficients =
      found.basis.coefficients(Eigen::all, times_to_look_at(moving.time))
          .eval();
  if (points_.empty()) points_ = points_near_peak(found.basis);
  const auto& points = points_;
  if (points.empty()) return found;  // the zones are all there is
  const auto& discretization = found.basis.discretization;
  const stress::PointStress<dim> near(discretization, rest_.job().part.material,
                                      kSubdivisions<dim>, points,
                                      found.basis.columns);
  // Loads with corners have peaks with corners: it goes closer twice.
  constexpr std::size_t kPeaks = 60, kHighest = 10;
  const auto beside_peaks = [&](const dynamics::LoadAnswer& answer,
                                std::size_t most) {
    return times_near_peaks(
        answer.time,
        near.von_mises(coefficients_of(answer)).colwise().maxCoeff(),
        times_.swing, most);
  };
  const VectorXd close = beside_peaks(moving, kPeaks);
  const VectorXd times = merged(
      merged(even, close), beside_peaks(answer_at(close, front), kHighest));
  moving = answer_at(times, front);
  found.basis.coefficients = coefficients_of(moving);
  const MatrixXd stresses = near.von_mises(found.basis.coefficients);
  Index point = 0, time = 0;
  found.peak.value = stresses.maxCoeff(&point, &time);
  found.peak.at = points[static_cast<std::size_t>(point)];
  found.peak.instant = static_cast<int>(time);
  const Index second = (stresses.cols() + 1) / 2;
  found.sampling_error =
      (1.0 - stresses(Eigen::all, Eigen::seqN(Index{0}, second, 2)).maxCoeff() /
                 found.peak.value) /
      3.0;
  if (fronts == Fronts::kJudged) {
    const auto peak_at = [&](double spread) {
      const MatrixXd coefficients = coefficients_of(answer_at(times, spread));
      return near.von_mises(coefficients).maxCoeff();
    };
    if (cut(front) > 0.0) {
      found.front_error =
          std::abs(peak_at(0.0) / found.peak.value - 1.0) +
          2.0 * cut(kUnspread * front) * rest_.peak().value / found.peak.value;
    }
    found.spread_error = error_of_spread(found.peak.value, peak_at(2.0 * front),
                                         peak_at(4.0 * front));
  }
  found.time = moving.time[time];
  found.at =
      stress::position<dim>(discretization, found.peak.at, kSubdivisions<dim>);
  found.group = stress::surface_group<dim>(discretization, found.peak.at,
                                           kSubdivisions<dim>);
  return found;
}

template class RestingModel<2>;
template class RestingModel<3>;
template class VibratingModel<2>;
template class VibratingModel<3>;

}  // namespace clevis::assessment

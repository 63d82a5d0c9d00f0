#include "assessment/nearby_peak.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "assessment/local_solve.h"
#include "base/errors.h"
#include "elasticity/tabulation.h"
#include "mesh/sub_mesh.h"
#include "stress/meeting_points.h"
#include "stress/surface_kink.h"

namespace clevis::assessment {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using stress::FieldPoint;

/// Finer solutions are looked at on a lattice twice as close as usual.
constexpr int kFineLattice = 8;
constexpr double kNothing = -std::numeric_limits<double>::infinity();

/// A point of the lattice where the peak may stand.
struct Place {
  double mean{}, high{}, low{};  ///< by the cells that meet there [Pa]
  int number{};                  ///< of MeetingPoints
  FieldPoint at;                 ///< in the cell that says most
  int instant{};
};

/// Places of one set, highest first.
struct PlacesOfSet {
  std::vector<Place> places;
  std::vector<std::vector<int>> cells;  ///< per number
};

/// Cells whose stress is not far below the peak, and those beside them.
template <int dim>
std::vector<int> stressed_cells(const mesh::PartMesh<dim>& mesh,
                                const stress::StressHistory& history,
                                double least) {
  std::vector<int> cells;
  for (Index c = 0; c < history.worst.cols(); ++c) {
    if (history.worst.col(c).maxCoeff() >= least) {
      cells.push_back(static_cast<int>(c));
    }
  }
  return mesh::with_neighbours(mesh, std::move(cells));
}

template <int dim>
PlacesOfSet find_places(const mesh::PartMesh<dim>& mesh,
                        const elasticity::Discretization<dim>& discretization,
                        const stress::StressHistory& history, double least) {
  PlacesOfSet result;
  const auto points = stress::meeting_points<dim>(
      discretization, stressed_cells<dim>(mesh, history, least),
      history.subdivisions);
  const auto n = static_cast<std::size_t>(points.count);
  std::vector<Place> all(n);
  std::vector<double> sum(n, 0.0);
  result.cells.resize(n);
  for (std::size_t k = 0; k < points.cells.size(); ++k) {
    for (Index q = 0; q < points.number.rows(); ++q) {
      const int number = points.number(q, static_cast<Index>(k));
      const auto i = static_cast<std::size_t>(number);
      const int cell = points.cells[k];
      const double value = history.worst(q, cell);
      Place& place = all[i];
      if (result.cells[i].empty()) place.low = value;
      result.cells[i].push_back(cell);
      sum[i] += value;
      place.low = std::min(place.low, value);
      if (value < place.high) continue;
      place.high = value;
      place.number = number;
      place.at = {cell, static_cast<int>(q)};
      place.instant = history.worst_instant(q, cell);
    }
  }
  for (std::size_t i = 0; i < n; ++i) {
    all[i].mean = sum[i] / static_cast<double>(result.cells[i].size());
    if (all[i].high >= least && all[i].low >= 0.0) {
      result.places.push_back(all[i]);
    }
  }
  std::ranges::stable_sort(result.places, std::greater{}, &Place::high);
  return result;
}

/// What finer solutions say near a place: its largest stress, that less the
/// error there, and the largest of stress and error over all its cells.
struct Closer {
  double value = kNothing, low = kNothing, high = kNothing;
  FieldPoint at;  ///< of the value: cell of the centre, point of kFineLattice
};

/// Solutions in the cells of a centre, lattice points × cells.
struct FinerFields {
  stress::JoinedStress low;   ///< one degree higher
  stress::JoinedStress wide;  ///< likewise, with a second layer around
  stress::JoinedStress high;  ///< two degrees higher
};

/// What degree, layer and cells differ by, each by its largest in the cell
/// where the stress is not far below its largest: what agrees at a point by
/// chance does not hide it.
/// @param rise  of each cell, from the instant that was solved for to its worst
///   one.
Closer judge(const FinerFields& fields, const Eigen::VectorXd& rise) {
  constexpr double kNear = 0.9;
  constexpr double kDegree = 0.6;
  constexpr double kLayer = 0.5;
  constexpr double kJump = 0.15;
  const MatrixXd value = fields.high.mean + fields.wide.mean - fields.low.mean;
  const double least = kNear * value.maxCoeff();
  Closer closer;
  for (Index c = 0; c < value.cols(); ++c) {
    const Eigen::ArrayXd counts =
        (value.col(c).array() >= least).cast<double>();
    const auto largest = [&](const auto& difference) {
      return (difference.array().abs() * counts).maxCoeff();
    };
    Index point = 0;
    const double peak = rise[c] * value.col(c).maxCoeff(&point);
    const double error =
        rise[c] *
        (kDegree * largest(fields.high.mean.col(c) - fields.low.mean.col(c)) +
         kLayer * largest(fields.wide.mean.col(c) - fields.low.mean.col(c)) +
         kJump * largest(fields.high.jump.col(c)));
    closer.high = std::max(closer.high, peak + error);
    if (peak <= closer.value) continue;
    closer.value = peak;
    closer.low = peak - error;
    closer.at = {static_cast<int>(c), static_cast<int>(point)};
  }
  return closer;
}

template <int dim>
class PeakSearch {
 public:
  PeakSearch(const PartJob& job, const std::vector<LoadSet>& sets,
             const mesh::PartMesh<dim>& mesh, const Level<dim>& level,
             const std::vector<stress::StressHistory>& histories)
      : job_(job),
        sets_(sets),
        mesh_(mesh),
        level_(level),
        histories_(histories) {}

  NearbyPeak search(double tolerance) {
    constexpr int kMostClusters = 8;
    find_all_places();
    int clusters = 0;
    while (clusters < kMostClusters) {
      const auto next = highest_open();
      if (!next || place(*next).high < kReach * best_) break;
      look_closer(*next);
      ++clusters;
    }
    return join(tolerance);
  }

 private:
  static constexpr double kReach = 0.97;
  struct Number {
    std::size_t set, place;
  };

  const Place& place(const Number& n) const {
    return found_[n.set].places[n.place];
  }

  void find_all_places() {
    constexpr double kShare = 0.6;
    double largest = 0.0;
    for (const auto& history : histories_) {
      largest = std::max(largest, history.worst.maxCoeff());
    }
    best_ = 0.0;
    for (std::size_t s = 0; s < sets_.size(); ++s) {
      found_.push_back(find_places<dim>(mesh_, level_.bases[s]->discretization,
                                        histories_[s], kShare * largest));
      open_.emplace_back(found_[s].places.size(), true);
      for (const Place& p : found_[s].places) best_ = std::max(best_, p.mean);
    }
  }

  std::optional<Number> highest_open() const {
    std::optional<Number> highest;
    for (std::size_t s = 0; s < found_.size(); ++s) {
      const auto at = std::ranges::find(open_[s], true);
      if (at == open_[s].end()) continue;
      const Number number{s, static_cast<std::size_t>(at - open_[s].begin())};
      if (!highest || place(number).high > place(*highest).high) {
        highest = number;
      }
    }
    return highest;
  }

  /// Cells that meet at the place, and beside them those of other places that
  /// are as high, as many as are cheap to solve for together.
  std::vector<int> centre_of(const Number& seed) const {
    constexpr std::size_t kMost = 24;
    const auto& found = found_[seed.set];
    std::vector<int> centre =
        found.cells[static_cast<std::size_t>(place(seed).number)];
    std::ranges::sort(centre);
    const auto around = mesh::with_neighbours(mesh_, centre);
    for (std::size_t i = 0; i < found.places.size(); ++i) {
      if (centre.size() >= kMost) break;
      const Place& other = found.places[i];
      if (!open_[seed.set][i] || other.high < kReach * best_) continue;
      const auto& cells = found.cells[static_cast<std::size_t>(other.number)];
      const bool is_near = std::ranges::all_of(cells, [&](int cell) {
        return std::ranges::binary_search(around, cell);
      });
      if (!is_near) continue;
      centre.insert(centre.end(), cells.begin(), cells.end());
      std::ranges::sort(centre);
      centre.erase(std::unique(centre.begin(), centre.end()), centre.end());
    }
    return centre;
  }

  stress::JoinedStress solve(const Number& seed, const std::vector<int>& centre,
                             int layers, int more) const {
    const auto enriched = solve_nearby<dim>(
        job_, sets_[seed.set], mesh_, *level_.bases[seed.set],
        {centre, layers, place(seed).instant, level_.member.degree + more});
    const auto joined = stress::joined_stress<dim>(
        enriched.basis, job_.part.material, kFineLattice);
    stress::JoinedStress of_centre{
        MatrixXd(joined.mean.rows(), static_cast<Index>(centre.size())),
        MatrixXd(joined.mean.rows(), static_cast<Index>(centre.size()))};
    for (std::size_t k = 0; k < enriched.cells.size(); ++k) {
      const auto at = std::ranges::lower_bound(centre, enriched.cells[k]);
      if (at == centre.end() || *at != enriched.cells[k]) continue;
      const Index column = at - centre.begin();
      of_centre.mean.col(column) = joined.mean.col(static_cast<Index>(k));
      of_centre.jump.col(column) = joined.jump.col(static_cast<Index>(k));
    }
    return of_centre;
  }

  /// By how much the solved stress near its largest is higher at its worst
  /// instant than at the place's, per cell.
  Eigen::VectorXd rise(const Number& seed,
                       const std::vector<int>& centre) const {
    constexpr double kNear = 0.9;
    Eigen::VectorXd result =
        Eigen::VectorXd::Ones(static_cast<Index>(centre.size()));
    const auto& basis = *level_.bases[seed.set];
    if (basis.coefficients.cols() < 2) return result;
    elasticity::DisplacementBasis<dim> part;
    part.discretization = basis.discretization;
    auto& d = part.discretization;
    d.cell_nodes.clear();
    d.cell_points.clear();
    for (const int cell : centre) {
      const auto c = static_cast<std::size_t>(cell);
      d.cell_nodes.push_back(basis.discretization.cell_nodes[c]);
      d.cell_points.push_back(basis.discretization.cell_points[c]);
    }
    part.columns = basis.columns * basis.coefficients.col(place(seed).instant);
    part.coefficients = MatrixXd::Ones(1, 1);
    const auto& history = histories_[seed.set];
    const auto then = stress::stress_history<dim>(part, job_.part.material,
                                                  history.subdivisions);
    for (std::size_t k = 0; k < centre.size(); ++k) {
      const auto at = static_cast<Index>(k);
      const auto worst = history.worst.col(centre[k]).array();
      const Eigen::ArrayXd counts =
          (worst >= kNear * worst.maxCoeff()).template cast<double>();
      const Eigen::ArrayXd least =
          then.worst.col(at).array().max(1e-3 * worst.maxCoeff());
      result[at] = std::max(1.0, (counts * worst / least).maxCoeff());
    }
    return result;
  }

  /// The nearest point of another lattice.
  FieldPoint on_lattice(const FieldPoint& fine, int subdivisions) const {
    const Eigen::Matrix<double, dim, 1> at =
        elasticity::lattice<dim>(mesh_.shape, kFineLattice).col(fine.point);
    Index nearest = 0;
    (elasticity::lattice<dim>(mesh_.shape, subdivisions).colwise() - at)
        .colwise()
        .squaredNorm()
        .minCoeff(&nearest);
    return {fine.cell, static_cast<int>(nearest)};
  }

  /// Of the stress, by what the mesh makes of a curved surface [1]: a surface
  /// whose slope is off by δ/2 to and fro has a stress that is by about δ.
  double shape_error(const std::vector<int>& centre) const {
    if constexpr (dim == 3) return stress::largest_kink(mesh_, centre);
    return 0.0;
  }

  void look_closer(const Number& seed) {
    const auto centre = centre_of(seed);
    Closer closer = judge({solve(seed, centre, 1, 1), solve(seed, centre, 2, 1),
                           solve(seed, centre, 1, 2)},
                          rise(seed, centre));
    closer.at = on_lattice(closer.at, histories_[seed.set].subdivisions);
    closer.at.cell = centre[static_cast<std::size_t>(closer.at.cell)];
    const double bent = shape_error(centre) * closer.value;
    closer.low -= bent;
    closer.high += bent;
    if (seen_.empty()) best_ = 0.0;
    seen_.emplace_back(seed, closer);
    best_ = std::max(best_, closer.value);
    auto& found = found_[seed.set];
    for (std::size_t i = 0; i < found.places.size(); ++i) {
      const auto& cells =
          found.cells[static_cast<std::size_t>(found.places[i].number)];
      if (std::ranges::any_of(cells, [&](int cell) {
            return std::ranges::binary_search(centre, cell);
          })) {
        open_[seed.set][i] = false;
      }
    }
    open_[seed.set][seed.place] = false;
  }

  NearbyPeak join(double tolerance) const {
    NearbyPeak peak;
    stress::Band& band = peak.band;
    band = {0.0, kNothing, kNothing, stress::Convergence::kConverged};
    for (const auto& [number, closer] : seen_) {
      band.high = std::max(band.high, closer.high);
      if (closer.value <= band.value) continue;
      band.value = closer.value;
      band.low = closer.low;
      peak.set = number.set;
      peak.at = closer.at;
      peak.instant = place(number).instant;
      peak.jump = place(number).high - place(number).low;
    }
    const auto rest = highest_open();
    if (rest && place(*rest).high >= kReach * best_) {
      band.high = std::max(band.high, place(*rest).high);
    }
    peak.degree = level_.member.degree + 2;
    const double reach =
        std::max(band.high - band.value, band.value - band.low);
    if (!(reach <= tolerance * band.value)) {
      band.verdict = stress::Convergence::kNotConverged;
    }
    return peak;
  }

  const PartJob& job_;
  const std::vector<LoadSet>& sets_;
  const mesh::PartMesh<dim>& mesh_;
  const Level<dim>& level_;
  const std::vector<stress::StressHistory>& histories_;
  std::vector<PlacesOfSet> found_;
  std::vector<std::vector<bool>> open_;
  std::vector<std::pair<Number, Closer>> seen_;
  double best_{};  ///< highest mean, then highest value of finer solutions
};

}  // namespace

template <int dim>
std::optional<NearbyPeak> nearby_peak(
    const PartJob& job, const std::vector<LoadSet>& sets,
    const mesh::PartMesh<dim>& mesh, const Level<dim>& level,
    const std::vector<stress::StressHistory>& histories, double tolerance) {
  try {
    return PeakSearch<dim>(job, sets, mesh, level, histories).search(tolerance);
  } catch (const Error&) {
    return std::nullopt;  // a neighbourhood that folds or is loose
  }
}

template <int dim>
double joined_peak(const mesh::PartMesh<dim>& mesh, const Level<dim>& level,
                   const std::vector<stress::StressHistory>& histories) {
  constexpr double kShare = 0.6;
  double largest = 0.0;
  for (const auto& history : histories) {
    largest = std::max(largest, history.worst.maxCoeff());
  }
  double joined = 0.0;
  for (std::size_t s = 0; s < histories.size(); ++s) {
    const auto found = find_places<dim>(mesh, level.bases[s]->discretization,
                                        histories[s], kShare * largest);
    for (const Place& place : found.places) {
      joined = std::max(joined, place.mean);
    }
  }
  return joined;
}

template std::optional<NearbyPeak> nearby_peak<2>(
    const PartJob&, const std::vector<LoadSet>&, const mesh::PartMesh<2>&,
    const Level<2>&, const std::vector<stress::StressHistory>&, double);
template std::optional<NearbyPeak> nearby_peak<3>(
    const PartJob&, const std::vector<LoadSet>&, const mesh::PartMesh<3>&,
    const Level<3>&, const std::vector<stress::StressHistory>&, double);
template double joined_peak<2>(const mesh::PartMesh<2>&, const Level<2>&,
                               const std::vector<stress::StressHistory>&);
template double joined_peak<3>(const mesh::PartMesh<3>&, const Level<3>&,
                               const std::vector<stress::StressHistory>&);

}  // namespace clevis::assessment

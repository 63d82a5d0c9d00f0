#include "assessment/places/nearby_peak.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "assessment/places/local_solve.h"
#include "assessment/places/meeting_places.h"
#include "assessment/places/place_band.h"
#include "base/errors.h"
#include "elasticity/fe_space/tabulation.h"
#include "mesh/derived/sub_mesh.h"
#include "stress/peaks/meeting_points.h"
#include "stress/surface/surface_kink.h"

namespace clevis::assessment {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using stress::FieldPoint;

/// Finer solutions are looked at on a lattice twice as close as usual.
constexpr int kFineLattice = 8;
constexpr double kNothing = -std::numeric_limits<double>::infinity();

/// Stress of finer solutions near a place: its largest stress, that less the
/// error there, and the largest of stress and error over all its cells.
struct Closer {
  PlaceEstimate stress{kNothing, kNothing, kNothing};
  FieldPoint at;  ///< of the value: cell of the centre, point of kFineLattice
};

/// Solutions in the cells of a centre, lattice points × cells.
struct FinerFields {
  stress::JoinedStress low;   ///< one degree higher
  stress::JoinedStress wide;  ///< likewise, with a second layer around
  stress::JoinedStress high;  ///< two degrees higher
};

/// Differences by degree, layer and cells, each by its largest in the cell
/// where the stress is not far below its largest: what agrees at a point by
/// chance does not hide it.
/// @param rise  of each cell, from the instant that was solved for to its worst
///   one.
/// @param counting  points × cells: those that are not left out.
Closer judge(const FinerFields& fields, const Eigen::VectorXd& rise,
             const Eigen::MatrixXd& counting) {
  constexpr double kNear = 0.9;
  constexpr double kDegree = 0.6;
  constexpr double kLayer = 0.5;
  constexpr double kJump = 0.15;
  const MatrixXd value = (fields.high.mean + fields.wide.mean - fields.low.mean)
                             .cwiseProduct(counting);
  const double least = kNear * value.maxCoeff();
  Closer closer;
  for (Index c = 0; c < value.cols(); ++c) {
    const Eigen::ArrayXd counts =
        (value.col(c).array() >= least).cast<double>() *
        counting.col(c).array();
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
    closer.stress.high = std::max(closer.stress.high, peak + error);
    if (peak <= closer.stress.value) continue;
    closer.stress.value = peak;
    closer.stress.low = peak - error;
    closer.at = {static_cast<int>(c), static_cast<int>(point)};
  }
  return closer;
}

template <int dim>
class PeakSearch {
 public:
  PeakSearch(const PartJob& job, const std::vector<LoadSet>& sets,
             const mesh::PartMesh<dim>& mesh, const Level<dim>& level,
             const std::vector<stress::StressHistory>& histories,
             double pollution)
      : job_(job),
        sets_(sets),
        mesh_(mesh),
        level_(level),
        histories_(histories),
        pollution_(pollution) {}

  /// @return nothing if no place counts, or it was left before the first.
  std::optional<NearbyPeak> search(double tolerance, PlaceSearch which) {
    constexpr int kMostClusters = 8;
    // Of hexahedra each is dear: enough where the band is within the tolerance.
    const int kFewest =
        mesh_.shape == mesh::CellShape::kTensor ? 1 : kMostClusters;
    find_all_places();
    int clusters = 0;
    while (clusters < kMostClusters) {
      const auto next = highest_open();
      if (!next || place(*next).high < kReach * best_) break;
      if (clusters >= kFewest &&
          join(tolerance).band.verdict == stress::Convergence::kConverged) {
        break;
      }
      if (!look_closer(*next, tolerance, which)) return std::nullopt;
      ++clusters;
      if (which == PlaceSearch::kWhileItMayConverge &&
          !may_converge(tolerance)) {
        break;
      }
    }
    if (seen_.empty()) return std::nullopt;
    return join(tolerance);
  }

 private:
  static constexpr double kReach = 0.97;
  static constexpr double kShare = 0.6;
  struct Number {
    std::size_t set, place;
  };
  /// A place that was looked at, with the cells that were solved for.
  struct Seen {
    std::size_t set{};
    Place place;
    std::vector<int> centre;
    Closer closer;
  };

  const Place& place(const Number& n) const {
    return found_[n.set].places[n.place];
  }

  void find_all_places() {
    double largest = 0.0;
    for (const auto& history : histories_) {
      largest = std::max(largest, history.worst.maxCoeff());
    }
    find_places_above(kShare * largest);
    best_ = 0.0;
    for (const PlacesOfSet& found : found_) {
      for (const Place& p : found.places) best_ = std::max(best_, p.mean);
    }
  }

  /// Places that were looked at are not open again.
  void find_places_above(double least) {
    least_ = least;
    found_.clear();
    open_.clear();
    for (std::size_t s = 0; s < sets_.size(); ++s) {
      found_.push_back(find_places<dim>(level_.bases[s]->discretization,
                                        histories_[s], least));
      open_.emplace_back(found_[s].places.size(), true);
    }
    for (const Seen& seen : seen_) close(seen.set, seen.centre);
  }

  /// Closes the places of all cells of a centre.
  void close(std::size_t set, const std::vector<int>& centre) {
    const auto& found = found_[set];
    for (std::size_t i = 0; i < found.places.size(); ++i) {
      const auto& cells =
          found.cells[static_cast<std::size_t>(found.places[i].number)];
      if (std::ranges::any_of(cells, [&](int cell) {
            return std::ranges::binary_search(centre, cell);
          })) {
        open_[set][i] = false;
      }
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
    const std::size_t kMost = mesh_.shape == mesh::CellShape::kTensor ? 8 : 24;
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

  /// The solved field at a place's instant in some cells alone.
  elasticity::DisplacementBasis<dim> field_in(
      const Number& seed, const std::vector<int>& cells) const {
    const auto& basis = *level_.bases[seed.set];
    elasticity::DisplacementBasis<dim> part;
    part.discretization = basis.discretization;
    auto& d = part.discretization;
    d.cell_nodes.clear();
    d.cell_points.clear();
    for (const int cell : cells) {
      const auto c = static_cast<std::size_t>(cell);
      d.cell_nodes.push_back(basis.discretization.cell_nodes[c]);
      d.cell_points.push_back(basis.discretization.cell_points[c]);
    }
    part.columns = basis.columns * basis.coefficients.col(place(seed).instant);
    part.coefficients = MatrixXd::Ones(1, 1);
    return part;
  }

  /// By how much the solved stress near its largest is higher at its worst
  /// instant than at the place's, per cell.
  Eigen::VectorXd rise(const Number& seed, const std::vector<int>& centre,
                       const elasticity::DisplacementBasis<dim>& field) const {
    constexpr double kNear = 0.9;
    Eigen::VectorXd result =
        Eigen::VectorXd::Ones(static_cast<Index>(centre.size()));
    if (level_.bases[seed.set]->coefficients.cols() < 2) return result;
    const auto& history = histories_[seed.set];
    const auto then = stress::stress_history<dim>(field, job_.part.material,
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

  /// 1 at the points of the fine lattice that count, 0 at those beside points
  /// of the usual one that are left out.
  MatrixXd counting(const Number& seed, const std::vector<int>& cells) const {
    const auto& history = histories_[seed.set];
    const auto fine = elasticity::lattice<dim>(mesh_.shape, kFineLattice);
    const auto usual =
        elasticity::lattice<dim>(mesh_.shape, history.subdivisions);
    const double beside = 1.01 * std::sqrt(double(dim)) *
                          (1.0 / history.subdivisions - 1.0 / kFineLattice);
    MatrixXd result =
        MatrixXd::Ones(fine.cols(), static_cast<Index>(cells.size()));
    for (std::size_t k = 0; k < cells.size(); ++k) {
      for (Index q = 0; q < usual.cols(); ++q) {
        if (history.worst(q, cells[k]) >= 0.0) continue;
        for (Index i = 0; i < fine.cols(); ++i) {
          if ((fine.col(i) - usual.col(q)).norm() <= beside) {
            result(i, static_cast<Index>(k)) = 0.0;
          }
        }
      }
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

  /// By what the mesh makes of a curved surface [Pa]: a surface whose slope is
  /// off by δ/2 to and fro has a stress that is by about δ off where it flows
  /// across.
  double shape_error(const std::vector<int>& centre,
                     const elasticity::DisplacementBasis<dim>& field) const {
    if constexpr (dim == 3) {
      constexpr int kIntervals = 4;
      return stress::kinked_stress(
          mesh_, centre,
          stress::instant_field<dim>(field, job_.part.material, kIntervals, 0)
              .stress);
    }
    return 0.0;
  }

  /// @return false where it was left: errors at the highest place that are
  /// known
  ///   before all is solved are beyond the tolerance already.
  bool look_closer(const Number& seed, double tolerance, PlaceSearch which) {
    constexpr double kSure = 1.1;  // the value is not known yet
    const auto is_futile = [&](double error, double value) {
      return which == PlaceSearch::kWhileItMayConverge && seen_.empty() &&
             error > kSure * tolerance * value;
    };
    const auto centre = centre_of(seed);
    const auto field = field_in(seed, centre);
    const Eigen::VectorXd rises = rise(seed, centre, field);
    const double shape = rises.maxCoeff() * shape_error(centre, field);
    const double solved = place(seed).high;
    if (is_futile(pollution_ * solved + shape, solved)) return false;
    const MatrixXd counts = counting(seed, centre);
    FinerFields fields{
        solve(seed, centre, 1, 1), {}, solve(seed, centre, 1, 2)};
    fields.wide = fields.low;  // dear, and last
    Closer closer = judge(fields, rises, counts);
    if (is_futile(closer.stress.value - closer.stress.low +
                      pollution_ * closer.stress.value + shape,
                  closer.stress.value)) {
      return false;
    }
    fields.wide = solve(seed, centre, 2, 1);
    closer = judge(fields, rises, counts);
    closer.at = on_lattice(closer.at, histories_[seed.set].subdivisions);
    closer.at.cell = centre[static_cast<std::size_t>(closer.at.cell)];
    const double off = pollution_ * closer.stress.value + shape;
    closer.stress.low -= off;
    closer.stress.high += off;
    if (seen_.empty()) best_ = 0.0;
    seen_.push_back({seed.set, place(seed), centre, closer});
    best_ = std::max(best_, closer.stress.value);
    open_[seed.set][seed.place] = false;
    close(seed.set, centre);
    // One bad cell may stand so high that all others were below the share.
    if (kShare * best_ < least_) find_places_above(kShare * best_);
    return true;
  }

  std::vector<PlaceEstimate> estimates() const {
    std::vector<PlaceEstimate> result;
    for (const Seen& seen : seen_) result.push_back(seen.closer.stress);
    return result;
  }

  /// By how much a place may be above what was solved there, as far off as the
  /// others were [1].
  double farthest() const {
    double result = 1.0;
    for (const Seen& seen : seen_) {
      result = std::max(result, seen.closer.stress.high / seen.place.high);
    }
    return result;
  }

  /// Whether the places that are left may still bring the band within the
  /// tolerance. Its upper end does not fall, so the value would have to rise,
  /// and only a place above it does that; its lower end does not rise for the
  /// same value.
  bool may_converge(double tolerance) const {
    const auto all = estimates();
    const LargestPlace largest = largest_place(all);
    const double value = all[largest.place].value;
    const auto rest = highest_open();
    const double most =
        rest ? std::max(value, farthest() * place(*rest).high) : value;
    if (largest.high - most > tolerance * most) return false;
    return most > value || value - largest.low <= tolerance * value;
  }

  NearbyPeak join(double tolerance) const {
    const LargestPlace largest = largest_place(estimates());
    const Seen& highest = seen_[largest.place];
    NearbyPeak peak;
    stress::Band& band = peak.band;
    band = {highest.closer.stress.value, largest.low, largest.high,
            stress::Convergence::kConverged};
    peak.set = highest.set;
    peak.at = highest.closer.at;
    peak.instant = highest.place.instant;
    peak.jump = highest.place.high - highest.place.low;
    // Places that are left may be as far off as the others were.
    const auto rest = highest_open();
    const bool is_left = rest && place(*rest).high >= kReach * best_;
    const double rise = is_left ? farthest() : 1.0;
    if (is_left) band.high = std::max(band.high, rise * place(*rest).high);
    peak.degree = level_.member.degree + 2;
    const double reach =
        std::max(band.high - band.value, band.value - band.low);
    if (!(reach <= tolerance * band.value)) {
      band.verdict = stress::Convergence::kNotConverged;
      peak.open = open_places(band, tolerance * band.value, rise);
    }
    return peak;
  }

  /// Where the band comes from: the places that were looked at and those that
  /// are left.
  /// @param admitted  error [Pa].
  /// @param farthest  of a place that is left: its stress over the one solved.
  std::vector<OpenPlace> open_places(const stress::Band& band, double admitted,
                                     double farthest) const {
    constexpr double kNearly = 0.5;
    constexpr std::size_t kMost = 40;
    std::vector<OpenPlace> open;
    const auto add = [&](std::size_t set, const FieldPoint& at, double error) {
      if (!(error > kNearly * admitted) || open.size() >= kMost) return;
      const auto& discretization = level_.bases[set]->discretization;
      const Eigen::Vector3d here = stress::position<dim>(
          discretization, at, histories_[set].subdivisions);
      const auto& corners =
          discretization.cell_points[static_cast<std::size_t>(at.cell)];
      const double cell =
          (corners.rowwise().maxCoeff() - corners.rowwise().minCoeff()).norm();
      if (std::ranges::any_of(open, [&](const OpenPlace& other) {
            return (other.at - here).norm() < 0.5 * cell;
          })) {
        return;
      }
      open.push_back({here, error / admitted});
    };
    for (const Seen& seen : seen_) {
      const PlaceEstimate& stress = seen.closer.stress;
      const bool may_be_peak = stress.high >= band.value;
      const double below = may_be_peak ? stress.value - stress.low : 0.0;
      add(seen.set, seen.closer.at, std::max(stress.high - band.value, below));
    }
    for (std::size_t s = 0; s < found_.size(); ++s) {
      for (std::size_t i = 0; i < found_[s].places.size(); ++i) {
        const Place& left = found_[s].places[i];
        if (left.high < kReach * best_) break;  // highest first
        if (open_[s][i]) add(s, left.at, farthest * left.high - band.value);
      }
    }
    return open;
  }

  const PartJob& job_;
  const std::vector<LoadSet>& sets_;
  const mesh::PartMesh<dim>& mesh_;
  const Level<dim>& level_;
  const std::vector<stress::StressHistory>& histories_;
  std::vector<PlacesOfSet> found_;
  std::vector<std::vector<bool>> open_;
  std::vector<Seen> seen_;
  double least_{};      ///< stress that the places found reach [Pa]
  double pollution_{};  ///< of a value, from outside of its neighbourhood [1]
  double best_{};       ///< highest mean, then highest value of finer solutions
};

}  // namespace

template <int dim>
std::optional<NearbyPeak> nearby_peak(
    const PartJob& job, const std::vector<LoadSet>& sets,
    const mesh::PartMesh<dim>& mesh, const Level<dim>& level,
    const std::vector<stress::StressHistory>& histories, double pollution,
    double tolerance, PlaceSearch which) {
  try {
    return PeakSearch<dim>(job, sets, mesh, level, histories, pollution)
        .search(tolerance, which);
  } catch (const Error&) {
    return std::nullopt;  // a neighbourhood that folds or is loose
  }
}

template std::optional<NearbyPeak> nearby_peak<2>(
    const PartJob&, const std::vector<LoadSet>&, const mesh::PartMesh<2>&,
    const Level<2>&, const std::vector<stress::StressHistory>&, double, double,
    PlaceSearch);
template std::optional<NearbyPeak> nearby_peak<3>(
    const PartJob&, const std::vector<LoadSet>&, const mesh::PartMesh<3>&,
    const Level<3>&, const std::vector<stress::StressHistory>&, double, double,
    PlaceSearch);
}  // namespace clevis::assessment

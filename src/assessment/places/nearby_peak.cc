#include "assessment/places/nearby_peak.h"

#include <algorithm>
#include <utility>

#include "assessment/places/closer_look.h"
#include "assessment/places/meeting_places.h"
#include "assessment/places/place_band.h"
#include "base/messages/errors.h"
#include "mesh/derived/sub_mesh.h"

namespace clevis::assessment {
namespace {

using stress::FieldPoint;

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

  FoundPeak search(double tolerance, PlaceSearch which) {
    FoundPeak found;
    try {
      found.peak = peak(tolerance, which);
    } catch (const Error&) {
      // a neighbourhood that folds or is loose
    }
    found.lasting_error = lasting_error_;
    return found;
  }

 private:
  /// @return nothing if no place counts, or it was left before the first.
  std::optional<NearbyPeak> peak(double tolerance, PlaceSearch which) {
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
    CloserStress closer;
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

  /// What more work at a place is worth. One whose error is beyond the
  /// tolerance keeps the band from converging, and one that is sure to stay
  /// below the highest changes nothing of it.
  Worth worth(const KnownOfPlace& known, double solved, double tolerance,
              PlaceSearch which) const {
    constexpr double kSure = 1.1;  // the value is not known yet
    const bool is_first = seen_.empty();
    if (!known.estimate && !is_first) return Worth::kMore;
    const double own = known.estimate ? known.estimate->value : solved;
    const double value = is_first ? own : std::max(best_, own);
    if (own + known.error - value > kSure * tolerance * value) {
      if (which == PlaceSearch::kWhileItMayConverge) return Worth::kNothing;
      // The band stays open: what narrows it is worth solving for.
      constexpr double kMuch = 0.25;
      const double error = known.estimate ? own - known.estimate->low : 0.0;
      return error - known.error > kMuch * error ? Worth::kMore
                                                 : Worth::kEnough;
    }
    if (is_first) return Worth::kMore;
    const double high = 2.0 * known.estimate->high - own;
    return high < best_ || !may_converge(tolerance) ? Worth::kEnough
                                                    : Worth::kMore;
  }

  /// @return false where it was left: errors that are known before all is
  ///   solved are beyond the tolerance already.
  bool look_closer(const Number& seed, double tolerance, PlaceSearch which) {
    const auto centre = centre_of(seed);
    const auto closer = assessment::look_closer<dim>(
        {job_, sets_[seed.set], mesh_, *level_.bases[seed.set],
         histories_[seed.set], level_.member.degree},
        place(seed), centre, pollution_, [&](const KnownOfPlace& known) {
          if (seen_.empty()) lasting_error_ = known.lasting / place(seed).high;
          return worth(known, place(seed).high, tolerance, which);
        });
    if (!closer) return false;
    if (seen_.empty()) best_ = 0.0;
    seen_.push_back({seed.set, place(seed), centre, *closer});
    best_ = std::max(best_, closer->stress.value);
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
    peak.instant = highest.closer.instant;
    peak.jump = highest.place.high - highest.place.low;
    const double unresolved = error_of_jump(band.value, peak.jump);
    band.low = std::max(0.0, band.low - unresolved);
    band.high += unresolved;
    // Places that are left may be as far off as the others were.
    const auto rest = highest_open();
    const bool is_left = rest && place(*rest).high >= kReach * best_;
    const double most = is_left ? farthest() : 1.0;
    if (is_left) band.high = std::max(band.high, most * place(*rest).high);
    peak.degree = level_.member.degree + 2;
    const double reach =
        std::max(band.high - band.value, band.value - band.low);
    if (!(reach <= tolerance * band.value)) {
      band.verdict = stress::Convergence::kNotConverged;
      peak.open = open_places(band, tolerance * band.value, most);
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
  double lasting_error_{};  ///< as in FoundPeak
  double best_{};  ///< highest mean, then highest value of finer solutions
};

}  // namespace

template <int dim>
FoundPeak nearby_peak(const PartJob& job, const std::vector<LoadSet>& sets,
                      const mesh::PartMesh<dim>& mesh, const Level<dim>& level,
                      const std::vector<stress::StressHistory>& histories,
                      double pollution, double tolerance, PlaceSearch which) {
  return PeakSearch<dim>(job, sets, mesh, level, histories, pollution)
      .search(tolerance, which);
}

template FoundPeak nearby_peak<2>(const PartJob&, const std::vector<LoadSet>&,
                                  const mesh::PartMesh<2>&, const Level<2>&,
                                  const std::vector<stress::StressHistory>&,
                                  double, double, PlaceSearch);
template FoundPeak nearby_peak<3>(const PartJob&, const std::vector<LoadSet>&,
                                  const mesh::PartMesh<3>&, const Level<3>&,
                                  const std::vector<stress::StressHistory>&,
                                  double, double, PlaceSearch);
}  // namespace clevis::assessment

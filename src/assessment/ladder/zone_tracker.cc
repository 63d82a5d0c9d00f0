#include "assessment/ladder/zone_tracker.h"

#include <algorithm>
#include <cmath>

#include "assessment/job/part_zones.h"
#include "assessment/judge/time_sampling_error.h"
#include "stress/zones/zone_strength.h"

namespace clevis::assessment {
namespace {

constexpr int kLayers = 8;  // innermost ring: 0.15^7 = 2e-6 of a cell

// On a mesh that is not graded the lattice reaches about a tenth of a zone's
// radius.
constexpr double kReached = 0.1;
constexpr double kFinest = 1e-6;
constexpr double kResolved = 5.0;  // of the radius: three cells to the wall

}  // namespace

template <int dim>
ZoneTracker<dim>::ZoneTracker(const PartJob& job,
                              const mesh::PartMesh<dim>& mesh)
    : job_(job), given_(&mesh) {
  for (const LoadSet& set : job.load_sets) {
    Set& own = sets_.emplace_back();
    for (auto& zone : part_zones<dim>(job, mesh, set)) {
      own.zones.push_back({std::move(zone), {}, {}, false});
    }
  }
  if (has_zones()) grade(mesh);
}

template <int dim>
bool ZoneTracker<dim>::has_zones() const {
  return std::ranges::any_of(sets_, [](const Set& set) {
    return !set.zones.empty();
  });
}

template <int dim>
void ZoneTracker<dim>::grade(const mesh::PartMesh<dim>& mesh) {
  if constexpr (dim == 2) {
    if (mesh.shape != mesh::CellShape::kTensor) return;
    std::vector<unsigned> vertices;
    for (const Set& set : sets_) {
      for (const Zone& zone : set.zones) {
        vertices.push_back(zone.zone.vertices[0]);
      }
    }
    std::ranges::sort(vertices);
    const auto twice = std::ranges::unique(vertices);
    vertices.erase(twice.begin(), twice.end());
    const auto graded = mesh::grade_at_vertices(mesh, vertices, kLayers);
    for (Set& set : sets_) {
      for (Zone& zone : set.zones) {
        const auto index =
            std::ranges::lower_bound(vertices, zone.zone.vertices[0]) -
            vertices.begin();
        zone.rings = stress::rings_of(graded, static_cast<std::size_t>(index));
      }
    }
    graded_ = graded.mesh;
  }
}

template <int dim>
void ZoneTracker<dim>::take(const Level<dim>& level) {
  if (!has_zones()) return;
  for (std::size_t s = 0; s < sets_.size() && taken_.empty(); ++s) {
    std::vector<stress::SingularZone> zones;
    for (const Zone& zone : sets_[s].zones) zones.push_back(zone.zone);
    sets_[s].zone_of = stress::zone_of_points<dim>(
        level.bases[s]->discretization, level.histories[s].subdivisions, zones);
    sets_[s].beside = stress::points_beside<dim>(
        level.bases[s]->discretization, level.histories[s].subdivisions, zones);
  }
  Taken& taken = taken_.emplace_back();
  taken.degree = level.member.degree;
  taken.dofs = level.member.dofs;
  taken.histories = level.histories;
  for (const auto& basis : level.bases) {
    taken.energies.push_back(basis->strain_energy);
  }
  measure(level, peak_of(taken, true).member.peak);
  outside_.clear();
  for (const Taken& one : taken_) outside_.push_back(peak_of(one, false));
  outside_.back().time_error = time_error(level, outside_.back());
}

template <int dim>
void ZoneTracker<dim>::measure(const Level<dim>& level, double outside_peak) {
  for (std::size_t s = 0; s < sets_.size(); ++s) {
    Set& set = sets_[s];
    const auto inside =
        stress::peaks_inside(level.histories[s], set.zone_of, set.zones.size());
    for (std::size_t z = 0; z < set.zones.size(); ++z) {
      Zone& zone = set.zones[z];
      if (zone.rings.empty()) {
        const double growth =
            std::pow(kFinest / kReached, zone.zone.exponent - 1.0);
        zone.governs = inside[z] * growth + zone.zone.rise > outside_peak;
        continue;
      }
      const auto strength = stress::zone_strength<dim>(
          *level.bases[s], job_.part.material, level.histories[s], zone.rings);
      zone.exponent = strength.exponent;
      zone.governs = strength.innermost > outside_peak &&
                     strength.exponent < stress::kSmoothExponent;
    }
  }
}

template <int dim>
OutsidePeak ZoneTracker<dim>::peak_of(const Taken& taken,
                                      bool without_all) const {
  OutsidePeak result;
  result.member.degree = taken.degree;
  result.member.dofs = taken.dofs;
  for (std::size_t s = 0; s < sets_.size(); ++s) {
    std::vector<bool> left_out;
    for (const Zone& zone : sets_[s].zones) {
      left_out.push_back(without_all || zone.governs);
    }
    const auto peak = stress::peak_outside(taken.histories[s], sets_[s].zone_of,
                                           left_out, dim);
    if (s > 0 && peak.value <= result.member.peak) continue;
    result.set = s;
    result.at = peak.at;
    result.instant = peak.instant;
    result.sampling_error = std::max(
        peak.sampling_error,
        stress::excess_at_borders(taken.histories[s], sets_[s].zone_of,
                                  sets_[s].beside, left_out, peak.value));
    result.member.peak = peak.value;
    result.member.strain_energy = taken.energies[s][peak.instant];
  }
  return result;
}

template <int dim>
double ZoneTracker<dim>::time_error(const Level<dim>& level,
                                    const OutsidePeak& peak) const {
  const auto at_point = stress::point_history<dim>(
      *level.bases[peak.set], job_.part.material, peak.at,
      level.histories[peak.set].subdivisions);
  return time_sampling_error(job_.load_sets[peak.set].history, at_point);
}

template <int dim>
bool ZoneTracker<dim>::is_singular() const {
  return std::ranges::any_of(sets_, [](const Set& set) {
    return std::ranges::any_of(set.zones, &Zone::governs);
  });
}

template <int dim>
double ZoneTracker<dim>::growth(const Zone& zone) {
  if (!zone.governs || !zone.rings.empty()) return 1.0;
  const double cells = zone.zone.reach / (kResolved * zone.zone.radius);
  return cells > 1.0 ? std::pow(cells, 1.0 - zone.zone.exponent) : 1.0;
}

template <int dim>
double ZoneTracker<dim>::unresolved_growth() const {
  double largest = 1.0;
  for (const Set& set : sets_) {
    for (const Zone& zone : set.zones) {
      largest = std::max(largest, growth(zone));
    }
  }
  return largest;
}

template <int dim>
std::vector<OpenPlace> ZoneTracker<dim>::coarse_places() const {
  constexpr double kSmall = 0.3;
  std::vector<OpenPlace> places;
  for (const Set& set : sets_) {
    for (const Zone& zone : set.zones) {
      const double excess = (growth(zone) - 1.0) / job_.tolerance;
      if (excess < kSmall) continue;
      for (const unsigned v : zone.zone.vertices) {
        Eigen::Vector3d at = Eigen::Vector3d::Zero();
        at.head<dim>() = this->mesh().vertices[v];
        places.push_back({at, excess});
      }
    }
  }
  return places;
}

template <int dim>
std::vector<stress::StressHistory> ZoneTracker<dim>::outside_histories() const {
  constexpr double kLeftOut = -1.0;
  auto histories = taken_.back().histories;
  for (std::size_t s = 0; s < sets_.size(); ++s) {
    const Set& set = sets_[s];
    for (Eigen::Index i = 0; i < set.zone_of.size(); ++i) {
      const int zone = set.zone_of.data()[i];
      if (zone >= 0 && set.zones[static_cast<std::size_t>(zone)].governs) {
        histories[s].worst.data()[i] = kLeftOut;
      }
    }
  }
  return histories;
}

template <int dim>
std::vector<ZoneResult> ZoneTracker<dim>::results() const {
  std::vector<ZoneResult> results;
  for (const Set& set : sets_) {
    for (const Zone& zone : set.zones) {
      if (!is_told(zone)) continue;
      results.push_back({zone.zone.name, zone.zone.exponent, zone.exponent,
                         zone.zone.at, zone.zone.radius, zone.governs, false,
                         zone.zone.edge_of});
    }
  }
  return results;
}

template <int dim>
std::optional<Eigen::MatrixXd> ZoneTracker<dim>::marks(std::size_t set) const {
  if (sets_[set].zone_of.size() == 0) return std::nullopt;
  std::vector<double> numbers;  // of the set's zones
  double told = 0.0;
  for (std::size_t s = 0; s <= set; ++s) {
    numbers.clear();
    for (const Zone& zone : sets_[s].zones) {
      numbers.push_back(is_told(zone) ? ++told : 0.0);
    }
  }
  return sets_[set]
      .zone_of
      .unaryExpr([&numbers](int zone) {
        return zone < 0 ? 0.0 : numbers[static_cast<std::size_t>(zone)];
      })
      .eval();
}

template class ZoneTracker<2>;
template class ZoneTracker<3>;

}  // namespace clevis::assessment

#include "assessment/models/part_shape.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <Eigen/Geometry>

#include "assessment/models/model_error.h"
#include "elasticity/revolution/revolution_solve.h"
#include "elasticity/solid/plane_loads.h"
#include "mesh/derived/plate.h"
#include "mesh/derived/quadrangles.h"
#include "mesh/reading/mesh_reader.h"

namespace clevis::assessment {
namespace {

double size_of(const mesh::PartMesh<2>& plate) {
  Eigen::AlignedBox2d box;
  for (const auto& vertex : plate.vertices) box.extend(vertex);
  return box.diagonal().norm();
}

/// Whether faces of a group are in a section of the part: of a plate's sides in
/// its mid-plane, of rings in the meridian.
bool has_faces(const mesh::PartMesh<2>& section, const std::string& name) {
  const auto found =
      std::ranges::find(section.groups, name, &mesh::SurfaceGroup::name);
  if (found == section.groups.end()) return false;
  const auto index = static_cast<int>(found - section.groups.begin());
  return std::ranges::any_of(section.boundary, [&](const auto& face) {
    return face.group == index;
  });
}

/// Whether all loads and supports act on faces that a section has.
template <class KnowsSeat>
bool acts_on(const mesh::PartMesh<2>& section, const PartJob& job,
             const KnowsSeat& knows_seat) {
  const auto known_load = [&](const loads::SurfaceLoad& load) {
    return has_faces(section, load.group);
  };
  const auto known_support = [&](const auto& support) {
    return has_faces(section, support.first);
  };
  return std::ranges::all_of(job.load_sets, [&](const LoadSet& set) {
    const auto& instants = set.history.instants;
    return std::ranges::all_of(set.history.seats, knows_seat) &&
           (instants.empty() ||
            std::ranges::all_of(instants.front().surface_loads, known_load)) &&
           std::ranges::all_of(set.fixed, known_support);
  });
}

bool acts_on_sides(const mesh::PartMesh<2>& plate, const PartJob& job) {
  return acts_on(plate, job, [&](const loads::Seat& seat) {
    return has_faces(plate, seat.group) &&
           (!seat.slide || seat.slide->opposite.empty() ||
            has_faces(plate, seat.slide->opposite));
  });
}

bool acts_on_rings(const mesh::Revolution& solid, const PartJob& job) {
  return acts_on(solid.meridian, job, [&](const loads::Seat& seat) {
    const bool is_patch = seat.slide && seat.kind != loads::SeatKind::kBearing;
    return has_faces(solid.meridian, seat.group) &&
           !is_patch;  // which goes round nothing
  });
}

bool is_loaded_in_plane(const mesh::PartMesh<2>& plate, const PartJob& job) {
  const double size = size_of(plate);
  return std::ranges::all_of(job.load_sets, [&](const LoadSet& set) {
    return elasticity::loads_in_plane(set.history, plate.mid_plane_z, size);
  });
}

/// What presses on a seat along a plate's thickness, p(s) = p₀ + s p₁, s from
/// the mid-plane [N/m], as of BearingTraction.
struct ThroughThickness {
  double mean{};  ///< |p₀|
  double ends{};  ///< |p₁| times half the thickness

  double largest() const { return mean + ends; }
};

ThroughThickness through_thickness(const loads::Seat& seat,
                                   const loads::Wrench& wrench,
                                   const mesh::PartMesh<2>& plate) {
  const Eigen::Vector3d z = Eigen::Vector3d::UnitZ();
  const double above = seat.p_LS.z() - plate.mid_plane_z;
  const Eigen::Vector3d moment =
      wrench.moment + (above * z).cross(wrench.force);
  const double t = plate.thickness;
  return {wrench.force.head<2>().norm() / t,
          6.0 * moment.cross(z).norm() / (t * t)};
}

/// Whether a slide's counterpart ends within the thickness.
bool ends_within(const loads::Seat& seat, const loads::ContactZone& zone,
                 const mesh::PartMesh<2>& plate) {
  constexpr double kFlat = 0.5, kSame = 1e-3;
  if (!seat.slide) return false;
  const std::array<double, 2> slopes = {seat.slide->along_L.z(),
                                        seat.slide->across_L.z()};
  for (int d = 0; d < 2; ++d) {
    const double slope = slopes[static_cast<std::size_t>(d)];
    if (std::abs(slope) < kFlat) continue;
    const double above = seat.p_LS.z() - plate.mid_plane_z;
    const double from = above + slope * zone.low[d],
                 to = above + slope * zone.high[d];
    const double half = (0.5 - kSame) * plate.thickness;
    if (std::min(from, to) > -half || std::max(from, to) < half) return true;
  }
  return false;
}

bool presses(const loads::Seat& seat) {
  return seat.kind == loads::SeatKind::kBearing ||
         (seat.slide && seat.kind != loads::SeatKind::kMean);
}

/// As of PlateShape::is_pressed_through: pressures count from a tenth of the
/// largest.
bool is_pressed_through(const mesh::PartMesh<2>& plate, const PartJob& job) {
  constexpr double kCounts = 0.1;
  double largest = 0.0, largest_kinked = 0.0;
  for (const LoadSet& set : job.load_sets) {
    for (const loads::InstantLoad& load : set.history.instants) {
      for (std::size_t s = 0; s < set.history.seats.size(); ++s) {
        const loads::Seat& seat = set.history.seats[s];
        const auto p = through_thickness(seat, load.wrenches[s], plate);
        largest = std::max(largest, p.largest());
        const bool is_kinked =
            presses(seat) &&
            (p.ends > p.mean ||
             (!load.zones.empty() && ends_within(seat, load.zones[s], plate)));
        if (is_kinked) largest_kinked = std::max(largest_kinked, p.largest());
      }
    }
  }
  return largest_kinked <= kCounts * largest;
}

std::optional<PlateShape> find_plate(const PartJob& job) {
  if (job.model == ModelKind::kSolid || has_bed(job)) return std::nullopt;
  auto plate = mesh::plate_mid_plane(job.mesh);
  if (!plate || !acts_on_sides(*plate, job)) return std::nullopt;
  PlateShape shape;
  shape.is_loaded_in_plane =
      !is_held_across(job) && is_loaded_in_plane(*plate, job);
  shape.is_pressed_through = is_pressed_through(*plate, job);
  // Terms through the thickness stand on quadrangles.
  shape.quadrangles = plate->shape == mesh::CellShape::kSimplex
                          ? mesh::quadrangles_of(*plate)
                          : *plate;
  shape.mesh = std::move(*plate);
  return shape;
}

std::optional<mesh::Revolution> find_rings(const PartJob& job) {
  if (has_bed(job)) return std::nullopt;
  auto solid = mesh::find_revolution(job.mesh);
  const auto fits = [&](const LoadSet& set) {
    return elasticity::supports_fit(*solid, set.fixed);
  };
  if (solid && acts_on_rings(*solid, job) &&
      std::ranges::all_of(job.load_sets, fits)) {
    return solid;
  }
  return std::nullopt;
}

bool has_one_load(const PartJob& job) {
  return job.load_sets.size() == 1 &&
         job.load_sets.front().history.instants.size() == 1;
}

}  // namespace

const std::optional<PlateShape>& PartShape::plate() const {
  if (!plate_) plate_ = find_plate(job_);
  return *plate_;
}

const std::optional<mesh::Revolution>& PartShape::revolution() const {
  if (!revolution_) revolution_ = find_rings(job_);
  return *revolution_;
}

const std::vector<LoadSet>& PartShape::governing() const {
  if (!governing_ && has_one_load(job_)) governing_ = job_.load_sets;
  if (!governing_) {
    governing_ = governing_loads(job_, plate()->quadrangles,
                                 plate()->is_loaded_in_plane);
  }
  return *governing_;
}

bool has_bed(const PartJob& job) {
  return std::ranges::any_of(job.load_sets, [](const LoadSet& set) {
    return !set.foundations.empty();
  });
}

bool is_held(const PartJob& job) {
  return std::ranges::any_of(job.load_sets, [](const LoadSet& set) {
    return !set.fixed.empty() || !set.foundations.empty();
  });
}

bool is_held_across(const PartJob& job) {
  return std::ranges::any_of(job.load_sets, [](const LoadSet& set) {
    return std::ranges::any_of(set.fixed, [](const auto& f) {
      return f.second[2];
    });
  });
}

bool leaves_plane_free(const PartJob& job) {
  return std::ranges::any_of(job.load_sets, [](const LoadSet& set) {
    return !set.fixed.empty() && set.foundations.empty() &&
           std::ranges::none_of(set.fixed, [](const auto& f) {
             return f.second[2];
           });
  });
}

}  // namespace clevis::assessment

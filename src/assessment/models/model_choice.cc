#include "assessment/models/model_choice.h"

#include <algorithm>
#include <utility>

#include <Eigen/Geometry>

#include "base/errors.h"
#include "elasticity/solid/plane_loads.h"
#include "mesh/derived/quadrangles.h"
#include "mesh/reading/mesh_reader.h"

namespace clevis::assessment {
namespace {

double size_of(const mesh::PartMesh<2>& plate) {
  Eigen::AlignedBox2d box;
  for (const auto& vertex : plate.vertices) box.extend(vertex);
  return box.diagonal().norm();
}

/// Whether a group has sides of the plate: it has no other then.
bool has_sides(const mesh::PartMesh<2>& plate, const std::string& name) {
  const auto found =
      std::ranges::find(plate.groups, name, &mesh::SurfaceGroup::name);
  if (found == plate.groups.end()) return false;
  const auto index = static_cast<int>(found - plate.groups.begin());
  return std::ranges::any_of(plate.boundary, [&](const auto& face) {
    return face.group == index;
  });
}

/// Elastic beds are in the equations of hexahedra and tetrahedra alone.
bool has_bed(const PartJob& job) {
  return std::ranges::any_of(job.load_sets, [](const LoadSet& set) {
    return !set.foundations.empty();
  });
}

bool acts_on_sides(const mesh::PartMesh<2>& plate, const PartJob& job) {
  const auto known = [&](const auto& entry) {
    return has_sides(plate, entry.group);
  };
  const auto known_seat = [&](const loads::Seat& seat) {
    return known(seat) && (!seat.slide || seat.slide->opposite.empty() ||
                           has_sides(plate, seat.slide->opposite));
  };
  return std::ranges::all_of(job.load_sets, [&](const LoadSet& set) {
    return std::ranges::all_of(set.history.seats, known_seat) &&
           std::ranges::all_of(set.history.instants.front().surface_loads,
                               known) &&
           std::ranges::all_of(set.fixed, [&](const auto& f) {
             return has_sides(plate, f.first);
           });
  });
}

/// Held across its plane the material cannot thin freely there.
bool is_held_across(const PartJob& job) {
  return std::ranges::any_of(job.load_sets, [](const LoadSet& set) {
    return std::ranges::any_of(set.fixed, [](const auto& f) {
      return f.second[2];
    });
  });
}

bool is_loaded_in_plane(const mesh::PartMesh<2>& plate, const PartJob& job) {
  const double size = size_of(plate);
  return std::ranges::all_of(job.load_sets, [&](const LoadSet& set) {
    return elasticity::loads_in_plane(set.history, plate.mid_plane_z, size);
  });
}

[[noreturn]] void refuse(const PartJob& job, const char* what) {
  throw Error("F005", "part " + job.part.name, what, "leave --model out");
}

}  // namespace

std::optional<PlateModel> plate_model(const PartJob& job) {
  if (job.model == ModelChoice::kSolid) return std::nullopt;
  const bool layered = job.model == ModelChoice::kLayered;
  const bool plane_stress = job.model == ModelChoice::kPlaneStress;
  if (has_bed(job)) {
    if (layered || plane_stress) {
      refuse(job,
             "a face rests on a foundation, which these models do not "
             "know");
    }
    return std::nullopt;
  }
  auto plate = mesh::plate_mid_plane(job.mesh);
  if (!plate || !acts_on_sides(*plate, job)) {
    if (layered || plane_stress) {
      refuse(job, "the part is no plate along z that is loaded on its sides");
    }
    return std::nullopt;
  }
  const bool held_across = is_held_across(job);
  PlateModel model;
  model.suits_plane_stress = !held_across && is_loaded_in_plane(*plate, job);
  model.suits_layers = true;
  // Terms through the thickness stand on quadrangles.
  model.quadrangles = plate->shape == mesh::CellShape::kSimplex
                          ? mesh::quadrangles_of(*plate)
                          : *plate;
  model.mesh = std::move(*plate);
  if (plane_stress && !model.suits_plane_stress) {
    refuse(job, "the part is no plate along z that is loaded in its plane");
  }
  if (layered) return model;
  // A clamped side takes so many terms that hexahedra are the better choice.
  model.suits_layers = model.suits_layers && !held_across;
  return model;
}

}  // namespace clevis::assessment

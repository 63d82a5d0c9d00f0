#include "assessment/model_choice.h"

#include <algorithm>

#include <Eigen/Geometry>

#include "base/errors.h"
#include "elasticity/plane_loads.h"
#include "mesh/mesh_reader.h"

namespace clevis::assessment {
namespace {

double size_of(const mesh::PartMesh<2>& plate) {
  Eigen::AlignedBox2d box;
  for (const auto& vertex : plate.vertices) box.extend(vertex);
  return box.diagonal().norm();
}

bool fits(const mesh::PartMesh<2>& plate, const PartJob& job) {
  const double size = size_of(plate);
  const auto known = [&](const std::string& name) {
    const auto found =
        std::ranges::find(plate.groups, name, &mesh::SurfaceGroup::name);
    if (found == plate.groups.end()) return false;
    const auto index = static_cast<int>(found - plate.groups.begin());
    return std::ranges::any_of(plate.boundary, [&](const auto& face) {
      return face.group == index;
    });
  };
  return std::ranges::all_of(job.load_sets, [&](const LoadSet& set) {
    const bool in_plane =
        elasticity::loads_in_plane(set.history, plate.mid_plane_z, size);
    return in_plane &&
           std::ranges::all_of(set.history.seats,
                               [&](const auto& s) {
                                 return known(s.group);
                               }) &&
           std::ranges::all_of(set.history.instants.front().surface_loads,
                               [&](const auto& s) {
                                 return known(s.group);
                               }) &&
           // held across its plane the material cannot thin freely there
           std::ranges::all_of(set.fixed, [&](const auto& f) {
             return known(f.first) && !f.second[2];
           });
  });
}

/// Thickness over the diameter of the smallest bore up to which the 3-D peak
/// at a bore was measured to be within 1 % of plane stress (docs/theory.md).
constexpr double kThickest = 0.6;

bool is_thin(const mesh::PartMesh<2>& plate) {
  return std::ranges::all_of(plate.groups, [&](const auto& group) {
    return !group.cylinder || !group.name.starts_with("bore_") ||
           plate.thickness <= kThickest * 2.0 * group.cylinder->radius;
  });
}

}  // namespace

std::optional<mesh::PartMesh<2>> plane_model(const PartJob& job) {
  if (job.model == ModelChoice::kSolid) return std::nullopt;
  auto plate = mesh::plate_mid_plane(job.mesh);
  const bool is_asked_for = job.model == ModelChoice::kPlaneStress;
  const bool suits = plate.has_value() && fits(*plate, job) &&
                     (is_asked_for || is_thin(*plate));
  if (suits) return plate;
  if (is_asked_for) {
    throw Error("F005", "part " + job.part.name,
                "the part is no plate along z that is loaded in its plane",
                "leave --model out");
  }
  return std::nullopt;
}

}  // namespace clevis::assessment

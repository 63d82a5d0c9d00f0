#include "beam/estimates/struck_part.h"

#include <algorithm>
#include <cmath>

#include "mesh/cells/section.h"

namespace clevis::beam {

using Eigen::Vector3d;

namespace {

constexpr double kUniform = 0.02;
constexpr double kAligned = 1e-3;  // [rad]
constexpr int kFine = 12;          // parts of a cell: a round bar to 0.1 %

bool is_uniform(const mesh::PartMesh<3>& mesh, const Vector3d& root,
                const Vector3d& axis, double length, double area) {
  constexpr double kEnds[] = {0.1, 0.9};
  const mesh::SectionCutter cutter(mesh);
  return std::ranges::all_of(kEnds, [&](double part) {
    const auto section = cutter.at(root + part * length * axis, axis);
    return section.pieces == 1 &&
           std::abs(section.area / area - 1.0) < kUniform;
  });
}

}  // namespace

std::optional<BarOfPart> bar_of_part(const mesh::PartMesh<3>& mesh,
                                     const part::Material& material,
                                     double mass, const Vector3d& root,
                                     const Vector3d& tip,
                                     const Vector3d& direction) {
  const double length = (tip - root).norm();
  if (!(length > 0.0)) return std::nullopt;
  const Vector3d axis = (tip - root) / length;
  const double along = std::abs(axis.dot(direction));
  const bool is_rod = along > 1.0 - kAligned;
  if (!is_rod && along > kAligned) return std::nullopt;
  const auto middle = mesh::cut(mesh, root + 0.5 * length * axis, axis, kFine);
  if (middle.pieces != 1 ||
      !is_uniform(mesh, root, axis, length, middle.area)) {
    return std::nullopt;
  }
  BarSection section{
      .area = middle.area, .second_moment = 0.0, .section_modulus = 0.0};
  BarOfPart found;
  found.length = length;
  found.is_rod = is_rod;
  if (is_rod) {
    found.bar = found.published = rod(material, section, length);
  } else {
    double reach = 0.0;
    for (const Vector3d& point : middle.rim) {
      reach = std::max(reach, std::abs(direction.dot(point - middle.centroid)));
    }
    if (length < 4.0 * reach) return std::nullopt;
    section.second_moment = direction.dot(middle.second_moment * direction);
    section.section_modulus = section.second_moment / reach;
    found.bar = cantilever(material, section, length);
    found.published =
        cantilever(material, section, length, Formula::kPublished);
  }
  found.bar.mass = found.published.mass = mass;
  return found;
}

}  // namespace clevis::beam

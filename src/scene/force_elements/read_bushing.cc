#include "scene/force_elements/read_bushing.h"

#include "scene/element_base/line_source.h"
#include "scene/element_base/read_points.h"
#include "scene/motion/read_joints.h"

namespace clevis::scene {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using mechanism::BushingElement;

/// Frame J: z along `axis`, x along `normal` as far as it is across.
Matrix3d read_frame(StrictTable& table, std::string_view axis_key,
                    std::string_view normal_key, const Matrix3d& otherwise) {
  const auto axis = table.find(axis_key);
  const auto normal = table.find(normal_key);
  if (!axis && !normal) return otherwise;
  return joint_rotation(
      axis ? axis->direction() : Vector3d(otherwise.col(2)),
      normal ? normal->direction() : Vector3d(otherwise.col(0)),
      normal ? *normal : *axis);
}

/// Three values on the diagonal of a matrix, from an index on; zero without.
/// @return whether the key is there.
bool read_diagonal(StrictTable& table, std::string_view key,
                   Dimension dimension, Eigen::Index at,
                   double (*read)(const Value&, Dimension),
                   BushingElement::Matrix6& matrix) {
  const auto given = table.find(key);
  if (!given) return false;
  for (const Value& value : given->elements(3)) {
    matrix(at, at) = read(value, dimension);
    ++at;
  }
  return true;
}

}  // namespace

mechanism::ForceElement read_bushing(StrictTable& table, const Names& names) {
  BushingElement bushing;
  const auto points = read_points(table, names);
  bushing.a = points[0];
  bushing.b = points[1];
  bushing.R_AJ = read_frame(table, "axis", "normal", Matrix3d::Identity());
  bushing.R_BJ = read_frame(table, "axis_to", "normal_to", bushing.R_AJ);
  const bool is_stiff =
      read_diagonal(table, "stiffness", Dimension::kStiffness, 0,
                    plausible_stiffness_or_zero, bushing.stiffness) |
      read_diagonal(table, "angular_stiffness", Dimension::kAngularStiffness, 3,
                    plausible_stiffness_or_zero, bushing.stiffness);
  read_diagonal(table, "damping", Dimension::kDamping, 0, not_negative,
                bushing.damping);
  read_diagonal(table, "angular_damping", Dimension::kAngularDamping, 3,
                not_negative, bushing.damping);
  if (is_stiff && bushing.stiffness.isZero(0.0) &&
      bushing.damping.isZero(0.0)) {
    throw table.refusal("S006",
                        "has neither stiffness nor damping: all are zero",
                        "Give one above zero, or remove the force.");
  }
  if (!is_stiff) {
    throw table.refusal(
        "S003", "lacks the key \"stiffness\" or \"angular_stiffness\"",
        "Give three values along, or about, x, y and z of its frame.");
  }
  return bushing;
}

}  // namespace clevis::scene

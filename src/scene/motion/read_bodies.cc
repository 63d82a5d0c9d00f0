#include "scene/motion/read_bodies.h"

#include <cmath>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include "scene/motion/read_drives.h"
#include "scene/text/names.h"

namespace clevis::scene {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

Matrix3d rotation_from_axes(StrictTable& table) {
  const Vector3d x = table["x_axis"].direction();
  const Value second = table["y_axis"];
  const Vector3d y = second.direction();
  constexpr double kRightAngle = 1e-3;  // radians off: a typing error
  if (std::abs(x.dot(y)) > kRightAngle) {
    throw second.refusal("S006", "is not at a right angle to x_axis",
                         "Give two orthogonal directions.");
  }
  Matrix3d rotation;
  rotation.col(0) = x;
  rotation.col(1) = (y - y.dot(x) * x).normalized();
  rotation.col(2) = x.cross(rotation.col(1));
  return rotation;
}

mechanism::Pose read_placement(StrictTable table) {
  mechanism::Pose pose;
  if (const auto origin = table.find("origin")) {
    pose.p_WL = origin->vector(Dimension::kLength);
  }
  if (const auto angle = table.find("angle")) {
    pose.R_WL =
        Eigen::AngleAxisd(angle->quantity(Dimension::kAngle), Vector3d::UnitZ())
            .toRotationMatrix();
  } else if (table.has("x_axis") || table.has("y_axis")) {
    pose.R_WL = rotation_from_axes(table);
  }
  table.finish("beside \"angle\"");
  return pose;
}

/// Three principal values or a 3×3 matrix [kg m²].
Matrix3d read_inertia(const Value& value) {
  const auto rows = value.elements(3);
  Matrix3d inertia = Matrix3d::Zero();
  if (!rows[0].node().is_array()) {
    inertia.diagonal() = value.vector(Dimension::kMassMoment);
    return inertia;
  }
  for (Eigen::Index i = 0; i < 3; ++i) {
    inertia.row(i) =
        rows[static_cast<std::size_t>(i)].vector(Dimension::kMassMoment);
  }
  return inertia;
}

/// A rigid body's inertia is symmetric, positive definite, and no principal
/// moment exceeds the sum of the others (equal: a flat body).
void require_possible(const Matrix3d& inertia, const Value& value) {
  constexpr double kRoundOff = 1e-9;  // of numbers typed with ten digits
  const double size = inertia.cwiseAbs().maxCoeff();
  if ((inertia - inertia.transpose()).cwiseAbs().maxCoeff() >
      kRoundOff * size) {
    throw value.refusal("S006", "is not symmetric",
                        "Give the same ixy, ixz, iyz above and below the "
                        "diagonal.");
  }
  const Vector3d principal =
      Eigen::SelfAdjointEigenSolver<Matrix3d>(inertia).eigenvalues();
  if (!(principal[0] > 0.0)) {
    throw value.refusal("S006", "is not positive definite",
                        "Give positive moments of inertia about the centre "
                        "of mass.");
  }
  if (principal[2] > (principal[0] + principal[1]) * (1.0 + kRoundOff)) {
    throw value.refusal("S006",
                        "belongs to no body: its largest principal moment "
                        "exceeds the sum of the others",
                        "Check the moments about the centre of mass.");
  }
}

part::MassProperties read_mass_properties(StrictTable& table) {
  part::MassProperties properties;
  properties.mass = table["mass"].positive(Dimension::kMass);
  properties.p_LCm = table["center_of_mass"].vector(Dimension::kLength);
  const Value inertia = table["inertia"];
  properties.inertia_LCm = read_inertia(inertia);
  require_possible(properties.inertia_LCm, inertia);
  return properties;
}

mechanism::BodyDefinition read_body(StrictTable& table, Names& names) {
  mechanism::BodyDefinition body;
  const Value name = table["name"];
  body.name = name.name();
  body.place = table.place();
  if (body.name == "ground") {
    throw name.refusal("S008", "= \"ground\" is the name of the fixed frame",
                       "Call the body something else.");
  }
  names.bodies.add(body.name, name);
  if (const auto part = table.find("part")) {
    body.part = part->name();
    names.parts.find(body.part, *part);
  } else if (table.has("mass") || table.has("center_of_mass") ||
             table.has("inertia")) {
    body.mass_properties = read_mass_properties(table);
  } else {
    throw table.refusal("K006", "\"" + body.name + "\" has no mass",
                        "Give part, or mass, center_of_mass and inertia.");
  }
  body.is_placed = table.has("placement");
  if (body.is_placed) {
    body.placement = read_placement(table.table("placement"));
  }
  table.finish("beside \"part\", which brings the mass");
  return body;
}

}  // namespace

std::vector<mechanism::BodyDefinition> read_bodies(StrictTable& root,
                                                   Names& names) {
  std::vector<mechanism::BodyDefinition> bodies;
  for (StrictTable& table : root.tables("body")) {
    bodies.push_back(read_body(table, names));
  }
  return bodies;
}

mechanism::BodyIndex find_body_or_ground(const Value& name,
                                         const Names& names) {
  const std::string text = name.name();
  return text == "ground" ? mechanism::kGround : names.bodies.find(text, name);
}

}  // namespace clevis::scene

#pragma once

#include "loads/load_history.h"
#include "mechanism/definition.h"
#include "mechanism/motion.h"
#include "part/bore.h"
#include "part/mass_properties.h"
#include "part/part_definition.h"

namespace clevis::loads {

/// Where the groups of a part lie, as `mesh` found them.
struct GroupGeometry {
  std::string name;
  bool is_cylinder{};
  part::Bore cylinder;                                 ///< if is_cylinder
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();  ///< of the face area [m]
  double area{};                                       ///< [m²]
  /// ∫ n dA [m²] and ∫ p_LQ × n dA [m³], n the outward unit normal.
  Eigen::Vector3d area_vector = Eigen::Vector3d::Zero();
  Eigen::Vector3d area_moment = Eigen::Vector3d::Zero();
  /// ∫ n nᵀ dA [m²]: of rank one where the group is flat, or walls that face
  /// each other.
  Eigen::Matrix3d normal_square = Eigen::Matrix3d::Zero();
  Eigen::Matrix3Xd points = {};  ///< of its faces, which they span [m]
};

/// The motion without the instants at change points: what stands there are
/// reactions of joints that give way, in balance in the deflected position
/// only.
mechanism::Motion loading_motion(mechanism::Motion motion);

/// Loads on a part over the motion of its body: reactions, drive efforts,
/// forces of the scene, inertia and gravity, in frame L.
///
/// Joints, drives and forces become seats. While a sliding drive pushes, its
/// effort over the area of its face is also the pressure of the surface loads
/// on the `pressurized` groups; a gas cylinder puts its gas's there.
/// @throws Error L001 if an instant is out of balance by more than 1e-9 of its
///   load, L002 if a group cannot take what its joint transmits, L003 if a
///   seat's cylinder and its joint do not coincide (1e-6 of the part's size),
///   L004 if a joint, drive or force of the body has no seat, M003 if a group
///   is missing.
LoadHistory part_loads(const mechanism::MechanismDefinition& definition,
                       const mechanism::Motion& motion,
                       mechanism::BodyIndex body,
                       const part::PartDefinition& part,
                       const std::vector<GroupGeometry>& groups,
                       const part::MassProperties& mass);

/// Loads of one `[[part.case]]`: pins become bearing seats, pressure and
/// traction surface loads. A case without `fixed` must be in balance with its
/// inertia.
/// @throws Error L001, L002, M003.
LoadHistory case_loads(const part::PartDefinition& part,
                       const part::LoadCaseDefinition& load_case,
                       const std::vector<GroupGeometry>& groups,
                       const part::MassProperties& mass);

/// Residual force [N] and moment about Lo [N m] of an instant: seats, surface
/// loads and inertia.
Wrench residual(const LoadHistory& history, const InstantLoad& instant,
                const part::MassProperties& mass);

}  // namespace clevis::loads

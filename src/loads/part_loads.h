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
  part::Bore cylinder;  ///< if is_cylinder
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();  ///< of the face area [m]
  double area{};                                       ///< [m²]
};

/// Loads on a part over the motion of its body: reactions, drive efforts,
/// inertia and gravity, in frame L.
///
/// @throws Error L003 if a seat's group and its joint do not coincide (1e-6
///   of the part's size), M003 if a group is missing, L001 if an instant is
///   out of balance by more than 1e-9 of its load.
LoadHistory part_loads(const mechanism::MechanismDefinition& definition,
                       const mechanism::Motion& motion,
                       mechanism::BodyIndex body,
                       const part::PartDefinition& part,
                       const std::vector<GroupGeometry>& groups,
                       const part::MassProperties& mass);

/// Loads of one `[[part.case]]`. Pins, pressure and traction become seats.
/// A case without `fixed` must be in balance with its inertia.
/// @throws Error L001, M003.
LoadHistory case_loads(const part::PartDefinition& part,
                       const part::LoadCaseDefinition& load_case,
                       const std::vector<GroupGeometry>& groups,
                       const part::MassProperties& mass);

/// Residual force [N] and moment about Lo [N m] of an instant.
Wrench residual(const LoadHistory& history, const InstantLoad& instant,
                const part::MassProperties& mass);

}  // namespace clevis::loads

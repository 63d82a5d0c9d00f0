#pragma once

#include <optional>

#include <Eigen/Core>

#include "elasticity/holds/pin_hold.h"
#include "elasticity/problem/displacement_basis.h"
#include "loads/history/load_history.h"
#include "loads/holds/holding_groups.h"

namespace clevis::stress {

/// Removes from every column of the basis the rigid motion of what holds the
/// part. By groups: the mean displacement of the first one's surface, the
/// rotation that keeps the mean of the second one's on the line between both,
/// and (dim = 3) the first one's mean rotation about that line. With one group,
/// or two about one centre, all of its mean rotation; with none that of all
/// nodes. Else by the combinations of mean motions that are held; the groups'
/// hold what these leave. Means are over the surfaces' area.
/// @param hold  a plane mesh has none of the groups of its upper and lower
///   side, which do not count.
/// @param touched  of the slides that hold; nothing: all of their walls.
template <int dim>
void remove_rigid_motion(elasticity::DisplacementBasis<dim>& basis,
                         const loads::PartHold& hold,
                         std::optional<elasticity::TouchedSeats> touched = {});

/// Adds rigid motions to the displacements of each instant.
/// @param rigid    displacements, dofs × motions [1].
/// @param amounts  motions × instants [m].
template <int dim>
void add_rigid_motions(const Eigen::MatrixXd& rigid,
                       const Eigen::MatrixXd& amounts,
                       elasticity::DisplacementBasis<dim>& basis);

/// Of a part that the mechanism holds otherwise at other instants of a motion:
/// its displacements refer to each one's hold. The basis gets the rigid motions
/// for that.
/// @param groups  of loads::holding_groups().
template <int dim>
void refer_to_instants(const loads::LoadHistory& history,
                       const loads::HoldingGroups& groups,
                       elasticity::DisplacementBasis<dim>& basis);

}  // namespace clevis::stress

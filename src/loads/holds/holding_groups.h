#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "loads/history/load_history.h"

namespace clevis::loads {

/// Groups that hold a part as a whole, by holder_of(): of a mechanism in the
/// order of their names, of cases and histories in that of their seats.
using HoldingGroups = std::vector<std::string>;

/// What a seat holds by: its group; of a slide that shares it with other seats
/// a name of its own, for it touches a place of its own on the wall.
std::string holder_of(const std::vector<Seat>& seats, std::size_t seat);

/// The group of a holder.
std::string group_of(const std::string& holder);

/// The ways in which the mechanism holds a part: by two groups, neither of
/// which gives way across the line between both; else by one that lets it
/// neither move nor turn, as a weld or the driven pin of a lever; else, where
/// the mechanism is free to move, by each two groups that hold at all, or the
/// only one. A seat that only carries a force, or a body that nothing holds, is
/// none. Empty groups: the part is free. Likewise the pins that hold it in a
/// case; where nothing is known, each two bearing seats that are no force's.
/// @return at least one.
std::vector<HoldingGroups> holding_groups(const LoadHistory& history);

/// Groups that the displacements of a part refer to: the first of
/// holding_groups(); of a part that force elements alone hold, those of their
/// seats that yield, the first and the farthest from it.
HoldingGroups reference_groups(const LoadHistory& history);

/// What is held of a group's mean motion about p_LS, among all that the
/// mechanism holds: columns of wrenches, 6 × columns, the same for all groups.
/// A guide that turns about a pin holds across only together with a turn.
struct GroupHold {
  std::string group;         ///< by holder_of()
  Eigen::Vector3d p_LS;      ///< of its first seat [m]
  Eigen::MatrixXd wrenches;  ///< forces [N], moments [N m]
};

/// At a time [s]. @pre the history has a hold.
std::vector<GroupHold> held_groups(const LoadHistory& history, double time);

/// How a part is held as a whole.
struct PartHold {
  /// Of two the first holds the turn about the line between both.
  HoldingGroups groups;
  /// In their place all that the mechanism holds; the groups hold what is left.
  /// Empty: the groups alone.
  std::vector<GroupHold> held = {};
  /// Force elements on the part itself hold before the groups what `held`
  /// leaves, each as hard as it is stiff: forces [√(N/m)], moments [m √(N/m)].
  std::vector<GroupHold> sprung = {};
};

/// At a time [s]: by the groups alone where each of their six conditions is
/// among what the mechanism holds, or where nothing is known of that.
/// @param groups  of holding_groups().
PartHold hold_at(const LoadHistory& history, const HoldingGroups& groups,
                 double time);

/// What displacements refer to at a time [s]: hold_at(), and force elements.
/// @param groups  of reference_groups().
PartHold reference_at(const LoadHistory& history, const HoldingGroups& groups,
                      double time);

/// Whether the same is held but for 1e-4 of unit wrenches, and of the
/// stiffness.
bool are_alike(const PartHold& one, const PartHold& other);

/// Whether the same is held but for 1e-4 of unit wrenches.
bool are_alike(const std::vector<GroupHold>& one,
               const std::vector<GroupHold>& other);

/// Whether more is held than balance needs: how much each bears, and bends,
/// depends on what the joints yield and on their play.
bool is_redundant(const std::vector<GroupHold>& held);

}  // namespace clevis::loads

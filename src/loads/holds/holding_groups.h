#pragma once

#include <string>
#include <vector>

#include "loads/history/load_history.h"

namespace clevis::loads {

/// Groups that hold a part as a whole, first in the order of the seats.
using HoldingGroups = std::vector<std::string>;

/// The ways in which the mechanism holds a part: by two groups, neither of
/// which gives way across the line between both; else by one that lets it
/// neither move nor turn, as a weld or the driven pin of a lever; else, where
/// the mechanism is free to move, by each two groups that hold at all, or the
/// only one. A seat that only carries a force, or a body that nothing holds, is
/// none. Empty groups: the part is free. Likewise the pins that hold it in a
/// case; where nothing is known, each two bearing seats.
/// @return at least one.
std::vector<HoldingGroups> holding_groups(const LoadHistory& history);

}  // namespace clevis::loads

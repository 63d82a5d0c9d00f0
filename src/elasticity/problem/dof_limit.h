#pragma once

#include <functional>
#include <optional>
#include <string>

namespace clevis::elasticity {

/// Degrees of freedom that a solution of a part may have at most; absent: as
/// many as the memory holds.
using DofLimit = std::optional<int>;

/// Hears, before a solution is made, how many degrees of freedom it has.
using DofListener = std::function<void(double dofs)>;

/// @param dofs  of the solution, mirrored halves counted in.
/// @throws Error F007 if they are more than the limit, before anything is
///   assembled.
void require_dofs(double dofs, DofLimit limit, const std::string& place);

}  // namespace clevis::elasticity

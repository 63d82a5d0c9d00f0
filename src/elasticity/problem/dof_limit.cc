#include "elasticity/problem/dof_limit.h"

#include <fmt/format.h>

#include "base/messages/errors.h"

namespace clevis::elasticity {

void require_dofs(double dofs, DofLimit limit, const std::string& place) {
  if (!limit || dofs <= *limit) return;
  throw Error("F007", place,
              fmt::format("{:.0f} degrees of freedom, --max-dofs allows {}",
                          dofs, *limit),
              fmt::format("Give --max-dofs {:.0f} or more, or mesh the part "
                          "coarser.",
                          dofs));
}

}  // namespace clevis::elasticity

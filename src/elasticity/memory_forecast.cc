#include "elasticity/memory_forecast.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <unistd.h>

#include "base/errors.h"

namespace clevis::elasticity {

double factor_bytes(int dim, double dofs) {
  const double n = std::max(dofs, 2.0);
  const double entries =
      dim == 3 ? 11.0 * std::pow(n, 4.0 / 3.0) : 8.0 * n * std::log2(n);
  return 8.0 * entries;
}

void require_memory(int dim, double dofs, double available,
                    const std::string& place) {
  constexpr double kUsable = 0.8;  // the rest of the solve needs some too
  constexpr double kGibi = 1024.0 * 1024.0 * 1024.0;
  const double bytes = factor_bytes(dim, dofs);
  if (bytes <= kUsable * available) return;
  throw Error("F004", place,
              fmt::format("{:.3g} degrees of freedom would need about {:.3g} "
                          "GiB for the factorisation, this machine has {:.3g}",
                          dofs, bytes / kGibi, available / kGibi),
              "mesh the part coarser");
}

double physical_memory() {
  return static_cast<double>(sysconf(_SC_PHYS_PAGES)) *
         static_cast<double>(sysconf(_SC_PAGE_SIZE));
}

}  // namespace clevis::elasticity

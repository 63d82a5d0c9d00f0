#include "elasticity/direct/memory_forecast.h"

#include <algorithm>
#include <cmath>
#include <fstream>

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include "base/messages/errors.h"

namespace clevis::elasticity {

namespace {

constexpr double kUsable = 0.8;  // the rest of the solve needs some too

void require(double bytes, double dofs, const char* what, double available,
             const std::string& place) {
  constexpr double kGibi = 1024.0 * 1024.0 * 1024.0;
  if (bytes <= kUsable * available) return;
  throw Error("F004", place,
              fmt::format("{:.3g} degrees of freedom would need about {:.3g} "
                          "GiB for {}, {:.3g} can be had",
                          dofs, bytes / kGibi, what, available / kGibi),
              "Mesh the part coarser.");
}

}  // namespace

double factor_bytes(int dim, double dofs) {
  const double n = std::max(dofs, 2.0);
  const double entries =
      dim == 3 ? 11.0 * std::pow(n, 4.0 / 3.0) : 8.0 * n * std::log2(n);
  return 8.0 * entries;
}

bool holds(double bytes, double available) {
  return bytes <= kUsable * available;
}

void require_memory(double bytes, double dofs, double available,
                    const std::string& place) {
  require(bytes, dofs, "the factorisation", available, place);
}

double multigrid_bytes(int degree, int coarse, double dofs, double columns) {
  constexpr double kBlock = 16.0;  // columns at a time
  const double p = degree;
  const double vectors = kBlock * (6.0 * 8.0 + 5.0 * 4.0);
  const double double_points = std::pow((p + 2.0) / p, 3) / 3.0;
  const double single_points = std::pow((p + 1.0) / p, 3) / 3.0;
  const double metric = 80.0 * double_points + 40.0 * single_points;
  const double numbers = 4.0 * 4.0 * single_points;
  const double inner_levels = coarse == 1 && degree > 2 ? 1.3 : 1.0;
  const double dense = 8.0 * 5.0 * columns;  // loads, solution, their checks
  const double coarse_dofs = dofs * std::pow(coarse / p, 3);
  const double coarse_matrix = coarse_dofs * (coarse == 1 ? 1200.0 : 3000.0);
  return dofs * ((vectors + metric + numbers) * inner_levels + dense) +
         coarse_matrix + factor_bytes(3, coarse_dofs);
}

void require_multigrid_memory(int degree, int coarse, double dofs,
                              double columns, double available,
                              const std::string& place) {
  require(multigrid_bytes(degree, coarse, dofs, columns), dofs,
          "the iterative solution", available, place);
}

void require_dealii_memory(double dofs, double available,
                           const std::string& place) {
  constexpr double kBytesPerDof = 1500.0;  // measured at degree 3, with MUMPS
  require(kBytesPerDof * dofs, dofs, "deal.II's levels", available, place);
}

double usable_memory() {
  double bytes = static_cast<double>(sysconf(_SC_PHYS_PAGES)) *
                 static_cast<double>(sysconf(_SC_PAGE_SIZE));
  rlimit limit{};
  if (getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY) {
    bytes = std::min(bytes, static_cast<double>(limit.rlim_cur));
  }
  // Version 2 says "max" and version 1 a number beyond any machine's memory
  // where there is no limit.
  for (const char* path : {"/sys/fs/cgroup/memory.max",
                           "/sys/fs/cgroup/memory/memory.limit_in_bytes"}) {
    double group = 0.0;
    if (std::ifstream(path) >> group) bytes = std::min(bytes, group);
  }
  return bytes;
}

}  // namespace clevis::elasticity

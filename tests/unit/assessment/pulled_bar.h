#pragma once

#include <cmath>
#include <utility>
#include <vector>

#include "assessment/job/part_job.h"
#include "mesh/quality/mass_properties.h"
#include "support/structured_mesh.h"

namespace clevis::assessment {

/// No lateral contraction: waves along the bar keep their shape.
inline const part::Material kCork{"cork", 70e9, 0.0, 2700.0, 300e6};
inline const Eigen::Vector3d kSize(0.3, 0.02, 0.01);
inline constexpr double kPull = 40e6;  // [Pa]

/// Of a wave along the bar [s].
inline double transit() {
  return kSize.x() * std::sqrt(kCork.density / kCork.youngs_modulus);
}

inline loads::InstantLoad pulled(double time, double share) {
  loads::InstantLoad instant;
  instant.time = time;
  instant.label = "t";
  for (const auto& [name, side] : {std::pair{"x0", -1.0}, {"x1", 1.0}}) {
    loads::SurfaceLoad load;
    load.group = name;
    load.traction.x() = side * share * kPull;
    load.resultant.force = kSize.y() * kSize.z() * load.traction;
    load.total = load.resultant.force.norm();
    instant.surface_loads.push_back(load);
  }
  return instant;
}

/// A free bar that is pulled at both ends, by what rises evenly from t = 0 and
/// stays.
inline PartJob bar(double rise) {
  PartJob job;
  job.part.name = "bar";
  job.part.material = kCork;
  job.mesh = support::structured_mesh<3>(
      {20, 1, 1}, 1, [](const Eigen::Vector3d& x) -> Eigen::Vector3d {
        return kSize.cwiseProduct(x - Eigen::Vector3d(0.0, 0.5, 0.5));
      });
  job.mass = mesh::mass_properties(job.mesh, kCork.density);
  LoadSet set;
  const double end = 20.0 * transit(), side = 1e-9 * transit();
  for (const auto& [t, share] :
       std::vector<std::pair<double, double>>{{-transit(), 0.0},
                                              {-side, 0.0},
                                              {0.0, 0.0},
                                              {rise, 1.0},
                                              {rise + side, 1.0},
                                              {end, 1.0}}) {
    set.history.instants.push_back(pulled(t, share));
  }
  job.load_sets.push_back(set);
  job.impact_loads.push_back(
      {.name = "touch", .duration = end, .rise_time = rise, .touches = {0.0}});
  return job;
}

}  // namespace clevis::assessment

#pragma once

#include <Eigen/Geometry>

#include "calculix/model.h"
#include "support/structured_mesh.h"

namespace clevis::calculix {

/// A unit cube [m] under `pressure` on its side x1, held at x0.
inline Model pressed_cube(int divisions, double pressure,
                          Hexahedron hexahedron = Hexahedron::kFull) {
  const auto mesh = support::structured_mesh<3>(
      {divisions, divisions, divisions}, 1, [](const Eigen::Vector3d& x) {
        return x;
      });
  loads::InstantLoad instant;
  instant.label = "push";
  loads::SurfaceLoad load;
  load.group = "x1";
  load.pressure = pressure;
  load.resultant.force = {-pressure, 0.0, 0.0};
  load.resultant.moment =
      Eigen::Vector3d(1.0, 0.5, 0.5).cross(load.resultant.force);
  load.total = pressure;
  instant.surface_loads = {load};
  loads::LoadHistory history;
  history.instants = {instant};
  const part::Material steel{.name = "steel",
                             .youngs_modulus = 210e9,
                             .poissons_ratio = 0.3,
                             .density = 7850.0,
                             .yield_strength = 355e6};
  return make_model(
      {mesh, steel, history, {{"x0", {true, false, false}}}, "cube"},
      hexahedron);
}

}  // namespace clevis::calculix

#pragma once

#include <cmath>

#include <Eigen/Geometry>

#include "elasticity/problem/displacement_basis.h"
#include "elasticity/problem/elastic_problem.h"
#include "mesh/quality/mass_properties.h"
#include "support/annulus_mesh.h"

namespace clevis::support {

/// A free 3-D ring: a pin presses on its bore, its rim carries the opposite
/// force, and it accelerates with what is left. Everything an elastic problem
/// consists of, so that it can be moved, scaled and renumbered as one.
struct EyeProblem {
  mesh::PartMesh<3> mesh;
  part::Material material{"steel", 210e9, 0.3, 7850.0, 355e6};
  loads::LoadHistory history;

  elasticity::ElasticProblem<3> problem() const {
    return {mesh, material, history, {}, "eye"};
  }
};

/// @param instants  directions of the pin's force, spread over the circle.
/// @param geometry_degree  of the mesh.
inline EyeProblem eye_problem(int instants, int geometry_degree = 2) {
  EyeProblem eye;
  const Annulus ring{.inner = 0.01,
                     .outer = 0.02,
                     .thickness = 0.008,
                     .radial = 1,
                     .angular = 8,
                     .axial = 1,
                     .degree = geometry_degree};
  eye.mesh = ring_mesh<3>(ring);
  const double mass =
      mesh::mass_properties(eye.mesh, eye.material.density).mass;
  const Eigen::Vector3d centre(0.0, 0.0, ring.thickness / 2);
  eye.history.seats = {{"pin", "x0", loads::SeatKind::kBearing, centre},
                       {"rim", "x1", loads::SeatKind::kTraction, centre}};
  for (int i = 0; i < instants; ++i) {
    const double angle = 0.3 + 0.7 * i;
    const Eigen::Vector3d pin(4000.0 * std::cos(angle),
                              4000.0 * std::sin(angle), 300.0 * (i + 1));
    const Eigen::Vector3d moment(0.4, -0.2, 3.0 + i);
    const Eigen::Vector3d rest(5.0, -3.0 * i, 2.0);
    loads::InstantLoad instant;
    instant.wrenches = {{pin, moment}, {rest - pin, -moment}};
    instant.rigid.acceleration = rest / mass;
    eye.history.instants.push_back(instant);
  }
  return eye;
}

/// The same part and loads elsewhere: p' = R p + d.
inline EyeProblem moved(EyeProblem eye, const Eigen::Matrix3d& R,
                        const Eigen::Vector3d& d) {
  for (auto& vertex : eye.mesh.vertices) vertex = R * vertex + d;
  for (auto& points : eye.mesh.cell_points) {
    points = ((R * points).colwise() + d).eval();
  }
  for (auto& group : eye.mesh.groups) {
    if (!group.cylinder) continue;
    group.cylinder->p_LC = R * group.cylinder->p_LC + d;
    group.cylinder->axis_L = R * group.cylinder->axis_L;
  }
  for (auto& seat : eye.history.seats) seat.p_LS = R * seat.p_LS + d;
  for (auto& instant : eye.history.instants) {
    for (auto& wrench : instant.wrenches) {
      wrench.force = R * wrench.force;
      wrench.moment = R * wrench.moment;
    }
    instant.rigid.acceleration = R * instant.rigid.acceleration;
  }
  return eye;
}

/// The same part in units of length `length` and of force `force` [m, N],
/// time unchanged.
inline EyeProblem in_units(EyeProblem eye, double length, double force) {
  for (auto& vertex : eye.mesh.vertices) vertex /= length;
  for (auto& points : eye.mesh.cell_points) points /= length;
  for (auto& group : eye.mesh.groups) {
    if (!group.cylinder) continue;
    group.cylinder->p_LC /= length;
    group.cylinder->radius /= length;
    group.cylinder->length /= length;
  }
  const double pressure = force / (length * length);
  eye.material.youngs_modulus /= pressure;
  eye.material.density *= length * length * length * length / force;
  for (auto& seat : eye.history.seats) seat.p_LS /= length;
  for (auto& instant : eye.history.instants) {
    for (auto& wrench : instant.wrenches) {
      wrench.force /= force;
      wrench.moment /= force * length;
    }
    instant.rigid.acceleration /= length;
  }
  return eye;
}

}  // namespace clevis::support

#pragma once

#include <string>

#include <Eigen/Geometry>

#include "assessment/job/part_job.h"
#include "mesh/basis/tensor_basis.h"
#include "mesh/quality/mass_properties.h"
#include "part/supports.h"

namespace clevis::support {

/// The plate of a plane mesh as one layer of hexahedra, from z = 0 up. Side
/// groups as in the plane, lids unnamed.
inline mesh::PartMesh<3> extruded(const mesh::PartMesh<2>& plane) {
  mesh::PartMesh<3> solid;
  solid.degree = plane.degree;
  solid.groups = plane.groups;
  const auto n = static_cast<unsigned>(plane.vertices.size());
  for (const double z : {0.0, plane.thickness}) {
    for (const auto& v : plane.vertices)
      solid.vertices.emplace_back(v[0], v[1], z);
  }
  const Eigen::VectorXd heights = mesh::gauss_lobatto(plane.degree);
  for (std::size_t c = 0; c < plane.cells.size(); ++c) {
    auto cell = plane.cells[c];
    for (const unsigned v : plane.cells[c]) cell.push_back(v + n);
    solid.cells.push_back(cell);
    const auto& flat = plane.cell_points[c];
    Eigen::Matrix3Xd points(3, flat.cols() * heights.size());
    for (Eigen::Index k = 0; k < heights.size(); ++k) {
      auto layer = points.middleCols(k * flat.cols(), flat.cols());
      layer.topRows<2>() = flat;
      layer.row(2).setConstant(heights[k] * plane.thickness);
    }
    solid.cell_points.push_back(points);
    const int index = static_cast<int>(c);
    solid.boundary.push_back({index, 4, -1});
    solid.boundary.push_back({index, 5, -1});
  }
  solid.boundary.insert(solid.boundary.end(), plane.boundary.begin(),
                        plane.boundary.end());
  return solid;
}

/// Area and centroid of a group by its flat faces' corners.
struct FlatFace {
  double area{};
  Eigen::Vector3d centroid = Eigen::Vector3d::Zero();
};
inline FlatFace flat_face(const mesh::PartMesh<3>& mesh,
                          const std::string& name) {
  FlatFace result;
  for (const auto& face : mesh.boundary) {
    if (face.group < 0 ||
        mesh.groups[static_cast<std::size_t>(face.group)].name != name) {
      continue;
    }
    const auto& cell = mesh.cells[static_cast<std::size_t>(face.cell)];
    std::vector<Eigen::Vector3d> p;
    for (std::size_t v = 0; v < 8; ++v) {
      if (((static_cast<int>(v) >> (face.face / 2)) & 1) == face.face % 2) {
        p.push_back(mesh.vertices[cell[v]]);
      }
    }
    for (const auto& [a, b, c] : {std::array{0, 1, 2}, {1, 3, 2}}) {
      const auto at = [&](int k) -> const Eigen::Vector3d& {
        return p[static_cast<std::size_t>(k)];
      };
      const double area = 0.5 * (at(b) - at(a)).cross(at(c) - at(a)).norm();
      result.area += area;
      result.centroid += area * (at(a) + at(b) + at(c)) / 3.0;
    }
  }
  result.centroid /= result.area;
  return result;
}

/// A part of steel with one load case; tractions per group of flat faces.
inline assessment::PartJob job_of(
    mesh::PartMesh<3> mesh,
    const std::map<std::string, Eigen::Vector3d>& tractions,
    const part::Supports& fixed, double poissons_ratio = 0.3) {
  assessment::PartJob job;
  job.part.name = "part";
  job.part.material = {"steel", 210e9, poissons_ratio, 7850.0, 355e6};
  job.mesh = std::move(mesh);
  job.mass = mesh::mass_properties(job.mesh, 7850.0);
  assessment::LoadSet set;
  set.fixed = fixed;
  loads::InstantLoad instant;
  instant.label = "case";
  for (const auto& [group, traction] : tractions) {
    const FlatFace face = flat_face(job.mesh, group);
    loads::SurfaceLoad load;
    load.group = group;
    load.traction = traction;
    load.resultant.force = face.area * traction;
    load.resultant.moment = face.centroid.cross(load.resultant.force);
    load.total = face.area * traction.norm();
    instant.surface_loads.push_back(load);
  }
  set.history.instants.push_back(instant);
  job.load_sets.push_back(set);
  return job;
}

}  // namespace clevis::support

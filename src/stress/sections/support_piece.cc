#include "stress/sections/support_piece.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <optional>
#include <set>

#include <Eigen/Geometry>

#include "base/algebra/append_columns.h"
#include "elasticity/fe_space/group_trace.h"
#include "part/supports.h"

namespace clevis::stress {
namespace {

using Eigen::Index;
using Eigen::Matrix3Xd;
using Eigen::Vector3d;

/// Faces that hang together, with their quadrature.
struct Patch {
  std::set<std::string> groups;
  std::set<int> nodes;
  std::vector<elasticity::GroupFace> faces;
  elasticity::GroupTrace trace;  // its `faces` are not kept

  void add(const Patch& other) {
    groups.insert(other.groups.begin(), other.groups.end());
    nodes.insert(other.nodes.begin(), other.nodes.end());
    faces.insert(faces.end(), other.faces.begin(), other.faces.end());
    append_columns(other.trace.quadrature.points, trace.quadrature.points);
    append_columns(other.trace.outward, trace.outward);
    auto& weights = trace.quadrature.weights;
    const auto& more = other.trace.quadrature.weights;
    weights.conservativeResize(weights.size() + more.size());
    weights.tail(more.size()) = more;
  }
};

bool meet(const Patch& a, const Patch& b) {
  return std::ranges::any_of(a.nodes, [&](int node) {
    return b.nodes.contains(node);
  });
}

/// Joins those that meet in one plane, until none does.
void join(std::vector<Patch>& patches) {
  constexpr double kPlane = 1e-6;
  for (std::size_t i = 0; i < patches.size(); ++i) {
    for (std::size_t j = i + 1; j < patches.size();) {
      const double turned =
          (patches[i].trace.outward.col(0) - patches[j].trace.outward.col(0))
              .norm();
      if (turned > kPlane || !meet(patches[i], patches[j])) {
        ++j;
        continue;
      }
      patches[i].add(patches[j]);
      patches.erase(patches.begin() + static_cast<std::ptrdiff_t>(j));
      j = i + 1;  // the larger one may meet others
    }
  }
}

/// For each of the faces the first one that it hangs together with.
std::vector<std::size_t> connected(
    const std::vector<elasticity::GroupTrace::Face>& faces) {
  std::vector<std::size_t> root(faces.size());
  std::iota(root.begin(), root.end(), 0);
  const auto find = [&](std::size_t k) {
    while (root[k] != k) k = root[k] = root[root[k]];
    return k;
  };
  std::map<int, std::size_t> first;  // face of each node
  for (std::size_t k = 0; k < faces.size(); ++k) {
    for (const int node : faces[k].nodes) {
      const std::size_t a = find(k),
                        b = find(first.try_emplace(node, k).first->second);
      root[std::max(a, b)] = std::min(a, b);
    }
  }
  for (std::size_t k = 0; k < root.size(); ++k) root[k] = find(k);
  return root;
}

/// The connected pieces of a group.
template <int dim>
std::vector<Patch> pieces_of(
    const elasticity::Discretization<dim>& discretization, std::size_t group) {
  elasticity::FaceTables<dim> tables;
  const auto trace =
      elasticity::group_trace(discretization, static_cast<int>(group), tables);
  const auto root = connected(trace.faces);
  std::vector<Index> begin(root.size() + 1, 0);
  for (std::size_t k = 0; k < root.size(); ++k) {
    begin[k + 1] = begin[k] + trace.faces[k].values->rows();
  }
  std::vector<Patch> patches;
  for (std::size_t first = 0; first < root.size(); ++first) {
    if (root[first] != first) continue;
    Patch patch;
    patch.groups = {discretization.groups[group].name};
    std::vector<Index> points;
    for (std::size_t k = first; k < root.size(); ++k) {
      if (root[k] != first) continue;
      patch.nodes.insert(trace.faces[k].nodes.begin(),
                         trace.faces[k].nodes.end());
      patch.faces.push_back(discretization.group_faces[group][k]);
      for (Index q = begin[k]; q < begin[k + 1]; ++q) points.push_back(q);
    }
    patch.trace.quadrature.points = trace.quadrature.points(Eigen::all, points);
    patch.trace.quadrature.weights = trace.quadrature.weights(points);
    patch.trace.outward = trace.outward(Eigen::all, points);
    patches.push_back(std::move(patch));
  }
  return patches;
}

/// Points of the faces: corners of straight ones, of curved ones as many
/// between as a circle's radius needs to a few 1e-4.
template <int dim>
Matrix3Xd points_of(const elasticity::Discretization<dim>& discretization,
                    const std::vector<elasticity::GroupFace>& faces) {
  constexpr std::size_t kMany = 200;
  const bool curved = discretization.mapping_degree().highest() > 1;
  const int parts = !curved ? 1 : faces.size() < kMany ? 16 : 4;
  const auto lattice = elasticity::lattice<dim>(discretization.shape, parts);
  std::map<int, elasticity::Tabulation> tables;
  std::vector<Vector3d> points;
  for (const auto& [cell, face] : faces) {
    if (!tables.contains(face)) {
      const auto rule =
          elasticity::face_gauss<dim>(discretization.shape, face, 1);
      std::vector<Index> on;
      for (Index q = 0; q < lattice.cols(); ++q) {
        const Eigen::Matrix<double, dim, 1> arm =
            lattice.col(q) - rule.points.col(0);
        if (std::abs(arm.dot(rule.outward)) < 1e-9) on.push_back(q);
      }
      const elasticity::ReferencePoints<dim> some = lattice(Eigen::all, on);
      tables.emplace(face, elasticity::tabulate_geometry<dim>(
                               discretization.shape,
                               discretization.mapping_degree(), some));
    }
    const Eigen::Matrix<double, dim, Eigen::Dynamic> at =
        discretization.cell_points[static_cast<std::size_t>(cell)] *
        tables.at(face).values.transpose();
    for (Index q = 0; q < at.cols(); ++q) {
      Vector3d point = Vector3d::Constant(discretization.mid_plane_z);
      point.template head<dim>() = at.col(q);
      points.push_back(point);
    }
  }
  Matrix3Xd all(3, static_cast<Index>(points.size()));
  for (std::size_t q = 0; q < points.size(); ++q) {
    all.col(static_cast<Index>(q)) = points[q];
  }
  return all;
}

/// The farthest points in all directions of the plane.
Matrix3Xd outermost(const Matrix3Xd& points, const Vector3d& normal) {
  constexpr int kDirections = 360;
  const Vector3d x = normal.unitOrthogonal(), y = normal.cross(x);
  std::set<Index> far;
  for (int k = 0; k < kDirections; ++k) {
    const double angle = 2.0 * std::numbers::pi * k / kDirections;
    Index at = 0;
    ((std::cos(angle) * x + std::sin(angle) * y).transpose() * points)
        .maxCoeff(&at);
    far.insert(at);
  }
  return points(Eigen::all, std::vector<Index>(far.begin(), far.end()));
}

}  // namespace

template <int dim>
std::vector<SupportPiece> support_pieces(
    const elasticity::Discretization<dim>& discretization,
    const part::Supports& fixed) {
  std::vector<Patch> patches;
  for (std::size_t g = 0; g < discretization.groups.size(); ++g) {
    if (!fixed.contains(discretization.groups[g].name)) continue;
    for (Patch& patch : pieces_of(discretization, g)) {
      if (plane_section(patch.trace)) patches.push_back(std::move(patch));
    }
  }
  join(patches);
  std::vector<SupportPiece> pieces;
  for (const Patch& patch : patches) {
    const auto section = plane_section(patch.trace);
    pieces.push_back(
        {{patch.groups.begin(), patch.groups.end()},
         *section,
         {patch.nodes.begin(), patch.nodes.end()},
         outermost(points_of(discretization, patch.faces), section->normal)});
  }
  return pieces;
}

template std::vector<SupportPiece> support_pieces<2>(
    const elasticity::Discretization<2>&, const part::Supports&);
template std::vector<SupportPiece> support_pieces<3>(
    const elasticity::Discretization<3>&, const part::Supports&);

}  // namespace clevis::stress

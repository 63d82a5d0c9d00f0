#include "elasticity/holds/bore_pieces.h"

#include <algorithm>
#include <map>
#include <numeric>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "elasticity/fe_space/group_trace.h"

namespace clevis::elasticity {
namespace {

using Eigen::Index;
using Eigen::Matrix3Xd;
using Eigen::Vector3d;

constexpr Index kMotion = 6;

std::size_t at(Index i) {
  return static_cast<std::size_t>(i);
}

/// Nodes of faces that hang together by common nodes, by node of the part.
std::vector<std::vector<bool>> connected_nodes(
    const std::vector<std::vector<int>>& faces, int nodes) {
  std::vector<int> root(static_cast<std::size_t>(nodes));
  std::iota(root.begin(), root.end(), 0);
  const auto find = [&root](int node) {
    while (root[static_cast<std::size_t>(node)] != node) {
      node = root[static_cast<std::size_t>(node)] =
          root[static_cast<std::size_t>(root[static_cast<std::size_t>(node)])];
    }
    return node;
  };
  for (const auto& face : faces) {
    for (const int node : face) {
      root[static_cast<std::size_t>(find(node))] = find(face.front());
    }
  }
  std::map<int, std::vector<bool>> pieces;
  for (const auto& face : faces) {
    auto& piece = pieces[find(face.front())];
    piece.resize(static_cast<std::size_t>(nodes), false);
    for (const int node : face) {
      piece[static_cast<std::size_t>(node)] = true;
    }
  }
  std::vector<std::vector<bool>> result;
  for (auto& [first, piece] : pieces) result.push_back(std::move(piece));
  return result;
}

std::vector<std::vector<int>> nodes_of_faces(
    const Discretization<3>& discretization, std::size_t group) {
  FaceTables<3> tables;
  std::vector<std::vector<int>> faces;
  for (const GroupFace& face : discretization.group_faces[group]) {
    const auto& nodes =
        discretization.cell_nodes[static_cast<std::size_t>(face.cell)];
    auto& of_face = faces.emplace_back();
    for (const std::size_t function :
         whole_face_table(discretization, face.face, tables).functions) {
      of_face.push_back(nodes[function]);
    }
  }
  return faces;
}

/// Mean motions about a centre of some nodes of a surface. Linear tractions on
/// a part of it are combinations of those on all of it.
NodeFunctionals<3> motions_of(const NodeFunctionals<3>& whole,
                              const std::vector<bool>& has_node,
                              const Vector3d& centre,
                              const Matrix3Xd& positions) {
  NodeFunctionals<3> motions;
  std::vector<Index> columns;
  for (std::size_t i = 0; i < whole.nodes.size(); ++i) {
    if (!has_node[at(whole.nodes[i])]) continue;
    motions.nodes.push_back(whole.nodes[i]);
    for (Index d = 0; d < 3; ++d) {
      columns.push_back(3 * static_cast<Index>(i) + d);
    }
  }
  const Eigen::MatrixXd forces = whole.rows(Eigen::all, columns);
  Eigen::Matrix<double, kMotion, kMotion> wrenches;
  wrenches.setZero();
  for (std::size_t i = 0; i < motions.nodes.size(); ++i) {
    const Vector3d arm = positions.col(motions.nodes[i]) - centre;
    for (Index k = 0; k < kMotion; ++k) {
      const Vector3d force =
          forces.row(k).segment<3>(3 * static_cast<Index>(i)).transpose();
      wrenches.col(k).head<3>() += force;
      wrenches.col(k).tail<3>() += arm.cross(force);
    }
  }
  motions.rows = wrenches.transpose().fullPivLu().solve(forces);
  return motions;
}

}  // namespace

std::vector<BorePiece> bore_pieces(const Discretization<3>& discretization,
                                   const std::string& group,
                                   const NodeFunctionals<3>& whole,
                                   const Matrix3Xd& positions) {
  const auto& groups = discretization.groups;
  const auto found =
      std::ranges::find(groups, group, &mesh::SurfaceGroup::name);
  if (found == groups.end() || !found->cylinder) return {};
  auto pieces = connected_nodes(
      nodes_of_faces(discretization,
                     static_cast<std::size_t>(found - groups.begin())),
      discretization.nodes);
  if (pieces.size() < 2) return {};
  const part::Bore& bore = *found->cylinder;
  std::vector<BorePiece> result;
  for (auto& has_node : pieces) {
    double sum = 0.0, count = 0.0;
    for (Index node = 0; node < positions.cols(); ++node) {
      if (!has_node[at(node)]) continue;
      sum += (positions.col(node) - bore.p_LC).dot(bore.axis_L);
      count += 1.0;
    }
    const Vector3d centre = bore.p_LC + sum / count * bore.axis_L;
    auto motions = motions_of(whole, has_node, centre, positions);
    result.push_back({centre, std::move(has_node), std::move(motions)});
  }
  return result;
}

}  // namespace clevis::elasticity

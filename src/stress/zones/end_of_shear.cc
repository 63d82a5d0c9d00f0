#include "stress/zones/end_of_shear.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "mesh/cells/topology.h"
#include "stress/corners/round_surfaces.h"

namespace clevis::stress {
namespace {

using Eigen::Vector3d;

constexpr double kPi = std::numbers::pi;

// Below this angle of the material shear that ends leaves a bounded stress.
constexpr double kBluntEdge = 0.75 * kPi;

/// Shear on both sides of a corner; null where there is none.
template <int dim>
std::array<const loads::GroupShear*, 2> shear_beside(
    const mesh::PartMesh<dim>& mesh, const BoundaryCorner& corner,
    const loads::SurfaceShear& shear) {
  std::array<const loads::GroupShear*, 2> beside{};
  if (corner.sides[0].group == corner.sides[1].group) return beside;
  for (std::size_t s = 0; s < 2; ++s) {
    const int group = corner.sides[s].group;
    if (group < 0) continue;
    const auto found =
        shear.find(mesh.groups[static_cast<std::size_t>(group)].name);
    if (found != shear.end()) beside[s] = &found->second;
  }
  return beside;
}

/// Largest jump of the shear over a smooth edge, of all instants [Pa].
double jump_of(const std::array<const loads::GroupShear*, 2>& beside) {
  const loads::GroupShear& first = beside[0] ? *beside[0] : *beside[1];
  if (!beside[0] || !beside[1]) {
    return (first.even.colwise().norm().transpose() + first.turning).maxCoeff();
  }
  return ((first.even - beside[1]->even).colwise().norm().transpose() +
          first.turning + beside[1]->turning)
      .maxCoeff();
}

/// The same at a roller, which mirrors what runs towards it and leaves on what
/// runs along it [Pa].
double jump_of_mirrored(const BoundaryCorner& corner,
                        const std::array<const loads::GroupShear*, 2>& beside) {
  double largest = 0.0;
  for (std::size_t s = 0; s < 2; ++s) {
    if (!beside[s]) continue;
    const Eigen::VectorXd towards =
        beside[s]->even.transpose() * corner.sides[s].direction;
    largest = std::max(
        largest, 2.0 * (towards.cwiseAbs() + beside[s]->turning).maxCoeff());
  }
  return largest;
}

}  // namespace

template <int dim>
std::optional<EndOfShear> end_of_shear(const mesh::PartMesh<dim>& mesh,
                                       const HeldCorner& at,
                                       const loads::SurfaceShear& shear) {
  constexpr double kPerFold = 1.10;  // √3 · 2/π
  constexpr double kFolds = 4.6;     // from a tenth of the radius
  const BoundaryCorner& corner = at.corner;
  const bool is_mirrored = at.held[0].wedge.hold != at.held[1].wedge.hold;
  const double angle = is_mirrored && at.kink ? *at.kink + kPi : corner.angle;
  if (angle < kBluntEdge) return std::nullopt;
  const auto beside = shear_beside<dim>(mesh, corner, shear);
  if (!beside[0] && !beside[1]) return std::nullopt;
  const double jump =
      is_mirrored ? jump_of_mirrored(corner, beside) : jump_of(beside);
  if (!(jump > 0.0)) return std::nullopt;
  const auto side = static_cast<std::size_t>(beside[0] == nullptr);
  return EndOfShear{
      mesh.groups[static_cast<std::size_t>(corner.sides[side].group)].name,
      kPerFold * kFolds * jump};
}

double rise_at_edges(const mesh::PartMesh<3>& mesh,
                     const loads::SurfaceShear& shear, const Vector3d& at) {
  double largest = 0.0;
  if (shear.empty()) return largest;
  for (const BoundaryCorner& corner : boundary_corners<3>(mesh)) {
    const Vector3d arm = at - corner.at;
    const double half = 0.5 * (position(mesh, corner.vertices[0]) -
                               position(mesh, corner.vertices[1]))
                                  .norm();
    const double along = std::abs(corner.axis.dot(arm));
    const double across = (arm - corner.axis.dot(arm) * corner.axis).norm();
    if (corner.angle >= kBluntEdge || across > corner.reach ||
        along > half + corner.reach) {
      continue;
    }
    const auto beside = shear_beside<3>(mesh, corner, shear);
    if (!beside[0] && !beside[1]) continue;
    // What points to the edge has to meet its like on the other face.
    Eigen::VectorXd rest;
    for (std::size_t s = 0; s < 2; ++s) {
      if (!beside[s]) continue;
      const Eigen::VectorXd towards = (s == 0 ? 1.0 : -1.0) *
                                      beside[s]->even.transpose() *
                                      corner.sides[s].direction;
      rest = rest.size() == 0 ? towards : Eigen::VectorXd(rest + towards);
    }
    largest = std::max(largest, rest.lpNorm<Eigen::Infinity>());
  }
  return 0.5 * kPi * largest;
}

template std::optional<EndOfShear> end_of_shear<2>(const mesh::PartMesh<2>&,
                                                   const HeldCorner&,
                                                   const loads::SurfaceShear&);
template std::optional<EndOfShear> end_of_shear<3>(const mesh::PartMesh<3>&,
                                                   const HeldCorner&,
                                                   const loads::SurfaceShear&);

}  // namespace clevis::stress

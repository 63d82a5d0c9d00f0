#include "beam/sections/station.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/LU>

#include "beam/theory/formulas.h"

namespace clevis::beam {

using Eigen::Matrix2d;
using Eigen::Vector2d;
using Eigen::Vector3d;
using PlaneBasis = Eigen::Matrix<double, 3, 2>;

namespace {

double turn(const Vector2d& a, const Vector2d& b, const Vector2d& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

// Andrew's monotone chain. Stress is linear over the section: only corners of
// the hull can be extreme.
std::vector<Vector2d> convex_hull(std::vector<Vector2d> points) {
  std::ranges::sort(points, [](const Vector2d& a, const Vector2d& b) {
    return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
  });
  std::vector<Vector2d> hull;
  const auto add_chain = [&hull](const auto& ordered) {
    const std::size_t start = hull.size();
    for (const Vector2d& p : ordered) {
      while (hull.size() >= start + 2 &&
             turn(hull[hull.size() - 2], hull.back(), p) <= 0.0) {
        hull.pop_back();
      }
      hull.push_back(p);
    }
    if (!hull.empty()) hull.pop_back();
  };
  add_chain(points);
  std::ranges::reverse(points);
  add_chain(points);
  return hull.empty() ? points : hull;
}

// Smallest extent over all directions: attained normal to a side of the hull.
double smallest_width(const std::vector<Vector2d>& hull) {
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Vector2d side = hull[(i + 1) % hull.size()] - hull[i];
    if (side.norm() == 0.0) continue;
    double width = 0.0;
    for (const Vector2d& p : hull) {
      width = std::max(
          width, std::abs(turn(hull[i], hull[i] + side, p)) / side.norm());
    }
    smallest = std::min(smallest, width);
  }
  return smallest;
}

/// Torsion modulus I_p/r of a disc or a ring [m³]; nothing if the section is
/// neither, by its area, its second moments and its outer radius.
/// @param J  second moments about the centroid [m⁴].
std::optional<double> round_modulus(double area, const Matrix2d& J,
                                    const std::vector<Vector2d>& hull) {
  constexpr double kSame = 0.02;  // a mesh's facets
  double outer = 0.0;
  for (const Vector2d& p : hull) outer = std::max(outer, p.norm());
  const double pi = std::numbers::pi;
  const double inner = std::max(0.0, outer * outer - area / pi);  // squared
  const double polar = 0.5 * pi * (std::pow(outer, 4) - inner * inner);
  const bool is_even =
      std::abs(J(0, 0) - J(1, 1)) + 2.0 * std::abs(J(0, 1)) < kSame * J.trace();
  if (!is_even || std::abs(J.trace() - polar) > kSame * polar) return {};
  return J.trace() / outer;
}

/// Torsion modulus of a solid section, from below [m³]: the larger of two that
/// are. For rectangles the constant A⁴/(40.5 I_p) over the width: 12.5 % too
/// high a stress for thin strips, least for sides of 3 : 1. For stout sections
/// the constant of an equilateral triangle, A⁴/(45 I_p), over D/(1 + x) (1 +
/// 0.15 x), x = π² D⁴/(16 A²), D the diameter of the largest inscribed circle
/// [Roark's Formulas, 8th ed., table 10.7]. That is largest at x = 1/3, which
/// stands for all larger D.
/// @param polar  I_p [m⁴]. @param width  ≥ D [m].
double solid_modulus(double area, double polar, double width) {
  const double pi = std::numbers::pi;
  const double by_polar = std::pow(area, 4) / polar;  // [m⁴]
  const double slender = by_polar / (40.5 * width);
  const double widest = std::sqrt(4.0 * area / (std::sqrt(3.0) * pi));
  const double D = std::min(width, widest);
  const double x = std::pow(pi * D * D / (4.0 * area), 2);
  const double stout = by_polar * (1.0 + x) / (45.0 * D * (1.0 + 0.15 * x));
  return std::max(slender, stout);
}

}  // namespace

Station::Station(const mesh::Section& section, const Vector3d& normal,
                 MassMoments beyond)
    : area_(section.area),
      centroid_(section.centroid),
      normal_(normal),
      beyond_(std::move(beyond)) {
  PlaneBasis basis;
  basis.col(0) = normal.unitOrthogonal();
  basis.col(1) = normal.cross(basis.col(0));
  const Matrix2d J = basis.transpose() * section.second_moment * basis;
  flexibility_ = basis * J.inverse() * basis.transpose();
  smallest_second_moment_ =
      Eigen::SelfAdjointEigenSolver<Matrix2d>(J, Eigen::EigenvaluesOnly)
          .eigenvalues()[0];
  std::vector<Vector2d> rim;
  for (const Vector3d& p : section.rim) {
    rim.emplace_back(basis.transpose() * (p - centroid_));
  }
  const std::vector<Vector2d> hull = convex_hull(std::move(rim));
  for (const Vector2d& p : hull) fibres_.push_back(basis * p);
  torsion_modulus_ =
      round_modulus(area_, J, hull)
          .value_or(solid_modulus(area_, J.trace(), smallest_width(hull)));
}

Vector3d Station::bending_gradient(const Vector3d& moment) const {
  return flexibility_ * normal_.cross(moment);
}

double Station::torsion_stress(const Vector3d& moment) const {
  return std::abs(moment.dot(normal_)) / torsion_modulus_;
}

double Station::normal_stress(const loads::Wrench& section_force) const {
  const double axial = section_force.force.dot(normal_) / area_;
  const Vector3d gradient = bending_gradient(section_force.moment);
  double largest = std::abs(axial);
  for (const Vector3d& r : fibres_) {
    largest = std::max(largest, std::abs(axial + gradient.dot(r)));
  }
  return largest;
}

double Station::fibre_stress(const loads::Wrench& section_force) const {
  return equivalent_stress(normal_stress(section_force),
                           torsion_stress(section_force.moment));
}

bool Station::is_twisted(const loads::Wrench& section_force) const {
  return fibre_stress(section_force) > 1.01 * normal_stress(section_force);
}

double Station::neutral_axis_stress(const loads::Wrench& section_force) const {
  const double axial = section_force.force.dot(normal_);
  const double shear = (section_force.force - axial * normal_).norm();
  return equivalent_stress(
      axial / area_,
      1.5 * shear / area_ + torsion_stress(section_force.moment));
}

LoadsBeyond loads_beyond(const loads::LoadHistory& history,
                         const std::vector<loads::GroupGeometry>& groups,
                         const Vector3d& point, const Vector3d& normal) {
  LoadsBeyond beyond;
  for (std::size_t i = 0; i < history.seats.size(); ++i) {
    if ((history.seats[i].p_LS - point).dot(normal) > 0.0) {
      beyond.seats.push_back(i);
    }
  }
  if (history.instants.empty()) return beyond;
  const auto& loads = history.instants.front().surface_loads;
  for (std::size_t i = 0; i < loads.size(); ++i) {
    const auto group =
        std::ranges::find(groups, loads[i].group, &loads::GroupGeometry::name);
    if (group != groups.end() && (group->centroid - point).dot(normal) > 0.0) {
      beyond.surface_loads.push_back(i);
    }
  }
  return beyond;
}

loads::Wrench section_force(const loads::LoadHistory& history,
                            const loads::InstantLoad& instant,
                            const LoadsBeyond& beyond, const Station& station) {
  loads::Wrench sum = inertia_of(station.beyond(), instant.rigid);
  for (const std::size_t i : beyond.seats) {
    const loads::Wrench& wrench = instant.wrenches[i];
    sum.force += wrench.force;
    sum.moment += wrench.moment + history.seats[i].p_LS.cross(wrench.force);
  }
  for (const std::size_t i : beyond.surface_loads) {
    const loads::Wrench& resultant = instant.surface_loads[i].resultant;
    sum.force += resultant.force;
    sum.moment += resultant.moment;
  }
  sum.moment -= station.centroid().cross(sum.force);
  return sum;
}

}  // namespace clevis::beam

#pragma once

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "beam/sections/part_model.h"
#include "loads/history/load_history.h"
#include "loads/parts/part_loads.h"
#include "part/mass_properties.h"
#include "part/material.h"

namespace clevis::beam {

/// A straight bar along x with a rectangular section, y = z = 0 its axis:
/// everything about it is known in closed form.
struct Bar {
  double start{}, end{};  // along x [m]
  double height = 20e-3;  // along y [m]
  double width = 5e-3;    // along z [m]
  double density = 7850.0;
  int slices = 4000;

  double length() const { return end - start; }
  double area() const { return height * width; }
  double section_modulus() const { return width * height * height / 6.0; }
  double second_moment() const { return section_modulus() * height / 2.0; }

  part::MassProperties mass() const {
    const double m = density * area() * length();
    const double h = height * height, w = width * width,
                 l = length() * length();
    return {.mass = m,
            .p_LCm = {0.5 * (start + end), 0.0, 0.0},
            .inertia_LCm = Eigen::Vector3d(h + w, l + w, l + h).asDiagonal() *
                           Eigen::Matrix3d::Identity() * (m / 12.0)};
  }

  /// Only for planes normal to x.
  mesh::Section section(const Eigen::Vector3d& point) const {
    mesh::Section s;
    if (point.x() < start || point.x() > end) return s;
    s.area = area();
    s.centroid = {point.x(), 0.0, 0.0};
    s.second_moment.diagonal() << 0.0, width * std::pow(height, 3) / 12.0,
        height * std::pow(width, 3) / 12.0;
    for (const double y : {-0.5, 0.5}) {
      for (const double z : {-0.5, 0.5}) {
        s.rim.emplace_back(point.x(), y * height, z * width);
      }
    }
    s.pieces = 1;
    return s;
  }

  PartModel model() const {
    PartModel model;
    const Bar bar = *this;
    model.section = [bar](const Eigen::Vector3d& point,
                          const Eigen::Vector3d&) {
      return bar.section(point);
    };
    model.outline = [](const Eigen::Vector3d&, const Eigen::Vector3d&) {
      return Outline{};
    };
    for (int i = 0; i < slices; ++i) {
      model.lumps.push_back(
          {area() * length() / slices,
           {start + length() * (i + 0.5) / slices, 0.0, 0.0}});
    }
    return model;
  }
};

/// Bearing seats on the axis with bores so thin that they take no length.
inline constexpr double kThinRadius = 1e-9;

inline loads::GroupGeometry pin_group(const std::string& name, double x,
                                      double radius = kThinRadius,
                                      double length = 5e-3) {
  const part::Bore bore{.p_LC = {x, 0.0, 0.0},
                        .axis_L = Eigen::Vector3d::UnitZ(),
                        .radius = radius,
                        .length = length};
  loads::GroupGeometry group;
  group.name = std::string("bore_").append(name);
  group.is_cylinder = true;
  group.cylinder = bore;
  group.centroid = bore.p_LC;
  group.area = 2.0 * std::numbers::pi * radius * length;
  return group;
}

inline loads::Seat pin_seat(const loads::GroupGeometry& group) {
  return {.name = group.name.substr(5),
          .group = group.name,
          .kind = loads::SeatKind::kBearing,
          .p_LS = group.cylinder.p_LC};
}

/// A history of one instant with forces on pins.
inline loads::LoadHistory pin_history(
    const std::vector<loads::GroupGeometry>& groups,
    const std::vector<Eigen::Vector3d>& forces) {
  loads::LoadHistory history;
  loads::InstantLoad instant;
  instant.label = "t = 0.5 s";
  instant.time = 0.5;
  for (std::size_t i = 0; i < groups.size(); ++i) {
    history.seats.push_back(pin_seat(groups[i]));
    instant.wrenches.push_back({.force = forces[i]});
  }
  history.instants.push_back(instant);
  return history;
}

inline part::Material steel() {
  return {.name = "steel",
          .youngs_modulus = 210e9,
          .poissons_ratio = 0.3,
          .density = 7850.0,
          .yield_strength = 355e6};
}

}  // namespace clevis::beam

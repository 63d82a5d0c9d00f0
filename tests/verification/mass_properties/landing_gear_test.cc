// Mass, centre and inertia of the committed meshes against the drawing: the
// same dimensions as in geometry/landing_gear/*.geo, integrated without mesh.

#include <array>
#include <cmath>
#include <filesystem>
#include <functional>
#include <iostream>
#include <numbers>
#include <string>

#include <Eigen/Core>
#include <gtest/gtest.h>

#include "mesh/quality/mass_properties.h"
#include "mesh/reading/mesh_reader.h"
#include "plane_region.h"
#include "support/source_dir.h"

namespace clevis::verification {
namespace {

using std::numbers::pi;

constexpr double kDensity = 7850.0;  // [kg/m³]
constexpr double kMm = 1e-3;

// Nothing but the reader's own geometry separates a plate's mesh from the
// drawing; arcs of up to 22° per cell as polynomials of its mapping.
constexpr double kPlate = 1e-9;
// Lofts, flare and dome are cubic cells between eight meridians; an arc of 45°
// as a cubic is right to 1e-5 of its radius, a cell of the dome to 1e-3.
constexpr double kRod = 4e-5, kCylinder = 1e-4;

// The rim is eight arcs of 45° as polynomials of the reader's mapping.
constexpr double kGasArea = 1e-9;

/// ∫ over the volume, in mm.
struct VolumeMoments {
  double volume{}, x{}, y{}, xx{}, yy{}, zz{}, xy{};

  VolumeMoments& operator+=(const VolumeMoments& other) {
    volume += other.volume;
    x += other.x;
    y += other.y;
    xx += other.xx;
    yy += other.yy;
    zz += other.zz;
    xy += other.xy;
    return *this;
  }
};

VolumeMoments plate(const AreaMoments& a, double t) {
  return {t * a.area, t * a.x,  t * a.y,
          t * a.xx,   t * a.yy, a.area * t * t * t / 12.0,
          t * a.xy};
}

/// A body symmetric about both planes through x, from its sections: area,
/// ∫ y² dA and ∫ z² dA at x; Simpson's rule.
struct SectionMoments {
  double area{}, yy{}, zz{};
};
VolumeMoments body_of_sections(
    double from, double to,
    const std::function<SectionMoments(double)>& section) {
  constexpr int kSteps = 2000;
  VolumeMoments sum;
  for (int i = 0; i <= kSteps; ++i) {
    const double x = from + (to - from) * i / kSteps;
    const double simpson = i == 0 || i == kSteps ? 1.0 : i % 2 == 1 ? 4.0 : 2.0;
    const double w = simpson * (to - from) / (3.0 * kSteps);
    const SectionMoments s = section(x);
    sum += {w * s.area, w * s.area * x, 0.0, w * s.area * x * x,
            w * s.yy,   w * s.zz,       0.0};
  }
  return sum;
}

SectionMoments disc(double radius) {
  const double area = pi * radius * radius;
  return {area, 0.25 * area * radius * radius, 0.25 * area * radius * radius};
}

SectionMoments difference(const SectionMoments& a, const SectionMoments& b) {
  return {a.area - b.area, a.yy - b.yy, a.zz - b.zz};
}

/// The share of the end section at s of a loft from 0 to 1.
double smooth_step(double s) {
  return s * s * (3.0 - 2.0 * s);
}

/// A section with corners (±corner_y, ±corner_z) and mid-sides (±mid_y, 0),
/// (0, ±mid_z), joined by eight chords to which the arch of a 45° arc of
/// radius `arch` is added: so are gmsh's transfinite surfaces between a
/// rectangle (arch 0) and a circle, or between two circles.
struct Octant {
  double corner_y, corner_z, mid_y, mid_z, arch;
};
SectionMoments section_of(const Octant& o) {
  const std::array<double, 9> y = {o.mid_y,     o.corner_y, 0.0,
                                   -o.corner_y, -o.mid_y,   -o.corner_y,
                                   0.0,         o.corner_y, o.mid_y};
  const std::array<double, 9> z = {0.0,        o.corner_z,  o.mid_z,
                                   o.corner_z, 0.0,         -o.corner_z,
                                   -o.mid_z,   -o.corner_z, 0.0};
  constexpr double kTurn = pi / 4.0;
  Outline outline;
  for (std::size_t e = 0; e < 8; ++e) {
    const double from = kTurn * double(e), to = from + kTurn;
    const double chord_y = std::cos(to) - std::cos(from);
    const double chord_z = std::sin(to) - std::sin(from);
    outline.piece([&](double u) {
      const double a = from + kTurn * u;
      const double arch_y = std::cos(a) - std::cos(from) - u * chord_y;
      const double arch_z = std::sin(a) - std::sin(from) - u * chord_z;
      return Outline::State{
          y[e] + u * (y[e + 1] - y[e]) + o.arch * arch_y,
          z[e] + u * (z[e + 1] - z[e]) + o.arch * arch_z,
          y[e + 1] - y[e] + o.arch * (-kTurn * std::sin(a) - chord_y),
          z[e + 1] - z[e] + o.arch * (kTurn * std::cos(a) - chord_z)};
    });
  }
  const AreaMoments& m = outline.moments();
  return {m.area, m.xx, m.yy};
}

/// Rectangle (half sides a, b; w = 0) to circle (w = 1).
SectionMoments loft_section(double a, double b, double radius, double w,
                            double arch) {
  const double corner = w * radius * std::sqrt(0.5);
  return section_of({(1 - w) * a + corner, (1 - w) * b + corner,
                     (1 - w) * a + w * radius, (1 - w) * b + w * radius, arch});
}

/// An eye on the x axis whose bar of half width w leaves towards +x (s = 1)
/// or -x (s = -1; everything turned by 180°), with tangent fillets.
struct Eye {
  double cx, s, boss, w, fillet;

  double fillet_y() const { return w + fillet; }
  double fillet_x() const {
    return std::sqrt(std::pow(boss + fillet, 2) - std::pow(fillet_y(), 2));
  }
  double tangent() const { return std::atan2(fillet_y(), fillet_x()); }
  double turn() const { return s > 0 ? 0.0 : pi; }

  void from_bar_to_boss(Outline& outline) const {
    outline.arc(cx + s * fillet_x(), s * fillet_y(), fillet, turn() - pi / 2,
                turn() - pi + tangent());
  }
  void free_boss(Outline& outline) const {
    outline.arc(cx, 0.0, boss, turn() + tangent(),
                turn() + 2.0 * pi - tangent());
  }
  void from_boss_to_bar(Outline& outline) const {
    outline.arc(cx + s * fillet_x(), -s * fillet_y(), fillet,
                turn() + pi - tangent(), turn() + pi / 2);
  }
};

void whole_eye(Outline& outline, const Eye& eye) {
  eye.from_bar_to_boss(outline);
  eye.free_boss(outline);
  eye.from_boss_to_bar(outline);
}

part::MassProperties mass_of(const VolumeMoments& v) {
  part::MassProperties result;
  const double to_kg = kDensity * kMm * kMm * kMm;
  result.mass = to_kg * v.volume;
  const Eigen::Vector3d centre(v.x / v.volume, v.y / v.volume, 0.0);
  result.p_LCm = kMm * centre;
  Eigen::Matrix3d second = Eigen::Vector3d(v.xx, v.yy, v.zz).asDiagonal();
  second(0, 1) = second(1, 0) = v.xy;
  second -= v.volume * centre * centre.transpose();
  result.inertia_LCm = to_kg * kMm * kMm *
                       (second.trace() * Eigen::Matrix3d::Identity() - second);
  return result;
}

void expect_mass(const std::string& name, const VolumeMoments& drawing,
                 double tolerance) {
  const std::filesystem::path file =
      support::source_dir() / "meshes/landing_gear" / name;
  const part::MassProperties got =
      mesh::mass_properties(mesh::read_part_mesh(file, kMm), kDensity);
  const part::MassProperties want = mass_of(drawing);
  EXPECT_NEAR(got.mass / want.mass, 1.0, tolerance);
  // Lengths on the scale of the part, moments on that of its largest.
  const double size = std::sqrt(want.inertia_LCm.trace() / want.mass);
  EXPECT_LT((got.p_LCm - want.p_LCm).norm(), tolerance * size)
      << got.p_LCm.transpose() << " m instead of " << want.p_LCm.transpose();
  EXPECT_LT((got.inertia_LCm - want.inertia_LCm).norm(),
            tolerance * want.inertia_LCm.norm())
      << got.inertia_LCm << "\ninstead of\n"
      << want.inertia_LCm;
  std::cout << name << ": mass " << got.mass << " kg, relative deviation "
            << got.mass / want.mass - 1.0 << ", inertia "
            << (got.inertia_LCm - want.inertia_LCm).norm() /
                   want.inertia_LCm.norm()
            << "\n";
}

TEST(LandingGearMass, LinkAb) {
  const Eye a{0.0, 1.0, 12.0, 9.0, 10.0}, b{140.0, -1.0, 12.0, 9.0, 10.0};
  Outline outline;
  whole_eye(outline, a);
  outline.line(a.fillet_x(), -9.0, 140.0 - a.fillet_x(), -9.0);
  whole_eye(outline, b);
  outline.line(140.0 - a.fillet_x(), 9.0, a.fillet_x(), 9.0);
  outline.hole(0.0, 0.0, 7.5);
  outline.hole(140.0, 0.0, 7.5);
  expect_mass("link_ab.msh", plate(outline.moments(), 5.0), kPlate);
}

TEST(LandingGearMass, LinkBc) {
  const Eye c{0.0, 1.0, 12.0, 9.0, 10.0}, wheel{100.0, -1.0, 12.0, 9.0, 10.0};
  const Eye b_left{60.0, -1.0, 12.0, 9.0, 10.0};
  const Eye b_right{60.0, 1.0, 12.0, 9.0, 10.0};
  const double fx = c.fillet_x(), ta = c.tangent();
  Outline outline;
  whole_eye(outline, c);
  outline.line(fx, -9.0, 60.0 - fx, -9.0);
  b_left.from_bar_to_boss(outline);
  outline.arc(60.0, 0.0, 12.0, pi + ta, 2.0 * pi - ta);
  b_right.from_boss_to_bar(outline);
  outline.line(60.0 + fx, -9.0, 100.0 - fx, -9.0);
  whole_eye(outline, wheel);
  outline.line(100.0 - fx, 9.0, 60.0 + fx, 9.0);
  b_right.from_bar_to_boss(outline);
  outline.arc(60.0, 0.0, 12.0, ta, pi - ta);
  b_left.from_boss_to_bar(outline);
  outline.line(60.0 - fx, 9.0, fx, 9.0);
  for (const double x : {0.0, 60.0, 100.0}) outline.hole(x, 0.0, 7.5);
  expect_mass("link_bc.msh", plate(outline.moments(), 5.0), kPlate);
}

TEST(LandingGearMass, LinkDce) {
  const double x_e =
      (140.0 * 140.0 + 60.0 * 60.0 - 145.0 * 145.0) / (2.0 * 140.0);
  const std::array<Eigen::Vector2d, 3> corners = {
      Eigen::Vector2d(0.0, 0.0), Eigen::Vector2d(140.0, 0.0),
      Eigen::Vector2d(x_e, std::sqrt(60.0 * 60.0 - x_e * x_e))};
  const auto normal = [&](std::size_t edge) {
    const Eigen::Vector2d along = corners[(edge + 1) % 3] - corners[edge];
    return std::atan2(-along.x(), along.y());
  };
  Outline outline;
  for (std::size_t i = 0; i < 3; ++i) {
    const Eigen::Vector2d p = corners[i], q = corners[(i + 1) % 3];
    const double in = normal((i + 2) % 3);
    double out = normal(i);
    if (out < in) out += 2.0 * pi;
    outline.arc(p.x(), p.y(), 12.0, in, out);
    const double nx = 12.0 * std::cos(out), ny = 12.0 * std::sin(out);
    outline.line(p.x() + nx, p.y() + ny, q.x() + nx, q.y() + ny);
    outline.hole(p.x(), p.y(), 7.5);
  }
  expect_mass("link_dce.msh", plate(outline.moments(), 8.0), kPlate);
}

TEST(LandingGearMass, Rod) {
  const Eye e{0.0, 1.0, 12.0, 8.0, 8.0};
  Outline outline;
  whole_eye(outline, e);
  outline.line(e.fillet_x(), -8.0, e.fillet_x(), 8.0);
  outline.hole(0.0, 0.0, 7.5);
  VolumeMoments sum = plate(outline.moments(), 8.0);
  sum += body_of_sections(e.fillet_x(), 36.0, [&](double x) {
    const double s = (x - e.fillet_x()) / (36.0 - e.fillet_x());
    return loft_section(8.0, 4.0, 4.0, smooth_step(s), 4.0 * s);
  });
  sum += body_of_sections(36.0, 110.0, [](double) {
    return disc(4.0);
  });
  sum += body_of_sections(110.0, 128.0, [](double x) {
    const double s = (x - 110.0) / 18.0;
    const double radius = 4.0 + 3.5 * smooth_step(s);
    return loft_section(0.0, 0.0, radius, 1.0, 4.0 + 3.5 * s);
  });
  sum += body_of_sections(128.0, 140.0, [](double) {
    return disc(7.5);
  });
  expect_mass("rod.msh", sum, kRod);
}

TEST(LandingGearMass, CylinderBody) {
  const Eye f{0.0, 1.0, 12.0, 9.5, 10.0};
  Outline outline;
  whole_eye(outline, f);
  outline.line(f.fillet_x(), -9.5, f.fillet_x(), 9.5);
  outline.hole(0.0, 0.0, 7.5);
  VolumeMoments sum = plate(outline.moments(), 10.0);
  const auto outside = [&](double x) {
    // The arch is linear between the sections of the .geo.
    const std::array<double, 4> at = {f.fillet_x(), 12.6, 15.2, 19.0};
    const auto weight = [&](double q) {
      return smooth_step((q - at[0]) / (at[3] - at[0]));
    };
    const std::size_t k = x < at[1] ? 0 : x < at[2] ? 1 : 2;
    const double t = (x - at[k]) / (at[k + 1] - at[k]);
    const double arch = (1 - t) * weight(at[k]) + t * weight(at[k + 1]);
    return loft_section(9.5, 5.0, 9.5, weight(x), 9.5 * arch);
  };
  sum += body_of_sections(f.fillet_x(), 15.0, outside);
  // The half ellipsoid: exact up to the ring where core and inner ring end,
  // from there on the meridians are, with arches linear in their angle.
  const auto angle = [](double x) {
    return std::acos((19.0 - x) / 4.0);
  };
  const double ring = std::asin(4.3 / 7.5);
  const double x_ring = 19.0 - 4.0 * std::cos(ring);
  sum += body_of_sections(15.0, x_ring, [&](double x) {
    return difference(outside(x), disc(7.5 * std::sin(angle(x))));
  });
  sum += body_of_sections(x_ring, 19.0, [&](double x) {
    const double share = (angle(x) - ring) / (pi / 2.0 - ring);
    const double arch = 4.3 + 3.2 * share;
    return difference(
        outside(x),
        loft_section(0.0, 0.0, 7.5 * std::sin(angle(x)), 1.0, arch));
  });
  sum += body_of_sections(19.0, 150.0, [](double) {
    return difference(disc(9.5), disc(7.5));
  });
  expect_mass("cylinder_body.msh", sum, kCylinder);
}

// The gas pushes on the cap with the full area of its bore, whatever the
// shape of the dome, and on the piston with the same.
TEST(LandingGearArea, GasSeesTheFullBore) {
  const double full = pi * 7.5 * 7.5 * kMm * kMm;
  const auto area_along_x = [](const std::string& file,
                               const std::string& name) {
    const mesh::PartMesh<3> part = mesh::read_part_mesh(
        support::source_dir() / "meshes/landing_gear" / file, kMm);
    for (std::size_t g = 0; g < part.groups.size(); ++g) {
      if (part.groups[g].name == name) {
        return mesh::face_properties(part, int(g)).area_vector.x();
      }
    }
    return 0.0;
  };
  const double cap = area_along_x("cylinder_body.msh", "cap") / full;
  const double piston = area_along_x("rod.msh", "piston_face") / full;
  std::cout << "cap " << cap - 1.0 << ", piston " << piston - 1.0 << "\n";
  EXPECT_NEAR(cap, 1.0, kGasArea);  // outward: towards the gas, along +x
  EXPECT_NEAR(piston, 1.0, kGasArea);
}

}  // namespace
}  // namespace clevis::verification

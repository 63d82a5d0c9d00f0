#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "band_catalogue.h"
#include "stress/field/stress_history.h"
#include "support/annulus_mesh.h"
#include "support/simplex_mesh.h"

namespace clevis::support {
namespace {

using Complex = std::complex<double>;
using Eigen::Vector2d;
using Eigen::Vector3d;
using std::numbers::pi;
template <int dim>
using Point = Eigen::Matrix<double, dim, 1>;
using Stress = std::function<Vector6d(const Vector3d&)>;
template <int dim>
using Map = std::function<Point<dim>(const Point<dim>&)>;

constexpr double kNu = 0.3;
constexpr double kKappa = (3 - kNu) / (1 + kNu);  // plane stress

/// Traction of a stress field on all sides of a patch.
template <int dim>
std::vector<TractionField<dim>> tractions(
    const mesh::PartMesh<dim>& mesh, const Stress& stress,
    const std::vector<std::string>& only) {
  std::vector<TractionField<dim>> all;
  for (const auto& group : mesh.groups) {
    if (!only.empty() && std::ranges::find(only, group.name) == only.end()) {
      continue;
    }
    all.push_back({group.name, [=](const Point<dim>& x, const Point<dim>& n) {
                     Vector3d at = Vector3d::Zero();
                     Vector3d normal = Vector3d::Zero();
                     at.head<dim>() = x;
                     normal.head<dim>() = n;
                     const Vector6d s = stress(at);
                     Eigen::Matrix3d sigma;
                     sigma << s[0], s[3], s[5], s[3], s[1], s[4], s[5], s[4],
                         s[2];
                     return Point<dim>((sigma * normal).template head<dim>());
                   }});
  }
  return all;
}

double component(const Vector6d& s, const std::string& quantity) {
  if (quantity == "stress_xx") return s[0];
  if (quantity == "stress_yy") return s[1];
  return stress::von_mises(s.transpose())[0];
}

/// Largest von Mises stress of the exact field on the patch: points of a fine
/// lattice, the mesh's own geometry.
template <int dim>
double exact_peak(const mesh::PartMesh<dim>& mesh, const Stress& stress) {
  elasticity::DisplacementBasis<dim> basis;
  basis.discretization = elasticity::discretize<dim>(mesh, mesh.degree);
  basis.columns = Eigen::MatrixXd::Zero(basis.discretization.dofs(), 1);
  basis.coefficients = Eigen::MatrixXd::Ones(1, 1);
  const auto field =
      stress::instant_field<dim>(basis, band_material(), dim == 2 ? 32 : 24, 0);
  double peak = 0.0;
  for (const auto& points : field.points) {
    for (Eigen::Index q = 0; q < points.rows(); ++q) {
      peak = std::max(peak,
                      stress::von_mises(stress(points.row(q)).transpose())[0]);
    }
  }
  return peak;
}

/// Points where the stress is looked at.
using Probes = std::vector<std::pair<Vector3d, std::string>>;

template <int dim>
BandProblem<dim> patch(const std::string& problem, const std::string& variant,
                       mesh::PartMesh<dim> mesh, const Stress& stress,
                       const Probes& probes,
                       const std::vector<std::string>& loaded = {}) {
  // Of a smooth field on that lattice, relative.
  constexpr double kLattice = dim == 2 ? 1e-5 : 1e-4;
  BandProblem<dim> result;
  result.problem = problem;
  result.variant = variant;
  result.tractions = tractions<dim>(mesh, stress, loaded);
  result.peak = exact_peak<dim>(mesh, stress);
  result.uncertainty = kLattice * result.peak;
  for (const auto& [at, quantity] : probes) {
    result.probes.push_back({at, quantity, component(stress(at), quantity)});
  }
  result.mesh = std::move(mesh);
  return result;
}

/// Plane meshes of a map of the unit square: quads and triangles.
void add_plane(const std::string& problem, const Map<2>& map,
               const Stress& stress, const Probes& probes,
               const std::vector<std::array<int, 2>>& divisions,
               std::vector<BandCase>& all, const BodyField<2>& body = {}) {
  const auto add = [&](const std::string& shape, const std::array<int, 2>& n,
                       mesh::PartMesh<2> mesh) {
    mesh.thickness = 1.0;
    auto one = patch<2>(
        problem,
        shape + " " + std::to_string(n[0]) + "x" + std::to_string(n[1]),
        std::move(mesh), stress, probes);
    one.body = body;
    add_cases<2>(one, all);
  };
  for (const auto& cells : divisions) {
    add("quads", cells, structured_mesh<2>(cells, 4, map));
  }
  add("triangles", divisions.front(),
      simplex_mesh<2>(divisions.front(), 4, map));
}

void add_solid(const std::string& problem, const Map<3>& map,
               const Stress& stress, const Probes& probes,
               const std::array<int, 3>& divisions,
               std::vector<BandCase>& all) {
  add_cases<3>(patch<3>(problem, "hexahedra",
                        structured_mesh<3>(divisions, 4, map), stress, probes),
               all);
}

/// Stress of Kolosov and Muskhelishvili's φ', φ'', ψ'.
Vector6d from_potentials(Complex z, Complex slope, Complex curvature,
                         Complex psi) {
  const double sum = 4.0 * slope.real();
  const Complex difference = 2.0 * (std::conj(z) * curvature + psi);
  Vector6d s = Vector6d::Zero();
  s[0] = 0.5 * (sum - difference.real());
  s[1] = 0.5 * (sum + difference.real());
  s[3] = 0.5 * difference.imag();
  return s;
}

Vector6d kirsch(const Vector3d& x) {
  const Complex z(x.x(), x.y());
  const Complex w = 1.0 / (z * z);
  return from_potentials(z, 0.25 * (1.0 - 2.0 * w), w / z,
                         -0.5 * (1.0 - w + 3.0 * w * w));
}

Map<2> sector(double outer, double start, double span) {
  return [=](const Vector2d& x) -> Vector2d {
    const double r = std::pow(outer, x[0]);
    const double angle = start + span * x[1];
    return {r * std::cos(angle), r * std::sin(angle)};
  };
}

Map<3> thick(const Map<2>& map, double height) {
  return [=](const Vector3d& x) -> Vector3d {
    const Vector2d p = map(x.head<2>());
    return {p.x(), p.y(), height * x.z()};
  };
}

/// Plane strain: the stress along z that keeps it.
Stress in_plane_strain(const Stress& plane, double nu) {
  return [=](const Vector3d& x) {
    Vector6d s = plane(x);
    s[2] = nu * (s[0] + s[1]);
    return s;
  };
}

void add_holes(std::vector<BandCase>& all) {
  const Vector3d top(0, 1, 0);
  add_plane("Kirsch", sector(3, 0, pi / 2), kirsch, {{top, "stress_xx"}},
            {{2, 2}, {3, 4}, {6, 6}}, all);
  add_plane("Kirsch, turned mesh", sector(3, 0.3, pi / 2 + 0.2), kirsch, {},
            {{2, 2}, {3, 4}, {6, 6}}, all);
  add_solid("Kirsch, 3-D", thick(sector(3, 0, pi / 2), 0.5),
            in_plane_strain(kirsch, kNu), {{top, "stress_xx"}}, {4, 4, 1}, all);
}

Stress lame(double outer) {
  return [=](const Vector3d& x) {
    const double b = outer * outer;
    const double q = b / x.head<2>().squaredNorm();
    return from_polar((1 - q) / (b - 1), (1 + q) / (b - 1), 0, 0,
                      std::atan2(x.y(), x.x()));
  };
}

void add_tubes(std::vector<BandCase>& all) {
  const Vector3d bore(1, 0, 0);
  add_plane("Lame ring", sector(2, 0, pi / 2), lame(2),
            {{bore, "stress_yy"}, {bore, "stress_xx"}},
            {{1, 2}, {2, 2}, {3, 4}}, all);
  add_plane("Lame, thick ring", sector(5, 0, pi / 2), lame(5),
            {{bore, "stress_yy"}}, {{2, 2}, {4, 3}}, all);
  add_solid("Lame tube", thick(sector(2, 0, pi / 2), 0.5),
            in_plane_strain(lame(2), kNu), {{bore, "stress_yy"}}, {3, 3, 1},
            all);
}

void add_spinning(std::vector<BandCase>& all) {
  const double b = 9.0;  // outer radius squared
  const auto stress = [=](const Vector3d& x) {
    const double r = x.head<2>().squaredNorm();
    return from_polar((3 + kNu) / 8 * (1 + b - b / r - r),
                      (3 + kNu) / 8 * (1 + b + b / r) - (1 + 3 * kNu) / 8 * r,
                      0, 0, std::atan2(x.y(), x.x()));
  };
  add_plane("spinning ring", sector(3, 0, pi / 2), stress,
            {{{1, 0, 0}, "stress_yy"}}, {{2, 2}, {3, 4}}, all,
            [](const Vector2d& x) -> Vector2d {
              return x;
            });
}

/// Pin in an infinite plate, cosine pressure towards `direction`.
Stress bearing(double direction) {
  return [=](const Vector3d& x) {
    Complex z = Complex(x.x(), x.y()) * std::polar(1.0, -direction);
    z *= std::max(1.0, 1.0 / std::abs(z));  // chords cut into the hole
    const Complex w = 1.0 / z;
    Complex slope = -w / (4 * (1 + kKappa));
    Complex curvature = -slope / z;
    Complex psi = kKappa / (4 * (1 + kKappa)) * w + w * w / pi +
                  (0.25 - 1 / (2 * (1 + kKappa))) * w * w * w;
    // Σ (−1)^m w^2m/(4m² − 1)/π and the same times 2m.
    const Complex arc = std::atan(w);
    const Complex sum = 0.5 * (1.0 - (w + z) * arc) / pi;
    const Complex slopes = -0.5 * ((w - z) * arc + 1.0) / pi;
    slope += sum;
    curvature -= slopes / z;
    psi += slopes * w * w;
    Vector6d s = from_potentials(z, slope, curvature, psi);
    // Turn back the axes.
    const double half = 0.5 * (s[0] + s[1]);
    const Complex d =
        Complex(0.5 * (s[0] - s[1]), s[3]) * std::polar(1.0, 2 * direction);
    s[0] = half + d.real();
    s[1] = half - d.real();
    s[3] = d.imag();
    return s;
  };
}

/// The whole ring: the pin's pressure is the program's own, the rim carries the
/// exact tractions.
void add_bearing(const std::vector<double>& directions,
                 std::vector<BandCase>& all) {
  for (const double direction : directions) {
    for (const auto& cells : {std::array{2, 8}, {3, 12}, {4, 16}}) {
      auto mesh = ring_mesh<2>({.inner = 1,
                                .outer = 2,
                                .thickness = 1,
                                .radial = cells[0],
                                .angular = cells[1]});
      loads::LoadHistory history;
      loads::Seat seat;
      seat.name = seat.group = "x0";
      seat.kind = loads::SeatKind::kBearing;
      history.seats.push_back(seat);
      history.instants.push_back({});
      history.instants[0].wrenches.push_back(
          {pi / 2 * Vector3d(std::cos(direction), std::sin(direction), 0),
           Vector3d::Zero()});
      auto pin =
          patch<2>("pin towards " + std::to_string(direction),
                   "quads " + std::to_string(cells[1]), mesh,
                   bearing(direction), {{{1, 0, 0}, "stress_yy"}}, {"x1"});
      pin.history = history;
      add_cases<2>(pin, all);
    }
  }
}

void add_beams(double b, std::vector<BandCase>& all) {
  const double N = 1 - b * b + (1 + b * b) * std::log(b);
  const auto sheared = [=](const Vector3d& x) {
    const double r = x.norm();
    const double angle = std::atan2(x.y(), x.x());
    const double c = b * b / (r * r * r);
    const double d = (1 + b * b) / r;
    return from_polar((r + c - d) * std::sin(angle) / N,
                      (3 * r - c - d) * std::sin(angle) / N,
                      -(r + c - d) * std::cos(angle) / N, 0.0, angle);
  };
  add_plane("curved beam, shear, b = " + std::to_string(b),
            sector(b, 0, pi / 2), sheared, {{{0, 1, 0}, "stress_xx"}},
            {{1, 2}, {2, 3}, {3, 4}}, all);
  const auto bent = [=](const Vector3d& x) {
    const double r = x.norm();
    const double log_b = std::log(b);
    const double n = std::pow(b * b - 1, 2) - 4 * b * b * log_b * log_b;
    const double q = b * b / (r * r) * log_b;
    const double radial = -4 / n * (q + b * b * std::log(r / b) - std::log(r));
    const double hoop =
        -4 / n * (-q + b * b * std::log(r / b) - std::log(r) + b * b - 1);
    return from_polar(radial, hoop, 0.0, 0.0, std::atan2(x.y(), x.x()));
  };
  add_plane("curved beam, bending, b = " + std::to_string(b),
            sector(b, 0.1, 1.0), bent,
            {{{std::cos(0.1), std::sin(0.1), 0}, "von_mises"}},
            {{1, 1}, {2, 2}, {3, 3}}, all);
}

/// Elliptic hole z = ζ + m/ζ under tension all round (Inglis); derivatives by
/// complex differences of 1e-5, good to 1e-10.
void add_ellipses(const std::vector<double>& all_m,
                  std::vector<BandCase>& all) {
  for (const double m : all_m) {
    const auto zeta_of = [=](Complex z) {
      const Complex root = std::sqrt(z * z - 4.0 * m);
      const Complex a = 0.5 * (z + root);
      const Complex b = 0.5 * (z - root);
      return std::abs(a) > std::abs(b) ? a : b;
    };
    const auto stress = [=](const Vector3d& x) {
      const Complex z(x.x(), x.y());
      const Complex zeta = zeta_of(z);
      const Complex w = zeta * zeta;
      const Complex dz = 1.0 - m / w;
      const auto slope_at = [=](Complex s) {
        return 0.5 * (1.0 + m / (s * s)) / (1.0 - m / (s * s));
      };
      const Complex slope = slope_at(zeta);
      const double e = 1e-5;
      const Complex curvature =
          (slope_at(zeta + e) - slope_at(zeta - e)) / (2 * e) / dz;
      const auto psi_at = [=](Complex s) {
        return -(1 + m * m) * s / (s * s - m);
      };
      const Complex psi = (psi_at(zeta + e) - psi_at(zeta - e)) / (2 * e) / dz;
      return from_potentials(z, slope, curvature, psi);
    };
    const Map<2> map = [=](const Vector2d& x) -> Vector2d {
      const Complex zeta = std::polar(std::pow(3.0, x[0]), pi / 2 * x[1]);
      const Complex z = zeta + m / zeta;
      return {z.real(), z.imag()};
    };
    add_plane("ellipse " + std::to_string(m), map, stress,
              {{{1 + m, 0, 0}, "stress_yy"}}, {{2, 3}, {4, 4}, {5, 8}}, all);
  }
}

/// Sources beside a square [0, 1]²: φ' = a/(z − z₀), ψ' = b/(z − z₀)².
void add_sources(const std::vector<double>& distances,
                 const std::vector<double>& places,
                 std::vector<BandCase>& all) {
  int k = 0;
  for (const double distance : distances) {
    for (const double along : places) {
      const Complex source(along, -distance);
      const Complex a = std::polar(1.0, 1.7 * ++k);
      const Complex b = 0.3 * std::polar(1.0, 2.9 * k);
      const auto stress = [=](const Vector3d& x) {
        const Complex z(x.x(), x.y());
        const Complex w = 1.0 / (z - source);
        return from_potentials(z, a * w, -a * w * w, b * w * w);
      };
      add_plane(
          "source at " + std::to_string(along) + ", " +
              std::to_string(distance),
          [](const Vector2d& x) -> Vector2d {
            return x;
          },
          stress, {{{0.5, 0, 0}, "stress_xx"}, {{0.3, 0.4, 0}, "stress_yy"}},
          {{2, 2}, {4, 4}, {5, 7}}, all);
    }
  }
}

void add_solids(std::vector<BandCase>& all) {
  // Sphere of radii 1 and 2 under inner pressure, a patch of it.
  const auto sphere = [](const Vector3d& x) {
    const double r = x.norm();
    const double q = 8 / (r * r * r);
    const Vector3d n = x / r;
    const double radial = (1 - q) / 7;
    const double hoop = (1 + q / 2) / 7;
    const Eigen::Matrix3d s = hoop * Eigen::Matrix3d::Identity() +
                              (radial - hoop) * n * n.transpose();
    Vector6d out;
    out << s(0, 0), s(1, 1), s(2, 2), s(0, 1), s(1, 2), s(0, 2);
    return out;
  };
  const Map<3> shell = [](const Vector3d& x) -> Vector3d {
    const Vector3d ray(1.0, std::tan(0.9 * (x[1] - 0.5)),
                       std::tan(0.9 * (x[2] - 0.5)));
    return std::pow(2.0, x[0]) * ray.normalized();
  };
  add_solid("sphere", shell, sphere, {{{1, 0, 0}, "stress_yy"}}, {2, 2, 2},
            all);
  // Kelvin's force beside a cube.
  for (const double distance : {0.3, 0.6}) {
    const Vector3d at(0.4, 0.55, -distance);
    const Vector3d force(std::cos(7 * distance), std::sin(7 * distance), 0.7);
    const auto kelvin = [=](const Vector3d& x) {
      const Vector3d d = x - at;
      const double r = d.norm();
      const Eigen::Matrix3d s =
          -(3 * d * d.transpose() * d.dot(force) / (r * r) +
            (1 - 2 * kNu) * (force * d.transpose() + d * force.transpose() -
                             d.dot(force) * Eigen::Matrix3d::Identity())) /
          (r * r * r);
      Vector6d out;
      out << s(0, 0), s(1, 1), s(2, 2), s(0, 1), s(1, 2), s(0, 2);
      return out;
    };
    add_solid(
        "force beside a cube " + std::to_string(distance),
        [](const Vector3d& x) -> Vector3d {
          return x;
        },
        kelvin, {{{0.5, 0.5, 0}, "stress_xx"}}, {3, 3, 3}, all);
  }
}

}  // namespace

std::vector<BandCase> closed_form_cases() {
  std::vector<BandCase> all;
  add_holes(all);
  add_tubes(all);
  add_spinning(all);
  add_bearing({0.0, 0.2, 0.5}, all);
  add_beams(2.0, all);
  add_ellipses({0.2, 0.4}, all);
  add_sources({0.15, 0.3, 0.6}, {0.5, 0.37, 0.9}, all);
  add_solids(all);
  return all;
}

std::vector<BandCase> held_out_closed_form_cases() {
  std::vector<BandCase> all;
  add_plane("Kirsch, far rim", sector(5, 0.7, 1.4), kirsch, {},
            {{3, 3}, {5, 5}}, all);
  add_plane("Lame, thin ring", sector(1.3, 0, pi / 2), lame(1.3),
            {{{1, 0, 0}, "stress_yy"}}, {{1, 3}, {2, 5}}, all);
  add_bearing({0.9, 1.3}, all);
  add_beams(3.0, all);
  add_ellipses({0.1, 0.3}, all);
  add_sources({0.22, 0.45}, {0.2, 0.65, 0.75}, all);
  return all;
}

}  // namespace clevis::support

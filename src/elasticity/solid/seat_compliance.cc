#include "elasticity/solid/seat_compliance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include "base/values/round_off_length.h"
#include "elasticity/problem/displacement_basis.h"
#include "elasticity/solid/energy_form.h"
#include "elasticity/solid/solid_solve.h"

namespace clevis::elasticity {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr int kDegree = 2;

/// Acceleration by which the part's inertia holds the wrenches.
loads::RigidAcceleration holding_acceleration(
    const std::vector<loads::Seat>& seats,
    const std::vector<loads::Wrench>& wrenches,
    const part::MassProperties& mass) {
  Vector3d force = Vector3d::Zero(), moment = Vector3d::Zero();  // about Cm
  for (std::size_t s = 0; s < seats.size(); ++s) {
    force += wrenches[s].force;
    moment += wrenches[s].moment +
              (seats[s].p_LS - mass.p_LCm).cross(wrenches[s].force);
  }
  loads::RigidAcceleration rigid;
  rigid.alpha = mass.inertia_LCm.ldlt().solve(moment);
  rigid.acceleration = force / mass.mass - rigid.alpha.cross(mass.p_LCm);
  return rigid;
}

/// Distances of the seats' points: a moment counts as force × this [m].
double reach(const std::vector<loads::Seat>& seats,
             const part::MassProperties& mass) {
  double length = 0.0;
  for (const auto& seat : seats) {
    length = std::max(length, (seat.p_LS - mass.p_LCm).norm());
  }
  return length > kRoundOffLength ? length : 1.0;
}

/// Spin about axes of L, of a part whose centre of mass rests.
loads::RigidAcceleration spin_about(const Vector3d& omega,
                                    const part::MassProperties& mass) {
  loads::RigidAcceleration rigid;
  rigid.omega = omega;
  rigid.alpha = -mass.inertia_LCm.ldlt().solve(
      omega.cross(Vector3d(mass.inertia_LCm * omega)));
  rigid.acceleration = -rigid.alpha.cross(mass.p_LCm) -
                       omega.cross(Vector3d(omega.cross(mass.p_LCm)));
  return rigid;
}

constexpr std::array<std::array<int, 2>, 6> kProducts{
    {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}}};

/// Loads whose energies tell those of any sum of them.
struct UnitLoads {
  loads::LoadHistory history;
  std::size_t wrenches{};  ///< on the seats, then elsewhere
  std::size_t elsewhere{};
  double length{};  ///< of unit moments, over forces [m]
  double speed{};   ///< of unit spins [rad/s]

  void push(std::vector<loads::Wrench> on_seats,
            const loads::RigidAcceleration& spin) {
    loads::InstantLoad load;
    load.rigid = spin;
    const auto held = holding_acceleration(history.seats, on_seats, mass);
    load.rigid.acceleration += held.acceleration;
    load.rigid.alpha += held.alpha;
    load.wrenches = std::move(on_seats);
    history.instants.push_back(std::move(load));
  }
  std::vector<loads::Wrench> none() const {
    return std::vector<loads::Wrench>(history.seats.size());
  }
  void add(std::size_t i, std::vector<loads::Wrench>& on_seats) const {
    const auto axis = static_cast<int>(i % 3);
    loads::Wrench& wrench = on_seats[i / 6];
    (i % 6 < 3 ? wrench.force[axis] += 1.0 : wrench.moment[axis] += length);
  }
  loads::RigidAcceleration spin(std::size_t k) const {
    Vector3d omega = Vector3d::Zero();
    for (const int axis : kProducts[k]) omega[axis] = speed;
    return spin_about(omega, mass);
  }

  const part::MassProperties& mass;
};

/// The unit wrenches, those elsewhere, the unit spins, the sums of each two
/// wrenches, of each wrench with each spin and with each elsewhere.
UnitLoads unit_loads(std::vector<loads::Seat> seats,
                     std::vector<loads::Seat> loaded,
                     const part::MassProperties& mass) {
  const double length = reach(seats, mass);
  const std::size_t n = 6 * seats.size(), m = 6 * loaded.size();
  std::ranges::move(loaded, std::back_inserter(seats));
  for (auto& seat : seats) {
    seat.kind = loads::SeatKind::kTraction;
    seat.slide.reset();
  }
  UnitLoads unit{.history = {},
                 .wrenches = n,
                 .elsewhere = m,
                 .length = length,
                 .speed = std::sqrt(1.0 / (mass.mass * length)),
                 .mass = mass};
  unit.history.seats = std::move(seats);
  for (std::size_t i = 0; i < n + m; ++i) {
    auto wrenches = unit.none();
    unit.add(i, wrenches);
    unit.push(std::move(wrenches), {});
  }
  for (std::size_t k = 0; k < kProducts.size(); ++k) {
    unit.push(unit.none(), unit.spin(k));
  }
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 1; j < n; ++j) {
      auto wrenches = unit.none();
      unit.add(i, wrenches);
      unit.add(j, wrenches);
      unit.push(std::move(wrenches), {});
    }
  }
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k < kProducts.size(); ++k) {
      auto wrenches = unit.none();
      unit.add(i, wrenches);
      unit.push(std::move(wrenches), unit.spin(k));
    }
  }
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = n; k < n + m; ++k) {
      auto wrenches = unit.none();
      unit.add(i, wrenches);
      unit.add(k, wrenches);
      unit.push(std::move(wrenches), {});
    }
  }
  return unit;
}

/// Twice the mixed energy of two kinds of loads [J], by polarisation.
/// @param both  of the sums of each of the one with each of the other.
MatrixXd mixed_form(const VectorXd& one, const VectorXd& other,
                    const VectorXd& both) {
  MatrixXd form(one.size(), other.size());
  for (Index i = 0; i < one.size(); ++i) {
    for (Index k = 0; k < other.size(); ++k) {
      form(i, k) = both[i * other.size() + k] - one[i] - other[k];
    }
  }
  return form;
}

/// Likewise Wᵀ D of unit wrenches and products of unit spins [J].
/// @param form  of the wrenches and the spins that have two axes at once.
MatrixXd spin_form(MatrixXd form) {
  for (std::size_t k = 3; k < kProducts.size(); ++k) {
    const auto& [one, other] = kProducts[k];
    form.col(static_cast<Index>(k)) -= form.col(one) + form.col(other);
  }
  return form;
}

}  // namespace

SeatCompliance seat_compliance(const mesh::PartMesh<3>& mesh,
                               const part::Material& material,
                               const part::MassProperties& mass,
                               std::vector<loads::Seat> seats,
                               std::vector<loads::Seat> loaded,
                               const std::string& name) {
  const UnitLoads unit = unit_loads(std::move(seats), std::move(loaded), mass);
  const VectorXd energy = solve<3>({.mesh = mesh,
                                    .material = material,
                                    .history = unit.history,
                                    .fixed = {},
                                    .name = name},
                                   kDegree)
                              .strain_energy;
  const auto n = static_cast<Index>(unit.wrenches);
  const auto m = static_cast<Index>(unit.elsewhere);
  const auto products = static_cast<Index>(kProducts.size());
  Index first = 0;
  const auto next = [&](Index count) {
    first += count;
    return VectorXd(energy.segment(first - count, count));
  };
  const VectorXd wrenches = next(n), elsewhere = next(m),
                 spins = next(products);
  const MatrixXd C = energy_form(wrenches, next(n * (n - 1) / 2));
  const MatrixXd D = spin_form(mixed_form(wrenches, spins, next(n * products)));
  const MatrixXd G = mixed_form(wrenches, elsewhere, next(n * m));
  const auto scales = [&unit](Index count) {
    VectorXd size(count);
    for (Index i = 0; i < count; ++i) size[i] = i % 6 < 3 ? 1.0 : unit.length;
    return VectorXd(size.cwiseInverse());
  };
  const VectorXd scale = scales(n);
  return {scale.asDiagonal() * C * scale.asDiagonal(),
          scale.asDiagonal() * D / (unit.speed * unit.speed),
          scale.asDiagonal() * G * scales(m).asDiagonal()};
}

}  // namespace clevis::elasticity

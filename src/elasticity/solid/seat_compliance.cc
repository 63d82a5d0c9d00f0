#include "elasticity/solid/seat_compliance.h"

#include <algorithm>
#include <array>
#include <cmath>
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
  std::size_t wrenches{};
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

/// The unit wrenches, the unit spins, the sums of each two wrenches and of each
/// wrench with each spin.
UnitLoads unit_loads(std::vector<loads::Seat> seats,
                     const part::MassProperties& mass) {
  const double length = reach(seats, mass);
  for (auto& seat : seats) {
    seat.kind = loads::SeatKind::kTraction;
    seat.slide.reset();
  }
  UnitLoads unit{.history = {},
                 .wrenches = 6 * seats.size(),
                 .length = length,
                 .speed = std::sqrt(1.0 / (mass.mass * length)),
                 .mass = mass};
  unit.history.seats = std::move(seats);
  const std::size_t n = unit.wrenches;
  for (std::size_t i = 0; i < n; ++i) {
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
  return unit;
}

/// Wᵀ D of unit wrenches and products of unit spins [J], by polarisation.
MatrixXd spin_form(const VectorXd& energy, Index n) {
  const auto products = static_cast<Index>(kProducts.size());
  const VectorXd both = energy.tail(n * products);
  MatrixXd form(n, products);
  for (Index i = 0; i < n; ++i) {
    for (Index k = 0; k < products; ++k) {
      form(i, k) = both[i * products + k] - energy[i] - energy[n + k];
    }
    for (Index k = 3; k < products; ++k) {
      const auto& [one, other] = kProducts[static_cast<std::size_t>(k)];
      form(i, k) -= form(i, one) + form(i, other);
    }
  }
  return form;
}

}  // namespace

SeatCompliance seat_compliance(const mesh::PartMesh<3>& mesh,
                               const part::Material& material,
                               const part::MassProperties& mass,
                               std::vector<loads::Seat> seats,
                               const std::string& name) {
  const UnitLoads unit = unit_loads(std::move(seats), mass);
  const VectorXd energy = solve<3>({.mesh = mesh,
                                    .material = material,
                                    .history = unit.history,
                                    .fixed = {},
                                    .name = name},
                                   kDegree)
                              .strain_energy;
  const auto n = static_cast<Index>(unit.wrenches);
  const auto products = static_cast<Index>(kProducts.size());
  const MatrixXd C = energy_form(energy.head(n),
                                 energy.segment(n + products, n * (n - 1) / 2));
  VectorXd size(n);
  for (Index i = 0; i < n; ++i) size[i] = i % 6 < 3 ? 1.0 : unit.length;
  const auto scale = size.cwiseInverse().asDiagonal();
  return {scale * C * scale,
          scale * spin_form(energy, n) / (unit.speed * unit.speed)};
}

}  // namespace clevis::elasticity

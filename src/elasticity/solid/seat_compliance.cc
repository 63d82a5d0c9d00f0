#include "elasticity/solid/seat_compliance.h"

#include <algorithm>
#include <optional>
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

/// The unit wrenches, then the sums of each two.
loads::LoadHistory unit_loads(std::vector<loads::Seat> seats,
                              const part::MassProperties& mass, double length) {
  loads::LoadHistory history;
  for (auto& seat : seats) {
    seat.kind = loads::SeatKind::kTraction;
    seat.slide.reset();
  }
  history.seats = std::move(seats);
  const std::size_t n = 6 * history.seats.size();
  const auto add = [&](std::size_t i, loads::InstantLoad& load) {
    const auto axis = static_cast<int>(i % 3);
    loads::Wrench& wrench = load.wrenches[i / 6];
    if (i % 6 < 3) {
      wrench.force[axis] += 1.0;
    } else {
      wrench.moment[axis] += length;
    }
  };
  const auto push = [&](std::size_t i, std::optional<std::size_t> j) {
    loads::InstantLoad load;
    load.wrenches.resize(history.seats.size());
    add(i, load);
    if (j) add(*j, load);
    load.rigid = holding_acceleration(history.seats, load.wrenches, mass);
    history.instants.push_back(std::move(load));
  };
  for (std::size_t i = 0; i < n; ++i) push(i, std::nullopt);
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 1; j < n; ++j) push(i, j);
  }
  return history;
}

}  // namespace

MatrixXd seat_compliance(const mesh::PartMesh<3>& mesh,
                         const part::Material& material,
                         const part::MassProperties& mass,
                         std::vector<loads::Seat> seats,
                         const std::string& name) {
  const double length = reach(seats, mass);
  const auto history = unit_loads(std::move(seats), mass, length);
  const VectorXd energy = solve<3>({.mesh = mesh,
                                    .material = material,
                                    .history = history,
                                    .fixed = {},
                                    .name = name},
                                   kDegree)
                              .strain_energy;
  const auto n = static_cast<Index>(6 * history.seats.size());
  const MatrixXd C = energy_form(energy.head(n), energy.tail(n * (n - 1) / 2));
  VectorXd unit(n);
  for (Index i = 0; i < n; ++i) unit[i] = i % 6 < 3 ? 1.0 : length;
  return unit.cwiseInverse().asDiagonal() * C *
         unit.cwiseInverse().asDiagonal();
}

}  // namespace clevis::elasticity

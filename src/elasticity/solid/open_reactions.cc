#include "elasticity/solid/open_reactions.h"

#include <utility>

#include "elasticity/problem/displacement_basis.h"
#include "elasticity/solid/energy_form.h"
#include "elasticity/solid/solid_solve.h"

namespace clevis::elasticity {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using Wrenches = std::vector<loads::Wrench>;

constexpr int kDegree = 2;

void add(const Wrenches& more, loads::InstantLoad& load) {
  for (std::size_t s = 0; s < more.size(); ++s) {
    load.wrenches[s].force += more[s].force;
    load.wrenches[s].moment += more[s].moment;
  }
}

/// The loads, each pattern, the loads with each, each two together.
void combine(const std::vector<Wrenches>& patterns,
             loads::LoadHistory& history) {
  const loads::InstantLoad loaded = history.instants.front();
  loads::InstantLoad nothing;
  nothing.wrenches.resize(history.seats.size());
  nothing.surface_loads = loaded.surface_loads;
  for (auto& load : nothing.surface_loads) {
    load = loads::SurfaceLoad{.group = load.group, .resultant = {}};
  }
  const auto push = [&](loads::InstantLoad load, const Wrenches& first,
                        const Wrenches& second = {}) {
    add(first, load);
    add(second, load);
    history.instants.push_back(std::move(load));
  };
  for (const Wrenches& p : patterns) push(nothing, p);
  for (const Wrenches& p : patterns) push(loaded, p);
  for (std::size_t i = 0; i < patterns.size(); ++i) {
    for (std::size_t j = i + 1; j < patterns.size(); ++j) {
      push(nothing, patterns[i], patterns[j]);
    }
  }
}

}  // namespace

PatternEnergy pattern_energy(const mesh::PartMesh<3>& mesh,
                             const part::Material& material,
                             loads::LoadHistory history,
                             const std::vector<Wrenches>& patterns,
                             const std::string& name) {
  for (auto& seat : history.seats) seat.kind = loads::SeatKind::kTraction;
  combine(patterns, history);
  const VectorXd energy = solve<3>({.mesh = mesh,
                                    .material = material,
                                    .history = history,
                                    .fixed = {},
                                    .name = name},
                                   kDegree)
                              .strain_energy;
  const auto n = static_cast<Index>(patterns.size());
  const VectorXd own = energy.segment(1, n);
  return {energy_form(own, energy.tail(n * (n - 1) / 2)),
          (energy.segment(1 + n, n) - own).array() - energy[0]};
}

}  // namespace clevis::elasticity

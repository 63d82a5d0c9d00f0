#include "elasticity/revolution/revolution_solve.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include <Eigen/QR>

#include "base/system/processor_share.h"
#include "base/values/stopwatch.h"
#include "elasticity/algebra/dense_product.h"
#include "elasticity/assembly/equations.h"
#include "elasticity/assembly/supports.h"
#include "elasticity/direct/dissection.h"
#include "elasticity/direct/frontal_cholesky.h"
#include "elasticity/nodal_loads/load_basis.h"
#include "elasticity/problem/self_checks.h"
#include "elasticity/revolution/harmonic_loads.h"
#include "elasticity/revolution/meridian_stiffness.h"
#include "elasticity/revolution/revolved_discretization.h"
#include "part/supports.h"

namespace clevis::elasticity {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

/// Which L components of a group's `fixed` hold the axial and which the two
/// transverse directions; nothing if they mix.
std::optional<std::pair<bool, bool>> held_directions(
    const mesh::Revolution& solid, const std::array<bool, 3>& fixed) {
  if (fixed[0] == fixed[1] && fixed[1] == fixed[2]) {
    return std::pair(fixed[0], fixed[0]);
  }
  for (std::size_t d = 0; d < 3; ++d) {
    if (std::abs(solid.axes(static_cast<Index>(d), 0)) < 1.0 - 1e-12) continue;
    const bool across = fixed[(d + 1) % 3];
    if (across != fixed[(d + 2) % 3]) return std::nullopt;
    return std::pair(fixed[d], across);
  }
  return std::nullopt;
}

double extent(const Discretization<2>& meridian) {
  const auto positions = node_positions(meridian);
  return (positions.rowwise().maxCoeff() - positions.rowwise().minCoeff())
      .norm();
}

/// Amplitudes that are zero: on the axis, and on fixed groups.
std::vector<int> held_amplitudes(const Discretization<2>& meridian,
                                 const mesh::Revolution& solid,
                                 const part::Supports& fixed, int order) {
  std::vector<int> held;
  for (int node : axis_nodes(meridian)) {
    if (order != 0) held.push_back(3 * node);
    held.push_back(3 * node + 1);
    if (order != 1) held.push_back(3 * node + 2);
  }
  for (std::size_t g = 0; g < meridian.groups.size(); ++g) {
    const auto entry = fixed.find(meridian.groups[g].name);
    if (entry == fixed.end()) continue;
    const auto directions = held_directions(solid, entry->second);
    if (!directions) continue;
    for (int node : group_nodes(meridian, static_cast<int>(g))) {
      if (directions->first) held.push_back(3 * node);
      if (!directions->second) continue;
      held.push_back(3 * node + 1);
      held.push_back(3 * node + 2);
    }
  }
  std::ranges::sort(held);
  held.erase(std::unique(held.begin(), held.end()), held.end());
  return held;
}

/// The rigid modes of an order, cosine and sine terms beside each other,
/// without those that are zero.
MatrixXd rigid_amplitudes(const Discretization<2>& meridian, int order) {
  const double length = extent(meridian);
  const MatrixXd cosine =
      harmonic_rigid_modes({order, false}, meridian, length);
  const MatrixXd sine = harmonic_rigid_modes({order, true}, meridian, length);
  MatrixXd all(cosine.rows(), 12);
  all << cosine, sine;
  Eigen::ColPivHouseholderQR<MatrixXd> qr(all);
  qr.setThreshold(1e-9);  // cosine and sine are one but for round-off
  MatrixXd modes(all.rows(), qr.rank());
  for (Index k = 0; k < qr.rank(); ++k) {
    modes.col(k) = all.col(qr.colsPermutation().indices()[k]);
  }
  return modes;
}

/// As many amplitudes as an order has rigid modes, far apart.
std::vector<int> determinate_amplitudes(const Discretization<2>& meridian,
                                        const std::vector<int>& on_axis,
                                        int order) {
  if (order > 1) return {};
  MatrixXd modes = rigid_amplitudes(meridian, order);
  for (int row : on_axis) modes.row(row).setZero();
  const Eigen::ColPivHouseholderQR<MatrixXd> qr(modes.transpose());
  std::vector<int> held;
  for (Index k = 0; k < modes.cols(); ++k) {
    held.push_back(static_cast<int>(qr.colsPermutation().indices()[k]));
  }
  return held;
}

/// One order's matrix with its supports.
struct OrderSystem {
  StiffnessMatrix<3> stiffness;
  std::vector<int> held;
};

/// All terms one below the other: row 3·nodes·h + dof belongs to term h.
class TermSystem {
 public:
  TermSystem(const Discretization<2>& meridian, std::vector<HarmonicLoad> loads)
      : block_(3 * meridian.nodes),
        dissection_(dissect(meridian)),
        loads_(std::move(loads)) {}

  std::vector<Harmonic> harmonics() const {
    std::vector<Harmonic> result;
    for (const auto& load : loads_) result.push_back(load.harmonic);
    return result;
  }

  void build(const MeridianStiffness& stiffness,
             const std::function<std::vector<int>(int)>& held) {
    for (const auto& load : loads_) {
      const int order = load.harmonic.order;
      if (systems_.contains(order)) continue;
      systems_.emplace(order,
                       OrderSystem{stiffness.of_order(order), held(order)});
    }
  }

  /// The load history as a few columns over all terms.
  LoadBasis compressed(double tolerance) const {
    Index rows = 0;
    for (const auto& load : loads_) rows += load.values.rows();
    const Index instants = loads_.empty() ? 0 : loads_.front().values.cols();
    MatrixXd stacked(rows, instants);
    Index at = 0;
    for (const auto& load : loads_) {
      stacked.middleRows(at, load.values.rows()) = load.values;
      at += load.values.rows();
    }
    LoadBasis basis = compress(stacked, tolerance);
    MatrixXd full =
        MatrixXd::Zero(block_ * Index(loads_.size()), basis.columns.cols());
    at = 0;
    for (std::size_t h = 0; h < loads_.size(); ++h) {
      for (const int node : loads_[h].nodes) {
        full.middleRows<3>(block_ * Index(h) + 3 * node) =
            basis.columns.middleRows<3>(at);
        at += 3;
      }
    }
    basis.columns = std::move(full);
    return basis;
  }

  std::vector<int> held() const {
    std::vector<int> result;
    for (std::size_t h = 0; h < loads_.size(); ++h) {
      for (int row : system(h).held) {
        result.push_back(static_cast<int>(block_ * Index(h)) + row);
      }
    }
    return result;
  }

  int equations() const {
    return static_cast<int>(block_ * Index(loads_.size())) -
           static_cast<int>(held().size());
  }

  StiffnessAction action() const {
    return {[this](const MatrixXd& x) {
              return apply(x, false);
            },
            [this](const MatrixXd& x) {
              return apply(x, true);
            }};
  }

  /// Terms of one order share a factorisation.
  MatrixXd solve(const MatrixXd& forces, const std::string& place) const {
    MatrixXd result(forces.rows(), forces.cols());
    if (forces.cols() == 0) return result;  // nothing loads it
    for (const auto& [order, system] : systems_) {
      std::vector<Index> begins;
      for (std::size_t h = 0; h < loads_.size(); ++h) {
        if (loads_[h].harmonic.order == order) {
          begins.push_back(block_ * Index(h));
        }
      }
      MatrixXd columns(block_, forces.cols() * Index(begins.size()));
      for (std::size_t k = 0; k < begins.size(); ++k) {
        columns.middleCols(forces.cols() * Index(k), forces.cols()) =
            forces.middleRows(begins[k], block_);
      }
      const auto numbers =
          number_equations(static_cast<int>(block_), system.held);
      const FrontalCholesky cholesky(
          free_equations(system.stiffness, numbers),
          front_tree(dissection_, 3, numbers.equation), place,
          own_processors());
      columns =
          extend_rows(cholesky.solve(restrict_rows(columns, numbers)), numbers);
      for (std::size_t k = 0; k < begins.size(); ++k) {
        result.middleRows(begins[k], block_) =
            columns.middleCols(forces.cols() * Index(k), forces.cols());
      }
    }
    return result;
  }

  /// Amplitudes per term of stacked columns, of orders >= `lowest`.
  std::vector<MatrixXd> amplitudes(const MatrixXd& columns, int lowest) const {
    std::vector<MatrixXd> result;
    for (std::size_t h = 0; h < loads_.size(); ++h) {
      result.emplace_back(columns.middleRows(block_ * Index(h), block_));
      if (loads_[h].harmonic.order < lowest) result.back().setZero();
    }
    return result;
  }

 private:
  const OrderSystem& system(std::size_t h) const {
    return systems_.at(loads_[h].harmonic.order);
  }
  MatrixXd apply(const MatrixXd& x, bool absolute) const {
    MatrixXd y(x.rows(), x.cols());
    for (std::size_t h = 0; h < loads_.size(); ++h) {
      const auto& k = system(h).stiffness;
      const MatrixXd part = x.middleRows(block_ * Index(h), block_);
      y.middleRows(block_ * Index(h), block_) =
          absolute ? k.absolute().multiply(part) : k.multiply(part);
    }
    return y;
  }

  Index block_;
  Dissection dissection_;
  std::vector<HarmonicLoad> loads_;
  std::map<int, OrderSystem> systems_;
};

}  // namespace

int highest_order(int degree) {
  return 2 << degree;
}

bool supports_fit(const mesh::Revolution& solid, const part::Supports& fixed) {
  if (fixed.empty()) return true;
  for (const auto& [name, components] : fixed) {
    if (!held_directions(solid, components)) return false;
  }
  const auto meridian = discretize(solid.meridian, 1);
  constexpr double kLoose = 1e-9;
  for (const int order : {0, 1}) {
    const MatrixXd modes = rigid_amplitudes(meridian, order);
    const auto held = held_amplitudes(meridian, solid, fixed, order);
    MatrixXd rows(static_cast<Index>(held.size()), modes.cols());
    for (std::size_t k = 0; k < held.size(); ++k) {
      rows.row(static_cast<Index>(k)) = modes.row(held[k]);
    }
    Eigen::ColPivHouseholderQR<MatrixXd> qr(rows);
    qr.setThreshold(kLoose);
    if (qr.rank() < modes.cols()) return false;
  }
  return true;
}

RevolutionSolution solve_revolution(const RevolutionProblem& problem,
                                    int degree) {
  constexpr double kCompressionTolerance = 3e-7;
  Stopwatch watch;
  const std::string place = "part " + problem.name;
  const double density = problem.material.density;
  const auto meridian = discretize(problem.solid.meridian, degree);
  RevolutionSolution result;
  auto& basis = result.basis;

  auto terms =
      assemble_harmonic_loads(meridian, problem.solid, problem.history, density,
                              highest_order(degree), problem.name);
  const bool is_free = problem.fixed.empty();
  if (is_free) {
    std::tie(basis.checks.relief, basis.checks.balance) =
        balance_harmonic_loads(meridian, density, extent(meridian), terms);
  }
  TermSystem system(meridian, std::move(terms));
  const MeridianStiffness stiffness(meridian, problem.material, place);
  system.build(stiffness, [&](int order) {
    auto held = held_amplitudes(meridian, problem.solid, problem.fixed, order);
    if (is_free) {
      const auto more = determinate_amplitudes(meridian, held, order);
      held.insert(held.end(), more.begin(), more.end());
      std::ranges::sort(held);
    }
    return held;
  });
  require_dofs(system.equations(), problem.max_dofs, place);
  if (problem.tell_dofs) problem.tell_dofs(system.equations());
  const LoadBasis loads = system.compressed(kCompressionTolerance);
  basis.checks.compression = loads.compression_error;
  basis.coefficients = loads.coefficients;
  basis.seconds.assemble = watch.lap();

  const MatrixXd stacked = system.solve(loads.columns, place);
  basis.seconds.factor = watch.lap();
  basis.strain_energy = check_solution(system.action(), stacked, loads,
                                       system.held(), is_free, basis.checks);
  require_checks(basis.checks, meridian.geometry_degree, problem.name);

  const auto harmonics = system.harmonics();
  int highest = 0;
  for (const auto& h : harmonics) highest = std::max(highest, h.order);
  const AngularGrid grid(highest);
  basis.discretization = revolve(meridian, problem.solid, grid);
  basis.columns = sum_harmonics(harmonics, system.amplitudes(stacked, 0),
                                problem.solid, grid);
  if (highest > 2) {
    result.upper_half =
        sum_harmonics(harmonics, system.amplitudes(stacked, highest / 2 + 1),
                      problem.solid, grid);
  }
  result.terms = static_cast<int>(harmonics.size());
  basis.equations = system.equations();
  basis.seconds.solve = watch.lap();
  return result;
}

}  // namespace clevis::elasticity

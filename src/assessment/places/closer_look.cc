#include "assessment/places/closer_look.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "assessment/places/local_solve.h"
#include "elasticity/fe_space/tabulation.h"
#include "stress/field/surface_mesh.h"
#include "stress/peaks/lattice_maximum.h"
#include "stress/peaks/meeting_points.h"
#include "stress/surface/surface_kink.h"

namespace clevis::assessment {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using stress::FieldPoint;

/// Finer solutions are looked at on a lattice twice as close as usual.
constexpr int kFineLattice = 8;
constexpr double kNothing = -std::numeric_limits<double>::infinity();

/// Solutions in the cells of a centre, lattice points × cells.
struct FinerFields {
  stress::JoinedStress low;   ///< one degree higher
  stress::JoinedStress high;  ///< two degrees higher
  /// As low, with a second layer around; not always solved for.
  std::optional<stress::JoinedStress> wide = std::nullopt;
};

/// From the instants that were solved for to the worst one of each point.
struct Rise {
  MatrixXd added;          ///< points of kFineLattice × cells [Pa]
  Eigen::MatrixXi to;      ///< that worst instant, index
  Eigen::VectorXd factor;  ///< of each cell's largest, >= 1 [1]
};

/// Stress of some cells.
struct JudgedStress {
  CloserStress stress;
  double least_error{};  ///< sure without a second layer [Pa]
  double rise{};         ///< of the value, to another instant [Pa]
  int rises_to{};        ///< that instant, index
};

/// Differences by degree, layer and cells, each by its largest in the cell
/// where the stress is not far below its largest: what agrees at a point by
/// chance does not hide it.
/// @param counting  points × cells: those that are not left out.
/// @return at a cell of the centre, a point of kFineLattice.
template <int dim>
JudgedStress judge(mesh::CellShape shape, const FinerFields& fields,
                   const Rise& rise, const Eigen::MatrixXd& counting) {
  constexpr double kNear = 0.9;
  // A hexahedron may be all that there is across a part.
  const bool is_hexahedron = dim == 3 && shape == mesh::CellShape::kTensor;
  const double degree_share = dim == 2 ? 0.6 : is_hexahedron ? 0.55 : 0.45;
  const double layer_share = dim == 2 || is_hexahedron ? 0.5 : 0.4;
  constexpr double kJump = 0.15;
  const MatrixXd by_degree = fields.high.mean - fields.low.mean;
  MatrixXd by_layer = MatrixXd::Zero(by_degree.rows(), by_degree.cols());
  if (fields.wide) by_layer = fields.wide->mean - fields.low.mean;
  const MatrixXd value =
      (fields.high.mean + by_layer + rise.added).cwiseProduct(counting);
  const MatrixXd& off_by_layer = fields.wide ? by_layer : by_degree;
  const double least = kNear * value.maxCoeff();
  JudgedStress judged{{{kNothing, kNothing, kNothing}, {}}};
  PlaceEstimate& estimate = judged.stress.stress;
  for (Index c = 0; c < value.cols(); ++c) {
    const Eigen::ArrayXd counts =
        (value.col(c).array() >= least).cast<double>() *
        counting.col(c).array();
    const auto largest = [&](const auto& difference) {
      return (difference.array().abs() * counts).maxCoeff();
    };
    Index point = 0;
    const double highest = value.col(c).maxCoeff(&point);
    const double peak = highest + stress::rise_between_points<dim>(
                                      shape, kFineLattice, value.col(c),
                                      counting.col(c), point);
    const double sure =
        rise.factor[c] * (degree_share * largest(by_degree.col(c)) +
                          kJump * largest(fields.high.jump.col(c)));
    const double error =
        sure + rise.factor[c] * layer_share * largest(off_by_layer.col(c));
    estimate.high = std::max(estimate.high, peak + error);
    if (peak <= estimate.value) continue;
    estimate.value = peak;
    // What it rises by at another instant is not solved for.
    estimate.low = peak - error - rise.added(point, c);
    judged.least_error = sure;
    judged.rise = rise.added(point, c);
    judged.rises_to = rise.to(point, c);
    judged.stress.at = {static_cast<int>(c), static_cast<int>(point)};
  }
  return judged;
}

/// What the solved stress rises by, point by point: loads that travel stress
/// one end of a cell now and the other later.
/// @param then  largest of the instants that are looked at, points of the
///   history × cells of the centre [Pa].
template <int dim>
Rise rise_above(const SolvedSet<dim>& solved, const std::vector<int>& centre,
                const MatrixXd& then) {
  const stress::StressHistory& history = solved.history;
  const auto cells = static_cast<Index>(centre.size());
  const auto fine = elasticity::lattice<dim>(solved.mesh.shape, kFineLattice);
  const auto usual =
      elasticity::lattice<dim>(solved.mesh.shape, history.subdivisions);
  Rise result{MatrixXd::Zero(fine.cols(), cells),
              Eigen::MatrixXi::Zero(fine.cols(), cells),
              Eigen::VectorXd::Ones(cells)};
  if (solved.basis.coefficients.cols() < 2) return result;
  const MatrixXd worst = history.worst(Eigen::all, centre);
  for (Index k = 0; k < cells; ++k) {
    const double now = then.col(k).maxCoeff();
    if (now > 0.0) {
      result.factor[k] = std::max(1.0, worst.col(k).maxCoeff() / now);
    }
  }
  const MatrixXd rise = (worst - then).cwiseMax(0.0);
  for (Index i = 0; i < fine.cols(); ++i) {
    // Linear between the points along each of the cell's directions.
    const Eigen::RowVectorXd weights =
        (1.0 -
         history.subdivisions * (usual.colwise() - fine.col(i)).array().abs())
            .max(0.0)
            .colwise()
            .prod();
    result.added.row(i) = weights * rise / weights.sum();
    for (Index k = 0; k < cells; ++k) {
      Index most = 0;
      rise.col(k).cwiseProduct(weights.transpose()).maxCoeff(&most);
      result.to(i, k) =
          history.worst_instant(most, centre[static_cast<std::size_t>(k)]);
    }
  }
  return result;
}

/// A look at some cells at one instant.
template <int dim>
class Look {
 public:
  Look(const SolvedSet<dim>& solved, const std::vector<int>& centre,
       int instant)
      : solved_(solved),
        centre_(centre),
        instant_(instant),
        field_(field_in_centre()),
        then_(stress::stress_history<dim>(field_, solved.job.part.material,
                                          solved.history.subdivisions)
                  .worst),
        shape_error_(shape_error()) {}

  /// Stress as it was solved, points of the history × cells [Pa].
  const MatrixXd& then() const { return then_; }
  /// Error of the surface's shape [Pa].
  double shape(const Rise& rise) const {
    return rise.factor.maxCoeff() * shape_error_;
  }

  /// @return false where that was worth nothing.
  bool solve(double pollution, const Rise& rise, const WorthOf& worth_of) {
    pollution_ = pollution;
    fields_ = {solved_nearby(1, 1), solved_nearby(1, 2)};
    const JudgedStress known = judged(rise);
    const Worth worth =
        worth_of({known.least_error, shape(rise), known.stress.stress});
    if (worth == Worth::kMore) fields_.wide = solved_nearby(2, 1);
    return worth != Worth::kNothing;
  }

  /// @pre solve().
  JudgedStress judged(const Rise& rise) const {
    JudgedStress all =
        judge<dim>(solved_.mesh.shape, fields_, rise, counting());
    const double off = pollution_ * all.stress.stress.value + shape(rise);
    all.stress.at = on_lattice(all.stress.at);
    all.stress.instant = instant_;
    all.stress.stress.low -= off;
    all.stress.stress.high += off;
    all.least_error += off;
    return all;
  }

 private:
  stress::JoinedStress solved_nearby(int layers, int more) const {
    const auto enriched =
        solve_nearby<dim>(solved_.job, solved_.set, solved_.mesh, solved_.basis,
                          {centre_, layers, instant_, solved_.degree + more});
    const auto joined = stress::joined_stress<dim>(
        enriched.basis, solved_.job.part.material, kFineLattice);
    stress::JoinedStress of_centre{
        MatrixXd(joined.mean.rows(), static_cast<Index>(centre_.size())),
        MatrixXd(joined.mean.rows(), static_cast<Index>(centre_.size()))};
    for (std::size_t k = 0; k < enriched.cells.size(); ++k) {
      const auto at = std::ranges::lower_bound(centre_, enriched.cells[k]);
      if (at == centre_.end() || *at != enriched.cells[k]) continue;
      const Index column = at - centre_.begin();
      of_centre.mean.col(column) = joined.mean.col(static_cast<Index>(k));
      of_centre.jump.col(column) = joined.jump.col(static_cast<Index>(k));
    }
    return of_centre;
  }

  /// The solved field at the place's instant in the centre alone.
  elasticity::DisplacementBasis<dim> field_in_centre() const {
    const auto& basis = solved_.basis;
    elasticity::DisplacementBasis<dim> part;
    part.discretization = basis.discretization;
    auto& d = part.discretization;
    d.cell_nodes.clear();
    d.cell_points.clear();
    for (const int cell : centre_) {
      const auto c = static_cast<std::size_t>(cell);
      d.cell_nodes.push_back(basis.discretization.cell_nodes[c]);
      d.cell_points.push_back(basis.discretization.cell_points[c]);
    }
    part.columns = basis.columns * basis.coefficients.col(instant_);
    part.coefficients = MatrixXd::Ones(1, 1);
    return part;
  }

  /// 1 at the points of the fine lattice that count, 0 at those beside points
  /// of the usual one that are left out.
  MatrixXd counting() const {
    const auto& history = solved_.history;
    const auto shape = solved_.mesh.shape;
    const auto fine = elasticity::lattice<dim>(shape, kFineLattice);
    const auto usual = elasticity::lattice<dim>(shape, history.subdivisions);
    const double beside = 1.01 * std::sqrt(double(dim)) *
                          (1.0 / history.subdivisions - 1.0 / kFineLattice);
    MatrixXd result =
        MatrixXd::Ones(fine.cols(), static_cast<Index>(centre_.size()));
    for (std::size_t k = 0; k < centre_.size(); ++k) {
      for (Index q = 0; q < usual.cols(); ++q) {
        if (history.worst(q, centre_[k]) >= 0.0) continue;
        for (Index i = 0; i < fine.cols(); ++i) {
          if ((fine.col(i) - usual.col(q)).norm() <= beside) {
            result(i, static_cast<Index>(k)) = 0.0;
          }
        }
      }
    }
    return result;
  }

  /// The point of the history's lattice that stands in for it.
  /// @param fine  cell of the centre, point of kFineLattice.
  FieldPoint on_lattice(const FieldPoint& fine) const {
    return {centre_[static_cast<std::size_t>(fine.cell)],
            stress::stand_in<dim>(solved_.mesh.shape, kFineLattice, fine.point,
                                  solved_.history.subdivisions)};
  }

  /// By what the mesh makes of a curved surface [Pa]: a surface whose slope is
  /// off by δ/2 to and fro has a stress that is by up to 0.8 δ off where it
  /// flows across (theory.md, facets).
  double shape_error() const {
    if constexpr (dim == 3) {
      constexpr double kOfKink = 0.8;
      constexpr int kIntervals = 4;
      return kOfKink * stress::kinked_stress(
                           solved_.mesh, centre_,
                           stress::instant_field<dim>(
                               field_, solved_.job.part.material, kIntervals, 0)
                               .stress);
    }
    return 0.0;
  }

  const SolvedSet<dim>& solved_;
  const std::vector<int>& centre_;
  int instant_;
  elasticity::DisplacementBasis<dim> field_;  ///< of field_in_centre()
  MatrixXd then_;
  double shape_error_;  ///< at the instant [Pa]
  double pollution_{};  ///< of a value [1]
  FinerFields fields_;
};

/// The largest of looks at one centre.
template <int dim>
JudgedStress joined(const std::vector<Look<dim>>& looks, const Rise& rise) {
  std::vector<JudgedStress> all;
  std::vector<PlaceEstimate> estimates;
  for (const Look<dim>& look : looks) {
    all.push_back(look.judged(rise));
    estimates.push_back(all.back().stress.stress);
  }
  const LargestPlace largest = largest_place(estimates);
  JudgedStress result = all[largest.place];
  result.stress.stress.low = largest.low;
  result.stress.stress.high = largest.high;
  return result;
}

}  // namespace

template <int dim>
std::optional<CloserStress> look_closer(const SolvedSet<dim>& solved,
                                        const Place& place,
                                        const std::vector<int>& centre,
                                        double pollution,
                                        const WorthOf& worth_of) {
  constexpr std::size_t kMostLooks = 3;
  constexpr double kMuch = 0.2;  // of the tolerance
  std::vector<Look<dim>> looks;
  looks.emplace_back(solved, centre, place.instant);
  MatrixXd then = looks.front().then();
  Rise rise = rise_above<dim>(solved, centre, then);
  const double shape = looks.front().shape(rise);
  const KnownOfPlace known{pollution * place.high + shape, shape, std::nullopt};
  if (worth_of(known) == Worth::kNothing ||
      !looks.front().solve(pollution, rise, worth_of)) {
    return std::nullopt;
  }
  for (;;) {
    const JudgedStress closer = joined<dim>(looks, rise);
    const double least =
        kMuch * solved.job.tolerance * closer.stress.stress.value;
    if (closer.rise <= least || looks.size() == kMostLooks) {
      return closer.stress;
    }
    Look<dim> next(solved, centre, closer.rises_to);
    then = then.cwiseMax(next.then());
    const Rise lower = rise_above<dim>(solved, centre, then);
    if (!next.solve(pollution, lower, worth_of)) return closer.stress;
    looks.push_back(std::move(next));
    rise = lower;
  }
}

template std::optional<CloserStress> look_closer<2>(const SolvedSet<2>&,
                                                    const Place&,
                                                    const std::vector<int>&,
                                                    double, const WorthOf&);
template std::optional<CloserStress> look_closer<3>(const SolvedSet<3>&,
                                                    const Place&,
                                                    const std::vector<int>&,
                                                    double, const WorthOf&);

}  // namespace clevis::assessment

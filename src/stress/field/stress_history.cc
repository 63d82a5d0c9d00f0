#include "stress/field/stress_history.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "elasticity/algebra/dense_product.h"
#include "elasticity/algebra/even_runs.h"
#include "stress/field/cell_field.h"

namespace clevis::stress {
namespace {

using Eigen::ArrayXXd;
using Eigen::Index;
using Eigen::MatrixXd;

/// The points of a lattice that are evaluated, and of each point of the lattice
/// the evaluated one whose von Mises it has.
template <int dim>
struct Sampling {
  elasticity::ReferencePoints<dim> points;
  std::vector<Index> source;
};

/// All points; of a field that mirrors itself about the mid-plane of a layer
/// those of one half.
template <int dim>
Sampling<dim> sample(const elasticity::ReferencePoints<dim>& lattice,
                     bool is_mirrored) {
  constexpr double kSame = 1e-9;
  Sampling<dim> sampling{
      lattice, std::vector<Index>(static_cast<std::size_t>(lattice.cols()))};
  Index kept = 0;
  for (Index q = 0; q < lattice.cols(); ++q) {
    Eigen::Matrix<double, dim, 1> point = lattice.col(q);
    if (is_mirrored)
      point[dim - 1] = std::min(point[dim - 1], 1.0 - point[dim - 1]);
    Index at = is_mirrored ? 0 : kept;
    while (at < kept && (sampling.points.col(at) - point).norm() > kSame) ++at;
    if (at == kept) sampling.points.col(kept++) = point;
    sampling.source[static_cast<std::size_t>(q)] = at;
  }
  sampling.points.conservativeResize(Eigen::NoChange, kept);
  return sampling;
}

template <typename Real>
using MatrixOf = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;
template <typename Real>
using ArrayOf = Eigen::Array<Real, Eigen::Dynamic, 1>;

/// Squares of von Mises [Pa²] in one cell.
template <typename Real>
struct CellPeaks {
  ArrayOf<Real> value;    ///< largest of each point
  ArrayOf<Real> instant;  ///< that it stands in
};

/// Instants in blocks whose stresses stay in the cache.
template <typename Real>
class Instants {
 public:
  explicit Instants(const MatrixXd& coefficients)
      : peak_(Eigen::VectorXd::Zero(coefficients.cols())) {
    constexpr Index kBlock = 64;
    for (Index begin = 0; begin < coefficients.cols(); begin += kBlock) {
      const Index count = std::min(kBlock, coefficients.cols() - begin);
      blocks_.push_back(
          coefficients.middleCols(begin, count).template cast<Real>());
    }
  }

  /// @param deviator  blocks of `points` rows.
  CellPeaks<Real> take(const MatrixXd& deviator, Index points) {
    const MatrixOf<Real> columns = deviator.template cast<Real>();
    CellPeaks<Real> worst{ArrayOf<Real>::Constant(points, Real{-1}),
                          ArrayOf<Real>::Zero(points)};
    ArrayOf<Real> squared(points);
    Real* value = worst.value.data();
    Real* instant = worst.instant.data();
    Index at = 0;
    for (const MatrixOf<Real>& block : blocks_) {
      const MatrixOf<Real> here = elasticity::product(columns, block);
      for (Index i = 0; i < block.cols(); ++i, ++at) {
        squared = here.col(i).head(points).array().square();
        for (Index row = points; row < here.rows(); row += points) {
          squared += here.col(i).segment(row, points).array().square();
        }
        const Real* mises = squared.data();
        const auto now = static_cast<Real>(at);
        for (Index q = 0; q < points; ++q) {
          const bool higher = mises[q] > value[q];
          value[q] = higher ? mises[q] : value[q];
          instant[q] = higher ? now : instant[q];
        }
        peak_[at] =
            std::max(peak_[at], static_cast<double>(squared.maxCoeff()));
      }
    }
    return worst;
  }

  /// Takes in what another one took.
  void join(const Instants& other) { peak_ = peak_.cwiseMax(other.peak_); }

  /// Of each instant, of all cells taken.
  const Eigen::VectorXd& peak() const { return peak_; }

 private:
  std::vector<MatrixOf<Real>> blocks_;
  Eigen::VectorXd peak_;
};

/// Largest of each point in one cell: von Mises squared [Pa²], and when.
struct PointPeaks {
  Eigen::VectorXd value;
  Eigen::VectorXi instant;
};

/// All instants.
class EveryInstant {
 public:
  explicit EveryInstant(const MatrixXd& coefficients)
      : instants_(coefficients) {}

  PointPeaks take(const MatrixXd& deviator, Index points) {
    const auto worst = instants_.take(deviator, points);
    return {worst.value.matrix(), worst.instant.cast<int>().matrix()};
  }
  void join(const EveryInstant& other) { instants_.join(other.instants_); }
  Eigen::VectorXd peak() const { return instants_.peak().cwiseSqrt(); }
  double rounding() const { return 0.0; }

 private:
  Instants<double> instants_;
};

/// Many instants: floats find about when each point is stressed most, doubles
/// say when and how much. What floats are off there, all of them may be.
class ManyInstants {
 public:
  explicit ManyInstants(const MatrixXd& coefficients)
      : coefficients_(coefficients),
        instants_(coefficients),
        exact_(Eigen::VectorXd::Zero(coefficients.cols())) {}

  PointPeaks take(const MatrixXd& deviator, Index points) {
    const auto rough = instants_.take(deviator, points);
    const MatrixXd rows = deviator.transpose();
    PointPeaks worst{Eigen::VectorXd(points), Eigen::VectorXi(points)};
    for (Index q = 0; q < points; ++q) {
      const auto squared = [&](Index instant) {
        double sum = 0.0;
        for (Index row = q; row < rows.cols(); row += points) {
          const double component =
              rows.col(row).dot(coefficients_.col(instant));
          sum += component * component;
        }
        return sum;
      };
      auto instant = static_cast<Index>(rough.instant[q]);
      double value = squared(instant);
      const double found = std::sqrt(static_cast<double>(rough.value[q]));
      off_ = std::max(off_, std::abs(std::sqrt(value) - found));
      // Floats do not tell instants near the top apart.
      for (const Index step : {-1, 1}) {
        for (Index next = instant + step;
             next >= 0 && next < coefficients_.cols(); next += step) {
          const double there = squared(next);
          if (!(there > value)) break;
          value = there;
          instant = next;
        }
      }
      double& exact = exact_[instant];
      exact = std::max(exact, std::sqrt(value));
      worst.value[q] = value;
      worst.instant[q] = static_cast<int>(instant);
    }
    return worst;
  }
  void join(const ManyInstants& other) {
    instants_.join(other.instants_);
    exact_ = exact_.cwiseMax(other.exact_);
    off_ = std::max(off_, other.off_);
  }
  /// The largest is that of the points, to the last bit.
  Eigen::VectorXd peak() const {
    return instants_.peak()
        .cwiseSqrt()
        .cwiseMin(exact_.maxCoeff())
        .cwiseMax(exact_);
  }
  double rounding() const { return off_; }

 private:
  const MatrixXd& coefficients_;
  Instants<float> instants_;
  Eigen::VectorXd exact_;  ///< of points at their worst instants [Pa]
  double off_ = 0.0;       ///< [Pa]
};

/// From so many on the products with them are most of the work.
constexpr Index kMany = 64;

template <int dim, class Peaks>
StressHistory history_of(const elasticity::DisplacementBasis<dim>& basis,
                         const part::Material& material, int subdivisions) {
  const auto& discretization = basis.discretization;
  const auto points =
      elasticity::lattice<dim>(discretization.shape, subdivisions);
  const auto sampling = sample<dim>(points, basis.is_mirrored);
  const CellField<dim> cell_field(discretization, material, sampling.points);
  const Index n = points.cols();
  StressHistory result;
  result.subdivisions = subdivisions;
  result.worst.resize(n, discretization.cells());
  result.worst_instant.resize(n, discretization.cells());
  const auto on_half_lattice = [&](Index q) {
    for (int d = 0; d < dim; ++d) {
      const double position = points(d, q) * subdivisions / 2.0;
      if (std::abs(position - std::round(position)) > 0.1) return false;
    }
    return true;
  };
  struct Run {
    Peaks peaks;
    double largest = -1.0, largest_of_half = 0.0;  ///< [Pa²]
    FieldPoint at = {};
    int instant = 0;
  };
  const auto look_at = [&](Index from, Index to) {
    Run run{Peaks(basis.coefficients)};
    for (Index c = from; c < to; ++c) {
      const PointPeaks worst = run.peaks.take(
          deviator<dim>(
              cell_field.stress(static_cast<std::size_t>(c), basis.columns),
              sampling.points.cols()),
          sampling.points.cols());
      auto when = result.worst_instant.col(c);
      for (Index q = 0; q < n; ++q) {
        const Index at = sampling.source[static_cast<std::size_t>(q)];
        const double value = worst.value[at];
        result.worst(q, c) = value;
        when[q] = worst.instant[at];
        if (value > run.largest_of_half && on_half_lattice(q)) {
          run.largest_of_half = value;
        }
        if (value > run.largest) {
          run.largest = value;
          run.at = {static_cast<int>(c), static_cast<int>(q)};
          run.instant = when[q];
        }
      }
    }
    return run;
  };
  constexpr Index kFewest = 64;
  auto runs =
      elasticity::in_even_runs(discretization.cells(), kFewest, look_at);
  Peaks& peaks = runs.front().peaks;
  double largest = -1.0, largest_of_half = 0.0;
  for (const Run& run : runs) {
    peaks.join(run.peaks);
    largest_of_half = std::max(largest_of_half, run.largest_of_half);
    if (!(run.largest > largest)) continue;
    largest = run.largest;
    result.peak_at = run.at;
    result.peak_instant = run.instant;
  }
  if (subdivisions > 1) {
    result.sampling_error =
        (std::sqrt(largest) - std::sqrt(largest_of_half)) / 3.0;
  }
  result.sampling_error += peaks.rounding();
  result.worst = result.worst.cwiseSqrt();
  result.peak = peaks.peak();
  return result;
}

}  // namespace

template <int dim>
StressHistory stress_history(const elasticity::DisplacementBasis<dim>& basis,
                             const part::Material& material, int subdivisions) {
  return basis.coefficients.cols() < kMany
             ? history_of<dim, EveryInstant>(basis, material, subdivisions)
             : history_of<dim, ManyInstants>(basis, material, subdivisions);
}

template <int dim>
Eigen::VectorXd peaks_outside(const elasticity::DisplacementBasis<dim>& basis,
                              const part::Material& material, int subdivisions,
                              const Eigen::MatrixXi& zone_of) {
  const auto& discretization = basis.discretization;
  const auto points =
      elasticity::lattice<dim>(discretization.shape, subdivisions);
  const CellField<dim> cell_field(discretization, material, points);
  Eigen::VectorXd peak = Eigen::VectorXd::Zero(basis.coefficients.cols());
  for (int c = 0; c < discretization.cells(); ++c) {
    ArrayXXd squared = von_mises_squared<dim>(
        elasticity::product(
            cell_field.stress(static_cast<std::size_t>(c), basis.columns),
            basis.coefficients),
        points.cols());
    for (Index q = 0; q < points.cols(); ++q) {
      if (zone_of(q, c) >= 0) squared.row(q).setZero();
    }
    peak = peak.cwiseMax(squared.colwise().maxCoeff().matrix().transpose());
  }
  return peak.cwiseSqrt();
}

template <int dim>
InstantField instant_field(const elasticity::DisplacementBasis<dim>& basis,
                           const part::Material& material, int subdivisions,
                           int instant) {
  const auto& discretization = basis.discretization;
  const auto points =
      elasticity::lattice<dim>(discretization.shape, subdivisions);
  const CellField<dim> cell_field(discretization, material, points);
  const Index n = points.cols();
  const MatrixXd u =
      elasticity::product(basis.columns, basis.coefficients.col(instant));
  InstantField field;
  field.subdivisions = subdivisions;
  for (std::size_t c = 0; c < discretization.cell_nodes.size(); ++c) {
    MatrixXd at = MatrixXd::Constant(n, 3, discretization.mid_plane_z);
    at.leftCols<dim>() = cell_field.positions(c);
    MatrixXd displacement = MatrixXd::Zero(n, 3);
    displacement.leftCols<dim>() = cell_field.displacement(c, u);
    const MatrixXd values = cell_field.stress(c, u);
    MatrixXd stress = MatrixXd::Zero(n, 6);
    for (int k = 0; k < kStressComponents<dim>; ++k) {
      stress.col(dim == 2 && k == 2 ? 3 : k) = values.middleRows(k * n, n);
    }
    field.points.push_back(std::move(at));
    field.displacement.push_back(std::move(displacement));
    field.stress.push_back(std::move(stress));
  }
  return field;
}

Eigen::Matrix3d stress_tensor(const Eigen::Matrix<double, 1, 6>& row) {
  Eigen::Matrix3d stress;
  stress << row[0], row[3], row[5], row[3], row[1], row[4], row[5], row[4],
      row[2];
  return stress;
}

namespace {

/// By how much the parabola through the largest value and its neighbours
/// rises above it; 0 if it stands at an end.
double vertex_excess(const Eigen::VectorXd& peak) {
  Index at = 0;
  peak.maxCoeff(&at);
  if (at == 0 || at == peak.size() - 1) return 0.0;
  const double slope = 0.5 * (peak[at + 1] - peak[at - 1]);
  const double curvature = peak[at + 1] - 2.0 * peak[at] + peak[at - 1];
  return curvature < 0.0 ? -0.5 * slope * slope / curvature : 0.0;
}

}  // namespace

double time_sampling_error(const Eigen::VectorXd& peak) {
  const Index n = peak.size();
  if (n < 2) return 0.0;
  constexpr Index kFew = 12;
  if (n < kFew) return peak.maxCoeff() - peak.minCoeff();
  const double ends = std::max(peak[0], peak[n - 1]);
  double largest[2] = {ends, ends};
  for (Index i = 0; i < n; ++i) {
    largest[i % 2] = std::max(largest[i % 2], peak[i]);
  }
  // Flanks may be steeper than a parabola's: it is doubted as much again.
  return std::max(2.0 * vertex_excess(peak),
                  std::abs(largest[0] - largest[1]) / 3.0);
}

Eigen::VectorXd von_mises(const MatrixXd& stress) {
  const auto s = [&](int k) {
    return stress.col(k).array();
  };
  return (0.5 * ((s(0) - s(1)).square() + (s(1) - s(2)).square() +
                 (s(2) - s(0)).square()) +
          3.0 * (s(3).square() + s(4).square() + s(5).square()))
      .sqrt();
}

template <int dim>
Eigen::Vector3d position(const elasticity::Discretization<dim>& discretization,
                         FieldPoint at, int subdivisions) {
  const elasticity::ReferencePoints<dim> point =
      elasticity::lattice<dim>(discretization.shape, subdivisions)
          .col(at.point);
  const auto geometry = elasticity::tabulate_geometry<dim>(
      discretization.shape, discretization.mapping_degree(), point);
  Eigen::Vector3d result =
      Eigen::Vector3d::Constant(discretization.mid_plane_z);
  result.head<dim>() =
      discretization.cell_points[static_cast<std::size_t>(at.cell)] *
      geometry.values.row(0).transpose();
  return result;
}

template <int dim>
std::string surface_group(const elasticity::Discretization<dim>& discretization,
                          FieldPoint at, int subdivisions) {
  const Eigen::Matrix<double, dim, 1> point =
      elasticity::lattice<dim>(discretization.shape, subdivisions)
          .col(at.point);
  for (std::size_t g = 0; g < discretization.groups.size(); ++g) {
    for (const auto& [cell, face] : discretization.group_faces[g]) {
      if (cell != at.cell) continue;
      const auto rule =
          elasticity::face_gauss<dim>(discretization.shape, face, 1);
      const double distance = (point - rule.points.col(0)).dot(rule.outward);
      if (std::abs(distance) < 1e-9) return discretization.groups[g].name;
    }
  }
  // A corner of a cell may touch a bore that no face of the cell lies on.
  const Eigen::Vector3d where = position<dim>(discretization, at, subdivisions);
  for (const auto& group : discretization.groups) {
    if (!group.cylinder) continue;
    const Eigen::Vector3d arm = where - group.cylinder->p_LC;
    const double along = arm.dot(group.cylinder->axis_L);
    const double radius = (arm - along * group.cylinder->axis_L).norm();
    if (std::abs(radius - group.cylinder->radius) <
            1e-6 * group.cylinder->radius &&
        std::abs(along) < 0.51 * group.cylinder->length) {
      return group.name;
    }
  }
  return "body";
}

#define CLEVIS_INSTANTIATE(dim)                                               \
  template StressHistory stress_history<dim>(                                 \
      const elasticity::DisplacementBasis<dim>&, const part::Material&, int); \
  template Eigen::VectorXd peaks_outside<dim>(                                \
      const elasticity::DisplacementBasis<dim>&, const part::Material&, int,  \
      const Eigen::MatrixXi&);                                                \
  template InstantField instant_field<dim>(                                   \
      const elasticity::DisplacementBasis<dim>&, const part::Material&, int,  \
      int);                                                                   \
  template Eigen::Vector3d position<dim>(                                     \
      const elasticity::Discretization<dim>&, FieldPoint, int);               \
  template std::string surface_group<dim>(                                    \
      const elasticity::Discretization<dim>&, FieldPoint, int);
CLEVIS_INSTANTIATE(2)
CLEVIS_INSTANTIATE(3)
#undef CLEVIS_INSTANTIATE

}  // namespace clevis::stress

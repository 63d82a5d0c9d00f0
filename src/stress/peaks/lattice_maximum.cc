#include "stress/peaks/lattice_maximum.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/QR>

#include "elasticity/fe_space/tabulation.h"
#include "stress/peaks/surroundings.h"

namespace clevis::stress {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Monomials of degree 1 and 2 at some points, points × terms.
/// @param offsets  from the centre, dim × points.
template <int dim>
MatrixXd monomials(const MatrixXd& offsets) {
  constexpr int kTerms = dim + dim * (dim + 1) / 2;
  MatrixXd terms(offsets.cols(), kTerms);
  int term = 0;
  for (int d = 0; d < dim; ++d) terms.col(term++) = offsets.row(d).transpose();
  for (int d = 0; d < dim; ++d) {
    for (int e = d; e < dim; ++e) {
      terms.col(term++) =
          offsets.row(d).cwiseProduct(offsets.row(e)).transpose();
    }
  }
  return terms;
}

/// Largest misfit at the neighbours of the centre: large where the quantity
/// bends within a spacing, as beside a free face.
double misfit_beside(const MatrixXd& offsets, const VectorXd& misfits) {
  constexpr double kNext = 1.001;  // spacings
  double largest = 0.0;
  for (Index i = 0; i < misfits.size(); ++i) {
    if (offsets.col(i).cwiseAbs().maxCoeff() > kNext) continue;
    largest = std::max(largest, std::abs(misfits[i]));
  }
  return largest;
}

/// Rise of the parabola through values at 0, 1 and 2 above the first, from 0 to
/// 1. @pre the first is the largest.
double rise_of_parabola(double at_0, double at_1, double at_2) {
  const double slope = -1.5 * at_0 + 2.0 * at_1 - 0.5 * at_2;
  const double bend = at_0 - 2.0 * at_1 + at_2;
  return slope > 0.0 && slope <= -bend ? 0.5 * slope * slope / -bend : 0.0;
}

/// Rise above a point of a tensor cell by the lattice's lines through it, each
/// direction's by the smaller of two parabolas on the side of its larger
/// neighbour: one of them is free of what bends beyond the point.
template <int dim>
double rise_along_lines(int subdivisions, const VectorXd& values,
                        const VectorXd& counting, Index at) {
  double rise = 0.0;
  Index stride = 1;
  for (int d = 0; d < dim; ++d, stride *= subdivisions + 1) {
    const Index place = at / stride % (subdivisions + 1);
    const auto value = [&](Index steps) -> double {
      const bool is_inside =
          place + steps >= 0 && place + steps <= subdivisions;
      const Index i = at + steps * stride;
      return is_inside && counting[i] > 0.0 ? values[i] : -HUGE_VAL;
    };
    const Index side = value(1) > value(-1) ? 1 : -1;
    if (std::isinf(value(2 * side))) continue;
    double along = rise_of_parabola(value(0), value(side), value(2 * side));
    if (!std::isinf(value(-side))) {
      const double slope = 0.5 * (value(side) - value(-side));
      const double bend = value(side) - 2.0 * value(0) + value(-side);
      if (bend < 0.0) along = std::min(along, 0.5 * slope * slope / -bend);
    }
    rise += along;
  }
  return rise;
}

/// Whether all points of the lattice beside a place count: between those and
/// others what counts ends.
/// @param offsets  of the lattice, in spacings. @param place  likewise.
bool lies_among(const MatrixXd& offsets, const VectorXd& counting,
                const VectorXd& place) {
  constexpr double kBeside = 0.999;  // spacings
  for (Index i = 0; i < offsets.cols(); ++i) {
    if (counting[i] > 0.0) continue;
    if ((offsets.col(i) - place).cwiseAbs().maxCoeff() < kBeside) return false;
  }
  return true;
}

}  // namespace

template <int dim>
double rise_between_points(mesh::CellShape shape, int subdivisions,
                           const VectorXd& values, const VectorXd& counting,
                           Index at) {
  constexpr double kReach =
      2.001;  // spacings, so that any face has three layers
  const auto lattice = elasticity::lattice<dim>(shape, subdivisions);
  const Eigen::Matrix<double, dim, 1> centre = lattice.col(at);
  const MatrixXd offsets = subdivisions * (lattice.colwise() - centre);
  std::vector<Index> around;
  for (Index i = 0; i < offsets.cols(); ++i) {
    if (i != at && counting[i] > 0.0 &&
        offsets.col(i).cwiseAbs().maxCoeff() <= kReach) {
      around.push_back(i);
    }
  }
  const MatrixXd terms = monomials<dim>(offsets(Eigen::all, around));
  if (terms.rows() < terms.cols()) return 0.0;
  const VectorXd weights =
      (-0.5 * offsets(Eigen::all, around).colwise().squaredNorm().array())
          .exp()
          .transpose();
  const VectorXd rises = values(around).array() - values[at];
  const Eigen::ColPivHouseholderQR<MatrixXd> fit(weights.asDiagonal() * terms);
  if (fit.rank() < terms.cols()) return 0.0;
  const VectorXd factors = fit.solve(weights.cwiseProduct(rises));
  const double misfit =
      misfit_beside(offsets(Eigen::all, around), terms * factors - rises);

  constexpr int kRounds = 5;
  double best = 0.0;
  Eigen::Matrix<double, dim, 1> from = centre;
  double spacing = 1.0 / subdivisions;
  for (int round = 0; round < kRounds; ++round) {
    spacing *= 0.5;
    const auto points = surroundings<dim>(shape, from, spacing);
    const MatrixXd places = subdivisions * (points.colwise() - centre);
    VectorXd found = monomials<dim>(places) * factors;
    for (Index i = 0; i < places.cols(); ++i) {
      if (!lies_among(offsets, counting, places.col(i))) found[i] = -HUGE_VAL;
    }
    Index highest = 0;
    best = std::max(best, found.maxCoeff(&highest));
    from = points.col(highest);
  }
  if (!(best > 0.0)) return 0.0;
  constexpr double kMost = 1.0 / 3.0;  // of the rise
  const double trusted =
      best * std::max(0.0, 1.0 - std::pow(misfit / (kMost * best), 2));
  if (shape != mesh::CellShape::kTensor) return trusted;
  return std::max(trusted,
                  std::min(best, rise_along_lines<dim>(subdivisions, values,
                                                       counting, at)));
}

template double rise_between_points<2>(mesh::CellShape, int, const VectorXd&,
                                       const VectorXd&, Index);
template double rise_between_points<3>(mesh::CellShape, int, const VectorXd&,
                                       const VectorXd&, Index);

}  // namespace clevis::stress

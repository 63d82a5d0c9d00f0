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
    const VectorXd found =
        monomials<dim>(subdivisions * (points.colwise() - centre)) * factors;
    Index highest = 0;
    best = std::max(best, found.maxCoeff(&highest));
    from = points.col(highest);
  }
  constexpr double kMost = 1.0 / 3.0;  // of the rise
  if (!(misfit < kMost * best)) return 0.0;
  return best * (1.0 - std::pow(misfit / (kMost * best), 2));
}

template double rise_between_points<2>(mesh::CellShape, int, const VectorXd&,
                                       const VectorXd&, Index);
template double rise_between_points<3>(mesh::CellShape, int, const VectorXd&,
                                       const VectorXd&, Index);

}  // namespace clevis::stress

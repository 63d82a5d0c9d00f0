#include "mechanism/neighbours/neighbour_following.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Cholesky>

#include "base/algebra/singular_vectors.h"

namespace clevis::mechanism {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kRoundOff = 1e-9;

}  // namespace

Following following_of(const Neighbours& neighbours, const NeighbourRows& rows,
                       const MatrixXd& of_places) {
  constexpr double kLight = 1e-6;  // of the heaviest: a body of no inertia
  const Index bodies = rows.there.cols(), moves = of_places.cols();
  Following found{MatrixXd::Identity(moves, moves),
                  MatrixXd::Zero(bodies, moves), MatrixXd(bodies, 0)};
  MatrixXd held = of_places;
  MatrixXd answer(0, moves), followed(bodies, 0);
  if (rows.free.cols() > 0) {
    MatrixXd mass =
        rows.free.transpose() * neighbours.masses(rows.x) * rows.free;
    const double heaviest = mass.diagonal().maxCoeff();
    mass.diagonal().array() += heaviest > 0.0 ? kLight * heaviest : 1.0;
    const Eigen::LLT<MatrixXd> root(mass);
    const MatrixXd free =
        root.matrixL().solve(rows.free.transpose()).transpose();
    found.loose = free;
    if (of_places.rows() > 0) {
      const SingularVectors there = singular_vectors(rows.there * free);
      const Index n = there.rank(kRoundOff);
      followed = free * there.V.leftCols(n);
      found.loose = free * there.left(n);
      const VectorXd scale = -there.sigma.head(n).cwiseInverse();
      answer = scale.asDiagonal() * there.U.leftCols(n).transpose() * of_places;
      held = there.left_rows(n).transpose() * of_places;
    }
  }
  if (held.rows() > 0) {
    const SingularVectors holding = singular_vectors(held);
    const MatrixXd kept = holding.V.leftCols(holding.count_above(kRoundOff));
    found.admitted -= kept * kept.transpose();
  }
  if (answer.rows() > 0) found.slow = followed * answer * found.admitted;
  return found;
}

void follow_springs(const MatrixXd& springs, const MatrixXd& form,
                    Following& following) {
  const Index bodies = following.slow.rows(), moves = following.slow.cols();
  const MatrixXd loose = following.loose;
  if (springs.cols() == 0 || loose.cols() == 0) return;
  MatrixXd motions(bodies + moves, moves);
  motions << following.slow, following.admitted;
  const SingularVectors held =
      singular_vectors(springs.topRows(bodies).transpose() * loose);
  const MatrixXd along = loose * held.V;
  const MatrixXd pushed = form.topLeftCorner(bodies, bodies) * along;
  const Index rank = held.rank(kRoundOff);
  std::vector<Index> sprung, others;
  for (Index k = 0; k < along.cols(); ++k) {
    const double stiffness = k < rank ? held.sigma[k] * held.sigma[k] : 0.0;
    const bool is_held = stiffness > std::abs(along.col(k).dot(pushed.col(k)));
    (is_held ? sprung : others).push_back(k);
  }
  const VectorXd sigma = held.sigma(sprung);
  following.sprung = along(Eigen::all, sprung);
  following.stiffness = sigma.cwiseAbs2();
  following.slow -= following.sprung * sigma.cwiseInverse().asDiagonal() *
                    held.U(Eigen::all, sprung).transpose() *
                    (springs.transpose() * motions);
  following.loose = along(Eigen::all, others);
}

}  // namespace clevis::mechanism

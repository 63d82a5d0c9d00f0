#pragma once

#include <algorithm>
#include <cmath>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

namespace clevis::support {

/// A mass on a linear one-sided spring strikes a body at rest.
struct DampedBlow {
  double mass{}, speed{}, stiffness{};  ///< [kg], [m/s], [N/m]
  double damping{};                     ///< of each mode, over the critical [1]
};

struct DampedAnswer {
  double force{};           ///< largest of the contact [N]
  double way{};             ///< largest of the contact's displacement [m]
  Eigen::VectorXd largest;  ///< of each row, |·|
};

/// The body's lowest modes with 2 ζ ω q' each and the striker by the classic
/// method of Runge and Kutta: none of clevis' own shapes, steps and closed
/// answers.
/// @param contact  c, its product with u is the contact's displacement.
/// @param rows     what is looked at, of the displacements.
inline DampedAnswer damped_blow(const Eigen::MatrixXd& stiffness,
                                const Eigen::MatrixXd& mass,
                                const Eigen::VectorXd& contact,
                                const Eigen::MatrixXd& rows,
                                const DampedBlow& blow, double duration,
                                int count) {
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> all(stiffness,
                                                                      mass);
  const Eigen::MatrixXd modes = all.eigenvectors().leftCols(count);
  const Eigen::VectorXd squares = all.eigenvalues().head(count);
  const Eigen::VectorXd losses = 2.0 * blow.damping * squares.cwiseSqrt();
  const Eigen::VectorXd c = modes.transpose() * contact;
  const Eigen::MatrixXd seen = rows * modes;
  DampedAnswer answer;
  answer.largest = Eigen::VectorXd::Zero(rows.rows());
  const auto force_at = [&](const Eigen::VectorXd& z) {
    return std::max(0.0,
                    blow.stiffness * (z[2 * count] - c.dot(z.head(count))));
  };
  const auto rates = [&](const Eigen::VectorXd& z) {
    const double force = force_at(z);
    Eigen::VectorXd d(z.size());
    d.head(count) = z.segment(count, count);
    d.segment(count, count) = force * c - squares.cwiseProduct(z.head(count)) -
                              losses.cwiseProduct(z.segment(count, count));
    d[2 * count] = z[2 * count + 1];
    d[2 * count + 1] = -force / blow.mass;
    return d;
  };
  Eigen::VectorXd z = Eigen::VectorXd::Zero(2 * count + 2);
  z[2 * count + 1] = blow.speed;
  const double h = 0.2 / std::sqrt(squares[count - 1]);
  for (double t = 0.0; t < duration; t += h) {
    const Eigen::VectorXd a = rates(z), b = rates(z + 0.5 * h * a),
                          e = rates(z + 0.5 * h * b), f = rates(z + h * e);
    z += h / 6.0 * (a + 2.0 * b + 2.0 * e + f);
    answer.force = std::max(answer.force, force_at(z));
    answer.way = std::max(answer.way, c.dot(z.head(count)));
    answer.largest = answer.largest.cwiseMax((seen * z.head(count)).cwiseAbs());
  }
  return answer;
}

}  // namespace clevis::support

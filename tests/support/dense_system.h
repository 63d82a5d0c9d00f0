#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include "dynamics/linear_system.h"

namespace clevis::support {

/// A system of dense matrices.
inline dynamics::LinearSystem dense_system(const Eigen::MatrixXd& stiffness,
                                           const Eigen::MatrixXd& mass) {
  dynamics::LinearSystem system;
  system.size = stiffness.rows();
  system.stiffness = [stiffness](const Eigen::MatrixXd& x) {
    return Eigen::MatrixXd(stiffness * x);
  };
  system.mass = [mass](const Eigen::MatrixXd& x) {
    return Eigen::MatrixXd(mass * x);
  };
  system.factor = [stiffness, mass](double shift) {
    const Eigen::LLT<Eigen::MatrixXd> factor(stiffness + shift * mass);
    return [factor](const Eigen::MatrixXd& b) {
      return Eigen::MatrixXd(factor.solve(b));
    };
  };
  system.rigid.resize(system.size, 0);
  return system;
}

/// Cantilever or simply supported Euler-Bernoulli beam of cubic Hermite
/// elements with consistent mass; unknowns deflection and slope per node.
struct EulerBeam {
  double length{}, bending_stiffness{}, mass_per_length{};  // [m] [N m²] [kg/m]
  int elements{};

  Eigen::MatrixXd stiffness() const {
    const double h = length / elements;
    Eigen::Matrix4d k;
    k << 12, 6 * h, -12, 6 * h,               //
        6 * h, 4 * h * h, -6 * h, 2 * h * h,  //
        -12, -6 * h, 12, -6 * h,              //
        6 * h, 2 * h * h, -6 * h, 4 * h * h;
    return assemble(k * bending_stiffness / (h * h * h));
  }
  Eigen::MatrixXd mass() const {
    const double h = length / elements;
    Eigen::Matrix4d m;
    m << 156, 22 * h, 54, -13 * h,              //
        22 * h, 4 * h * h, 13 * h, -3 * h * h,  //
        54, 13 * h, 156, -22 * h,               //
        -13 * h, -3 * h * h, -22 * h, 4 * h * h;
    return assemble(m * mass_per_length * h / 420.0);
  }

 private:
  Eigen::MatrixXd assemble(const Eigen::Matrix4d& element) const {
    Eigen::MatrixXd all =
        Eigen::MatrixXd::Zero(2 * elements + 2, 2 * elements + 2);
    for (int e = 0; e < elements; ++e) {
      all.block<4, 4>(2 * e, 2 * e) += element;
    }
    return all;
  }
};

/// Rows and columns without the first `n`.
inline Eigen::MatrixXd without_first(const Eigen::MatrixXd& matrix, int n) {
  return matrix.bottomRightCorner(matrix.rows() - n, matrix.cols() - n);
}

}  // namespace clevis::support

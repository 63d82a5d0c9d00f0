#pragma once

#include <memory>
#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

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

/// Rod of unit length, section, modulus and density (so waves of unit speed and
/// impedance) of linear elements, held at its first end.
inline dynamics::LinearSystem unit_rod(int elements) {
  using Sparse = Eigen::SparseMatrix<double>;
  const double h = 1.0 / elements;
  std::vector<Eigen::Triplet<double>> k, m;
  for (int j = 0; j < elements; ++j) {
    const double shared = j + 1 < elements ? 2.0 : 1.0;
    k.emplace_back(j, j, shared / h);
    m.emplace_back(j, j, shared * h / 3.0);
    if (j == 0) continue;
    for (const auto& [row, column] : {std::pair(j, j - 1), {j - 1, j}}) {
      k.emplace_back(row, column, -1.0 / h);
      m.emplace_back(row, column, h / 6.0);
    }
  }
  const auto stiffness = std::make_shared<Sparse>(elements, elements);
  const auto mass = std::make_shared<Sparse>(elements, elements);
  stiffness->setFromTriplets(k.begin(), k.end());
  mass->setFromTriplets(m.begin(), m.end());
  dynamics::LinearSystem system;
  system.size = elements;
  system.stiffness = [stiffness](const Eigen::MatrixXd& x) {
    return Eigen::MatrixXd(*stiffness * x);
  };
  system.mass = [mass](const Eigen::MatrixXd& x) {
    return Eigen::MatrixXd(*mass * x);
  };
  system.factor = [stiffness, mass](double shift) {
    const auto factor = std::make_shared<Eigen::SimplicialLLT<Sparse>>(
        Sparse(*stiffness + shift * *mass));
    return [factor](const Eigen::MatrixXd& b) {
      return Eigen::MatrixXd(factor->solve(b));
    };
  };
  system.rigid.resize(elements, 0);
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

/// Rows and columns without one.
inline Eigen::MatrixXd without(const Eigen::MatrixXd& matrix, int at) {
  std::vector<int> kept;
  for (int i = 0; i < matrix.rows(); ++i) {
    if (i != at) kept.push_back(i);
  }
  return matrix(kept, kept);
}

}  // namespace clevis::support

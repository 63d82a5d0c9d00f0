#pragma once

#include <cmath>
#include <functional>
#include <memory>
#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/LU>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include "dynamics/systems/linear_system.h"

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
/// impedance), held at its first end, of elements of degree 4 on equidistant
/// nodes.
struct UnitRod {
  explicit UnitRod(int elements) : size(1.0 / elements) {
    using Sparse = Eigen::SparseMatrix<double>;
    constexpr int kNodes = 5;
    Eigen::Matrix<double, kNodes, kNodes> powers, stiffness, mass;
    for (int i = 0; i < kNodes; ++i) {
      for (int j = 0; j < kNodes; ++j) {
        powers(i, j) = j == 0 ? 1.0 : std::pow(0.25 * i, j);
        mass(i, j) = 1.0 / (i + j + 1);
        stiffness(i, j) = i * j == 0 ? 0.0 : double(i * j) / (i + j - 1);
      }
    }
    coefficients = powers.inverse();
    stiffness = (coefficients.transpose() * stiffness * coefficients).eval();
    mass = (coefficients.transpose() * mass * coefficients).eval();
    std::vector<Eigen::Triplet<double>> k, m;
    for (int e = 0; e < elements; ++e) {
      for (int i = 0; i < kNodes; ++i) {
        for (int j = 0; j < kNodes; ++j) {
          const int row = 4 * e + i - 1, column = 4 * e + j - 1;
          if (row < 0 || column < 0) continue;
          k.emplace_back(row, column, stiffness(i, j) / size);
          m.emplace_back(row, column, mass(i, j) * size);
        }
      }
    }
    const int n = 4 * elements;
    const auto all_k = std::make_shared<Sparse>(n, n);
    const auto all_m = std::make_shared<Sparse>(n, n);
    all_k->setFromTriplets(k.begin(), k.end());
    all_m->setFromTriplets(m.begin(), m.end());
    system.size = n;
    system.stiffness = [all_k](const Eigen::MatrixXd& x) {
      return Eigen::MatrixXd(*all_k * x);
    };
    system.mass = [all_m](const Eigen::MatrixXd& x) {
      return Eigen::MatrixXd(*all_m * x);
    };
    system.factor = [all_k, all_m](double shift) {
      const auto factor = std::make_shared<Eigen::SimplicialLLT<Sparse>>(
          Sparse(*all_k + shift * *all_m));
      return [factor](const Eigen::MatrixXd& b) {
        return Eigen::MatrixXd(factor->solve(b));
      };
    };
    system.rigid.resize(n, 0);
  }

  /// Of the first four unknowns: stress at the held end.
  Eigen::RowVector4d root_stress() const {
    return coefficients.row(1).tail<4>() / size;
  }

  double size{};
  Eigen::Matrix<double, 5, 5> coefficients;
  dynamics::LinearSystem system;
};

/// Cantilever or simply supported Euler-Bernoulli beam of cubic Hermite
/// elements with consistent mass; unknowns deflection and slope per node. With
/// a shear stiffness Timoshenko's (Przemieniecki, Theory of matrix structural
/// analysis, 1968, 5.6 and 11.4, the mass for short elements).
struct EulerBeam {
  double length{}, bending_stiffness{}, mass_per_length{};  // [m] [N m²] [kg/m]
  int elements{};
  double shear_stiffness = 0.0;  // κ G A, 0: infinite [N]
  double rotary_inertia = 0.0;   // ρ I [kg m]

  // Height of element e over that the figures above are of.
  std::function<double(int)> height = [](int) {
    return 1.0;
  };

  Eigen::MatrixXd stiffness() const {
    const double h = length / elements;
    return assemble([&](int e) {
      const double d = height(e);
      const double bending = bending_stiffness * d * d * d;
      const double s = shear_stiffness > 0.0
                           ? 12.0 * bending / (shear_stiffness * d * h * h)
                           : 0.0;
      Eigen::Matrix4d k;
      k << 12, 6 * h, -12, 6 * h,                           //
          6 * h, (4 + s) * h * h, -6 * h, (2 - s) * h * h,  //
          -12, -6 * h, 12, -6 * h,                          //
          6 * h, (2 - s) * h * h, -6 * h, (4 + s) * h * h;
      return Eigen::Matrix4d(k * bending / (h * h * h * (1 + s)));
    });
  }
  Eigen::MatrixXd mass() const {
    const double h = length / elements;
    Eigen::Matrix4d m, turning;
    m << 156, 22 * h, 54, -13 * h,              //
        22 * h, 4 * h * h, 13 * h, -3 * h * h,  //
        54, 13 * h, 156, -22 * h,               //
        -13 * h, -3 * h * h, -22 * h, 4 * h * h;
    turning << 36, 3 * h, -36, 3 * h,      //
        3 * h, 4 * h * h, -3 * h, -h * h,  //
        -36, -3 * h, 36, -3 * h,           //
        3 * h, -h * h, -3 * h, 4 * h * h;
    return assemble([&](int e) {
      const double d = height(e);
      return Eigen::Matrix4d(m * mass_per_length * d * h / 420.0 +
                             turning * rotary_inertia * d * d * d / (30.0 * h));
    });
  }

 private:
  template <class Element>
  Eigen::MatrixXd assemble(const Element& element) const {
    Eigen::MatrixXd all =
        Eigen::MatrixXd::Zero(2 * elements + 2, 2 * elements + 2);
    for (int e = 0; e < elements; ++e) {
      all.block<4, 4>(2 * e, 2 * e) += element(e);
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

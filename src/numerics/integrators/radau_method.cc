#include "numerics/integrators/radau_method.h"

#include <cmath>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

namespace clevis::numerics {
namespace {

using Eigen::Index;
using Long = long double;
using Matrix = Eigen::Matrix<Long, Eigen::Dynamic, Eigen::Dynamic>;
using Vector = Eigen::Matrix<Long, Eigen::Dynamic, 1>;

/// Zeros of Jacobi's polynomial P(1, 0) of degree s − 1 on [0, 1], and 1: by
/// the eigenvalues of its recurrence.
Vector radau_nodes(Index s) {
  const Index n = s - 1;
  Matrix recurrence = Matrix::Zero(n, n);
  for (Index k = 0; k < n; ++k) {
    const Long twice = 2.0L * static_cast<Long>(k) + 1.0L;  // 2 k + α + β
    recurrence(k, k) = -1.0L / (twice * (twice + 2.0L));
    if (k == 0) continue;
    const Long m = static_cast<Long>(k);
    const Long below = 2.0L / twice *
                       std::sqrt(m * m * (m + 1.0L) * (m + 1.0L) /
                                 ((twice + 1.0L) * (twice - 1.0L)));
    recurrence(k, k - 1) = recurrence(k - 1, k) = below;
  }
  const Eigen::SelfAdjointEigenSolver<Matrix> eigen(recurrence);
  Vector c(s);
  c.head(n) = 0.5L * (eigen.eigenvalues().array() + 1.0L);
  c[n] = 1.0L;
  return c;
}

/// V(k, i) = c_i^k.
Matrix powers(const Vector& c) {
  Matrix V(c.size(), c.size());
  for (Index k = 0; k < c.size(); ++k) {
    for (Index i = 0; i < c.size(); ++i) {
      V(k, i) = std::pow(c[i], static_cast<Long>(k));
    }
  }
  return V;
}

/// A(i, j) = ∫₀^c_i l_j.
Matrix method_matrix(const Vector& c) {
  Matrix integrals(c.size(), c.size());  // of powers, by node
  for (Index i = 0; i < c.size(); ++i) {
    for (Index k = 0; k < c.size(); ++k) {
      integrals(i, k) =
          std::pow(c[i], static_cast<Long>(k + 1)) / static_cast<Long>(k + 1);
    }
  }
  const Matrix transposed = powers(c).fullPivLu().solve(integrals.transpose());
  return transposed.transpose();
}

RadauMethod::Table table(const Matrix& matrix) {
  RadauMethod::Table result{};
  for (Index i = 0; i < matrix.rows(); ++i) {
    for (Index j = 0; j < matrix.cols(); ++j) {
      result[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] =
          static_cast<double>(matrix(i, j));
    }
  }
  return result;
}

void decompose(const Matrix& inverse, RadauMethod& method) {
  const Eigen::EigenSolver<Matrix> eigen(inverse);
  Matrix T(inverse.rows(), inverse.cols());
  const auto vectors = eigen.eigenvectors().eval();
  Index column = 1;
  for (Index k = 0; k < inverse.rows(); ++k) {
    const std::complex<Long> value = eigen.eigenvalues()[k];
    const auto vector = vectors.col(k);
    if (std::abs(value.imag()) < 1e-9L) {
      method.real = static_cast<double>(value.real());
      T.col(0) = vector.real();
    } else if (value.imag() > 0.0L) {
      method.pairs[static_cast<std::size_t>(column / 2)] = {
          static_cast<double>(value.real()), static_cast<double>(value.imag())};
      T.col(column) = vector.real();
      T.col(column + 1) = -vector.imag();
      column += 2;
    }
  }
  method.T = table(T);
  method.T_inverse = table(T.fullPivLu().inverse());
}

/// Weights b̂ of order s beside 1/real at t itself, less those of the method,
/// which are the last row of A.
void embed(const Vector& c, const Matrix& A, RadauMethod& method) {
  const Index s = c.size();
  const Long first = 1.0L / static_cast<Long>(method.real);
  Vector moments(s);
  for (Index k = 0; k < s; ++k) moments[k] = 1.0L / static_cast<Long>(k + 1);
  moments[0] -= first;
  const Vector differ =
      powers(c).fullPivLu().solve(moments) - A.row(s - 1).transpose();
  const Vector error = A.transpose().fullPivLu().solve(differ) / first;
  for (Index i = 0; i < s; ++i) {
    method.error[static_cast<std::size_t>(i)] = static_cast<double>(error[i]);
  }
}

RadauMethod make_method(int stages) {
  RadauMethod method;
  method.stages = stages;
  const Vector c = radau_nodes(stages);
  const Matrix A = method_matrix(c);
  const Matrix inverse = A.fullPivLu().inverse();
  for (Index i = 0; i < stages; ++i) {
    method.c[static_cast<std::size_t>(i)] = static_cast<double>(c[i]);
  }
  method.inverse = table(inverse);
  decompose(inverse, method);
  embed(c, A, method);
  return method;
}

}  // namespace

RadauMethod::Weights RadauMethod::through_stages(double s) const {
  Weights weights{};
  for (std::size_t j = 0; j < count(); ++j) {
    weights[j] = 1.0;
    for (std::size_t k = 0; k < count(); ++k) {
      if (k != j) weights[j] *= (s - c[k]) / (c[j] - c[k]);
    }
  }
  return weights;
}

RadauMethod::Weights RadauMethod::at(double s) const {
  Weights weights = through_stages(s);
  for (std::size_t j = 0; j < count(); ++j) weights[j] *= s / c[j];
  return weights;
}

const RadauMethod& radau_method(int stages) {
  static const RadauMethod kThree = make_method(3);
  static const RadauMethod kFive = make_method(5);
  static const RadauMethod kSeven = make_method(7);
  return stages == 3 ? kThree : stages == 5 ? kFive : kSeven;
}

}  // namespace clevis::numerics

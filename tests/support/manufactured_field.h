#pragma once

#include <cmath>

#include <Eigen/Core>

namespace clevis::support {

/// A smooth displacement that vanishes on y = 0,
/// u_i = y sin(w_i · x + i), with the stress and the body force that belong
/// to it: the exact solution on any domain that is held at y = 0 and takes the
/// field's tractions on the rest of its surface.
template <int dim>
class ManufacturedField {
 public:
  using Vector = Eigen::Matrix<double, dim, 1>;
  using Matrix = Eigen::Matrix<double, dim, dim>;

  /// @param waves  rows w_i [1/m].
  /// @param lambda, mu  of the model [Pa].
  ManufacturedField(const Matrix& waves, double lambda, double mu)
      : waves_(waves), lambda_(lambda), mu_(mu) {}

  Vector displacement(const Vector& x) const {
    Vector u;
    for (int i = 0; i < dim; ++i) u[i] = x[1] * std::sin(angle(i, x));
    return u;
  }

  /// ∂u_i/∂x_j.
  Matrix gradient(const Vector& x) const {
    Matrix result;
    for (int i = 0; i < dim; ++i) {
      result.row(i) = x[1] * std::cos(angle(i, x)) * waves_.row(i);
      result(i, 1) += std::sin(angle(i, x));
    }
    return result;
  }

  Matrix stress_of(const Matrix& gradient) const {
    return lambda_ * gradient.trace() * Matrix::Identity() +
           mu_ * (gradient + gradient.transpose());
  }
  Matrix stress(const Vector& x) const { return stress_of(gradient(x)); }

  /// −div σ = −(λ + μ) grad div u − μ Δu [N/m³].
  Vector body_force(const Vector& x) const {
    Vector force = Vector::Zero();
    for (int i = 0; i < dim; ++i) {
      const Vector wave = waves_.row(i);
      const Vector y = Vector::Unit(1);
      const double c = std::cos(angle(i, x));
      const double s = std::sin(angle(i, x));
      const Matrix hessian =  // of u_i
          c * (y * wave.transpose() + wave * y.transpose()) -
          x[1] * s * wave * wave.transpose();
      force -= (lambda_ + mu_) * hessian.col(i);
      force[i] -= mu_ * hessian.trace();
    }
    return force;
  }

 private:
  double angle(int i, const Vector& x) const { return waves_.row(i) * x + i; }

  Matrix waves_;
  double lambda_, mu_;
};

}  // namespace clevis::support

#include "elasticity/revolution/harmonic.h"

#include <cmath>
#include <numbers>

namespace clevis::elasticity {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using std::numbers::pi;

Matrix3d mix_components() {
  const double h = std::numbers::sqrt2 / 2.0;
  Matrix3d mix;
  mix << 1.0, 0.0, 0.0,  //
      0.0, h, h,         //
      0.0, h, -h;
  return mix;
}

Vector3d wave(const Harmonic& harmonic, double angle) {
  const double c = std::cos(harmonic.order * angle);
  const double s = std::sin(harmonic.order * angle);
  return harmonic.is_sine ? Vector3d(s, s, -c) : Vector3d(c, c, s);
}

double wave_norm(const Harmonic& harmonic) {
  return harmonic.order == 0 ? 2.0 * pi : pi;
}

const std::array<Harmonic, kLinearHarmonics>& linear_harmonics() {
  static const std::array<Harmonic, kLinearHarmonics> all = {
      {{0, false}, {0, true}, {1, false}, {1, true}, {2, false}, {2, true}}};
  return all;
}

double sample_angle(int k) {
  return 2.0 * pi * k / kAngles;
}

Vector3d project(const Harmonic& harmonic,
                 const Eigen::Matrix<double, 3, kAngles>& field) {
  Vector3d sum = Vector3d::Zero();
  for (int k = 0; k < kAngles; ++k) {
    const double angle = sample_angle(k);
    const double c = std::cos(angle), s = std::sin(angle);
    const Vector3d t = field.col(k);
    const Vector3d turned(t.x(), c * t.y() + s * t.z(), c * t.z() - s * t.y());
    sum += wave(harmonic, angle).cwiseProduct(turned);
  }
  return 2.0 * pi / kAngles * mix_components() * sum;
}

LinearProjections linear_projections(const Harmonic& harmonic) {
  LinearProjections result;
  for (std::size_t b = 0; b < 4; ++b) {
    for (std::size_t k = 0; k < 3; ++k) {
      Eigen::Matrix<double, 3, kAngles> field;
      for (int a = 0; a < kAngles; ++a) {
        const double angle = sample_angle(a);
        const double factor = b == 2   ? std::cos(angle)
                              : b == 3 ? std::sin(angle)
                                       : 1.0;
        field.col(a) = factor * Vector3d::Unit(Index(k));
      }
      result[b][k] = project(harmonic, field);
    }
  }
  return result;
}

MatrixXd linear_columns(const Harmonic& harmonic, const MatrixXd& moments) {
  const auto projections = linear_projections(harmonic);
  MatrixXd columns(3 * moments.rows(), 12);
  for (std::size_t b = 0; b < 4; ++b) {
    const Index moment = b < 2 ? Index(b) : 2;
    for (std::size_t k = 0; k < 3; ++k) {
      for (Index node = 0; node < moments.rows(); ++node) {
        columns.block<3, 1>(3 * node, Index(3 * b + k)) =
            moments(node, moment) * projections[b][k];
      }
    }
  }
  return columns;
}

Eigen::Matrix<double, 12, 1> linear_coefficients(const Vector3d& value,
                                                 const Matrix3d& slope) {
  Eigen::Matrix<double, 12, 1> rows;
  rows << value, slope.col(0), slope.col(1), slope.col(2);
  return rows;
}

}  // namespace clevis::elasticity

#include "stress/corners/wedge_exponent.h"

#include <cmath>
#include <complex>
#include <numbers>

#include <Eigen/Core>
#include <Eigen/LU>

namespace clevis::stress {
namespace {

using Complex = std::complex<double>;
using Row = Eigen::RowVector4cd;

constexpr double kLowest = 0.05;    // no wedge has a lower exponent than 1/4
constexpr double kHighest = 0.995;  // λ = 1 is a rotation, always a root
constexpr double kHeight = 2.0;     // imaginary parts stay far below
constexpr int kBisections = 24;

/// Components of a field c r^m at θ, rows over the unknowns (Re a, Im a, Re b,
/// Im b) of φ = a z^λ, ψ = b z^λ.
struct SideRows {
  Row radial, hoop;       ///< 2μ u_r, 2μ u_θ, over r^λ
  Row tension, shearing;  ///< σ_θθ, σ_rθ, over λ r^(λ−1)
};

SideRows rows_at(double theta, Complex lambda, double kolosov) {
  const Complex c1 = std::cos((lambda - 1.0) * theta);
  const Complex s1 = std::sin((lambda - 1.0) * theta);
  const Complex c2 = std::cos((lambda + 1.0) * theta);
  const Complex s2 = std::sin((lambda + 1.0) * theta);
  // a e^{i(λ−1)θ} and b e^{i(λ+1)θ}: real and imaginary parts.
  const Row a_real(c1, -s1, 0.0, 0.0);
  const Row a_imag(s1, c1, 0.0, 0.0);
  const Row b_real(0.0, 0.0, c2, -s2);
  const Row b_imag(0.0, 0.0, s2, c2);
  return {(kolosov - lambda) * a_real - b_real,
          (kolosov + lambda) * a_imag + b_imag,
          (lambda + 1.0) * a_real + b_real, (lambda - 1.0) * a_imag + b_imag};
}

/// The two conditions of a side.
void set_conditions(const SideRows& rows, const WedgeSide& side,
                    Eigen::Matrix4cd& matrix, int first_row) {
  auto conditions = matrix.middleRows<2>(first_row);
  switch (side.hold) {
    case WedgeSide::Hold::kNothing:
      conditions << rows.tension, rows.shearing;
      return;
    case WedgeSide::Hold::kBoth:
      conditions << rows.radial, rows.hoop;
      return;
    case WedgeSide::Hold::kOneDirection:
      const double c = std::cos(side.direction);
      const double s = std::sin(side.direction);
      // Traction (σ_rθ, σ_θθ) has no component across the held direction.
      conditions << c * rows.radial + s * rows.hoop,
          c * rows.tension - s * rows.shearing;
      return;
  }
}

/// Its zeros in λ are the exponents; real on the real axis.
class Determinant {
 public:
  Determinant(double angle, const WedgeSide& first, const WedgeSide& second,
              double kolosov)
      : angle_(angle), first_(first), second_(second), kolosov_(kolosov) {}

  Complex operator()(Complex lambda) const {
    Eigen::Matrix4cd matrix;
    set_conditions(rows_at(0.0, lambda, kolosov_), first_, matrix, 0);
    set_conditions(rows_at(angle_, lambda, kolosov_), second_, matrix, 2);
    return matrix.determinant();
  }

 private:
  double angle_;
  WedgeSide first_, second_;
  double kolosov_;
};

struct Sample {
  Complex at, value;
};

/// Change of the determinant's argument along a straight path.
double turn(const Determinant& determinant, const Sample& from,
            const Sample& to, int depth) {
  constexpr double kSmall = 0.6;  // [rad]
  constexpr int kDeepest = 40;
  const double direct = std::arg(to.value / from.value);
  const Complex middle = 0.5 * (from.at + to.at);
  const Sample half{middle, determinant(middle)};
  const double first = std::arg(half.value / from.value);
  const double second = std::arg(to.value / half.value);
  const bool is_smooth = std::abs(first) < kSmall && std::abs(second) < kSmall;
  if ((is_smooth && std::abs(first + second - direct) < kSmall) ||
      depth == kDeepest) {
    return first + second;
  }
  return turn(determinant, from, half, depth + 1) +
         turn(determinant, half, to, depth + 1);
}

/// Number of zeros with real part in (kLowest, x), by the argument principle
/// on the upper half of a rectangle: the lower half is its mirror image.
int zeros_below(const Determinant& determinant, double x) {
  const Complex path[] = {
      {x, 0.0}, {x, kHeight}, {kLowest, kHeight}, {kLowest, 0.0}};
  constexpr int kPieces = 8;
  double change = 0.0;
  Sample here{path[0], determinant(path[0])};
  for (int side = 0; side < 3; ++side) {
    for (int k = 1; k <= kPieces; ++k) {
      const Complex at = path[side] + (path[side + 1] - path[side]) *
                                          (static_cast<double>(k) / kPieces);
      const Sample next{at, determinant(at)};
      change += turn(determinant, here, next, 0);
      here = next;
    }
  }
  return static_cast<int>(std::lround(change / std::numbers::pi));
}

}  // namespace

double kolosov_plane_strain(double poissons_ratio) {
  return 3.0 - 4.0 * poissons_ratio;
}

double kolosov_plane_stress(double poissons_ratio) {
  return (3.0 - poissons_ratio) / (1.0 + poissons_ratio);
}

std::vector<double> wedge_exponents(double angle, const WedgeSide& first,
                                    const WedgeSide& second, double kolosov) {
  const Determinant determinant(angle, first, second, kolosov);
  std::vector<double> exponents;
  const int all = zeros_below(determinant, kHighest);
  for (int k = 1; k <= all; ++k) {
    double low = exponents.empty() ? kLowest : exponents.back();
    double high = kHighest;
    for (int step = 0; step < kBisections; ++step) {
      const double middle = 0.5 * (low + high);
      (zeros_below(determinant, middle) >= k ? high : low) = middle;
    }
    exponents.push_back(high);
  }
  return exponents;
}

double antiplane_exponent(double angle, bool first_held, bool second_held) {
  const double whole = std::numbers::pi / angle;
  return first_held == second_held ? whole : 0.5 * whole;
}

}  // namespace clevis::stress

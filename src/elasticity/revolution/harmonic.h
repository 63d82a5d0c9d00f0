#pragma once

#include <array>

#include <Eigen/Core>

#include "mesh/derived/revolution.h"

namespace clevis::elasticity {

/// One term of a field's Fourier series about the axis of a solid of
/// revolution. Along the axis, radially and along the circumference it is
/// (u_x cos nθ, u_r cos nθ, u_θ sin nθ), or turned by a quarter of its wave
/// (u_x sin nθ, u_r sin nθ, −u_θ cos nθ): both have one stiffness.
///
/// Amplitudes are kept as (u_x, u_+, u_−), u_± = (u_r ± u_θ)/√2: on the axis
/// these vanish one by one (u_x unless n = 0, u_− unless n = 1, u_+ always).
struct Harmonic {
  int order{};
  bool is_sine{};
  bool operator==(const Harmonic&) const = default;
};

/// Matrix that takes (u_x, u_r, u_θ) to (u_x, u_+, u_−) and, being its own
/// inverse, back.
Eigen::Matrix3d mix_components();

/// Factors at an angle [rad] of the amplitudes u_x, u_r, u_θ [1].
Eigen::Vector3d wave(const Harmonic& harmonic, double angle);

/// ∮ of the squared factors over the angle: 2π for order 0, else π [1].
double wave_norm(const Harmonic& harmonic);

/// All terms that a vector field has which is linear in the position: orders
/// 0 to 2.
inline constexpr int kLinearHarmonics = 6;
const std::array<Harmonic, kLinearHarmonics>& linear_harmonics();

/// Angles at which products of such terms are summed exactly [rad].
inline constexpr int kAngles = 8;
double sample_angle(int k);

/// ∮ a·t dθ for the unit amplitudes a of a term, t a vector field given at the
/// kAngles sample angles in directions fixed in the axis' frame (3 × kAngles);
/// in the units of t.
Eigen::Vector3d project(const Harmonic& harmonic,
                        const Eigen::Matrix<double, 3, kAngles>& field);

/// ∮ a·t dθ of the fields t that have unit component k (0…2 in the axis' frame)
/// times 1, x, y or z, but for the factors x and r of the position:
/// [b][k], b = 0…3.
using LinearProjections = std::array<std::array<Eigen::Vector3d, 3>, 4>;
LinearProjections linear_projections(const Harmonic& harmonic);

/// Linear fields in terms: column 3 b + k belongs to component k times
/// (1, x, y, z)[b]. @param moments  nodes × 3: 1, x and r at each node or
/// integrals of these. @return 3·nodes × 12, amplitude after amplitude, in the
/// units of the moments.
Eigen::MatrixXd linear_columns(const Harmonic& harmonic,
                               const Eigen::MatrixXd& moments);

/// Rows 3 b + k of a field f_0 + G p in the axis' frame as linear_columns
/// counts them, in the units of f. @param value  f_0 at the frame's origin.
/// @param slope  G, per metre.
Eigen::Matrix<double, 12, 1> linear_coefficients(const Eigen::Vector3d& value,
                                                 const Eigen::Matrix3d& slope);

}  // namespace clevis::elasticity

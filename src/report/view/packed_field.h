#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

namespace clevis::report {

/// Values at points over instants as few columns: value(p, i) = Σ_k
/// scale_k · integers(p, k) · coefficients(k, i).
struct PackedField {
  Eigen::Matrix<std::int16_t, Eigen::Dynamic, Eigen::Dynamic> integers;
  Eigen::VectorXd scale;         ///< unit of the values, per column
  Eigen::MatrixXf coefficients;  ///< columns × instants [1]
  double error{};  ///< largest difference from the values given, their unit

  /// points × instants.
  Eigen::MatrixXd values() const;
};

/// Packs values by taking, again and again, the instant that the columns so
/// far tell worst, as a new column, until all instants are within
/// `tolerance` or `most` columns stand. The instant `first` comes first, told
/// to an eighth of the tolerance; its largest value is told as it is. Further
/// columns are rounded to a quarter of the tolerance: finer steps would be
/// digits that nothing asks for.
/// @param values  points × instants, finite.
/// @param tolerance  largest error of a value, in its unit.
PackedField pack(Eigen::MatrixXd values, Eigen::Index first, double tolerance,
                 int most);

}  // namespace clevis::report

#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

namespace clevis::report {

/// Values at points over instants as few columns: value(p, i) = Σ_k
/// scale_k · integers(p, k) · coefficients(k, i).
struct PackedField {
  /// Columns of 8 bits hold −127 … 127.
  Eigen::Matrix<std::int16_t, Eigen::Dynamic, Eigen::Dynamic> integers;
  std::vector<int> bits;         ///< of each column: 16 or 8
  Eigen::VectorXd scale;         ///< unit of the values, per column
  Eigen::MatrixXf coefficients;  ///< columns × instants [1]
  double error{};  ///< largest difference from the values given, their unit

  /// points × instants.
  Eigen::MatrixXd values() const;
};

/// Packs values by taking, again and again, the instant that the columns so
/// far tell worst, as a new column, until all instants are within
/// `tolerance` or `most` columns stand. The instant `first` comes first and is
/// told to a 65000th of its largest value. Columns that are small beside the
/// tolerance take 8 bits, the others 16.
/// @param values  points × instants, finite.
/// @param tolerance  largest error of a value, in its unit.
PackedField pack(Eigen::MatrixXd values, Eigen::Index first, double tolerance,
                 int most);

}  // namespace clevis::report

#pragma once

#include <functional>
#include <vector>

#include <Eigen/Core>

#include "dynamics/load_vibration/load_path.h"

namespace clevis::dynamics {

/// m q'' + d q' + k q = f in coordinates that couple by constraints alone;
/// those without mass or stiffness are tied to others by them.
struct DiagonalSystem {
  Eigen::VectorXd mass, damping, stiffness;
};

/// Matrices between the instants at which they are known: on each interval the
/// cubic with the slopes of parabolas through three instants, so that it goes
/// with any turn of rows and columns. Pieces end where they bend or jump.
class SmoothPath {
 public:
  /// @param time   rising [s]. @param values  of each instant, of one shape.
  /// @param jump   instants no farther apart are two sides of one time [s].
  /// @param bends  rising; of them those count that are instants, to `jump`
  ///   [s].
  SmoothPath(Eigen::VectorXd time, std::vector<Eigen::MatrixXd> values,
             double jump = 0.0, const std::vector<double>& bends = {},
             LoadPath::Between between = LoadPath::Between::kCubic);

  const Eigen::VectorXd& time() const { return time_; }
  /// At an instant.
  const Eigen::MatrixXd& value(Eigen::Index i) const {
    return values_[static_cast<std::size_t>(i)];
  }
  /// In the interval behind instant i, by shares of it [1].
  class Piece {
   public:
    Eigen::MatrixXd at(double share) const;

   private:
    friend class SmoothPath;
    Eigen::MatrixXd value_, first_, second_, third_;  ///< of the share's powers
  };
  Piece piece(Eigen::Index i) const;

 private:
  Eigen::MatrixXd secant(Eigen::Index i) const;
  /// Of interval i, at its end that interval `next` shares.
  Eigen::MatrixXd slope(Eigen::Index i, Eigen::Index next) const;
  bool is_one_piece(Eigen::Index i, Eigen::Index next) const;

  Eigen::VectorXd time_;
  std::vector<Eigen::MatrixXd> values_;
  double jump_;
  LoadPath::Between between_;
  std::vector<bool> is_bend_;  ///< by instant
};

/// What forces bend it to at rest, of rows that hold it [as q].
Eigen::VectorXd at_rest(const DiagonalSystem& system,
                        const Eigen::MatrixXd& rows,
                        const Eigen::VectorXd& forces);

/// Takes each step's time and coordinates.
using TakeStep =
    std::function<void(double time, const Eigen::VectorXd& coordinates)>;

/// What the forces bend it to at rest at each instant, and at so many even
/// parts of the intervals between them.
void follow_at_rest(const DiagonalSystem& system, const SmoothPath& constraints,
                    const SmoothPath& forces, int parts, const TakeStep& take);

/// Its motion from rest at the first instant on, to second order of the step:
/// the scheme of [ArnoldBruels2007] with a spectral radius of 0.9.
/// @param constraints  G, each row going on from that before.
/// @param forces  on the coordinates, one column, at the same instants.
/// @param step    at most [s].
void follow(const DiagonalSystem& system, const SmoothPath& constraints,
            const SmoothPath& forces, double step, const TakeStep& take);

}  // namespace clevis::dynamics

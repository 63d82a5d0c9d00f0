#pragma once

#include <functional>
#include <vector>

#include <Eigen/Core>

namespace clevis::dynamics {

/// m q'' + d q' + k q = f in coordinates that couple by constraints alone;
/// those without mass or stiffness are tied to others by them.
struct DiagonalSystem {
  Eigen::VectorXd mass, damping, stiffness;
};

/// Matrices between the instants at which they are known: on each interval a
/// cubic that goes with any turn of rows and columns. Pieces end where they
/// bend or jump.
class SmoothPath {
 public:
  enum class Slopes {
    kOfParabolas,  ///< through three instants
    kLimited,      ///< the same, less where it steepens: it may bend unseen
    kOfSecants     ///< as of a table's rows
  };
  /// @param time   rising [s]. @param values  of each instant, of one shape.
  /// @param jump   instants no farther apart are two sides of one time [s].
  /// @param bends  rising; of them those count that are instants, to `jump`
  ///   [s].
  SmoothPath(Eigen::VectorXd time, std::vector<Eigen::MatrixXd> values,
             double jump = 0.0, const std::vector<double>& bends = {},
             Slopes slopes = Slopes::kOfParabolas);

  const Eigen::VectorXd& time() const { return time_; }
  /// At an instant.
  const Eigen::MatrixXd& value(Eigen::Index i) const {
    return values_[static_cast<std::size_t>(i)];
  }
  /// In the interval behind instant i, by shares of it [1].
  class Piece {
   public:
    Eigen::MatrixXd at(double share) const;
    /// Mean from its start to there.
    Eigen::MatrixXd mean(double share) const;

   private:
    friend class SmoothPath;
    Eigen::MatrixXd value_, first_, second_, third_;  ///< of the share's powers
  };
  Piece piece(Eigen::Index i) const;
  Eigen::MatrixXd at(double time) const;
  /// Index of the interval that holds a time; the first and last beside all.
  Eigen::Index interval(double time) const;

 private:
  Eigen::MatrixXd secant(Eigen::Index i) const;
  /// Of interval i, at its end that interval `next` shares.
  Eigen::MatrixXd slope(Eigen::Index i, Eigen::Index next) const;
  bool is_one_piece(Eigen::Index i, Eigen::Index next) const;

  Eigen::VectorXd time_;
  std::vector<Eigen::MatrixXd> values_;
  double jump_;
  Slopes slopes_;
  std::vector<bool> is_bend_;  ///< by instant
};

/// What forces bend it to at rest, of rows that hold it [as q].
Eigen::VectorXd at_rest(const DiagonalSystem& system,
                        const Eigen::MatrixXd& rows,
                        const Eigen::VectorXd& forces);

/// Takes each step's time and coordinates.
using TakeStep =
    std::function<void(double time, const Eigen::VectorXd& coordinates)>;

/// What the forces bend it to at rest, in even steps. @param step  at most [s].
void follow_at_rest(const DiagonalSystem& system, const SmoothPath& constraints,
                    const SmoothPath& forces, double step,
                    const TakeStep& take);

/// Its motion from rest at the first instant on, to second order of the step:
/// the scheme of [ArnoldBruels2007] with a spectral radius of 0.9. Steps are
/// even, for instants may be so close together that differences of coordinates
/// over them are round-off; forces count by their mean around each step's end.
/// @param constraints  G, each row going on from that before.
/// @param forces  on the coordinates, one column, at the same instants.
/// @param step    at most [s].
void follow(const DiagonalSystem& system, const SmoothPath& constraints,
            const SmoothPath& forces, double step, const TakeStep& take);

}  // namespace clevis::dynamics

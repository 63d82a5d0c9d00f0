#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "elasticity/problem/displacement_basis.h"
#include "elasticity/vibration/vibrating_part.h"
#include "loads/history/load_history.h"

namespace clevis::elasticity {

/// A free part in few shapes: rigid motions, and what wrenches on its seats
/// bend at rest and by the inertia of that. Its first vibrations as a mechanism
/// holds and weighs it come quickly at many times, within a per cent or so from
/// above.
class SeatShapes {
 public:
  /// @param part   as nothing holds it.
  /// @param seats  wrenches on the seats that may hold and weigh it, 6 n ×
  ///   columns, independent, orthonormal.
  /// @param means  of unit wrenches on the seats, dofs × 6 n.
  /// @param has_fields  whether fields() are asked for: they take memory.
  SeatShapes(const VibratingPart<3>& part, Eigen::MatrixXd seats,
             const Eigen::MatrixXd& means, bool has_fields = false);

  /// Vibrations, lowest first: elastic ones, and swings on springs of the
  /// mechanism.
  struct Vibrations {
    Eigen::VectorXd squares;  ///< ω² [1/s²]
    Eigen::VectorXd damping;  ///< ζ by dampers [1]
    /// Motions of the seats in them, along `seats`, columns × shapes [1/√kg].
    Eigen::MatrixXd motions;
    /// The same less what the part moves as a whole: loads in balance excite by
    /// that alone.
    Eigen::MatrixXd bending;
    /// Of their strain energy, the part's: swings on springs bend it little
    /// [1].
    Eigen::VectorXd own_share;
  };
  /// @param hold  of seats' wrenches in the span of `seats`.
  Vibrations held_by(const loads::SeatHold& hold) const;
  /// Swings of the rigid part, and of other bodies, on springs of the
  /// mechanism, lowest first.
  struct Swings {
    Eigen::VectorXd squares;  ///< ω² [1/s²]
    Eigen::VectorXd damping;  ///< ζ by dampers [1]
  };
  /// Of the rigid part, and of other bodies [1/s²], [1].
  Swings rigid_swings(const loads::SeatHold& hold) const;

  /// A frequency and what bodies that spin on the part move it to, both
  /// circular [1/s].
  struct Moved {
    double still{}, moved{};
  };
  /// The lowest elastic ones, of M q'' + S q' + K q = 0.
  /// @param hold  with a spin.
  std::vector<Moved> moved_by_spin(const loads::SeatHold& hold) const;

  /// Components along `seats` of wrenches, 6 n × columns [N], [N m].
  Eigen::MatrixXd along_seats(const Eigen::MatrixXd& wrenches) const;
  /// Squares of the free part's circular frequencies in each shape, which are
  /// M-orthonormal; 0: the rigid ones, first [1/s²].
  const Eigen::VectorXd& squares() const { return squares_; }
  Eigen::Index rigid() const { return rigid_; }
  /// What wrenches do on the shapes, columns × shapes [N/√kg].
  Eigen::MatrixXd along_shapes(const Eigen::MatrixXd& wrenches) const;
  /// The shapes as displacements, without coefficients [1/√kg].
  /// @pre has_fields.
  const DisplacementBasis<3>& fields() const { return *fields_; }

 private:
  /// What is held and weighed: of shapes_ or of the rigid ones alone.
  struct Held;
  Held held(const loads::SeatHold& hold, Eigen::Index shapes) const;

  Eigen::MatrixXd seats_;
  Eigen::MatrixXd motions_;  ///< seats_ × shapes, of M-orthonormal shapes
  Eigen::VectorXd squares_;
  Eigen::Index rigid_{};  ///< the first of them
  std::optional<DisplacementBasis<3>> fields_;
};

/// Orthonormal wrenches of which those of all holds, and loads, are made, each
/// over its length, 6 n × columns.
/// @param loads  6 n × columns.
Eigen::MatrixXd span_of(const std::vector<loads::SeatHold>& holds,
                        const Eigen::MatrixXd& loads);

}  // namespace clevis::elasticity

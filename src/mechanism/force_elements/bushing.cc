#include "mechanism/force_elements/bushing.h"

#include <cmath>

#include <Eigen/Geometry>

#include "mechanism/element_base/acting_element.h"
#include "mechanism/joints/cross_matrix.h"

namespace clevis::mechanism {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Vector6 = Eigen::Matrix<double, 6, 1>;

/// Rate of a rotation vector per angular velocity in the frame that it turns
/// from: I − ½ [θ] + (1 − ½θ cot ½θ)/θ² [θ]².
Matrix3d rotation_vector_rate(const Vector3d& turn) {
  constexpr double kSmall = 1e-3;  // its next term is θ⁴/30240
  const double angle = turn.norm();
  const double c =
      angle < kSmall
          ? 1.0 / 12.0 + angle * angle / 720.0
          : (1.0 - 0.5 * angle / std::tan(0.5 * angle)) / (angle * angle);
  const Matrix3d across = cross_matrix(turn);
  return Matrix3d::Identity() - 0.5 * across + c * across * across;
}

class Bushing final : public ActingElement {
 public:
  Bushing(const BushingElement& bushing, const ReferenceFrame& frame)
      : bushing_(bushing) {
    R_PW = frame.R_WP.transpose();
    join(bushing.a, bushing.b, frame);
    line.frame_a.R_LJ = line.frame_a.R_LJ * bushing.R_AJ;
    line.frame_b.R_LJ = line.frame_b.R_LJ * bushing.R_BJ;
  }

  ElementSpring spring(const Configuration& x,
                       const ElementState& state) const override;

 protected:
  void act(const ActingState& state, const Twist& a, const Twist& b,
           ElementResponse& now) const override;
  /// The force acts at the origin of J on b.
  std::array<Vector3d, 2> touched(const ElementResponse& now) const override {
    return {now.placed.d, Vector3d::Zero()};
  }

 private:
  const BushingElement& bushing_;
};

ElementSpring Bushing::spring(const Configuration& x,
                              const ElementState& /*state*/) const {
  const PlacedJoint placed = placed_in(x);
  const Matrix3d& A = placed.axes_a;
  const Eigen::AngleAxisd turn(Matrix3d(A.transpose() * placed.axes_b));
  const Matrix3d moments =
      A * rotation_vector_rate(turn.angle() * turn.axis()).transpose();
  const Vector3d to_b = placed.r_a + placed.d;
  ElementSpring found{.stiffness = bushing_.stiffness,
                      .damping = bushing_.damping};
  for (int k = 0; k < 3; ++k) {
    const Vector3d f = A.col(k);
    found.directions.push_back(
        {.a = {-f, -to_b.cross(f)}, .b = {f, placed.r_b.cross(f)}});
  }
  for (int k = 0; k < 3; ++k) {
    const Vector3d m = moments.col(k);
    found.directions.push_back(
        {.a = {Vector3d::Zero(), -m}, .b = {Vector3d::Zero(), m}});
  }
  return found;
}

void Bushing::act(const ActingState& /*state*/, const Twist& a, const Twist& b,
                  ElementResponse& now) const {
  const PlacedJoint& placed = now.placed;
  const Matrix3d& A = placed.axes_a;
  const Eigen::AngleAxisd turn(Matrix3d(A.transpose() * placed.axes_b));
  const Vector3d rotation = turn.angle() * turn.axis();
  const Matrix3d rate_of_rotation = rotation_vector_rate(rotation);
  const Vector3d to_b = placed.r_a + placed.d;  // J on b, from M of a
  Vector6 x, x_rate;
  x << A.transpose() * placed.d, rotation;
  x_rate << A.transpose() *
                (b.v + b.w.cross(placed.r_b) - a.v - a.w.cross(to_b)),
      rate_of_rotation * (A.transpose() * (b.w - a.w));
  const Vector6 elastic = bushing_.stiffness * x;
  const Vector6 s = elastic + bushing_.damping * x_rate;
  const Vector3d f = -(A * s.head<3>());
  const Vector3d m = -(A * (rate_of_rotation.transpose() * s.tail<3>()));
  now.on_b = {f, placed.r_b.cross(f) + m};
  now.on_a = {-f, -(to_b.cross(f) + m)};
  now.q = placed.d.norm();
  now.rate = now.q > 0.0 ? x.head<3>().dot(x_rate.head<3>()) / now.q : 0.0;
  now.effort = f.norm();
  now.channels = {m.norm(), 0.5 * x.dot(elastic)};
}

}  // namespace

ElementProperties properties(const BushingElement& /*bushing*/) {
  return {.type = "bushing",
          .channels = {{.key = "moment_N_m"}, {.key = "energy_J"}},
          .free = 0.0};
}

std::unique_ptr<ActingElement> place(const BushingElement& bushing,
                                     const ReferenceFrame& frame) {
  return std::make_unique<Bushing>(bushing, frame);
}

}  // namespace clevis::mechanism

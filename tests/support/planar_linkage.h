#pragma once

#include <cmath>
#include <string>
#include <vector>

#include <Eigen/Core>

/// A planar mechanism as data, from which every program that is compared
/// builds its own: the same numbers for all.
namespace clevis::mechanism::testing {

/// Its frame has the pin by which it hangs on the others as origin.
struct PlanarBody {
  std::string name;
  double mass{};                                       ///< [kg]
  double inertia{};                                    ///< about the centre
                                                       ///< of mass [kg m²]
  Eigen::Vector2d centre = Eigen::Vector2d::Zero();    ///< in its frame [m]
  Eigen::Vector2d origin = Eigen::Vector2d::Zero();    ///< at the start [m]
  double angle{};                                      ///< at the start [rad]
  Eigen::Vector2d velocity = Eigen::Vector2d::Zero();  ///< of its origin [m/s]
  double rate{};                                       ///< [rad/s]

  Eigen::Vector2d at(const Eigen::Vector2d& p) const {
    const double c = std::cos(angle), s = std::sin(angle);
    return origin +
           Eigen::Vector2d(c * p.x() - s * p.y(), s * p.x() + c * p.y());
  }
};

/// A point of body a and one of body b that coincide; on a slide only their
/// heights do, and b does not turn against a. −1: the ground.
struct PlanarJoint {
  std::string name;
  int a = -1, b{};
  Eigen::Vector2d p_a = Eigen::Vector2d::Zero(), p_b = Eigen::Vector2d::Zero();
  bool slides = false;  ///< along x of the ground
};

struct PlanarSpring {
  int a = -1, b{};
  Eigen::Vector2d p_a, p_b;
  double stiffness{}, free{};  ///< [N/m], [m]
};

struct PlanarLinkage {
  std::string name;
  std::vector<PlanarBody> bodies;
  /// A joint whose body b no joint before it has is one of the tree, whose
  /// loops the others close.
  std::vector<PlanarJoint> joints;
  std::vector<PlanarSpring> springs;
  int turned = -1;   ///< body that `torque` acts on
  double torque{};   ///< [N m], about z
  double gravity{};  ///< along −y [m/s²]
  /// What is compared: the direction of x of a body and, in z, how far another
  /// slid [m]; the force in a joint.
  int pointer{}, slider = -1, watched = 0;

  /// Which joints close loops.
  std::vector<bool> closures() const {
    std::vector<bool> closes, reached(bodies.size(), false);
    for (const PlanarJoint& joint : joints) {
      const auto b = static_cast<std::size_t>(joint.b);
      closes.push_back(reached[b]);
      reached[b] = true;
    }
    return closes;
  }

  /// Rate of a joint at the start [rad/s].
  double rate(const PlanarJoint& joint) const {
    const auto of = [this](int body) {
      return body < 0 ? 0.0 : bodies[static_cast<std::size_t>(body)].rate;
    };
    return of(joint.b) - of(joint.a);
  }
};

}  // namespace clevis::mechanism::testing

#pragma once

#include <array>
#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Core>

namespace clevis::mechanism {

/// A displacement, then a turn.
inline constexpr Eigen::Index kMotionOfMover = 6;
using Motion6 = Eigen::Matrix<double, kMotionOfMover, 1>;

/// A body, or the body at one of its places, that moves by itself.
struct Mover {
  Eigen::Index at{};  ///< of its displacement and turn among all motions
  Eigen::Vector3d p;  ///< the point that is displaced, in P [m]
  bool is_place{};
};

/// What loads gain by second order, yᵀ H y / 2 of motions y: displacements,
/// turns, in P [m], [rad]. Forces f [N], moments t [N m], tensions [N], points
/// [m] in P.
class SecondOrderForm {
 public:
  explicit SecondOrderForm(Eigen::Index motions)
      : H_(Eigen::MatrixXd::Zero(motions, motions)) {}
  const Eigen::MatrixXd& matrix() const { return H_; }

  /// A force on a point r from the mover's: −f·θ×(θ×r)/2.
  void add_force(const Mover& mover, const Eigen::Vector3d& f,
                 const Eigen::Vector3d& r);
  /// A moment on b, its opposite on a: t·(θa×θb)/2.
  void add_moment(const Mover& a, const Mover& b, const Eigen::Vector3d& t);
  /// A tension along the line from a point of a to one of b.
  /// @param a, b  nothing: it does not move.
  void add_line(const std::optional<Mover>& a, const std::optional<Mover>& b,
                const Eigen::Vector3d& p_a, const Eigen::Vector3d& p_b,
                double tension);
  /// A force on b, its opposite on a, that turns with a: −(θa×f)·(δb − δa).
  void add_turning(const Mover& a, const std::optional<Mover>& b,
                   const Eigen::Vector3d& p, const Eigen::Vector3d& f);
  /// −λ times what a row's displacement has of second order.
  /// @param row  its second derivative for two motions.
  template <class Row>
  void add_row(const std::array<std::optional<Mover>, 2>& movers, double lambda,
               const Row& row) {
    std::vector<std::pair<std::size_t, Eigen::Index>> units;
    for (std::size_t side = 0; side < 2; ++side) {
      for (Eigen::Index k = 0; movers[side] && k < kMotionOfMover; ++k) {
        units.emplace_back(side, k);
      }
    }
    const auto of = [&](std::size_t i, std::size_t j) {
      std::array<Motion6, 2> motion{Motion6::Zero(), Motion6::Zero()};
      motion[units[i].first][units[i].second] += 1.0;
      if (i != j) motion[units[j].first][units[j].second] += 1.0;
      return row(motion[0], motion[1]);
    };
    std::vector<double> own;
    for (std::size_t i = 0; i < units.size(); ++i) own.push_back(of(i, i));
    const auto at = [&](std::size_t i) {
      return movers[units[i].first]->at + units[i].second;
    };
    for (std::size_t i = 0; i < units.size(); ++i) {
      H_(at(i), at(i)) -= lambda * own[i];
      for (std::size_t j = 0; j < i; ++j) {
        const double mixed = 0.5 * (of(i, j) - own[i] - own[j]);
        H_(at(i), at(j)) -= lambda * mixed;
        H_(at(j), at(i)) -= lambda * mixed;
      }
    }
  }

 private:
  /// Of p_b on b against p_a on a, 3 × motions.
  Eigen::MatrixXd relative_displacement(const std::optional<Mover>& a,
                                        const std::optional<Mover>& b,
                                        const Eigen::Vector3d& p_a,
                                        const Eigen::Vector3d& p_b) const;

  Eigen::MatrixXd H_;
};

}  // namespace clevis::mechanism

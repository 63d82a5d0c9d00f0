#include "mechanism/compliance/compliant_balance.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/QR>

#include "mechanism/compliance/compliance_maps.h"

namespace clevis::mechanism {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kDriveCompliance = 0.1 * kDefaultCompliance;
constexpr int kIterations = 200;
constexpr double kFree = 0.2;  // of the length: the load moves it off, freely

/// The energy and its derivatives, seen from displacements of one x.
class Energy {
 public:
  Energy(const SolvingFrame& frame, const ConstraintSystem& system,
         const Configuration& x, const VectorXd& f, const MatrixXd& held)
      : system_(system), f_(f), held_(MatrixXd::Zero(f.size(), f.size())) {
    if (held.cols() > 0) {
      const MatrixXd q = held.householderQr().householderQ() *
                         MatrixXd::Identity(held.rows(), held.cols());
      held_ = q * q.transpose() / kDriveCompliance;
    }
    const auto placed = system.place(x);
    const Index drives = system.rows() - system.joint_rows();
    targets_ = VectorXd::Zero(drives);
    targets_ = system.residual(placed, targets_).tail(drives);
    for (Index i = 0; i < drives; ++i) {
      const auto row = static_cast<std::size_t>(system.joint_rows() + i);
      targets_[i] /= system.scale(system.row_list()[row]);
    }
    MatrixXd C = row_compliance(frame, system, placed);
    C.diagonal().tail(drives).setConstant(kDriveCompliance);
    stiffness_ = C.ldlt().solve(MatrixXd::Identity(C.rows(), C.cols()));
  }

  /// −λ: forces of the joints against their gaps.
  VectorXd forces(const std::vector<PlacedJoint>& placed) const {
    return stiffness_ * system_.residual(placed, targets_);
  }

  double value(const Configuration& x, const VectorXd& displacement) const {
    const VectorXd c = system_.residual(system_.place(x), targets_);
    return 0.5 * c.dot(stiffness_ * c) + f_.dot(displacement) +
           0.5 * displacement.dot(held_ * displacement);
  }

  VectorXd gradient(const std::vector<PlacedJoint>& placed,
                    const VectorXd& displacement) const {
    return system_.jacobian(placed).transpose() * forces(placed) + f_ +
           held_ * displacement;
  }

  /// Jᵀ C⁻¹ J and the geometric part, by differences of J at fixed forces.
  MatrixXd hessian(const Configuration& x,
                   const std::vector<PlacedJoint>& placed) const {
    const MatrixXd J = system_.jacobian(placed);
    const VectorXd mu = forces(placed);
    const MatrixXd H = J.transpose() * stiffness_ * J + held_;
    const double h = 1e-6 * system_.scale({JointRow::Kind::kRotation});
    MatrixXd geometric(H.rows(), H.cols());
    const auto pull = [&](Index column, double step) {
      Configuration y = x;
      system_.move(y, step * VectorXd::Unit(H.cols(), column));
      return VectorXd(system_.jacobian(system_.place(y)).transpose() * mu);
    };
    for (Index k = 0; k < H.cols(); ++k) {
      geometric.col(k) = (pull(k, h) - pull(k, -h)) / (2.0 * h);
    }
    return H + 0.5 * (geometric + geometric.transpose());
  }

 private:
  const ConstraintSystem& system_;
  const VectorXd& f_;
  MatrixXd held_;  ///< stiffness
  VectorXd targets_;
  MatrixXd stiffness_;
};

/// Descent direction: Newton's where the Hessian is positive definite, else
/// that of the Hessian with a larger diagonal.
VectorXd descent(const MatrixXd& hessian, const VectorXd& gradient) {
  const double largest = hessian.diagonal().cwiseAbs().maxCoeff();
  for (double damping = 0.0;; damping = std::max(1e-14, 10.0 * damping)) {
    MatrixXd damped = hessian;
    damped.diagonal().array() += damping * largest;
    const Eigen::LLT<MatrixXd> cholesky(damped);
    if (cholesky.info() == Eigen::Success) return -cholesky.solve(gradient);
  }
}

}  // namespace

CompliantBalance compliant_balance(const SolvingFrame& frame,
                                   const ConstraintSystem& system,
                                   const Configuration& x, const VectorXd& f,
                                   const MatrixXd& held) {
  const Energy energy(frame, system, x, f, held);
  const double longest = 0.05 * frame.length;
  const double scale = std::max(f.cwiseAbs().maxCoeff(), 1e-300);
  Configuration y = x;
  VectorXd displacement = VectorXd::Zero(f.size());
  CompliantBalance result;
  double last = 0.0;
  for (int i = 0; i < kIterations; ++i) {
    const auto placed = system.place(y);
    const VectorXd gradient = energy.gradient(placed, displacement);
    result.lambda = -energy.forces(placed);
    // stiff joints: round-off of gaps (1e-16 m) over 1e-10 m/N
    const double left = gradient.cwiseAbs().maxCoeff();
    const double size_of_forces =
        std::max(scale, result.lambda.cwiseAbs().maxCoeff());
    result.found = left <= 1e-6 * size_of_forces;
    if (result.found && !(left < 0.5 * last)) break;
    last = left;
    VectorXd step = descent(energy.hessian(y, placed), gradient);
    const double size = step.cwiseAbs().maxCoeff();
    if (size > longest) step *= longest / size;
    const double before = energy.value(y, displacement);
    bool lower = false;
    for (int halvings = 0; halvings < 40 && !lower; ++halvings) {
      Configuration trial = y;
      system.move(trial, step);
      // near the minimum round-off hides the energy's change
      lower = energy.value(trial, displacement + step) < before ||
              energy.gradient(system.place(trial), displacement + step)
                      .cwiseAbs()
                      .maxCoeff() < 1e-2 * left;
      if (lower) {
        y = std::move(trial);
        displacement += step;
      } else {
        step *= 0.5;
      }
    }
    if (!lower) break;  // as far as round-off lets it
    result.deflection = system.distance(x, y);
    if (result.deflection > kFree * frame.length) {
      result.found = false;
      break;
    }
  }
  return result;
}

}  // namespace clevis::mechanism

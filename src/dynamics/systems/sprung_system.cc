#include "dynamics/systems/sprung_system.h"

#include "base/algebra/singular_vectors.h"
#include "dynamics/systems/block_krylov.h"
#include "dynamics/systems/updated_factor.h"

namespace clevis::dynamics {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

/// Rigid motions that springs do not feel, or so little that round-off of
/// elastic ones is more.
MatrixXd unsprung(const LinearSystem& system, const MatrixXd& springs) {
  constexpr double kFree = 1e-5;  // of a square that is low already
  if (system.rigid.cols() == 0) return system.rigid;
  const MatrixXd rigid = mass_orthonormal(system, system.rigid);
  const SingularVectors sprung = singular_vectors(springs.transpose() * rigid);
  return rigid *
         sprung.left(sprung.count_above(std::sqrt(kFree * system.low_square)));
}

}  // namespace

LinearSystem sprung_system(const LinearSystem& system,
                           const MatrixXd& springs) {
  LinearSystem sprung = system;
  sprung.rigid = unsprung(system, springs);
  sprung.is_held = system.is_held || sprung.rigid.cols() < system.rigid.cols();
  sprung.stiffness = [stiffness = system.stiffness,
                      springs](const MatrixXd& x) -> MatrixXd {
    return stiffness(x) + springs * (springs.transpose() * x);
  };
  sprung.factor = [factor = system.factor, stiffness = sprung.stiffness,
                   mass = system.mass, springs](double shift) -> BlockOperator {
    const BlockOperator solve = factor(shift);
    return updated_factor(solve, springs, 1.0,
                          [stiffness, mass, shift](const MatrixXd& x) {
                            return MatrixXd(stiffness(x) + shift * mass(x));
                          });
  };
  return sprung;
}

}  // namespace clevis::dynamics

#include "mechanism/neighbours/load_gains.h"

#include <algorithm>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include "base/algebra/append_columns.h"
#include "base/values/index.h"
#include "mechanism/neighbours/neighbour_following.h"
#include "mechanism/neighbours/second_order_form.h"

namespace clevis::mechanism {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double kRoundOff = 1e-9;

/// The rows of the body as rows of the places' motions, turns times length.
MatrixXd rows_of_places(const Neighbours& neighbours, const NeighbourRows& rows,
                        const std::vector<LoadPlace>& places) {
  const SolvingFrame& frame = neighbours.frame();
  const Matrix3d& R = rows.x[index(neighbours.slot())].R;
  MatrixXd all =
      MatrixXd::Zero(rows.body.rows(), kMotionOfMover * std::ssize(places));
  for (Index k = 0; k < rows.body.rows(); ++k) {
    const NeighbourPlace& at = rows.places[rows.place_of[index(k)]];
    int drive = -1;
    const auto& drives = neighbours.definition().drives;
    for (std::size_t d = 0; at.is_drive && d < drives.size(); ++d) {
      if (drives[d].joint == at.joint) drive = static_cast<int>(d);
    }
    const auto place = place_of(
        places, at.is_drive ? LoadPlace::Kind::kDrive : LoadPlace::Kind::kJoint,
        at.is_drive ? drive : at.joint, at.joint);
    if (!place) continue;
    const Vector3d force = rows.body.row(k).head<3>();
    const Vector3d to_M =
        R * (frame.p_LM[index(neighbours.slot() - 1)] - places[*place].p_LS);
    all.row(k).segment<3>(kMotionOfMover * static_cast<Index>(*place)) = force;
    all.row(k).segment<3>(kMotionOfMover * static_cast<Index>(*place) + 3) =
        rows.body.row(k).tail<3>().transpose() +
        to_M.cross(force) / frame.length;
  }
  return all;
}

/// Rows of force elements, times the root of their stiffness: of motions of
/// neighbours, then of places, × rows [√(N/m)].
struct ElementRows {
  MatrixXd springs;  ///< of those that yield
  /// Of those whose effort grows as they give way: a table's that rises.
  MatrixXd pushing_on;
};

ElementRows element_rows(const Neighbours& neighbours,
                         const NeighbourRows& rows, const Instant& instant,
                         const std::vector<LoadPlace>& places) {
  const SolvingFrame& frame = neighbours.frame();
  const Matrix3d& R = rows.x[index(neighbours.slot())].R;
  const Index of_bodies = kMotionOfMover * std::ssize(neighbours.slots());
  const Index motions = of_bodies + kMotionOfMover * std::ssize(places);
  ElementRows found{MatrixXd(motions, 0), MatrixXd(motions, 0)};
  const std::size_t count =
      std::min(instant.elements.size(), neighbours.elements().size());
  for (std::size_t e = 0; e < count; ++e) {
    if (!neighbours.elements()[e]) continue;
    const ActingElement& element = *neighbours.elements()[e];
    const ElementSpring spring = element.spring(rows.x, instant.elements[e]);
    if (spring.relaxes) continue;
    MatrixXd along = MatrixXd::Zero(motions, std::ssize(spring.directions));
    const auto add = [&](int slot, const SpatialForce& force, Index column) {
      if (slot != neighbours.slot()) {
        neighbours.add_action(slot, force, along.col(column).head(of_bodies));
        return;
      }
      const auto place = place_of(places, LoadPlace::Kind::kElement,
                                  static_cast<int>(e), element.joint);
      if (!place) return;
      const Vector3d to_M =
          R * (frame.p_LM[index(slot - 1)] - places[*place].p_LS);
      auto row = along.col(column).segment<kMotionOfMover>(
          of_bodies + kMotionOfMover * static_cast<Index>(*place));
      row.head<3>() += force.v;
      row.tail<3>() += (force.w + to_M.cross(force.v)) / frame.length;
    };
    for (Index k = 0; k < along.cols(); ++k) {
      add(element.line.a, spring.directions[index(k)].a, k);
      add(element.line.b, spring.directions[index(k)].b, k);
    }
    if (along.cols() == 0) continue;
    const auto append = [&](const MatrixXd& stiffness, MatrixXd& all) {
      const MatrixXd root = root_of(stiffness);
      if (root.isZero(0.0)) return;
      append_columns(along * root, all);
    };
    append(spring.stiffness, found.springs);
    append(-spring.stiffness, found.pushing_on);
  }
  return found;
}

/// What springs that hold neighbours yield at a load factor: wᵀ (K/λ + H) w/2
/// is least over their strains w. Where they topple before the factor that is
/// wanted, that of the loads as they are counts.
MatrixXd yielded(const MatrixXd& form, const MatrixXd& product,
                 const Following& following, double wanted) {
  const Index bodies = following.slow.rows(), moves = following.slow.cols();
  const MatrixXd& sprung = following.sprung;
  const MatrixXd pushed = sprung.transpose() * product.topRows(bodies);
  const MatrixXd of_loads =
      sprung.transpose() * form.topLeftCorner(bodies, bodies) * sprung;
  for (const double factor : {wanted, 1.0}) {
    MatrixXd held = of_loads;
    held.diagonal() += following.stiffness / factor;
    const Eigen::LLT<MatrixXd> root(held);
    if (root.info() == Eigen::Success) {
      return pushed.transpose() * root.solve(pushed);
    }
  }
  return MatrixXd::Zero(moves, moves);
}

/// Whether springs hold bodies that are no parts: what those of a checked part
/// yield is told by its own factor.
bool holds_other_bodies(const Neighbours& neighbours, const MatrixXd& sprung) {
  if (sprung.cols() == 0) return false;
  const double least = kRoundOff * sprung.norm();
  for (std::size_t k = 0; k < neighbours.slots().size(); ++k) {
    const BodyDefinition& body =
        neighbours.definition().bodies[index(neighbours.slots()[k] - 1)];
    const auto moves = sprung.middleRows<kMotionOfMover>(kMotionOfMover *
                                                         static_cast<Index>(k));
    if (body.part.empty() && !moves.isZero(least)) return true;
  }
  return false;
}

/// −∂²L of the places, of a form of neighbours' motions and theirs.
/// @param wanted  load factor at which springs that hold these yield; 0: they
///   do not.
MatrixXd eliminated(const MatrixXd& form, const Following& following,
                    double wanted) {
  const Index bodies = following.slow.rows(), moves = following.slow.cols();
  MatrixXd motions(bodies + moves, moves);
  motions << following.slow, following.admitted;
  const MatrixXd product = form * motions;
  MatrixXd gain = -motions.transpose() * product;
  if (wanted > 0.0) gain += yielded(form, product, following, wanted);
  if (following.loose.cols() > 0) {
    const MatrixXd& loose = following.loose;
    const Eigen::SelfAdjointEigenSolver<MatrixXd> held(
        loose.transpose() * form.topLeftCorner(bodies, bodies) * loose);
    const MatrixXd pushed = held.eigenvectors().transpose() *
                            loose.transpose() * product.topRows(bodies);
    const double round_off =
        kRoundOff * form.norm() * loose.colwise().squaredNorm().maxCoeff();
    for (Index k = 0; k < pushed.rows(); ++k) {
      const double stiffness = held.eigenvalues()[k];
      if (stiffness <= round_off) continue;
      gain += pushed.row(k).transpose() * pushed.row(k) / stiffness;
    }
  }
  return 0.5 * (gain + gain.transpose());
}

}  // namespace

MatrixXd load_gains(const Neighbours& neighbours, const Instant& instant,
                    const std::vector<LoadPlace>& places, double wanted) {
  const NeighbourRows rows = neighbours.rows(instant);
  const double length = neighbours.frame().length;
  const Index moves = kMotionOfMover * std::ssize(places);
  MatrixXd form = load_form(neighbours, rows, instant, places);
  VectorXd scale = VectorXd::Ones(form.rows());  // of turns to lengths
  for (Index i = 0; i < scale.size(); ++i) {
    if (i % kMotionOfMover >= 3) scale[i] = 1.0 / length;
  }
  form = scale.asDiagonal() * form * scale.asDiagonal();
  Following following =
      following_of(neighbours, rows, rows_of_places(neighbours, rows, places));
  const ElementRows elements = element_rows(neighbours, rows, instant, places);
  form -= elements.pushing_on * elements.pushing_on.transpose();
  follow_springs(elements.springs, form, following);
  MatrixXd to_P = MatrixXd::Zero(moves, moves);
  const Matrix3d& R_PL = rows.x[index(neighbours.slot())].R;
  for (Index i = 0; i < moves; i += 3) {
    const double of_turns = i % kMotionOfMover == 0 ? 1.0 : length;
    to_P.block<3, 3>(i, i) = of_turns * R_PL;
  }
  const bool yields = holds_other_bodies(neighbours, following.sprung);
  return to_P.transpose() * eliminated(form, following, yields ? wanted : 0.0) *
         to_P;
}

}  // namespace clevis::mechanism

#include "mechanism/mass_matrix/neighbour_inertia.h"

#include <algorithm>
#include <deque>

#include <Eigen/Geometry>
#include <Eigen/SVD>

#include "base/values/index.h"
#include "mechanism/constraints/constraint_system.h"
#include "mechanism/mass_matrix/centre_frame.h"

namespace clevis::mechanism {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;

constexpr std::size_t kMostBodies = 100;
constexpr Index kTwist = 6;
// Of rows of pure numbers, and of bodies' masses: less is round-off.
constexpr double kRoundOff = 1e-9;

/// Of the bodies at an instant, referred to the frame's points M.
Configuration configuration(const SolvingFrame& frame, const Instant& instant) {
  Configuration x(instant.bodies.size() + 1);
  for (std::size_t i = 0; i < instant.bodies.size(); ++i) {
    const Pose& pose = instant.bodies[i].pose;
    BodyPlacement& at = x[i + 1];
    at.R = frame.R_WP.transpose() * pose.R_WL;
    at.q = Eigen::Quaterniond(at.R);
    at.p = frame.R_WP.transpose() * pose.p_WL + at.R * frame.p_LM[i];
  }
  return x;
}

/// Slots of the bodies that are joined to one, the nearest by joints first; the
/// ground joins none.
std::vector<int> neighbours_of(const SolvingFrame& frame, int slot) {
  std::vector<int> found;
  std::vector<bool> is_known(frame.placement.size(), false);
  is_known[0] = is_known[index(slot)] = true;
  std::deque<int> next{slot};
  const auto join = [&](int here, int there) {
    if (here != next.front() || is_known[index(there)]) return;
    is_known[index(there)] = true;
    found.push_back(there);
    next.push_back(there);
  };
  for (; !next.empty() && found.size() < kMostBodies; next.pop_front()) {
    for (const JointModel& joint : frame.joints) {
      join(joint.a, joint.b);
      join(joint.b, joint.a);
    }
    for (const CouplingModel& coupling : frame.couplings) {
      const JointModel& first = frame.joints[index(coupling.joint_1)];
      const JointModel& second = frame.joints[index(coupling.joint_2)];
      for (const int a : {first.a, first.b}) {
        for (const int b : {second.a, second.b}) {
          join(a, b);
          join(b, a);
        }
      }
    }
  }
  return found;
}

/// Of bodies about their centres, in unknowns of ConstraintSystem [kg].
MatrixXd masses(const MechanismDefinition& definition,
                const SolvingFrame& frame, const Configuration& x,
                const std::vector<int>& slots) {
  const Index size = kTwist * static_cast<Index>(slots.size());
  MatrixXd mass = MatrixXd::Zero(size, size);
  for (std::size_t k = 0; k < slots.size(); ++k) {
    const Index at = kTwist * static_cast<Index>(k);
    const auto& given = definition.bodies[index(slots[k] - 1)].mass_properties;
    const Matrix3d& R = x[index(slots[k])].R;
    mass.block<3, 3>(at, at) = given.mass * Matrix3d::Identity();
    mass.block<3, 3>(at + 3, at + 3) =
        R * given.inertia_LCm * R.transpose() / (frame.length * frame.length);
  }
  return mass;
}

/// Motions that rows leave, orthonormal.
MatrixXd null_space(const MatrixXd& rows) {
  if (rows.size() == 0) return MatrixXd::Identity(rows.cols(), rows.cols());
  Eigen::BDCSVD<MatrixXd> svd(rows, Eigen::ComputeFullV);
  svd.setThreshold(kRoundOff);
  return svd.matrixV().rightCols(rows.cols() - svd.rank());
}

/// A row of the body as a wrench, by place.
class Wrenches {
 public:
  Wrenches(const SolvingFrame& frame, const BodyPlacement& body,
           const Vector3d& p_LM)
      : length_(frame.length), R_LP_(body.R.transpose()), p_LM_(p_LM) {}

  void put(const Eigen::Matrix<double, 6, 1>& row, NeighbourInertia::Place at,
           std::vector<NeighbourInertia::Place>& places) {
    const auto known = std::ranges::find_if(places, [&](const auto& place) {
      return place.joint == at.joint && place.is_drive == at.is_drive;
    });
    of_place_.push_back(known - places.begin());
    if (known == places.end()) places.push_back(at);
    const Vector3d force = R_LP_ * row.head<3>();
    Eigen::Matrix<double, 6, 1> wrench;
    wrench << force, length_ * (R_LP_ * row.tail<3>()) + p_LM_.cross(force);
    wrenches_.push_back(wrench);
  }

  /// 6 places × rows.
  MatrixXd matrix(std::size_t places) const {
    MatrixXd all = MatrixXd::Zero(kTwist * static_cast<Index>(places),
                                  static_cast<Index>(wrenches_.size()));
    for (std::size_t k = 0; k < wrenches_.size(); ++k) {
      all.col(static_cast<Index>(k)).segment<kTwist>(kTwist * of_place_[k]) =
          wrenches_[k];
    }
    return all;
  }

 private:
  double length_;
  Matrix3d R_LP_;
  Vector3d p_LM_;
  std::vector<Index> of_place_;
  std::vector<Eigen::Matrix<double, 6, 1>> wrenches_;
};

/// Rows on the body, its part and its neighbours', and those among neighbours.
struct Rows {
  MatrixXd wrenches;  ///< on the body, 6 places × rows
  MatrixXd there;     ///< of the neighbours' motions
  MatrixXd among;
};

Rows split_rows(const ConstraintSystem& system, const SolvingFrame& frame,
                const Configuration& x, int slot, const std::vector<int>& slots,
                std::vector<NeighbourInertia::Place>& places) {
  const MatrixXd J = system.jacobian(system.place(x));
  const auto block = [&](Index row, int of) {
    return J.row(row).segment<kTwist>(kTwist * (of - 1));
  };
  Wrenches wrenches(frame, x[index(slot)], frame.p_LM[index(slot - 1)]);
  std::vector<Index> own, among;
  for (Index row = 0; row < J.rows(); ++row) {
    if (block(row, slot).isZero(0.0)) {
      if (std::ranges::any_of(slots, [&](int neighbour) {
            return !block(row, neighbour).isZero(0.0);
          })) {
        among.push_back(row);
      }
      continue;
    }
    const ConstraintSystem::Row& of = system.row_list()[index(row)];
    const JointModel& first = frame.joints[index(of.joint)];
    const bool is_second =
        of.coupling >= 0 && first.a != slot && first.b != slot;
    const int joint =
        is_second ? frame.couplings[index(of.coupling)].joint_2 : of.joint;
    own.push_back(row);
    wrenches.put(block(row, slot).transpose(),
                 {joint, row >= system.joint_rows()}, places);
  }
  const auto of_neighbours = [&](const std::vector<Index>& rows) {
    MatrixXd part(static_cast<Index>(rows.size()),
                  kTwist * static_cast<Index>(slots.size()));
    for (std::size_t i = 0; i < rows.size(); ++i) {
      for (std::size_t k = 0; k < slots.size(); ++k) {
        part.row(static_cast<Index>(i))
            .segment<kTwist>(kTwist * static_cast<Index>(k)) =
            block(rows[i], slots[k]);
      }
    }
    return part;
  };
  return {wrenches.matrix(places.size()), of_neighbours(own),
          of_neighbours(among)};
}

}  // namespace

NeighbourInertia neighbour_inertia(const MechanismDefinition& definition,
                                   const Instant& instant, BodyIndex body) {
  const SolvingFrame frame = frame_at_centres(definition);
  const ConstraintSystem system(frame, definition.drives, Motions::kSpatial,
                                ConstraintSystem::Drives::kAll);
  const Configuration x = configuration(frame, instant);
  const int slot = body + 1;
  const std::vector<int> slots = neighbours_of(frame, slot);
  NeighbourInertia found;
  const Rows rows = split_rows(system, frame, x, slot, slots, found.places);
  // What the neighbours can do, and what of it their rows on the body see.
  const MatrixXd free = null_space(rows.among);
  found.held = rows.wrenches;
  found.weighed.resize(rows.wrenches.rows(), 0);
  if (free.cols() == 0 || rows.wrenches.cols() == 0) return found;
  const MatrixXd seen = rows.there * free;
  const Eigen::JacobiSVD<MatrixXd> svd(seen, Eigen::ComputeFullU);
  const Index follow = (svd.singularValues().array() > kRoundOff).count();
  const MatrixXd& U = svd.matrixU();
  found.held = rows.wrenches * U.rightCols(U.cols() - follow);
  if (follow == 0) return found;
  MatrixXd mass = free.transpose() * masses(definition, frame, x, slots) * free;
  mass.diagonal().array() += kRoundOff * kRoundOff * mass.diagonal().maxCoeff();
  const MatrixXd directions = seen.transpose() * U.leftCols(follow);
  const MatrixXd mobility =
      directions.transpose() * mass.llt().solve(directions);
  const Eigen::LLT<MatrixXd> root(mobility);
  // Added mass (L Lᵀ)⁻¹ = L⁻ᵀ L⁻¹ of the followed motions.
  found.weighed = rows.wrenches * U.leftCols(follow) *
                  root.matrixU().solve(MatrixXd::Identity(follow, follow));
  return found;
}

}  // namespace clevis::mechanism

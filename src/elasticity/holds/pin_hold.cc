#include "elasticity/holds/pin_hold.h"

#include <iterator>
#include <map>
#include <utility>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "base/algebra/singular_vectors.h"
#include "elasticity/algebra/dense_product.h"

namespace clevis::elasticity {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// Centres nearer than this, over the part's size, have no line between them.
constexpr double kNearest = 1e-3;

template <int dim>
inline constexpr Index kMotions = kRigidModes<dim>;

/// Functionals one after another.
template <int dim>
void append(const NodeFunctionals<dim>& more, NodeFunctionals<dim>& all) {
  const Index rows = all.rows.rows(), columns = all.rows.cols();
  std::ranges::copy(more.nodes, std::back_inserter(all.nodes));
  all.rows.conservativeResize(std::max(rows, more.rows.rows()),
                              columns + more.rows.cols());
  all.rows.rightCols(more.rows.cols()) = more.rows;
}

/// Conditions of a part.
template <int dim>
class Conditions {
 public:
  Conditions(MeanMotions<dim>& motions, const HoldingSeats& hold,
             const std::string& part_name)
      : motions_(motions), hold_(hold), part_name_(part_name) {}

  /// As many as rigid motions, not scaled.
  NodeFunctionals<dim> of_groups() {
    std::vector<std::string> groups;
    std::ranges::copy_if(hold_.groups, std::back_inserter(groups),
                         [&](const std::string& name) {
                           return motions_.has_faces(loads::group_of(name));
                         });
    if (groups.empty()) return motions_.of_part().of;
    const MeanMotion<dim>& first = motion_of(groups[0]);
    if (groups.size() == 1) return first.of;
    const MeanMotion<dim>& second = motion_of(groups[1]);
    const Eigen::Matrix<double, dim, 1> line = second.centre - first.centre;
    if (line.norm() <= kNearest * motions_.size()) return first.of;
    const Eigen::Matrix<double, dim, 1> along = line.normalized();
    const Eigen::Matrix<double, dim, 1> across = along.unitOrthogonal();
    MatrixXd of_first = MatrixXd::Zero(kMotions<dim>, first.of.rows.cols());
    MatrixXd of_second = MatrixXd::Zero(kMotions<dim>, second.of.rows.cols());
    of_first.topRows(dim) = first.of.rows.topRows(dim);
    of_second.row(dim) = across.transpose() * second.of.rows.topRows(dim);
    if constexpr (dim == 3) {
      of_second.row(4) =
          along.cross(across).transpose() * second.of.rows.topRows(3);
      of_first.row(5) = along.transpose() * first.of.rows.bottomRows(3);
    }
    NodeFunctionals<dim> both{first.of.nodes, std::move(of_first)};
    append({second.of.nodes, std::move(of_second)}, both);
    return both;
  }

  /// As many as there are columns of wrenches.
  NodeFunctionals<dim> of_wrenches() {
    NodeFunctionals<dim> all;
    for (const loads::GroupHold& held : hold_.held) {
      if (!motions_.has_faces(loads::group_of(held.group))) continue;
      const MeanMotion<dim>& motion = motion_of(held.group);
      append({motion.of.nodes,
              about(motion.centre, held).transpose() * motion.of.rows},
             all);
    }
    return all;
  }

 private:
  /// Wrenches about a centre as they act on a displacement and a turn there.
  static MatrixXd about(const Eigen::Matrix<double, dim, 1>& centre,
                        const loads::GroupHold& hold) {
    Vector3d from_point = Vector3d::Zero();
    from_point.head<dim>() = centre - hold.p_LS.head<dim>();
    MatrixXd wrenches(kMotions<dim>, hold.wrenches.cols());
    for (Index k = 0; k < wrenches.cols(); ++k) {
      const Vector3d force = hold.wrenches.col(k).head<3>();
      const Vector3d moment =
          hold.wrenches.col(k).tail<3>() - from_point.cross(force);
      wrenches.col(k) << force.head<dim>(), moment.tail<kMotions<dim> - dim>();
    }
    return wrenches;
  }

  const MeanMotion<dim>& motion_of(const std::string& holder) {
    const auto known = touched_.find(holder);
    if (known != touched_.end()) return known->second;
    if (const auto seat = touched_seat(holder)) {
      return touched_
          .emplace(holder,
                   motions_.of_touched(*hold_.touched, *seat, part_name_))
          .first->second;
    }
    return motions_.of_group(loads::group_of(holder));
  }

  std::optional<std::size_t> touched_seat(const std::string& holder) const {
    if (!hold_.touched) return std::nullopt;
    const auto& seats = hold_.touched->seats;
    for (std::size_t s = 0; s < seats.size(); ++s) {
      if (seats[s].slide && loads::holder_of(seats, s) == holder) return s;
    }
    return std::nullopt;
  }

  MeanMotions<dim>& motions_;
  const HoldingSeats& hold_;
  const std::string& part_name_;
  std::map<std::string, MeanMotion<dim>> touched_;  ///< by holder
};

/// Of unit effect on rigid motions.
template <int dim>
NodeFunctionals<dim> scaled(NodeFunctionals<dim> conditions,
                            const MatrixXd& rigid) {
  conditions.rows =
      (conditions.of(rigid).fullPivLu().inverse() * conditions.rows).eval();
  return conditions;
}

/// Those of the wrenches that rigid motions feel; what they do not feel is held
/// by the groups' conditions, of unit effect.
template <int dim>
NodeFunctionals<dim> felt(NodeFunctionals<dim> wrenches,
                          const NodeFunctionals<dim>& groups,
                          const MatrixXd& rigid) {
  constexpr double kFeels = 1e-4;  // of what is felt most
  const SingularVectors by_rigid = singular_vectors(wrenches.of(rigid));
  const Index n = by_rigid.rank(kFeels);
  const Index rest = kMotions<dim> - n;
  NodeFunctionals<dim> all{wrenches.nodes,
                           MatrixXd::Zero(kMotions<dim>, wrenches.rows.cols())};
  all.rows.topRows(n) = by_rigid.U.leftCols(n).transpose() * wrenches.rows;
  MatrixXd left = MatrixXd::Zero(kMotions<dim>, groups.rows.cols());
  left.bottomRows(rest) = by_rigid.left(n).transpose() * groups.rows;
  append({groups.nodes, std::move(left)}, all);
  return all;
}

}  // namespace

template <int dim>
PinHold<dim>::PinHold(MeanMotions<dim>& motions, const HoldingSeats& hold,
                      const std::string& part_name)
    : rigid_(motions.rigid()) {
  Conditions<dim> conditions(motions, hold, part_name);
  conditions_ = scaled(conditions.of_groups(), rigid_);
  NodeFunctionals<dim> held = conditions.of_wrenches();
  if (held.rows.rows() == 0) return;
  if (hold.with_all) all_ = held;
  conditions_ = scaled(felt(std::move(held), conditions_, rigid_), rigid_);
}

template <int dim>
MatrixXd PinHold<dim>::broken(const MatrixXd& u) const {
  return conditions_.of(u);
}

template <int dim>
MatrixXd PinHold<dim>::project(const MatrixXd& u) const {
  return u - product(rigid_, broken(u));
}

template <int dim>
MatrixXd PinHold<dim>::balance(const MatrixXd& f) const {
  MatrixXd balanced = f;
  conditions_.add(-transposed_product(rigid_, f), balanced);
  return balanced;
}

template <int dim>
MatrixXd PinHold<dim>::beyond() const {
  MatrixXd forces = MatrixXd::Zero(rigid_.rows(), all_.rows.rows());
  if (forces.cols() == 0) return forces;
  all_.add(MatrixXd::Identity(forces.cols(), forces.cols()), forces);
  return balance(forces);
}

template class PinHold<2>;
template class PinHold<3>;

}  // namespace clevis::elasticity

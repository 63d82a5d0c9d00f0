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
  NodeFunctionals<dim> of_wrenches(const std::vector<loads::GroupHold>& holds) {
    NodeFunctionals<dim> all;
    for (const loads::GroupHold& held : holds) {
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

/// Conditions from wrenches one after another, each for rigid motions that
/// those before leave free.
template <int dim>
class FeltConditions {
 public:
  explicit FeltConditions(const MatrixXd& rigid)
      : rigid_(rigid),
        free_(MatrixXd::Identity(kMotions<dim>, kMotions<dim>)) {}

  /// Takes those that rigid motions feel: of more wrenches than motions the
  /// motion that is nearest to all, by their sizes.
  /// @param least  share of the wrench's whole effect, below which it lets the
  ///   free motions pass.
  void take(const NodeFunctionals<dim>& wrenches, double least) {
    if (wrenches.rows.rows() == 0 || free_.cols() == 0) return;
    const MatrixXd effect = wrenches.of(rigid_);
    const SingularVectors felt = singular_vectors(effect * free_);
    std::vector<Index> holding, passing;
    for (Index k = 0; k < free_.cols(); ++k) {
      const double whole =
          k < felt.U.cols() ? (felt.U.col(k).transpose() * effect).norm() : 0.0;
      const bool holds = k < felt.sigma.size() &&
                         felt.sigma[k] > kFeels * felt.sigma[0] &&
                         felt.sigma[k] > least * whole;
      (holds ? holding : passing).push_back(k);
    }
    add(felt.U(Eigen::all, holding).transpose() * wrenches.rows,
        wrenches.nodes);
    free_ = (free_ * felt.V(Eigen::all, passing)).eval();
  }

  /// What is still free is held by the groups' conditions, of unit effect.
  NodeFunctionals<dim> finish(const NodeFunctionals<dim>& groups) {
    add(free_.transpose() * groups.rows, groups.nodes);
    return std::move(all_);
  }

 private:
  static constexpr double kFeels = 1e-4;  // of what is felt most

  void add(const MatrixXd& conditions, const std::vector<Index>& nodes) {
    MatrixXd rows = MatrixXd::Zero(kMotions<dim>, conditions.cols());
    rows.middleRows(count_, conditions.rows()) = conditions;
    append({nodes, std::move(rows)}, all_);
    count_ += conditions.rows();
  }

  const MatrixXd& rigid_;
  MatrixXd free_;  ///< of rigid motions, orthonormal
  NodeFunctionals<dim> all_;
  Index count_ = 0;
};

}  // namespace

template <int dim>
PinHold<dim>::PinHold(MeanMotions<dim>& motions, const HoldingSeats& hold,
                      const std::string& part_name)
    : rigid_(motions.rigid()) {
  Conditions<dim> conditions(motions, hold, part_name);
  conditions_ = scaled(conditions.of_groups(), rigid_);
  NodeFunctionals<dim> held = conditions.of_wrenches(hold.held);
  const NodeFunctionals<dim> sprung = conditions.of_wrenches(hold.sprung);
  if (held.rows.rows() == 0 && sprung.rows.rows() == 0) return;
  FeltConditions<dim> felt(rigid_);
  felt.take(held, 0.0);
  // A spring whose arm is so short gives way as a whole.
  constexpr double kShortArm = 0.05;
  felt.take(sprung, kShortArm);
  conditions_ = scaled(felt.finish(conditions_), rigid_);
  if (hold.with_all) all_ = std::move(held);
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

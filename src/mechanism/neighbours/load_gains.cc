#include "mechanism/neighbours/load_gains.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/QR>

#include "base/algebra/singular_vectors.h"
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

/// The place of a joint or a drive; a drive without one acts at its joint's.
std::optional<std::size_t> place_of(const std::vector<LoadPlace>& places,
                                    LoadPlace::Kind kind, int index,
                                    int joint) {
  const auto find = [&](LoadPlace::Kind wanted, int of) {
    return std::ranges::find_if(places, [&](const LoadPlace& place) {
      return place.kind == wanted && place.index == of;
    });
  };
  auto found = find(kind, index);
  if (found == places.end()) found = find(LoadPlace::Kind::kJoint, joint);
  if (found == places.end()) return std::nullopt;
  return static_cast<std::size_t>(found - places.begin());
}

/// Loads and reactions of an instant as a form of the motions of neighbours,
/// then places.
class LoadForm {
 public:
  LoadForm(const Neighbours& neighbours, const NeighbourRows& rows,
           const Instant& instant, const std::vector<LoadPlace>& places)
      : neighbours_(neighbours),
        frame_(neighbours.frame()),
        rows_(rows),
        instant_(instant),
        places_(places),
        form_(kMotionOfMover *
              (std::ssize(neighbours.slots()) + std::ssize(places))) {
    add_joints();
    add_efforts();
    add_elements();
  }
  const MatrixXd& matrix() const { return form_.matrix(); }

 private:
  Vector3d in_P(const Vector3d& in_W) const {
    return frame_.R_WP.transpose() * in_W;
  }

  /// Nothing for the ground, and for what no joint leads to.
  std::optional<Mover> mover(int slot, LoadPlace::Kind kind, int index,
                             int joint) const {
    if (slot == neighbours_.slot()) {
      const auto place = place_of(places_, kind, index, joint);
      if (!place) return std::nullopt;
      const BodyPlacement& body = rows_.x[clevis::index(slot)];
      const Vector3d from_M =
          places_[*place].p_LS - frame_.p_LM[clevis::index(slot - 1)];
      return Mover{kMotionOfMover * (std::ssize(neighbours_.slots()) +
                                     static_cast<Index>(*place)),
                   body.p + body.R * from_M, true};
    }
    const auto found = std::ranges::find(neighbours_.slots(), slot);
    if (found == neighbours_.slots().end()) return std::nullopt;
    return Mover{kMotionOfMover * (found - neighbours_.slots().begin()),
                 rows_.x[clevis::index(slot)].p, false};
  }

  void add_row(const PlacedJoint& placed, int joint, const JointRow& row,
               double lambda, LoadPlace::Kind kind, int of) {
    if (lambda == 0.0) return;
    const JointModel& model = frame_.joints[index(joint)];
    const std::array slots{model.a, model.b};
    const std::array movers{mover(model.a, kind, of, joint),
                            mover(model.b, kind, of, joint)};
    const auto twist = [&](std::size_t side, const Motion6& motion) {
      if (!movers[side]) return Twist{};
      const Vector3d turn = motion.tail<3>();
      const Vector3d to_M = rows_.x[index(slots[side])].p - movers[side]->p;
      return Twist{motion.head<3>() + turn.cross(to_M), turn};
    };
    form_.add_row(movers, lambda, [&](const Motion6& a, const Motion6& b) {
      return placed.bias(row, twist(0, a), twist(1, b));
    });
    // The twist is of M, whose way from a place's point is turned, too.
    const auto levers = placed.levers(row);
    if (kind == LoadPlace::Kind::kDrive && !movers[0] &&
        acts_on_own_seat(movers[1], kind, of)) {
      const Vector3d force = lambda * levers.b.v;
      form_.add_force(*movers[1], -force,
                      way_along(force, *movers[1], placed.p_b));
    }
    for (std::size_t side = 0; side < 2; ++side) {
      if (!movers[side] || !movers[side]->is_place) continue;
      const Vector3d& force = side == 0 ? levers.a.v : levers.b.v;
      form_.add_force(*movers[side], lambda * force,
                      rows_.x[index(slots[side])].p - movers[side]->p);
    }
  }

  bool acts_on_own_seat(const std::optional<Mover>& mover, LoadPlace::Kind kind,
                        int of) const {
    return mover && mover->is_place &&
           std::ranges::any_of(places_, [&](const LoadPlace& place) {
             return place.kind == kind && place.index == of;
           });
  }

  /// The part along a force of the way from a mover's point to another [m].
  /// Where on its line a joint has its point says nothing of where the force
  /// acts: its seat does.
  static Vector3d way_along(const Vector3d& force, const Mover& mover,
                            const Vector3d& p) {
    const Vector3d e = force.normalized();
    return (p - mover.p).dot(e) * e;
  }

  /// What of that way does not count [m]: all of it on a line of a joint; of a
  /// point of its own what would hold the part, as behind the face that the
  /// force presses on. A point ahead of the face is a fixture's, and pushes it
  /// over.
  static Vector3d idle_way(const ElementLine* line, bool turns,
                           const Mover& mover, const Vector3d& force,
                           const Vector3d& p) {
    const Vector3d way = way_along(force, mover, p);
    const bool is_joints =
        line != nullptr && line->kind == ElementLine::Kind::kJoint;
    const bool is_fixed_axis =
        line != nullptr ? line->kind == ElementLine::Kind::kSlide : !turns;
    const bool is_idle = is_joints || (is_fixed_axis && way.dot(force) > 0.0);
    return is_idle ? way : Vector3d::Zero();
  }

  PlacedJoint placed(std::size_t k) const {
    const JointModel& joint = frame_.joints[k];
    return {joint, rows_.x[index(joint.a)], rows_.x[index(joint.b)]};
  }

  bool concerns(const JointModel& joint) const {
    const auto moves = [&](int slot) {
      return slot == neighbours_.slot() ||
             std::ranges::find(neighbours_.slots(), slot) !=
                 neighbours_.slots().end();
    };
    return moves(joint.a) || moves(joint.b);
  }

  void add_joints() {
    for (std::size_t k = 0; k < frame_.joints.size(); ++k) {
      const JointModel& joint = frame_.joints[k];
      if (!concerns(joint)) continue;
      const PlacedJoint here = placed(k);
      const auto rows = constrained_rows(joint.type, Motions::kSpatial);
      MatrixXd actions(kMotionOfMover, std::ssize(rows));
      for (std::size_t r = 0; r < rows.size(); ++r) {
        const SpatialForce action = here.action(rows[r]);
        actions.col(static_cast<Index>(r)) << action.v,
            action.w / frame_.length;
      }
      const JointReaction& reaction = instant_.joints[k];
      Motion6 wrench;
      wrench << in_P(reaction.f_W), in_P(reaction.t_W) / frame_.length;
      const VectorXd multipliers = actions.colPivHouseholderQr().solve(wrench);
      for (std::size_t r = 0; r < rows.size(); ++r) {
        add_row(here, static_cast<int>(k), rows[r],
                multipliers[static_cast<Index>(r)], LoadPlace::Kind::kJoint,
                static_cast<int>(k));
      }
    }
  }

  void add_effort(int joint, const JointRow& row, double effort,
                  LoadPlace::Kind kind, int of) {
    if (!concerns(frame_.joints[index(joint)])) return;
    add_row(placed(index(joint)), joint, row, effort, kind, of);
  }

  void add_efforts() {
    const MechanismDefinition& definition = neighbours_.definition();
    for (std::size_t d = 0; d < instant_.drives.size(); ++d) {
      const DriveDefinition& drive = definition.drives[d];
      add_effort(drive.joint,
                 coordinate_row(frame_.joints[index(drive.joint)].type,
                                drive.coordinate),
                 instant_.drives[d].effort, LoadPlace::Kind::kDrive,
                 static_cast<int>(d));
    }
    for (std::size_t c = 0; c < instant_.couplings.size(); ++c) {
      const CouplingModel& coupling = frame_.couplings[c];
      if (const auto& force = instant_.couplings[c].teeth) {
        add_teeth(coupling, *force);
        continue;
      }
      const double effort = instant_.couplings[c].effort;
      add_effort(coupling.joint_1, coupling.row_1, effort,
                 LoadPlace::Kind::kJoint, coupling.joint_1);
      add_effort(coupling.joint_2, coupling.row_2, -coupling.ratio * effort,
                 LoadPlace::Kind::kJoint, coupling.joint_2);
    }
  }

  /// On both wheels, the first's tooth force and its opposite: both turn with
  /// what guides the first, as a rack's flanks do. The part towards the axis
  /// goes through this, the rest stays at the pitch point.
  void add_teeth(const CouplingModel& coupling, const ToothForce& teeth) {
    const Vector3d pitch = in_P(teeth.p_W), force = in_P(teeth.f_W);
    const auto guide = mover(coupling.teeth->carrier, LoadPlace::Kind::kJoint,
                             coupling.joint_1, coupling.joint_1);
    const auto add = [&](int wheel, int joint, const JointRow& row,
                         const Vector3d& on_wheel) {
      const auto moved = mover(wheel, LoadPlace::Kind::kJoint, joint, joint);
      const auto press = [&](const Vector3d& f, const Vector3d& at) {
        if (moved) form_.add_force(*moved, f, at - moved->p);
        if (guide) form_.add_turning(*guide, moved, at, f);
      };
      if (!row.is_angle()) return press(on_wheel, pitch);
      const PlacedJoint bearing = placed(index(joint));
      const Vector3d axis = bearing.action(row).w;
      const Vector3d middle =
          bearing.p_b + (pitch - bearing.p_b).dot(axis) * axis;
      const Vector3d out = (pitch - middle).normalized();
      const Vector3d radial = on_wheel.dot(out) * out;
      press(radial, middle);
      press(on_wheel - radial, pitch);
    };
    add(coupling.teeth->wheel_1, coupling.joint_1, coupling.row_1, force);
    add(coupling.teeth->wheel_2, coupling.joint_2, coupling.row_2, -force);
  }

  void add_elements() {
    const auto& elements = neighbours_.definition().elements;
    for (std::size_t e = 0; e < elements.size(); ++e) {
      const auto& actions = instant_.elements[e].actions;
      const ElementLine* line = line_of(elements[e]);
      std::array<std::optional<Mover>, 2> movers;
      std::array<Vector3d, 2> points, forces;
      for (std::size_t side = 0; side < 2; ++side) {
        const ElementAction& action = actions[side];
        movers[side] =
            mover(action.body + 1, LoadPlace::Kind::kElement,
                  static_cast<int>(e), line != nullptr ? line->joint : -1);
        points[side] = in_P(action.p_W);
        forces[side] = in_P(action.f_W);
      }
      if (!movers[0] && !movers[1]) continue;
      const bool turns = turns_with_first(elements[e]);
      if (!movers[0] && acts_on_own_seat(movers[1], LoadPlace::Kind::kElement,
                                         static_cast<int>(e))) {
        points[1] -= idle_way(line, turns, *movers[1], forces[1], points[1]);
      }
      if (turns) points[0] = points[1];
      if (const ElementPoint* centre = rolling_centre(elements[e])) {
        add_rolling(movers, forces[1], points[1], *centre);
        continue;
      }
      for (std::size_t side = 0; side < 2; ++side) {
        if (!movers[side]) continue;
        form_.add_force(*movers[side], forces[side],
                        points[side] - movers[side]->p);
      }
      if (movers[0] && movers[1]) {
        form_.add_moment(*movers[0], *movers[1], in_P(actions[1].t_W));
      }
      if (turns && movers[0]) {
        form_.add_turning(*movers[0], movers[1], points[1], forces[1]);
      }
      if (line != nullptr && line->kind == ElementLine::Kind::kDistance) {
        const Vector3d along = (points[1] - points[0]).normalized();
        form_.add_line(movers[0], movers[1], points[0], points[1],
                       -forces[1].dot(along));
      }
    }
  }

  /// A wheel on a plane, a to b: its normal force goes through its centre and
  /// turns with the plane; friction stays where it touches.
  void add_rolling(const std::array<std::optional<Mover>, 2>& movers,
                   const Vector3d& force, const Vector3d& touch,
                   const ElementPoint& centre) {
    Vector3d middle = in_P(centre.p_L);
    if (centre.body != kGround) {
      const std::size_t body = index(centre.body);
      const BodyPlacement& wheel = rows_.x[body + 1];
      middle = wheel.p + wheel.R * (centre.p_L - frame_.p_LM[body]);
    }
    const Vector3d up = (middle - touch).normalized();
    const Vector3d pressing = force.dot(up) * up;
    for (const std::size_t side : {0u, 1u}) {
      if (!movers[side]) continue;
      const double sign = side == 0 ? -1.0 : 1.0;
      form_.add_force(*movers[side], sign * pressing, middle - movers[side]->p);
      form_.add_force(*movers[side], sign * (force - pressing),
                      touch - movers[side]->p);
    }
    if (movers[0]) form_.add_turning(*movers[0], movers[1], middle, pressing);
  }

  const Neighbours& neighbours_;
  const SolvingFrame& frame_;
  const NeighbourRows& rows_;
  const Instant& instant_;
  const std::vector<LoadPlace>& places_;
  SecondOrderForm form_;
};

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
      all.conservativeResize(Eigen::NoChange, all.cols() + along.cols());
      all.rightCols(along.cols()) = along * root;
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
  MatrixXd form = LoadForm(neighbours, rows, instant, places).matrix();
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

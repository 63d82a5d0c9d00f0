#include "mechanism/neighbours/load_form.h"

#include <algorithm>
#include <array>
#include <utility>

#include <Eigen/Geometry>
#include <Eigen/QR>

#include "base/values/index.h"
#include "mechanism/neighbours/second_order_form.h"

namespace clevis::mechanism {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

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

namespace {

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
    for (std::size_t side = 0; side < 2; ++side) {
      if (!movers[side] || !movers[side]->is_place) continue;
      const Vector3d& force = side == 0 ? levers.a.v : levers.b.v;
      form_.add_force(*movers[side], lambda * force,
                      rows_.x[index(slots[side])].p - movers[side]->p);
    }
  }

  /// Whether both bodies of a joint have its line.
  bool shares_line(int joint) const {
    const auto rows =
        constrained_rows(frame_.joints[index(joint)].type, Motions::kSpatial);
    return std::ranges::count_if(rows, [](const JointRow& row) {
             return row.kind == JointRow::Kind::kRotation && row.axis < 2;
           }) == 2;
  }

  /// A force along the line of a joint, on b, if a body bears it on a seat of
  /// its own: where that stands, wherever the joint has its points. It turns
  /// with the other body, which has the line where they touch; the seat may
  /// lean otherwise.
  /// @param on_line  a point. @return whether a body does.
  bool add_push(const std::array<std::optional<Mover>, 2>& movers, int joint,
                const Vector3d& force, const Vector3d& on_line,
                LoadPlace::Kind kind, int of) {
    if (force.isZero(0.0)) return false;
    for (const std::size_t side : {0u, 1u}) {
      if (!acts_on_own_seat(movers[side], kind, of)) continue;
      if (side == 0 && !shares_line(joint)) continue;  // a alone has it
      const Mover& seat = *movers[side];
      const std::optional<Mover>& other = movers[1 - side];
      const Vector3d on_seat = side == 0 ? Vector3d(-force) : force;
      const Vector3d at = on_line - way_along(force, seat, on_line);
      form_.add_force(seat, on_seat, at - seat.p);
      if (!other) return true;
      form_.add_force(*other, -on_seat, at - other->p);
      form_.add_turning(*other, seat, at, on_seat);
      return true;
    }
    return false;
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

  /// What of that way does not count [m]: of a point of its own what would hold
  /// the part, as behind the face that the force presses on. A point ahead of
  /// the face is a fixture's, and pushes it over.
  static Vector3d idle_way(const ElementLine* line, bool turns,
                           const Mover& mover, const Vector3d& force,
                           const Vector3d& p) {
    const Vector3d way = way_along(force, mover, p);
    const bool is_fixed_axis =
        line != nullptr ? line->kind == ElementLine::Kind::kSlide : !turns;
    return is_fixed_axis && way.dot(force) > 0.0 ? way : Vector3d::Zero();
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
    const JointModel& model = frame_.joints[index(joint)];
    if (!concerns(model)) return;
    const PlacedJoint here = placed(index(joint));
    const std::array movers{mover(model.a, kind, of, joint),
                            mover(model.b, kind, of, joint)};
    const bool slides = row.kind == JointRow::Kind::kTranslation;
    const Vector3d force =
        slides ? Vector3d(effort * here.action(row).v) : Vector3d::Zero();
    if (add_push(movers, joint, force, here.p_b, kind, of)) return;
    add_row(here, joint, row, effort, kind, of);
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
      const bool is_joints =
          line != nullptr && line->kind == ElementLine::Kind::kJoint;
      if (is_joints &&
          add_push(movers, line->joint, forces[1], points[1],
                   LoadPlace::Kind::kElement, static_cast<int>(e))) {
        continue;
      }
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

}  // namespace

MatrixXd load_form(const Neighbours& neighbours, const NeighbourRows& rows,
                   const Instant& instant,
                   const std::vector<LoadPlace>& places) {
  return LoadForm(neighbours, rows, instant, places).matrix();
}

}  // namespace clevis::mechanism

#include "loads/parts/part_loads.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>
#include <optional>
#include <utility>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "base/messages/errors.h"
#include "loads/history/balance.h"
#include "loads/history/motion_instants.h"
#include "loads/holds/neighbours_over_motion.h"
#include "loads/holds/seat_hold.h"
#include "loads/parts/axis_loads.h"
#include "loads/seats/force_places.h"
#include "loads/seats/force_seats.h"
#include "loads/seats/part_seats.h"
#include "loads/seats/seat_fit.h"
#include "loads/seats/seat_spans.h"
#include "loads/seats/slide_zone.h"
#include "mechanism/reactions/largest_reaction.h"
#include "part/buckling_limit.h"

namespace clevis::loads {

using Eigen::Vector3d;

namespace {

Wrench reaction_on(const mechanism::Instant& instant, const JointSeat& seat,
                   const mechanism::Pose& pose) {
  const auto& reaction = instant.joints[seat.joint.index];
  const auto R_LW = pose.R_WL.transpose();
  const Vector3d p_LJ = R_LW * (reaction.p_WJ - pose.p_WL);
  return about(R_LW * (seat.joint.sign * reaction.f_W),
               R_LW * (seat.joint.sign * reaction.t_W), p_LJ, seat.seat.p_LS);
}

Wrench effort_on(const mechanism::Instant& instant, const DrivenSeat& driven,
                 const mechanism::Pose& pose) {
  const mechanism::DriveState& state = instant.drives[driven.drive];
  const Vector3d effort_L =
      pose.R_WL.transpose() * (driven.joint.sign * state.effort * state.axis_W);
  if (!driven.turns) {
    return about(effort_L, Vector3d::Zero(), driven.joint.frame->p_LJ,
                 driven.seat.p_LS);
  }
  return {.force = Vector3d::Zero(), .moment = effort_L};
}

/// Adds a pressure to those on the groups; one surface load per group.
void add_pressure(double pressure, const std::vector<GroupGeometry>& groups,
                  InstantLoad& load) {
  for (const GroupGeometry& group : groups) {
    auto on_group =
        std::ranges::find(load.surface_loads, group.name, &SurfaceLoad::group);
    if (on_group == load.surface_loads.end()) {
      load.surface_loads.push_back({.group = group.name, .resultant = {}});
      on_group = load.surface_loads.end() - 1;
    }
    on_group->pressure += pressure;
    on_group->resultant.force -= pressure * group.area_vector;
    on_group->resultant.moment -= pressure * group.area_moment;
    on_group->total = std::abs(on_group->pressure) * group.area;
  }
}

double drive_pressure(const mechanism::Instant& instant,
                      const DrivenSeat& driven) {
  const double push =
      driven.turns ? 0.0 : std::max(0.0, instant.drives[driven.drive].effort);
  return push / driven.area;
}

RigidAcceleration rigid_acceleration(const mechanism::BodyState& state,
                                     const Vector3d& gravity_W) {
  const auto R_LW = state.pose.R_WL.transpose();
  return {.acceleration = R_LW * (state.a_WLo - gravity_W),
          .alpha = R_LW * state.alpha_WL,
          .omega = R_LW * state.w_WL};
}

/// All instants in the order of time; nothing if none repeats another.
std::optional<mechanism::Motion> with_repeats(const mechanism::Motion& motion) {
  if (motion.repeats.empty()) return std::nullopt;
  mechanism::Motion whole = motion;
  whole.instants.clear();
  std::ranges::merge(motion.instants, motion.repeats,
                     std::back_inserter(whole.instants), {},
                     &mechanism::Instant::t, &mechanism::Instant::t);
  return whole;
}

/// Of a history of all instants of a motion.
void set_repeats_apart(const mechanism::Motion& motion, LoadHistory& history) {
  if (motion.repeats.empty()) return;
  const auto repeats = std::ranges::stable_partition(
      history.instants, [&](const InstantLoad& load) {
        return !std::ranges::binary_search(motion.repeats, load.time, {},
                                           &mechanism::Instant::t);
      });
  history.repeats.assign(std::make_move_iterator(repeats.begin()),
                         std::make_move_iterator(repeats.end()));
  history.instants.erase(repeats.begin(), repeats.end());
}

/// What joints that give way carry at a change point over the largest force, or
/// moment over the part's size, of the instants at any joint of the part, less
/// 1; 0: no more [1]. Where not even those hold the loads there is no bound.
double beyond_instants(const mechanism::Motion& motion,
                       const std::vector<JointSeat>& seats, double size) {
  constexpr double kNoBound = 1e3;
  const auto reaction = [&](const mechanism::Instant& instant) {
    double most = 0.0;
    for (const JointSeat& seat : seats) {
      const mechanism::JointReaction& joint = instant.joints[seat.joint.index];
      most = std::max({most, joint.f_W.norm(), joint.t_W.norm() / size});
    }
    return most;
  };
  double at_points = 0.0, at_instants = 0.0;
  for (const mechanism::ChangePoint& point : motion.change_points) {
    if (!point.at) return kNoBound;
    at_points = std::max(at_points, reaction(*point.at));
  }
  for (const auto& instant : motion.instants) {
    at_instants = std::max(at_instants, reaction(instant));
  }
  return at_instants > 0.0 ? std::max(0.0, at_points / at_instants - 1.0) : 0.0;
}

/// Refuses a force whose point travels over a face, as a wheel's on a rail:
/// spread over all of it it would bend the part too little. @throws Error L007.
void require_still_forces(const SeatContext& context,
                          const std::vector<ForceSeat>& forces,
                          const mechanism::Motion& motion) {
  constexpr double kCounts = 0.1;   // of the largest force
  constexpr double kTravels = 0.1;  // of the face's longest way
  for (const ForceSeat& seat : forces) {
    const auto visit = [&](const auto& take) {
      for (const mechanism::Instant& instant : motion.instants) {
        const auto& pose =
            instant.bodies[static_cast<std::size_t>(context.body)].pose;
        for (const auto& action : instant.elements[seat.index].actions) {
          if (action.body != context.body) continue;
          take(action.f_W.norm(),
               Vector3d(pose.R_WL.transpose() * (action.p_W - pose.p_WL)));
        }
      }
    };
    double largest = 0.0;
    visit([&](double force, const Vector3d&) {
      largest = std::max(largest, force);
    });
    Eigen::AlignedBox3d places;
    visit([&](double force, const Vector3d& at) {
      if (force > kCounts * largest) places.extend(at);
    });
    const std::string& name = seat.seat.group;
    const auto group =
        std::ranges::find(context.groups, name, &GroupGeometry::name);
    if (places.isEmpty() || group == context.groups.end() ||
        group->points.cols() == 0) {
      continue;
    }
    const double way = places.diagonal().norm();
    const double size = (group->points.rowwise().maxCoeff() -
                         group->points.rowwise().minCoeff())
                            .maxCoeff();
    if (way <= kTravels * size) continue;
    throw Error("L007", context.place(seat.seat.name),
                fmt::format("it travels {:.4g} mm over \"{}\", which is {:.4g} "
                            "mm long: spread over all of it the load would be "
                            "too kind",
                            way * 1e3, name, size * 1e3),
                "Let a body that slides on the part take it, whose seat has a "
                "length, or check the part by cases with the force where it is "
                "worst.");
  }
}

/// What acts on each seat, about its point.
std::vector<mechanism::LoadPlace> acting_on(
    const std::vector<JointSeat>& by_joint,
    const std::vector<DrivenSeat>& by_drive,
    const std::vector<ForceSeat>& by_force, const std::vector<Seat>& seats) {
  using Kind = mechanism::LoadPlace::Kind;
  std::vector<mechanism::LoadPlace> acting;
  const auto add = [&](Kind kind, std::size_t index) {
    acting.push_back(
        {kind, static_cast<int>(index), seats[acting.size()].p_LS});
  };
  for (const JointSeat& seat : by_joint) add(Kind::kJoint, seat.joint.index);
  for (const DrivenSeat& seat : by_drive) add(Kind::kDrive, seat.drive);
  for (const ForceSeat& seat : by_force) add(Kind::kElement, seat.index);
  return acting;
}

/// Sets what holds the part, and what its loads gain as it gives way.
void set_neighbours(const SeatContext& context, const mechanism::Motion& motion,
                    std::vector<mechanism::LoadPlace> acting,
                    LoadHistory& history) {
  const std::size_t hardest = hardest_instant(history.instants);
  history.hold_time = history.instants[hardest].time;
  std::vector<NeighboursOverMotion::Place> places;
  for (std::size_t i = 0; i < history.instants.size(); ++i) {
    places.push_back({motion.instants[i], history.instants[i].zones});
  }
  const auto neighbours = std::make_shared<NeighboursOverMotion>(
      context.definition, context.body, history.seats, std::move(acting),
      std::move(places), part::wanted_buckling_factor(context.part.limits));
  history.hold = [neighbours](double time) {
    return neighbours->hold(time);
  };
  history.lasting_hold = [neighbours](double time) {
    return neighbours->lasting_hold(time);
  };
  history.hold_at_rest = [neighbours](double time) {
    return neighbours->hold_at_rest(time);
  };
  for (std::size_t i = 0; i < history.instants.size(); ++i) {
    history.instants[i].gains = [neighbours, i] {
      return neighbours->gains(i);
    };
  }
}

}  // namespace

mechanism::Motion loading_motion(mechanism::Motion motion) {
  std::erase_if(motion.instants, [](const mechanism::Instant& instant) {
    return instant.is_change_point;
  });
  return motion;
}

LoadHistory part_loads(const mechanism::MechanismDefinition& definition,
                       const mechanism::Motion& given,
                       mechanism::BodyIndex body,
                       const part::PartDefinition& part,
                       const std::vector<GroupGeometry>& groups,
                       const part::MassProperties& mass,
                       const SeatSpans& spans) {
  const std::optional<mechanism::Motion> whole = with_repeats(given);
  const mechanism::Motion& motion = whole ? *whole : given;
  const SeatContext context{definition, body, part, groups,
                            part_size(groups, mass)};
  require_seats(context);
  require_force_seats(context);
  const std::vector<JointSeat> by_joint = joint_seats(context);
  const std::vector<DrivenSeat> by_drive = driven_seats(context);
  const std::vector<ForceSeat> by_force = force_seats(context);
  LoadHistory history;
  for (const JointSeat& seat : by_joint) history.seats.push_back(seat.seat);
  for (const DrivenSeat& seat : by_drive) history.seats.push_back(seat.seat);
  for (const ForceSeat& seat : by_force) history.seats.push_back(seat.seat);
  for (const mechanism::Instant& instant : motion.instants) {
    const auto& state = instant.bodies[static_cast<std::size_t>(body)];
    InstantLoad load;
    load.label = fmt::format("t = {:.6g} s", instant.t);
    load.time = instant.t;
    load.rigid = rigid_acceleration(state, definition.gravity_W);
    for (const JointSeat& seat : by_joint) {
      load.wrenches.push_back(reaction_on(instant, seat, state.pose));
    }
    for (const DrivenSeat& seat : by_drive) {
      load.wrenches.push_back(effort_on(instant, seat, state.pose));
      add_pressure(drive_pressure(instant, seat), seat.pressurized, load);
    }
    for (const ForceSeat& seat : by_force) {
      load.wrenches.push_back(force_on(context, instant, seat));
      if (seat.pressurized.empty()) continue;
      add_pressure(pressure_of(instant, seat), seat.pressurized, load);
    }
    history.instants.push_back(std::move(load));
  }
  history.followed_until = motion.followed_until;
  history.step_behind = motion.step_behind;
  history.bends = motion.bends;
  if (motion.search) {
    constexpr double kSeen = 1e-12;  // what was searched is no longer unknown
    history.unseen =
        std::max(motion.search->bodies[static_cast<std::size_t>(body)], kSeen);
  }
  if (const double beyond = beyond_instants(motion, by_joint, context.size);
      beyond > 0.0) {
    constexpr double kBetween = 0.05;  // where instants alone were looked at
    history.unseen =
        std::max(history.unseen, beyond + (motion.search ? 0.0 : kBetween));
    history.at_change_points = beyond / history.unseen;
  }
  require_still_forces(context, by_force, motion);
  require_balance(history, mass, context.size, context.place("loads"),
                  mechanism::largest_reaction(motion, context.size));
  history.notes = off_middle_notes(context, by_joint);
  const auto off_faces = off_face_notes(context, by_force, motion);
  history.notes.insert(history.notes.end(), off_faces.begin(), off_faces.end());
  act_on_axes(context, by_joint, mass, history);
  set_contact_zones(context, motion, spans, by_joint, history);
  set_repeats_apart(given, history);
  history.slide_excess = std::pow(longest_slide_step(history), 2);
  if (!history.instants.empty()) {
    set_neighbours(context, given,
                   acting_on(by_joint, by_drive, by_force, history.seats),
                   history);
  }
  return history;
}

LoadHistory part_loads(const mechanism::MechanismDefinition& definition,
                       const mechanism::Motion& motion,
                       mechanism::BodyIndex body,
                       const part::PartDefinition& part,
                       const std::vector<GroupGeometry>& groups,
                       const part::MassProperties& mass) {
  return part_loads(definition, motion, body, part, groups, mass, SeatSpans{});
}

}  // namespace clevis::loads

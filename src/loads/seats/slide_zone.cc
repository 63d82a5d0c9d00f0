#include "loads/seats/slide_zone.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <fmt/format.h>

#include "base/algebra/append_columns.h"
#include "base/messages/errors.h"
#include "loads/history/balance.h"
#include "mechanism/joints/joint_types.h"

namespace clevis::loads {

using Eigen::Matrix3d;
using Eigen::Matrix3Xd;
using Eigen::Vector3d;
using mechanism::JointType;

namespace {

// Normals of a wall across its slide, and of one flat face to another: meshes
// print coordinates to at least seven digits.
constexpr double kNormalTolerance = 1e-6;
constexpr double kRoundOff = 1e-9;  // of lengths

/// The faces of a seat: its group, and the one that faces it.
struct Walls {
  double area = 0.0;
  Matrix3d normal_square = Matrix3d::Zero();
  Matrix3Xd points;

  void add(const GroupGeometry& group) {
    area += group.area;
    normal_square += group.normal_square;
    append_columns(spanning_points(group), points);
  }
};

Walls walls_of(const SeatContext& context, const std::string& group,
               const std::string& opposite, const std::string& place) {
  Walls walls;
  walls.add(find_group(context.groups, group, place));
  if (!opposite.empty()) walls.add(find_group(context.groups, opposite, place));
  return walls;
}

/// Whether all its normals are along one line.
bool is_flat(const Walls& walls, const Vector3d& normal) {
  return normal.dot(walls.normal_square * normal) >=
         (1.0 - kNormalTolerance) * walls.area;
}

SlideWall cylinder_wall(const Vector3d& along) {
  SlideWall wall;
  wall.along_L = along;
  wall.across_L = along.unitOrthogonal();
  wall.normal_L = along.cross(wall.across_L);
  return wall;
}

void require_along(const Walls& walls, const Vector3d& along,
                   const std::string& group, const std::string& place) {
  const double slope =
      std::sqrt(along.dot(walls.normal_square * along) / walls.area);
  if (slope <= std::sqrt(kNormalTolerance)) return;
  throw Error(
      "L003", place,
      fmt::format("\"{}\" is no wall along the slide: its normals lean "
                  "{:.3g} deg towards the joint's axis on the average",
                  group,
                  std::asin(std::min(1.0, slope)) * 180.0 / std::numbers::pi),
      "Give faces parallel to the joint's axis, or correct that axis.");
}

[[noreturn]] void refuse_unknown(const std::string& group, double length,
                                 bool is_planar, const std::string& place) {
  throw Error(
      "L007", place,
      fmt::format("it is not known how much of \"{}\" ({:.4g} mm along the "
                  "slide) the counterpart touches: spread over all of it the "
                  "load would be too kind",
                  group, length * 1e3),
      fmt::format(
          "Say it: {{ group = \"{}\", length = \"20 mm\"{} }}; a length not "
          "below the group's own stands for all of it. A part on the other "
          "body whose own pin names this joint says it too.",
          group, is_planar ? ", width = \"20 mm\"" : ""));
}

/// One seat's zones over the motion.
class ZoneFinder {
 public:
  ZoneFinder(const SeatContext& context, const JointSeat& seat,
             const SeatSpans& spans)
      : context_(context),
        seat_(seat),
        place_(context.place("joint " + seat.seat.name)),
        wanted_(*std::ranges::find(context.part.seats, seat.seat.name,
                                   &part::Seat::joint)),
        is_b_(seat.joint.sign > 0.0),
        mine_(spans[seat.joint.index][is_b_ ? 1 : 0]),
        other_(spans[seat.joint.index][is_b_ ? 0 : 1]) {
    const SlideWall& wall = *seat.seat.slide;
    const Walls walls =
        walls_of(context, seat.seat.group, wall.opposite, place_);
    Matrix3Xd points = walls.points.colwise() - seat.seat.p_LS;
    along_ = extent(points, wall.along_L);
    is_flat_ =
        seat.seat.kind != SeatKind::kBearing && is_flat(walls, wall.normal_L);
    across_ = is_flat_ ? extent(points, wall.across_L)
                       : Interval{-ContactZone::kAll, ContactZone::kAll};
    if (wanted_.slide.width && !is_flat_) {
      throw Error("L002", place_,
                  fmt::format("`width` has no meaning on \"{}\", which is not "
                              "flat",
                              seat.seat.group),
                  "Leave it out.");
    }
  }

  /// @throws Error L007.
  void require_known(const mechanism::Motion& motion, LoadHistory& history) {
    const bool is_planar = type().slide_directions == 2;
    says_all_ =
        wanted_.slide.length &&
        *wanted_.slide.length >= (1.0 - kNormalTolerance) * along_.length() &&
        (!is_planar || wanted_.slide.width);
    if (says_all_) return;
    if (is_planar) {
      if (other_.stated && other_.stated_width) return;
      refuse_unknown(seat_.seat.group, along_.length(), true, place_);
    }
    if (other_.stated || mine_.stated || counterpart_fits()) return;
    if (!is_pin_that_stays(motion)) {
      refuse_unknown(seat_.seat.group, along_.length(), false, place_);
    }
    says_all_ = true;
    history.notes.push_back(fmt::format(
        "joint {} slides by less than 5 % of \"{}\": taken as a pin that fills "
        "it; if it is shorter give its length",
        seat_.seat.name, seat_.seat.group));
  }

  /// @throws Error L007.
  ContactZone zone(const mechanism::Instant& instant) {
    if (says_all_ && !wanted_.slide.width) return {};
    const Vector3d p_SJ = counterpart_point(instant) - seat_.seat.p_LS;
    const SlideWall& wall = *seat_.seat.slide;
    ContactZone zone;
    zone.low[0] = along_.low;
    zone.high[0] = along_.high;
    zone.low[1] = across_.low;
    zone.high[1] = across_.high;
    if (!says_all_) {
      const double touching = clip_along(wall.along_L.dot(p_SJ), zone);
      note_overhang(zone.high[0] - zone.low[0], touching, instant.t);
    }
    clip_across(wall.across_L.dot(p_SJ), zone);
    require_contact(zone, instant.t);
    open_at_edges(zone);
    return zone;
  }

  /// A line where the counterpart leaves part of the wall.
  std::vector<std::string> notes() const {
    if (!(overhang_ < 1.0 - 1e-3)) return {};
    return {fmt::format(
        "joint {}: its counterpart reaches beyond \"{}\": {:.3g} % of its "
        "length touch at t = {:.6g} s, which carry the whole load",
        seat_.seat.name, seat_.seat.group, 100.0 * overhang_, overhang_at_)};
  }

 private:
  const mechanism::JointTraits& type() const {
    return mechanism::traits(seat_.joint.definition->type);
  }

  /// Whether the counterpart's own seat tells where it touches.
  bool counterpart_fits() const {
    return other_.is_known() &&
           (!other_.is_cylinder || seat_.seat.kind == SeatKind::kBearing);
  }

  /// A bore of a joint that may slide, but does not, is one that its pin
  /// fills: no longer than pins are.
  bool is_pin_that_stays(const mechanism::Motion& motion) const {
    constexpr double kTravel = 0.05;  // of the bore's length
    constexpr double kLongest = 2.5;  // diameters
    if (!type().may_stand_for_hinge) return false;
    const part::Bore& bore =
        find_group(context_.groups, seat_.seat.group, place_).cylinder;
    Interval way{ContactZone::kAll, -ContactZone::kAll};
    for (const auto& instant : motion.instants) {
      const double at =
          seat_.seat.slide->along_L.dot(counterpart_point(instant));
      way = {std::min(way.low, at), std::max(way.high, at)};
    }
    return way.length() <= kTravel * bore.length &&
           bore.length <= kLongest * 2.0 * bore.radius;
  }

  /// The joint's point on the counterpart, in L.
  Vector3d counterpart_point(const mechanism::Instant& instant) const {
    const mechanism::JointDefinition& joint = *seat_.joint.definition;
    const auto body = is_b_ ? joint.body_a : joint.body_b;
    const Vector3d& p_BJ = is_b_ ? joint.frame_a.p_LJ : joint.frame_b.p_LJ;
    Vector3d p_WJ = p_BJ;
    if (body != mechanism::kGround) {
      const auto& pose = instant.bodies[static_cast<std::size_t>(body)].pose;
      p_WJ = pose.p_WL + pose.R_WL * p_BJ;
    }
    const auto& pose =
        instant.bodies[static_cast<std::size_t>(context_.body)].pose;
    return pose.R_WL.transpose() * (p_WJ - pose.p_WL);
  }

  static void clip(const Interval& by, int direction, ContactZone& zone) {
    zone.low[direction] = std::max(zone.low[direction], by.low);
    zone.high[direction] = std::min(zone.high[direction], by.high);
  }

  /// @param at  of the joint's point on the counterpart.
  /// @return the length that touches where nothing overhangs.
  double clip_along(double at, ContactZone& zone) const {
    double shortest = along_.length();
    const auto clip_by = [&](const Interval& by, double from) {
      shortest = std::min(shortest, by.length());
      clip({from + by.low, from + by.high}, 0, zone);
    };
    const Vector3d z = Vector3d::Unit(type().slide_axis());
    if (other_.stated) {
      clip_by(*other_.stated, at);
    } else if (counterpart_fits()) {
      clip_by(extent(other_.points_J, z), at);
    }
    if (mine_.stated) {
      const Vector3d p_SJ = seat_.joint.frame->p_LJ - seat_.seat.p_LS;
      clip_by(*mine_.stated, seat_.seat.slide->along_L.dot(p_SJ));
    }
    return shortest;
  }

  void clip_across(double at, ContactZone& zone) const {
    if (!is_flat_) return;
    const std::optional<double>& width =
        wanted_.slide.width ? wanted_.slide.width : other_.stated_width;
    if (width) {
      clip({at - 0.5 * *width, at + 0.5 * *width}, 1, zone);
    } else if (!says_all_ && !other_.stated && counterpart_fits() &&
               type().keeps_orientation) {
      const Vector3d across_J =
          seat_.joint.frame->R_LJ.transpose() * seat_.seat.slide->across_L;
      const Interval by = extent(other_.points_J, across_J);
      clip({at + by.low, at + by.high}, 1, zone);
    }
  }

  void note_overhang(double touching, double whole, double t) {
    if (touching / whole >= overhang_) return;
    overhang_ = touching / whole;
    overhang_at_ = t;
  }

  void require_contact(const ContactZone& zone, double t) const {
    constexpr double kLeast = 0.01;  // of the wall, or the counterpart
    const Eigen::Array2d size = zone.high - zone.low;
    const double wanted =
        says_all_ ? 0.0 : kLeast * std::min(along_.length(), shortest());
    if (size[0] > wanted && size[1] > 0.0) return;
    throw Error(
        "L007", place_,
        fmt::format("at t = {:.6g} s the counterpart has left \"{}\": it "
                    "touches {:.4g} mm of it along the slide",
                    t, seat_.seat.group, std::max(0.0, size[0]) * 1e3),
        "Correct the joint's points, the `offset` of the length or the motion; "
        "the zone lies about the joint's point on the other body.");
  }

  double shortest() const {
    double result = along_.length();
    if (other_.stated) result = std::min(result, other_.stated->length());
    return result;
  }

  /// A zone that ends with the wall has no edge there.
  void open_at_edges(ContactZone& zone) const {
    const std::array<Interval, 2> own = {along_, across_};
    for (int d = 0; d < 2; ++d) {
      const Interval& all = own[static_cast<std::size_t>(d)];
      const double gap = is_flat_ || d == 0 ? kRoundOff * all.length() : 0.0;
      if (zone.low[d] <= all.low + gap) zone.low[d] = -ContactZone::kAll;
      if (zone.high[d] >= all.high - gap) zone.high[d] = ContactZone::kAll;
    }
  }

  const SeatContext& context_;
  const JointSeat& seat_;
  std::string place_;
  const part::Seat& wanted_;
  bool is_b_;
  const SeatSpan &mine_, &other_;
  Interval along_, across_;
  bool is_flat_ = false;
  bool says_all_ = false;
  double overhang_ = 1.0, overhang_at_ = 0.0;
};

}  // namespace

SlideWall slide_wall(const SeatContext& context, const part::Seat& wanted,
                     const BodyJoint& joint) {
  const std::string place = context.place("joint " + wanted.joint);
  const JointType type = joint.definition->type;
  const Vector3d along = slide_axis(type, *joint.frame);
  if (find_group(context.groups, wanted.group, place).is_cylinder) {
    return cylinder_wall(along);
  }
  if (mechanism::traits(type).needs_cylinder) {
    throw Error("L002", place,
                fmt::format("\"{}\" is not a circular cylinder, but the joint "
                            "turns in it",
                            wanted.group),
                "Give a bore_* or round_* group.");
  }
  const Walls walls =
      walls_of(context, wanted.group, wanted.slide.opposite, place);
  SlideWall wall;
  wall.opposite = wanted.slide.opposite;
  wall.along_L = along;
  require_along(walls, along, wanted.group, place);
  const Eigen::SelfAdjointEigenSolver<Matrix3d> eigen(walls.normal_square);
  const bool is_planar = mechanism::traits(type).slide_directions == 2;
  wall.normal_L = is_planar ? Vector3d(joint.frame->R_LJ.col(2))
                            : Vector3d(eigen.eigenvectors().col(2));
  wall.normal_L -= along.dot(wall.normal_L) * along;
  wall.normal_L.normalize();
  wall.across_L = wall.normal_L.cross(along);
  if (is_planar && !is_flat(walls, wall.normal_L)) {
    throw Error(
        "L003", place,
        fmt::format("\"{}\" is not flat across the joint's axis", wanted.group),
        "Give a plane face normal to the joint's axis.");
  }
  return wall;
}

bool is_whole(const ContactZone& zone) {
  return (zone.low == -ContactZone::kAll).all() &&
         (zone.high == ContactZone::kAll).all();
}

void set_contact_zones(const SeatContext& context,
                       const mechanism::Motion& motion, const SeatSpans& spans,
                       const std::vector<JointSeat>& seats,
                       LoadHistory& history) {
  SeatSpans all = spans;
  add_seat_spans(context.definition, context.body, context.part, context.groups,
                 all);
  for (std::size_t s = 0; s < seats.size(); ++s) {
    if (!seats[s].seat.slide) continue;
    ZoneFinder finder(context, seats[s], all);
    finder.require_known(motion, history);
    bool always_whole = true;
    for (std::size_t i = 0; i < motion.instants.size(); ++i) {
      const ContactZone zone = finder.zone(motion.instants[i]);
      always_whole = always_whole && is_whole(zone);
      auto& zones = history.instants[i].zones;
      zones.resize(history.seats.size());
      zones[s] = zone;
    }
    if (always_whole && seats[s].seat.kind == SeatKind::kBearing) {
      history.seats[s].slide.reset();
    }
    for (const std::string& note : finder.notes()) {
      history.notes.push_back(note);
    }
  }
}

}  // namespace clevis::loads

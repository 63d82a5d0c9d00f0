#include "loads/seats/seat_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "base/messages/errors.h"
#include "loads/history/balance.h"
#include "mechanism/joints/joint_types.h"

namespace clevis::loads {

using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

// Gap between a joint and its cylinder, relative to the part's size, and
// angle between their axes [rad]. Scenes and meshes print coordinates to at
// least seven digits.
constexpr double kGapTolerance = 1e-6;
constexpr double kAngleTolerance = 1e-6;
// Largest gap across the axis over the diameter: drawings round lengths, and
// joints find bores in solids as well as that (cad/cylinders). Forces then act
// on the cylinder's axis (parts/axis_loads).
constexpr double kOffsetTolerance = 1e-3;
constexpr double kDegrees = 180.0 / std::numbers::pi;

/// A joint and the cylinder that it should lie in.
struct Pair {
  std::string name;  ///< of the joint
  std::string group;
  mechanism::JointFrame frame;
  part::Bore cylinder;
  bool has_axis;  ///< a weld and a ball have none of their own
  bool slides;
  bool goes_on = false;  ///< the joint's place along the axis says nothing

  const Vector3d& joint() const { return frame.p_LJ; }
  Vector3d axis() const { return frame.R_LJ.col(2); }
  /// From the cylinder's middle.
  double along() const {
    return (joint() - cylinder.p_LC).dot(cylinder.axis_L);
  }
  Vector3d across() const {
    return joint() - cylinder.p_LC - along() * cylinder.axis_L;
  }
  double angle() const {
    if (!has_axis) return 0.0;
    return std::asin(std::min(1.0, axis().cross(cylinder.axis_L).norm()));
  }
  bool is_beyond_the_end(double gap) const {
    return !slides && !goes_on &&
           std::abs(along()) > 0.5 * cylinder.length + gap;
  }
  /// @param gap  that the digits of scene and mesh explain [m].
  double allowed_across(double gap) const {
    return slides ? gap
                  : std::max(gap, 2.0 * kOffsetTolerance * cylinder.radius);
  }
  bool fits(double gap) const { return fits(gap, allowed_across(gap)); }
  bool fits_to_digits(double gap) const { return fits(gap, gap); }
  /// Place on the cylinder's axis at the joint's height.
  Vector3d foot() const { return joint() - across(); }

 private:
  bool fits(double gap, double gap_across) const {
    return across().norm() <= gap_across && angle() <= kAngleTolerance &&
           !is_beyond_the_end(gap);
  }
};

std::vector<Pair> pairs_of(const SeatContext& context,
                           const std::vector<JointSeat>& seats) {
  std::vector<Pair> pairs;
  for (const JointSeat& seat : seats) {
    if (seat.seat.kind != SeatKind::kBearing) continue;
    const auto group = std::ranges::find(context.groups, seat.seat.group,
                                         &GroupGeometry::name);
    const auto& type = mechanism::traits(seat.joint.definition->type);
    const bool has_axis = type.axis == mechanism::JointTraits::Axis::kNeeded;
    pairs.push_back({seat.seat.name, seat.seat.group, *seat.joint.frame,
                     group->cylinder, has_axis, type.slides()});
  }
  return pairs;
}

/// The pairs with the mesh turned or mirrored, scaled and shifted.
std::vector<Pair> moved(std::vector<Pair> pairs, const Matrix3d& turn,
                        double scale, const Vector3d& shift) {
  for (Pair& pair : pairs) {
    part::Bore& c = pair.cylinder;
    c.p_LC = scale * (turn * c.p_LC) + shift;
    c.axis_L = turn * c.axis_L;
    c.radius *= scale;
    c.length *= scale;
  }
  return pairs;
}

bool all_fit(const std::vector<Pair>& pairs, double gap) {
  return std::ranges::all_of(pairs, [gap](const Pair& pair) {
    return pair.fits_to_digits(gap);
  });
}

Vector3d mean_gap(const std::vector<Pair>& pairs) {
  Vector3d sum = Vector3d::Zero();
  for (const Pair& pair : pairs) sum += pair.joint() - pair.cylinder.p_LC;
  return sum / static_cast<double>(pairs.size());
}

/// Likewise across the axes alone: a joint need not stand in the middle.
Vector3d mean_gap_across(const std::vector<Pair>& pairs) {
  Vector3d sum = Vector3d::Zero();
  for (const Pair& pair : pairs) sum += pair.across();
  return sum / static_cast<double>(pairs.size());
}

/// Largest distance from their mean.
double spread(const std::vector<Vector3d>& points) {
  Vector3d mean = Vector3d::Zero();
  for (const Vector3d& p : points) mean += p;
  mean /= static_cast<double>(points.size());
  double largest = 0.0;
  for (const Vector3d& p : points) {
    largest = std::max(largest, (p - mean).norm());
  }
  return largest;
}

/// Joints' distances over the mesh's where that is a slip of the unit.
std::optional<double> unit_slip(const std::vector<Pair>& pairs) {
  constexpr double kAlike = 1e-3;
  std::vector<Vector3d> joints, cylinders;
  for (const Pair& pair : pairs) {
    if (pair.slides) continue;  // its place along the axis says nothing
    joints.push_back(pair.joint());
    cylinders.push_back(pair.cylinder.p_LC);
  }
  if (joints.empty()) return std::nullopt;
  if (joints.size() == 1) {  // from the origin
    joints.emplace_back(Vector3d::Zero());
    cylinders.emplace_back(Vector3d::Zero());
  }
  const double ratio = spread(joints) / spread(cylinders);
  for (const double unit : {10.0, 100.0, 1000.0, 2.54, 25.4, 12.0, 304.8}) {
    for (const double slip : {unit, 1.0 / unit}) {
      if (std::abs(ratio / slip - 1.0) < kAlike) return slip;
    }
  }
  return std::nullopt;
}

struct Turn {
  std::string name;
  Matrix3d matrix;
};

/// Mirrored in a plane, or turned by quarters about an axis.
std::vector<Turn> turns() {
  std::vector<Turn> result;
  constexpr std::array<char, 3> kNames = {'x', 'y', 'z'};
  for (int k = 0; k < 3; ++k) {
    Matrix3d mirror = Matrix3d::Identity();
    mirror(k, k) = -1.0;
    result.push_back(
        {fmt::format("Mirrored along {}", kNames[static_cast<std::size_t>(k)]),
         mirror});
  }
  for (int k = 0; k < 3; ++k) {
    for (const int degrees : {180, 90, 270}) {
      const double angle = degrees * std::numbers::pi / 180.0;
      Matrix3d matrix =
          Eigen::AngleAxisd(angle, Vector3d::Unit(k)).toRotationMatrix();
      matrix = matrix.array().round();
      result.push_back({fmt::format("Turned by {} deg about {}", degrees,
                                    kNames[static_cast<std::size_t>(k)]),
                        matrix});
    }
  }
  return result;
}

/// "["12.5 mm", "0 mm", "0 mm"]", as scenes have it; v [m].
std::string scene_text(const Vector3d& v, double size) {
  const auto number = [size](double x) {
    return std::abs(x) <= 1e-12 * size ? 0.0 : 1e3 * x;
  };
  return fmt::format("[\"{:.9g} mm\", \"{:.9g} mm\", \"{:.9g} mm\"]",
                     number(v.x()), number(v.y()), number(v.z()));
}

/// The number in the scene that would make one pair agree.
std::string remedy_for(const Pair& pair, const std::string& body, double size) {
  if (pair.across().norm() <= pair.allowed_across(kGapTolerance * size) &&
      pair.angle() > kAngleTolerance) {
    const Vector3d axis = pair.axis().dot(pair.cylinder.axis_L) < 0.0
                              ? Vector3d(-pair.cylinder.axis_L)
                              : pair.cylinder.axis_L;
    return fmt::format(
        "Give joint {} the cylinder's axis, in the body's frame ({:.9g}, "
        "{:.9g}, {:.9g}), or turn the mesh.",
        pair.name, axis.x() + 0.0, axis.y() + 0.0, axis.z() + 0.0);
  }
  const Vector3d place = pair.is_beyond_the_end(kGapTolerance * size)
                             ? Vector3d(pair.cylinder.p_LC)
                             : pair.foot();
  return fmt::format(
      "Place joint {} on the cylinder, at.{} = {} instead of {}; or correct "
      "the mesh: same lengths, in the body's frame, right length_unit.",
      pair.name, body, scene_text(place, size), scene_text(pair.joint(), size));
}

/// Likely remedy for the user.
/// @param bad  the pair that does not fit, of body `body`.
std::string remedy_for(const std::vector<Pair>& pairs, const Pair& bad,
                       const std::string& body, double size) {
  const double gap = kGapTolerance * size;
  const Matrix3d as_is = Matrix3d::Identity();
  if (const auto slip = unit_slip(pairs)) {
    return fmt::format(
        "The joints' distances are {:.4g} times the mesh's: correct the "
        "part's length_unit.",
        *slip);
  }
  if (pairs.size() > 1) {
    for (const Turn& turn : turns()) {
      if (!all_fit(moved(pairs, turn.matrix, 1.0, Vector3d::Zero()), gap)) {
        continue;
      }
      return fmt::format(
          "{}, all cylinders of the mesh would lie on their joints: give the "
          "mesh in the body's frame.",
          turn.name);
    }
  }
  for (const Vector3d& shift : {mean_gap_across(pairs), mean_gap(pairs)}) {
    if (pairs.size() < 2 || !all_fit(moved(pairs, as_is, 1.0, shift), gap))
      continue;
    return fmt::format(
        "Move the mesh by {} mm, or the part's joints by the opposite.",
        vector_text(shift * 1e3, size * 1e3));
  }
  return remedy_for(bad, body, size);
}

[[noreturn]] void refuse(const SeatContext& context, const Pair& pair,
                         const std::string& place, const std::string& remedy) {
  const std::string& group = pair.group;
  const double size_mm = context.size * 1e3;
  const double allowed = pair.allowed_across(kGapTolerance * context.size);
  if (!(pair.across().norm() <= allowed)) {
    throw Error("L003", place,
                fmt::format("the joint lies {:.6g} mm off the axis of "
                            "\"{}\", {:.3g} mm are allowed: joint at {} mm, "
                            "off by {} mm, cylinder at {} mm",
                            pair.across().norm() * 1e3, group, allowed * 1e3,
                            vector_text(pair.joint() * 1e3, size_mm),
                            vector_text(pair.across() * 1e3, size_mm),
                            vector_text(pair.cylinder.p_LC * 1e3, size_mm)),
                remedy);
  }
  if (!(pair.angle() <= kAngleTolerance)) {
    throw Error(
        "L003", place,
        fmt::format("the joint's axis and the cylinder \"{}\" make an "
                    "angle of {:.6g} deg, {:.2g} deg are allowed",
                    group, pair.angle() * kDegrees, kAngleTolerance * kDegrees),
        remedy);
  }
  throw Error("L003", place,
              fmt::format("the joint lies {:.6g} mm from the middle of \"{}\", "
                          "beyond its end: the cylinder is {:.6g} mm long",
                          std::abs(pair.along()) * 1e3, group,
                          pair.cylinder.length * 1e3),
              remedy);
}

const std::string& body_name(const SeatContext& context) {
  return context.definition.bodies[static_cast<std::size_t>(context.body)].name;
}

}  // namespace

void require_fit(const SeatContext& context,
                 const std::vector<JointSeat>& seats) {
  const std::vector<Pair> pairs = pairs_of(context, seats);
  for (const Pair& pair : pairs) {
    if (pair.fits(kGapTolerance * context.size)) continue;
    refuse(context, pair, context.place("joint " + pair.name),
           remedy_for(pairs, pair, body_name(context), context.size));
  }
}

void require_coaxial(const SeatContext& context, const part::Bore& cylinder,
                     int joint, const std::string& group,
                     const std::string& place) {
  const auto& definition =
      context.definition.joints[static_cast<std::size_t>(joint)];
  const Pair pair{.name = definition.name,
                  .group = group,
                  .frame = definition.body_b == context.body
                               ? definition.frame_b
                               : definition.frame_a,
                  .cylinder = cylinder,
                  .has_axis = true,
                  .slides = mechanism::traits(definition.type).slides(),
                  .goes_on = true};
  if (pair.fits(kGapTolerance * context.size)) return;
  refuse(context, pair, place,
         remedy_for({pair}, pair, body_name(context), context.size));
}

std::vector<Vector3d> axis_offsets(const SeatContext& context,
                                   const std::vector<JointSeat>& seats) {
  std::vector<Vector3d> offsets(seats.size(), Vector3d::Zero());
  for (const Pair& pair : pairs_of(context, seats)) {
    if (pair.across().norm() <= kGapTolerance * context.size) continue;
    const auto seat =
        std::ranges::find(seats, pair.name, [](const JointSeat& s) {
          return s.seat.name;
        });
    offsets[static_cast<std::size_t>(seat - seats.begin())] = pair.across();
  }
  return offsets;
}

std::vector<std::string> off_axis_notes(const SeatContext& context,
                                        const std::vector<JointSeat>& seats) {
  std::vector<std::string> notes;
  for (const Pair& pair : pairs_of(context, seats)) {
    const Vector3d across = pair.across();
    if (across.norm() <= kGapTolerance * context.size) continue;
    notes.push_back(fmt::format(
        "joint {} stands {:.3g} mm off the axis of \"{}\", by {} mm: its force "
        "acts on that axis; at.{} = {} would lie on it",
        pair.name, across.norm() * 1e3, pair.group,
        vector_text(across * 1e3, context.size * 1e3), body_name(context),
        scene_text(pair.foot(), context.size)));
  }
  return notes;
}

bool is_off_middle(double along, const part::Bore& bore) {
  constexpr double kSmall = 0.02;
  return std::abs(along) > kSmall * bore.length;
}

std::vector<std::string> off_middle_notes(const SeatContext& context,
                                          const std::vector<JointSeat>& seats) {
  std::vector<std::string> notes;
  for (const Pair& pair : pairs_of(context, seats)) {
    const double along = std::abs(pair.along());
    if (pair.slides || !is_off_middle(along, pair.cylinder)) continue;
    notes.push_back(fmt::format(
        "joint {} stands {:.4g} mm from the middle of \"{}\" along its axis "
        "({:.3g} % of its length): its force may bend the part across; if "
        "that is not meant, move the mesh or the joint",
        pair.name, along * 1e3, pair.group,
        100.0 * along / pair.cylinder.length));
  }
  return notes;
}

}  // namespace clevis::loads

#include "cad/first_case.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "base/messages/errors.h"

namespace clevis::cad {
namespace {

using Eigen::Vector3d;

Vector3d across(const Vector3d& v, const Vector3d& axis) {
  return v - v.dot(axis) * axis;
}

/// At right angles to an axis, along a coordinate axis where that can be.
Vector3d normal_to(const Vector3d& axis) {
  Eigen::Index smallest = 0;
  axis.cwiseAbs().minCoeff(&smallest);
  return across(Vector3d::Unit(smallest), axis).normalized();
}

/// Rather along `wanted`, and where that says nothing along the axes.
Vector3d with_sense(const Vector3d& direction, const Vector3d& wanted) {
  constexpr double kNothing = 1e-6;
  double sense = direction.dot(wanted);
  if (std::abs(sense) <= kNothing * wanted.norm()) {
    Eigen::Index largest = 0;
    direction.cwiseAbs().maxCoeff(&largest);
    sense = direction[largest];
  }
  return sense < 0.0 ? Vector3d(-direction) : direction;
}

/// Of a force on `pulled`: away from `held`, without a moment about the axis of
/// that.
Vector3d direction_between(const PinBore& held, const PinBore& pulled) {
  constexpr double kNearly = 0.02;  // of the force, along the pulled bore
  constexpr double kHardly = 1e-4;
  const Vector3d way = pulled.middle - held.middle;
  const double distance = way.norm();
  if (distance <= kHardly * held.diameter) return normal_to(pulled.axis);
  Vector3d ahead = way / distance;
  // Whatever points to the middle of the held bore has no moment there; what
  // is normal to `arm` has none about its axis.
  const Vector3d arm = held.axis.cross(ahead);
  const Vector3d exact = pulled.axis.cross(arm);
  if (!are_parallel(held.axis, pulled.axis) &&
      std::abs(ahead.dot(pulled.axis)) <= kNearly) {
    return ahead;
  }
  if (exact.norm() > kHardly) return with_sense(exact.normalized(), way);
  const Vector3d line = across(ahead, pulled.axis);
  if (line.norm() > kHardly) return line.normalized();
  return normal_to(pulled.axis);
}

/// How many bores beside the widest are as wide as the widest of them and
/// parallel to it.
std::ptrdiff_t pattern_size(const std::vector<PinBore>& bores) {
  return std::ranges::count_if(
      bores.begin() + 1, bores.end(), [&](const PinBore& bore) {
        constexpr double kSame = 1e-3;
        return bores[1].diameter - bore.diameter <= kSame * bores[1].diameter &&
               are_parallel(bore.axis, bores[1].axis);
      });
}

/// Whether bolts hold the part rather than a pin: three or more equal holes
/// beside a wider bore, of two that lie across it.
bool has_bolts(const std::vector<PinBore>& bores) {
  constexpr double kWider = 1.001, kAcross = 0.5;
  constexpr std::ptrdiff_t kPattern = 3, kPair = 2;
  if (bores.size() <= kPair ||
      bores[0].diameter <= kWider * bores[1].diameter) {
    return false;
  }
  const bool is_across = bores[0].axis.cross(bores[1].axis).norm() > kAcross;
  return pattern_size(bores) >= (is_across ? kPair : kPattern);
}

/// The plane face that is largest and farthest behind a point.
const Face* base_behind(const Solid& solid, const Vector3d& point,
                        const std::function<bool(const Face&)>& is_wanted) {
  const Face* best = nullptr;
  double highest = 0.0;
  for (const Face& face : solid.faces) {
    if (face.kind != SurfaceKind::kPlane || !is_wanted(face)) continue;
    const double score =
        face.normal.dot(face.centre - point) * std::sqrt(face.area);
    if (score <= highest) continue;
    highest = score;
    best = &face;
  }
  return best;
}

/// The widest bore pulled off a base; absent without a plane face behind it.
bool pull_off_base(const Solid& solid, FirstCase& made) {
  constexpr double kAcross = 0.5;
  const PinBore& bore = made.bores.front();
  const bool bolts = has_bolts(made.bores);
  const Face* base = base_behind(solid, bore.middle, [&](const Face& face) {
    return bolts ? are_parallel(face.normal, made.bores[1].axis)
                 : face.normal.cross(bore.axis).norm() > kAcross;
  });
  if (base == nullptr && !bolts) {
    base = base_behind(solid, bore.middle, [](const Face&) {
      return true;
    });
  }
  if (base == nullptr) return false;
  made.base = base->number;
  made.pulled = 0;
  const Vector3d off = across(-base->normal, bore.axis);
  made.direction =
      off.norm() > kAcross ? Vector3d(off.normalized()) : normal_to(bore.axis);
  return true;
}

/// Two plane faces that look away from each other, large and far apart.
bool pull_ends(const Solid& solid, FirstCase& made) {
  double highest = 0.0;
  for (const Face& base : solid.faces) {
    if (base.kind != SurfaceKind::kPlane) continue;
    for (const Face& end : solid.faces) {
      if (end.kind != SurfaceKind::kPlane ||
          !are_parallel(base.normal, end.normal) ||
          end.normal.dot(base.normal) > 0.0) {
        continue;
      }
      const double score = end.normal.dot(end.centre - base.centre) *
                           std::sqrt(std::min(base.area, end.area));
      if (score <= highest) continue;
      highest = score;
      made.base = base.number;
      made.end = end.number;
      made.direction = end.normal;
    }
  }
  return highest > 0.0;
}

}  // namespace

FirstCase first_case(const Solid& solid, const std::string& place) {
  FirstCase made;
  made.bores = pin_bores(solid);
  const auto& bores = made.bores;
  if ((bores.size() == 1 || has_bolts(bores)) && pull_off_base(solid, made)) {
    return made;
  }
  if (bores.size() > 1) {
    made.held = 0;
    made.pulled = 1;
    made.direction = direction_between(bores[0], bores[1]);
    return made;
  }
  if (pull_ends(solid, made)) return made;
  throw Error("M017", place,
              fmt::format("the solid has {} that goes all round, and no plane "
                          "face to hold it by; its cylinders: {}",
                          bores.empty() ? "no bore" : "one bore",
                          list_of(cylinders_of(solid))),
              "`clevis faces FILE` lists all faces: name two of them in "
              "[part.faces] of a scene; `clevis init NAME` writes one to start "
              "from.");
}

}  // namespace clevis::cad

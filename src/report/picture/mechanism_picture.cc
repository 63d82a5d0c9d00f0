#include "report/picture/mechanism_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include <Eigen/Geometry>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "base/messages/errors.h"
#include "report/picture/picture.h"
#include "report/picture/stored_surface.h"
#include "report/stored/stored_numbers.h"
#include "report/text/json_node.h"

namespace clevis::report {
namespace {

using Eigen::Vector3d;
using nlohmann::ordered_json;

Vector3d vector_of(const JsonNode& node) {
  const auto numbers = node.numbers<3>();
  return {numbers[0], numbers[1], numbers[2]};
}

/// Poses of bodies over the motion.
class Poses {
 public:
  explicit Poses(const JsonNode& motion)
      : times_(stored_numbers(motion.at("t_s"))),
        poses_(stored_numbers(motion.at("poses"))) {
    for (const JsonNode& body : motion.at("bodies").elements()) {
      bodies_.push_back(body.at("name").text());
    }
    if (poses_.size() != 7 * times_.size() * bodies_.size()) {
      throw Error("I003", "view of the mechanism",
                  "its poses do not fit its instants",
                  "Run `clevis check` again.");
    }
  }

  bool empty() const { return times_.empty() || bodies_.empty(); }
  std::size_t count() const { return times_.size(); }
  double time(std::size_t instant) const { return times_[instant]; }

  std::optional<std::size_t> find(const std::string& body) const {
    const auto found = std::ranges::find(bodies_, body);
    if (found == bodies_.end()) return std::nullopt;
    return found - bodies_.begin();
  }

  /// Points of a body in the world [mm].
  Eigen::MatrixX3d placed(const Eigen::MatrixX3d& points, std::size_t body,
                          std::size_t instant) const {
    const double* p = &poses_[7 * (instant * bodies_.size() + body)];
    const Eigen::Matrix3d turn =
        Eigen::Quaterniond(p[3], p[4], p[5], p[6]).normalized().matrix();
    return (points * turn.transpose()).rowwise() +
           Eigen::RowVector3d(p[0], p[1], p[2]);
  }

 private:
  std::vector<double> times_, poses_;
  std::vector<std::string> bodies_;
};

/// Axes of the joints as they stand on the first body.
struct JointAxes {
  std::vector<Vector3d> turning, sliding;
};
JointAxes joint_axes(const JsonNode& motion) {
  JointAxes axes;
  for (const JsonNode& joint : motion.at("joints").elements()) {
    const Vector3d axis = vector_of(joint.at("axes_on_a").element(2, 3));
    (joint.at("type").text() == "prismatic" ? axes.sliding : axes.turning)
        .push_back(axis.normalized());
  }
  return axes;
}

Sight sight_of(const JsonNode& motion) {
  constexpr double kParallel = 1e-6, kAlong = 0.9;
  Vector3d normal = Vector3d::Zero();
  const auto axes = joint_axes(motion);
  for (const Vector3d& axis : axes.turning) {
    normal += axis.dot(normal) < 0.0 ? Vector3d(-axis) : axis;
  }
  normal = normal.norm() > 0.0 ? normal.normalized() : Vector3d::UnitZ();
  const bool is_plane =
      std::ranges::all_of(axes.turning,
                          [&normal](const Vector3d& axis) {
                            return axis.cross(normal).norm() < kParallel;
                          }) &&
      std::ranges::all_of(axes.sliding, [&normal](const Vector3d& axis) {
        return std::abs(axis.dot(normal)) < kParallel;
      });
  Vector3d up = -vector_of(motion.at("gravity_m_per_s2"));
  up = up.norm() > 0.0 ? up.normalized() : Vector3d::UnitY();
  for (const Vector3d& other :
       std::array<Vector3d, 2>{Vector3d::UnitY(), Vector3d::UnitX()}) {
    if (std::abs(up.dot(normal)) > kAlong) up = other;
  }
  const Vector3d side = up.cross(normal);
  const Vector3d towards =
      is_plane ? normal : Vector3d(normal + 0.28 * up + 0.32 * side);
  return sight(towards, up.cross(towards));
}

/// The frame of a part next to a time; of cases, that of the largest stress.
std::size_t frame_at(const JsonNode& part, double time) {
  if (!part.at("is_motion").flag()) {
    return static_cast<std::size_t>(part.at("peak_frame").number());
  }
  std::size_t nearest = 0;
  double least = INFINITY;
  const auto times = part.at("frames").at("t_s").elements();
  for (std::size_t k = 0; k < times.size(); ++k) {
    const double away = std::abs(times[k].number() - time);
    if (away < least) {
      least = away;
      nearest = k;
    }
  }
  return nearest;
}

}  // namespace

std::optional<std::string> mechanism_picture(const StoredPage& page) {
  const auto motion_json = ordered_json::parse(page.motion);
  const JsonNode motion(motion_json, "view of the mechanism:");
  const Poses poses(motion);
  if (poses.empty()) return std::nullopt;
  std::vector<ordered_json> parts;
  for (const std::string& text : page.parts) {
    parts.push_back(ordered_json::parse(text));
  }
  Picture picture;
  std::vector<std::string> times;
  std::vector<std::size_t> shown{0, poses.count() / 2, poses.count() - 1};
  shown.erase(std::unique(shown.begin(), shown.end()), shown.end());
  for (const std::size_t instant : shown) {
    times.push_back(fmt::format("{:.4g} s", poses.time(instant)));
    std::vector<Surface>& layer = picture.layers.emplace_back();
    for (const auto& json : parts) {
      const JsonNode part(json, "view of a part:");
      const auto body = poses.find(part.at("body").text());
      if (!body) continue;
      Surface surface =
          stored_surface(part, frame_at(part, poses.time(instant)));
      surface.points = poses.placed(surface.points, *body, instant);
      layer.push_back(std::move(surface));
    }
  }
  if (picture.layers.front().empty()) return std::nullopt;
  picture.title = motion.at("scene").text();
  picture.detail =
      fmt::format("at t = {}, the last in front", fmt::join(times, ", "));
  picture.sight = sight_of(motion);
  return svg_of(picture);
}

}  // namespace clevis::report

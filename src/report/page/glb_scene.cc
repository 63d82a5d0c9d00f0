#include "report/page/glb_scene.h"

#include <algorithm>

#include <Eigen/Geometry>
#include <nlohmann/json.hpp>

#include "base/messages/errors.h"
#include "report/page/glb_mesh.h"
#include "report/stored/stored_numbers.h"

namespace clevis::report {
namespace {

using nlohmann::ordered_json;
using Use = GlbBuffer::Use;

constexpr std::size_t kPose = 7;  // numbers of a pose: x y z, w x y z

/// Positions [m] and turns of a body over the instants; turns never flip sign,
/// between which viewers would go the long way round.
struct Course {
  std::vector<float> positions, turns;  ///< turns: x y z w
};

Course course_of(const std::vector<double>& poses, std::size_t bodies,
                 std::size_t body) {
  constexpr double kMilli = 1e-3;
  Course course;
  Eigen::Vector4d before = Eigen::Vector4d::Zero();
  for (std::size_t at = kPose * body; at + kPose <= poses.size();
       at += kPose * bodies) {
    for (std::size_t d = 0; d < 3; ++d) {
      course.positions.push_back(static_cast<float>(kMilli * poses[at + d]));
    }
    Eigen::Vector4d turn(poses[at + 4], poses[at + 5], poses[at + 6],
                         poses[at + 3]);
    turn.normalize();
    if (turn.dot(before) < 0.0) turn = -turn;
    before = turn;
    for (const double q : turn) course.turns.push_back(static_cast<float>(q));
  }
  return course;
}

template <class Numbers>
ordered_json first(const Numbers& numbers, std::ptrdiff_t count) {
  return std::vector<float>(numbers.begin(), numbers.begin() + count);
}

/// Bodies of the mechanism as nodes of a glTF, moving.
class Bodies {
 public:
  Bodies(const JsonNode& motion, GlbBuffer& buffer)
      : poses_(stored_numbers(motion.at("poses"))),
        bodies_(motion.at("bodies").elements()),
        buffer_(buffer) {
    for (const double t : stored_numbers(motion.at("t_s"))) {
      times_.push_back(static_cast<float>(t));
    }
    if (times_.size() < 2 || bodies_.empty()) return;
    times_accessor_ = buffer.add(times_, "SCALAR", Use::kAnimation);
    buffer.add_bounds(times_accessor_, times_, 1);
  }

  ordered_json node(std::size_t body, int index) {
    const Course course = course_of(poses_, bodies_.size(), body);
    ordered_json node = {{"name", bodies_[body].at("name").text()},
                         {"translation", first(course.positions, 3)},
                         {"rotation", first(course.turns, 4)}};
    if (times_.size() > 1) {
      add_channel(course.positions, "VEC3", "translation", index);
      add_channel(course.turns, "VEC4", "rotation", index);
    }
    return node;
  }

  std::size_t count() const { return bodies_.size(); }
  std::string part_of(std::size_t body) const {
    return bodies_[body].at("part").text();
  }
  const ordered_json& samplers() const { return samplers_; }
  const ordered_json& channels() const { return channels_; }

 private:
  void add_channel(const std::vector<float>& numbers, const char* type,
                   const char* path, int node) {
    samplers_.push_back(
        {{"input", times_accessor_},
         {"output", buffer_.add(numbers, type, Use::kAnimation)},
         {"interpolation", "LINEAR"}});
    channels_.push_back({{"sampler", samplers_.size() - 1},
                         {"target", {{"node", node}, {"path", path}}}});
  }

  std::vector<double> poses_;
  std::vector<JsonNode> bodies_;
  GlbBuffer& buffer_;
  std::vector<float> times_;
  int times_accessor_ = -1;
  ordered_json samplers_ = ordered_json::array();
  ordered_json channels_ = ordered_json::array();
};

/// Turns the scene so that up is +y.
ordered_json upright(const JsonNode& motion) {
  const auto g = motion.at("gravity_m_per_s2").numbers<3>();
  const Eigen::Vector3d up = -Eigen::Vector3d(g[0], g[1], g[2]);
  const Eigen::Quaterniond turn =
      up.norm() > 0.0
          ? Eigen::Quaterniond::FromTwoVectors(up, Eigen::Vector3d::UnitY())
          : Eigen::Quaterniond::Identity();
  return {turn.x(), turn.y(), turn.z(), turn.w()};
}

/// Views of the parts, parsed.
struct Parts {
  std::vector<ordered_json> texts;
  std::vector<JsonNode> nodes;
  double largest = 0.0;  ///< stress [MPa]
};

Parts parts_of(const StoredPage& page) {
  Parts parts;
  for (const std::string& part : page.parts) {
    parts.texts.push_back(ordered_json::parse(part));
  }
  for (const auto& text : parts.texts) {
    parts.nodes.emplace_back(text, "view of a part:");
    parts.largest = std::max(parts.largest, largest_stress(parts.nodes.back()));
  }
  return parts;
}

/// The root, the bodies with their parts' meshes, the parts without a body.
ordered_json nodes_of(const JsonNode& motion, const Parts& parts,
                      Bodies& bodies) {
  ordered_json nodes = ordered_json::array();
  nodes.push_back({{"name", motion.at("scene").text()},
                   {"rotation", upright(motion)},
                   {"children", ordered_json::array()}});
  std::vector<bool> is_carried(parts.nodes.size());
  for (std::size_t body = 0; body < bodies.count(); ++body) {
    ordered_json node = bodies.node(body, static_cast<int>(nodes.size()));
    for (std::size_t p = 0; p < parts.nodes.size(); ++p) {
      if (parts.nodes[p].at("part").text() != bodies.part_of(body)) continue;
      node["mesh"] = p;
      is_carried[p] = true;
    }
    nodes.push_back(node);
  }
  for (std::size_t p = 0; p < parts.nodes.size(); ++p) {
    if (is_carried[p]) continue;
    nodes.push_back({{"name", parts.nodes[p].at("part").text()}, {"mesh", p}});
  }
  for (std::size_t n = 1; n < nodes.size(); ++n) {
    nodes[0]["children"].push_back(n);
  }
  return nodes;
}

ordered_json material(double largest) {
  return {{"name", "von Mises"},
          {"doubleSided", true},
          {"pbrMetallicRoughness",
           {{"metallicFactor", 0.0}, {"roughnessFactor", 0.9}}},
          {"extras", {{"von_mises_MPa_of_the_last_colour", largest}}}};
}

}  // namespace

std::string glb_scene(const StoredPage& page) {
  if (page.parts.empty()) {
    throw Error("I008", "--glb", "the result has no part",
                "Run `clevis check` on a scene with parts.");
  }
  const ordered_json motion_json = ordered_json::parse(page.motion);
  const JsonNode motion(motion_json, "view of the mechanism:");
  const Parts parts = parts_of(page);
  GlbBuffer buffer;
  Bodies bodies(motion, buffer);
  ordered_json meshes = ordered_json::array();
  for (const JsonNode& part : parts.nodes) {
    meshes.push_back(glb_mesh(part, parts.largest, buffer));
  }
  const std::string scene = motion.at("scene").text();
  ordered_json json = {
      {"asset",
       {{"version", "2.0"},
        {"generator", "clevis " + motion.at("version").text()}}},
      {"scene", 0},
      {"scenes", ordered_json::array(
                     {{{"name", scene}, {"nodes", ordered_json::array({0})}}})},
      {"nodes", nodes_of(motion, parts, bodies)},
      {"meshes", meshes},
      {"materials", ordered_json::array({material(parts.largest)})}};
  if (!bodies.channels().empty()) {
    json["animations"] =
        ordered_json::array({{{"name", "motion"},
                              {"channels", bodies.channels()},
                              {"samplers", bodies.samplers()}}});
  }
  return buffer.file(json);
}

}  // namespace clevis::report

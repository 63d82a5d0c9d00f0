#include "multibody/body_hosts.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "base/messages/errors.h"

namespace clevis::multibody {
namespace {

constexpr int kOpen = -3;

/// The body on a joint's side; links are resolved as far as `hosts` is.
int host(const std::vector<int>& hosts, int link) {
  return link == kGround ? kGround : hosts[std::size_t(link)];
}

/// Links without mass take the body that they are fixed to, in turn.
/// @param fixed  the links on both sides of the fixed joints.
void follow_fixed_joints(const std::vector<std::array<int, 2>>& fixed,
                         std::vector<int>& hosts) {
  for (bool is_new = true; is_new;) {
    is_new = false;
    for (const auto& [a, b] : fixed) {
      for (const auto& [open, other] : {std::array{a, b}, std::array{b, a}}) {
        if (host(hosts, open) != kOpen || host(hosts, other) == kOpen) continue;
        hosts[std::size_t(open)] = host(hosts, other);
        is_new = true;
      }
    }
  }
}

/// Which links the fixed joints hold together.
std::vector<std::array<int, 2>> fixed_pairs(const Model& model,
                                            const std::string& file) {
  std::vector<std::array<int, 2>> pairs;
  for (const Joint& joint : model.joints) {
    if (joint.type != "fixed") continue;
    pairs.push_back({link_index(model, joint.parent, file),
                     link_index(model, joint.child, file)});
  }
  return pairs;
}

}  // namespace

int link_index(const Model& model, const std::string& name,
               const std::string& file) {
  if (name.empty()) return kGround;
  const auto found = std::ranges::find(model.links, name, &Link::name);
  if (found != model.links.end()) return int(found - model.links.begin());
  throw Error("S014", file, fmt::format("a joint names no link: \"{}\"", name),
              "Repair the model, or export it again.");
}

std::vector<int> body_hosts(const Model& model, const std::string& file,
                            std::vector<std::string>& told) {
  std::vector<int> hosts;
  for (const Link& link : model.links) {
    const int own = int(hosts.size());
    hosts.push_back(link.is_fixed ? kGround : link.mass == 0.0 ? kOpen : own);
  }
  const std::vector<int> before = hosts;
  follow_fixed_joints(fixed_pairs(model, file), hosts);
  for (std::size_t i = 0; i < hosts.size(); ++i) {
    const std::string& name = model.links[i].name;
    if (before[i] == kOpen && hosts[i] != kOpen) {
      told.push_back(fmt::format(
          "link {}: no mass; it is a place on {}", name,
          hosts[i] == kGround ? "the ground"
                              : model.links[std::size_t(hosts[i])].name));
    }
    if (hosts[i] != kOpen) continue;
    const auto joints =
        std::ranges::count_if(model.joints, [&](const Joint& joint) {
          return joint.parent == name || joint.child == name;
        });
    if (joints > 1) {
      throw Error("S015", fmt::format("{}, link {}", file, name),
                  "it has no mass and moves between others",
                  "Give it a mass and an inertia, or fix it to a neighbour.");
    }
    hosts[i] = kNoBody;
    told.push_back(fmt::format("link {}: no mass; left out", name));
  }
  return hosts;
}

}  // namespace clevis::multibody

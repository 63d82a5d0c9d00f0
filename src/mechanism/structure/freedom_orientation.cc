#include "mechanism/structure/freedom_orientation.h"

#include <algorithm>

namespace clevis::mechanism {
namespace {

constexpr int kFreedoms = 3;  // of a link in the plane

/// Lets `link` take one more share, by passing shares on where it has three
/// (augmenting paths).
bool make_room(std::vector<OrientedFreedom>& shares, int link,
               std::vector<int>& asked) {
  if (std::ranges::find(asked, link) != asked.end()) return false;
  asked.push_back(link);
  if (std::ranges::count(shares, link, &OrientedFreedom::link) < kFreedoms) {
    return true;
  }
  for (std::size_t i = 0; i < shares.size(); ++i) {
    const OrientedFreedom share = shares[i];
    if (share.link != link || share.other == kGround || share.other == link) {
      continue;
    }
    if (!make_room(shares, share.other, asked)) continue;
    shares[i] = {.link = share.other, .other = link};
    return true;
  }
  return false;
}

bool add_share(std::vector<OrientedFreedom>& shares,
               const LinkGraph::Pair& pair) {
  for (const auto& [link, other] :
       {OrientedFreedom{pair.a, pair.b}, OrientedFreedom{pair.b, pair.a}}) {
    std::vector<int> asked;
    if (link == kGround || !make_room(shares, link, asked)) continue;
    shares.push_back({link, other});
    return true;
  }
  return false;
}

}  // namespace

std::optional<std::vector<OrientedFreedom>> freedom_orientation(
    const LinkGraph& graph) {
  std::vector<OrientedFreedom> shares;
  for (const LinkGraph::Pair& pair : graph.pairs) {
    for (int constraint = 0; constraint < 2; ++constraint) {
      if (!add_share(shares, pair)) return std::nullopt;
    }
  }
  return shares;
}

std::vector<int> dependency_closure(const std::vector<OrientedFreedom>& shares,
                                    int link) {
  std::vector<int> links{link};
  for (std::size_t i = 0; i < links.size(); ++i) {  // grows
    for (const OrientedFreedom& share : shares) {
      if (share.link != links[i] || share.other == kGround) continue;
      if (std::ranges::find(links, share.other) == links.end()) {
        links.push_back(share.other);
      }
    }
  }
  std::ranges::sort(links);
  return links;
}

}  // namespace clevis::mechanism

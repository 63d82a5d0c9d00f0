#include "mechanism/reactions/largest_reaction.h"

#include <algorithm>

namespace clevis::mechanism {

double largest_reaction(const Motion& motion, double length) {
  double largest = 0.0;
  for (const Instant& instant : motion.instants) {
    for (const JointReaction& joint : instant.joints) {
      largest =
          std::max({largest, joint.f_W.norm(), joint.t_W.norm() / length});
    }
  }
  return largest;
}

}  // namespace clevis::mechanism

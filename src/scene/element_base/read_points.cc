#include "scene/element_base/read_points.h"

#include "scene/motion/read_bodies.h"

namespace clevis::scene {

std::array<mechanism::ElementPoint, 2> read_points(StrictTable& table,
                                                   const Names& names) {
  const Value between = table["between"];
  const auto bodies = between.elements(2);
  const auto a = find_body_or_ground(bodies[0], names);
  const auto b = find_body_or_ground(bodies[1], names);
  if (a == b) {
    throw between.refusal("S010", "names one body twice",
                          "Name two different bodies, one may be \"ground\".");
  }
  return {{{a, table["from"].vector(Dimension::kLength)},
           {b, table["to"].vector(Dimension::kLength)}}};
}

}  // namespace clevis::scene

#include "mechanism/forces/given_efforts.h"

namespace clevis::mechanism {

void give_row_effort(const ActingElement& e, double effort,
                     ElementResponse& now) {
  if (e.inertia() > 0.0) {
    now.give_effort(now.effort + effort);
  } else {
    now.act_along(effort);
  }
}

void give_load(const ActingElement& e, double load, ElementResponse& now) {
  now.load = load;
  if (!e.sticks()) now.give_effort(load * now.per_load + now.own_effort);
}

}  // namespace clevis::mechanism

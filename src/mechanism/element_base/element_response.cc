#include "mechanism/element_base/element_response.h"

namespace clevis::mechanism {
namespace {

const JointModel kNothing{.frame_a = {}, .frame_b = {}};
const BodyPlacement kNowhere;

}  // namespace

ElementResponse::ElementResponse() : placed(kNothing, kNowhere, kNowhere) {}

void ElementResponse::act_along(double new_effort) {
  effort = new_effort;
  on_a = {effort * levers.a.v, effort * levers.a.w};
  on_b = {effort * levers.b.v, effort * levers.b.w};
}

void ElementResponse::give_effort(double new_effort) {
  act_along(new_effort);
  power = effort * rate;
}

}  // namespace clevis::mechanism

#include "mechanism/element_base/pressing_end.h"

#include <algorithm>

namespace clevis::mechanism {

double press(const ModeSwitch& e, std::size_t end, const ContactLaw& law,
             double depth, double rate, ElementResponse& now) {
  now.depth[end] = depth;
  now.depth_rate[end] = rate;
  now.unbounded[end] = contact_effort(law, depth, rate);
  return e.modes[end] == 1 ? now.unbounded[end] : 0.0;
}

LineTangent contact_tangent(const ContactLaw& law, double depth, double rate) {
  constexpr double kStep = 1e-6;  // of the depth
  const double effort = contact_effort(law, depth, rate);
  if (!(depth > 0.0) || !(effort > 0.0 || may_pull(law))) return {};
  const double less = (1.0 - kStep) * depth;
  return {(effort - contact_effort(law, less, rate)) / (depth - less),
          contact_effort(law, depth, rate + 1.0) - effort};
}

int pressing_mode(const ElementResponse& now, std::size_t end,
                  const ContactLaw& law) {
  if (!(now.depth[end] > 0.0)) return 0;
  return now.unbounded[end] >= 0.0 || may_pull(law) ? 1 : 2;
}

double pressing_value(const ModeSwitch& e, std::size_t end,
                      const ContactLaw& law, const ElementResponse& now) {
  const double depth = now.depth[end], rate = now.depth_rate[end];
  if (e.modes[end] == 0) return -depth;
  // without force: until it is out, or pressed again
  if (e.modes[end] == 2) return std::min(depth, -now.unbounded[end]);
  if (may_pull(law)) return depth;
  const double sign = contact_sign(law, depth, rate);
  return law.model == ContactModel::kHuntCrossley ? std::min(depth, sign)
                                                  : sign;
}

void pass_pressing(ModeSwitch& e, std::size_t end, const ContactLaw& law,
                   const ElementResponse& now) {
  int& mode = e.modes[end];
  if (mode == 0) {
    mode = 1;
  } else if (mode == 1) {
    mode = !may_pull(law) && now.depth[end] > 0.0 ? 2 : 0;
  } else {
    const bool leaves = now.depth_rate[end] < 0.0 && now.unbounded[end] <= 0.0;
    mode = leaves ? 0 : 1;
  }
}

const char* name_of_pressing(int mode, int mode_before) {
  if (mode == 1) return "press";
  return mode_before == 1 ? "release" : nullptr;  // else force was 0 before
}

void add_pressing_guards(int end, const ContactLaw& law,
                         std::vector<ElementGuard>& guards) {
  using enum ElementGuard::Kind;
  guards.push_back({kDepth, end, 0.0});
  if (law.transition > 0.0) guards.push_back({kDepth, end, law.transition});
  if (law.damping > 0.0 && !may_pull(law)) guards.push_back({kOwn, end, 0.0});
}

}  // namespace clevis::mechanism

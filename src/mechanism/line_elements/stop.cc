#include "mechanism/line_elements/stop.h"

#include "base/values/index.h"
#include "mechanism/element_base/line_force.h"
#include "mechanism/element_base/pressing_end.h"

namespace clevis::mechanism {
namespace {

/// End 0 is the lower, end 1 the upper.
class Stop final : public LineForce {
 public:
  Stop(const LineDefinition& definition, const StopLaw& law,
       const ReferenceFrame& frame)
      : LineForce(definition, frame), law_(law) {}

  bool has_smooth_effort() const override { return true; }
  bool presses(int end) const override { return has_end(index(end)); }
  bool may_switch() const override { return true; }

  void choose_modes(const ElementResponse& now) override {
    for (const std::size_t end : {0, 1}) {
      modes[end] = has_end(end) ? pressing_mode(now, end, law_.contact) : 0;
    }
  }
  double event_value(int end, const ElementResponse& now) const override {
    return has_end(index(end))
               ? pressing_value(*this, index(end), law_.contact, now)
               : 1.0;
  }
  void pass_event(int end, const ElementResponse& now) override {
    pass_pressing(*this, index(end), law_.contact, now);
  }
  const char* name_of_change(int end, int mode_before) const override {
    return name_of_pressing(modes[index(end)], mode_before);
  }

  std::vector<ElementGuard> guards() const override {
    std::vector<ElementGuard> all;
    for (const int end : {0, 1}) {
      if (has_end(index(end))) add_pressing_guards(end, law_.contact, all);
    }
    return all;
  }
  double guard_value(const ElementGuard& guard, double t,
                     const ElementResponse& now) const override {
    if (guard.kind != ElementGuard::Kind::kOwn) {
      return ActingElement::guard_value(guard, t, now);
    }
    const std::size_t end = index(guard.end);
    return contact_sign(law_.contact, now.depth[end], now.depth_rate[end]);
  }
  bool guard_matters(const ElementGuard& guard,
                     const ElementResponse& now) const override {
    return guard.kind != ElementGuard::Kind::kOwn ||
           now.depth[index(guard.end)] > 0.0;
  }

 protected:
  LineTangent tangent(const ElementState& state) const override {
    LineTangent sum;
    const auto add = [&](double depth, double rate) {
      const LineTangent end = contact_tangent(law_.contact, depth, rate);
      sum.stiffness += end.stiffness;
      sum.damping += end.damping;
    };
    if (law_.lower) add(*law_.lower - state.position, -state.rate);
    if (law_.upper) add(state.position - *law_.upper, state.rate);
    return sum;
  }
  double law_effort(const ActingState& /*state*/,
                    ElementResponse& now) const override {
    double sum = 0.0;
    if (law_.lower) {
      sum += press(*this, 0, law_.contact, *law_.lower - now.q, -now.rate, now);
    }
    if (law_.upper) {
      sum -= press(*this, 1, law_.contact, now.q - *law_.upper, now.rate, now);
    }
    return sum;
  }

 private:
  bool has_end(std::size_t end) const {
    return (end == 0 ? law_.lower : law_.upper).has_value();
  }

  const StopLaw& law_;
};

}  // namespace

ElementProperties properties(const StopLaw& law) {
  return {.type = "stop",
          .presses = true,
          .lower = law.lower,
          .upper = law.upper,
          .size = law.lower && law.upper ? *law.upper - *law.lower : 0.0};
}

std::unique_ptr<ActingElement> place(const LineDefinition& definition,
                                     const StopLaw& law,
                                     const ReferenceFrame& frame) {
  return std::make_unique<Stop>(definition, law, frame);
}

}  // namespace clevis::mechanism

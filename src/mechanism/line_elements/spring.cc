#include "mechanism/line_elements/spring.h"

#include "mechanism/element_base/line_force.h"

namespace clevis::mechanism {
namespace {

class Spring final : public OneSenseForce {
 public:
  Spring(const LineDefinition& definition, const SpringLaw& law,
         const ReferenceFrame& frame)
      : OneSenseForce(definition, frame), law_(law) {}

  bool has_smooth_effort() const override { return acts_in_both(); }

 protected:
  LineTangent tangent(const ElementState& state) const override {
    if (!acts_in_both() && state.effort == 0.0) return {};
    return {law_.stiffness, law_.damping};
  }
  double full_effort(const ActingState& /*state*/,
                     const ElementResponse& now) const override {
    return -law_.stiffness * (now.q - law_.free) - law_.damping * now.rate -
           law_.preload;
  }

 private:
  const SpringLaw& law_;
};

}  // namespace

ElementProperties properties(const SpringLaw& law) {
  ElementProperties result{.type = "spring"};
  if (law.stiffness != 0.0) result.free = law.free;  // else a damper
  return result;
}

std::unique_ptr<ActingElement> place(const LineDefinition& definition,
                                     const SpringLaw& law,
                                     const ReferenceFrame& frame) {
  return std::make_unique<Spring>(definition, law, frame);
}

}  // namespace clevis::mechanism

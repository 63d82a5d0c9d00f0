#include "mechanism/line_elements/line_element.h"

#include "base/values/index.h"
#include "mechanism/element_base/acting_element.h"

namespace clevis::mechanism {

std::array<int, 2> LineElement::bodies(
    const std::vector<JointDefinition>& joints) const {
  if (line.kind != ElementLine::Kind::kJoint) return {line.a.body, line.b.body};
  const JointDefinition& joint = joints[index(line.joint)];
  return {joint.body_a, joint.body_b};
}

ElementProperties properties(const LineElement& element) {
  return std::visit(
      [](const auto& law) {
        return properties(law);
      },
      element.law);
}

std::unique_ptr<ActingElement> place(const LineElement& element,
                                     const ReferenceFrame& frame) {
  return std::visit(
      [&](const auto& law) {
        return place(element, law, frame);
      },
      element.law);
}

}  // namespace clevis::mechanism

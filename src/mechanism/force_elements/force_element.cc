#include "mechanism/force_elements/force_element.h"

#include "mechanism/element_base/acting_element.h"

namespace clevis::mechanism {

const std::string& name_of(const ForceElement& element) {
  return std::visit(
      [](const auto& e) -> const std::string& {
        return e.name;
      },
      element);
}

const std::string& place_of(const ForceElement& element) {
  return std::visit(
      [](const auto& e) -> const std::string& {
        return e.place;
      },
      element);
}

std::array<int, 2> bodies_of(const ForceElement& element,
                             const std::vector<JointDefinition>& joints) {
  return std::visit(
      [&](const auto& e) {
        return e.bodies(joints);
      },
      element);
}

bool acts_on(const ForceElement& element,
             const std::vector<JointDefinition>& joints, int body) {
  const auto [a, b] = bodies_of(element, joints);
  return a == body || b == body;
}

const ElementLine* line_of(const ForceElement& element) {
  const auto* line = std::get_if<LineElement>(&element);
  return line == nullptr ? nullptr : &line->line;
}

const ElementPoint* rolling_centre(const ForceElement& element) {
  const auto* contact = std::get_if<ContactElement>(&element);
  return contact == nullptr ? nullptr : &contact->center;
}

bool turns_with_first(const ForceElement& element) {
  const ElementLine* line = line_of(element);
  return line != nullptr ? line->kind != ElementLine::Kind::kDistance
                         : std::holds_alternative<BushingElement>(element);
}

bool is_angle(const ForceElement& element,
              const std::vector<JointDefinition>& joints) {
  const ElementLine* line = line_of(element);
  return line != nullptr && is_angle(*line, joints);
}

ElementProperties properties(const ForceElement& element) {
  return std::visit(
      [](const auto& e) {
        return properties(e);
      },
      element);
}

std::unique_ptr<ActingElement> place(const ForceElement& element,
                                     const ReferenceFrame& frame) {
  return std::visit(
      [&](const auto& e) {
        return place(e, frame);
      },
      element);
}

}  // namespace clevis::mechanism

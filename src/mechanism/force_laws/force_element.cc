#include "mechanism/force_laws/force_element.h"

#include "mechanism/joints/joint_types.h"

namespace clevis::mechanism {

const FrictionLaw* switched_friction(const ForceElement& element) {
  const auto* line = std::get_if<LineElement>(&element);
  const auto* law = line ? std::get_if<FrictionLaw>(&line->law) : nullptr;
  return law && law->model != FrictionModel::kRegularized ? law : nullptr;
}

const TableLaw* position_table(const ForceElement& element) {
  const auto* line = std::get_if<LineElement>(&element);
  const auto* law = line ? std::get_if<TableLaw>(&line->law) : nullptr;
  return law && !law->positions.empty() ? law : nullptr;
}

const ContactLaw* contact_law(const ForceElement& element) {
  if (const auto* contact = std::get_if<ContactElement>(&element)) {
    return &contact->law;
  }
  const auto* line = std::get_if<LineElement>(&element);
  const auto* stop = line ? std::get_if<StopLaw>(&line->law) : nullptr;
  return stop ? &stop->contact : nullptr;
}

const GasCylinderLaw* gas_law(const ForceElement& element) {
  const auto* line = std::get_if<LineElement>(&element);
  return line ? std::get_if<GasCylinderLaw>(&line->law) : nullptr;
}

const MotorLaw* motor_law(const ForceElement& element) {
  const auto* line = std::get_if<LineElement>(&element);
  return line ? std::get_if<MotorLaw>(&line->law) : nullptr;
}

const ServoLaw* servo_law(const ForceElement& element) {
  const auto* line = std::get_if<LineElement>(&element);
  return line ? std::get_if<ServoLaw>(&line->law) : nullptr;
}

const std::string& name_of(const ForceElement& element) {
  return std::visit(
      [](const auto& e) -> const std::string& {
        return e.name;
      },
      element);
}

bool is_angle(const ElementLine& line,
              const std::vector<JointDefinition>& joints) {
  if (line.kind != ElementLine::Kind::kJoint) return false;
  const auto& joint = joints[static_cast<std::size_t>(line.joint)];
  return coordinate_row(joint.type, line.coordinate).is_angle();
}

bool acts_on(const ForceElement& element,
             const std::vector<JointDefinition>& joints, int body) {
  if (const auto* line = std::get_if<LineElement>(&element)) {
    if (line->line.kind == ElementLine::Kind::kJoint) {
      const auto& joint = joints[static_cast<std::size_t>(line->line.joint)];
      return joint.body_a == body || joint.body_b == body;
    }
    return line->line.a.body == body || line->line.b.body == body;
  }
  if (const auto* contact = std::get_if<ContactElement>(&element)) {
    return contact->center.body == body || contact->plane.body == body;
  }
  return std::get<ImpedanceElement>(element).point.body == body;
}

}  // namespace clevis::mechanism

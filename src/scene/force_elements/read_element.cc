#include "scene/force_elements/read_element.h"

#include <fmt/format.h>

#include "mechanism/joints/joint_types.h"
#include "scene/element_base/read_points.h"
#include "scene/force_elements/read_bushing.h"
#include "scene/force_elements/read_constant.h"
#include "scene/force_elements/read_contact.h"
#include "scene/force_elements/read_impedance.h"
#include "scene/line_elements/read_friction.h"
#include "scene/line_elements/read_gas_cylinder.h"
#include "scene/line_elements/read_motor.h"
#include "scene/line_elements/read_servo.h"
#include "scene/line_elements/read_spring.h"
#include "scene/line_elements/read_stop.h"
#include "scene/line_elements/read_table.h"
#include "scene/motion/read_joint_properties.h"

namespace clevis::scene {
namespace {

using namespace mechanism;

/// Lines of an element between points.
enum class Needs { kAnyLine, kFixedAxis };

/// `joint` and perhaps `coordinate`, or `between` with `from`, `to` and perhaps
/// `axis`.
ElementLine read_line(StrictTable& table,
                      const std::vector<JointDefinition>& joints,
                      const Names& names, Needs needs) {
  ElementLine line;
  if (const auto joint = table.find("joint")) {
    line.kind = ElementLine::Kind::kJoint;
    line.joint = names.joints.find(joint->name(), *joint);
    const auto& definition = joints[static_cast<std::size_t>(line.joint)];
    if (coordinates(definition.type).empty()) {
      throw joint->refusal("S010", "has no coordinate",
                           "Name a joint that moves.");
    }
    if (const auto coordinate = table.find("coordinate")) {
      line.coordinate = find_coordinate(*coordinate, definition);
    }
    return line;
  }
  const auto points = read_points(table, names);
  line.a = points[0];
  line.b = points[1];
  line.kind = ElementLine::Kind::kDistance;
  const auto axis = needs == Needs::kFixedAxis ? std::optional(table["axis"])
                                               : table.find("axis");
  if (axis) {
    line.kind = ElementLine::Kind::kSlide;
    line.axis_L = axis->direction();
  }
  return line;
}

/// On which sense of motion an element acts.
void read_sense(StrictTable& table, const LineUnits& units,
                LineElement& element) {
  const auto acts_on = table.find("acts_on");
  if (!acts_on) return;
  element.acts_on =
      acts_on->choice<ActsOn>({{"both", ActsOn::kBoth},
                               {"increasing", ActsOn::kIncreasing},
                               {"decreasing", ActsOn::kDecreasing}});
  if (element.acts_on == ActsOn::kBoth) return;
  if (const auto speed = table.find("full_speed")) {
    element.full_speed = speed->positive(units.rate);
  }
}

/// A type of force and its reader: along a line, or else.
struct ElementReader {
  std::string_view type;
  LineLaw (*line_law)(const LineSource&) = nullptr;
  Needs needs = Needs::kFixedAxis;
  bool may_act_in_one_sense = false;
  ForceElement (*element)(StrictTable&, const Names&) = nullptr;
};

constexpr ElementReader kReaders[] = {
    {.type = "constant", .element = read_constant},
    {"spring", read_spring, Needs::kAnyLine, true},
    {"friction", read_friction},
    {"stop", read_stop},
    {"table", read_table, Needs::kAnyLine, true},
    {.type = "contact", .element = read_contact},
    {.type = "impedance", .element = read_impedance},
    {.type = "bushing", .element = read_bushing},
    {"gas_cylinder", read_gas_cylinder, Needs::kAnyLine},
    {"motor", read_motor},
    {"servo", read_servo}};

const ElementReader& reader_of(StrictTable& table) {
  std::vector<std::pair<std::string_view, const ElementReader*>> choices;
  for (const ElementReader& reader : kReaders) {
    choices.emplace_back(reader.type, &reader);
  }
  return *table["type"].choice(choices);
}

LineElement read_line_element(const ElementReader& reader, StrictTable& table,
                              const std::vector<JointDefinition>& joints,
                              const Names& names) {
  LineElement element;
  element.line = read_line(table, joints, names, reader.needs);
  const LineSource source{table, element.line, joints, names};
  element.law = reader.line_law(source);
  if (reader.may_act_in_one_sense) read_sense(table, source.units(), element);
  return element;
}

}  // namespace

ForceElement read_element(const std::string& name, StrictTable& table,
                          const std::vector<JointDefinition>& joints,
                          const Names& names) {
  const ElementReader& reader = reader_of(table);
  ForceElement result =
      reader.element != nullptr
          ? reader.element(table, names)
          : ForceElement(read_line_element(reader, table, joints, names));
  std::visit(
      [&](auto& element) {
        element.name = name;
        element.place = table.place();
      },
      result);
  table.finish("with this type of force");
  return result;
}

}  // namespace clevis::scene

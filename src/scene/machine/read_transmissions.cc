#include "scene/machine/read_transmissions.h"

#include <numbers>

#include <fmt/format.h>

#include "scene/element_base/line_source.h"
#include "scene/machine/read_compliances.h"
#include "scene/text/names.h"

namespace clevis::scene {
namespace {

using machine::BallScrewUnit;
using machine::ErrorShares;
using machine::TransmissionDefinition;
using machine::TransmissionStage;

/// u of a stage to the next one; a lead or a pinion make that one slide.
void read_ratio(StrictTable& table, bool last, TransmissionStage& stage,
                bool& next_turns) {
  constexpr double kLeast = 1e-3, kMost = 1e4;
  next_turns = stage.angular;
  for (const char* key : {"ratio", "lead", "pinion_radius"}) {
    if (last && table.has(key)) {
      throw table[key].refusal("S010", "stands on the last stage",
                               "It says how far a stage moves per motion of "
                               "the next one: the last has none.");
    }
  }
  if (last) return;
  if (!table.has("lead") && !table.has("pinion_radius")) {
    stage.ratio = table["ratio"].number(kLeast, kMost);
    return;
  }
  const char* key = table.has("lead") ? "lead" : "pinion_radius";
  const Value value = table[key];
  if (!stage.angular) {
    throw value.refusal("S010", "stands on a stage that does not turn",
                        "A screw or pinion turns; what follows slides.");
  }
  const double length = value.positive(Dimension::kLength);
  stage.ratio =
      table.has("lead") ? 2.0 * std::numbers::pi / length : 1.0 / length;
  next_turns = false;
}

std::vector<TransmissionStage> read_stages(StrictTable& table) {
  std::vector<StrictTable> tables = table.tables("stage");
  if (tables.empty()) {
    throw table.refusal("S003", "lacks [[transmission.stage]]",
                        "Add the stages from the motor to the output.");
  }
  std::vector<TransmissionStage> stages;
  bool turns = true;
  for (StrictTable& each : tables) {
    TransmissionStage stage;
    const auto name = each.find("name");
    stage.name =
        name ? name->title() : fmt::format("stage_{}", stages.size() + 1);
    stage.angular = turns;
    read_ratio(each, stages.size() + 1 == tables.size(), stage, turns);
    const Dimension inertia =
        stage.angular ? Dimension::kMassMoment : Dimension::kMass;
    stage.wheel_inertia = not_negative_or(each, "wheel_inertia", inertia, 0.0);
    stage.pinion_inertia =
        not_negative_or(each, "pinion_inertia", inertia, 0.0);
    for (StrictTable& element : each.tables("element")) {
      stage.elements.push_back(read_compliance(element, stage.angular));
    }
    each.finish("beside lead or pinion_radius");
    stages.push_back(std::move(stage));
  }
  return stages;
}

ErrorShares read_errors(StrictTable table, bool angular) {
  const Dimension motion = angular ? Dimension::kAngle : Dimension::kLength;
  const Dimension load = angular ? Dimension::kTorque : Dimension::kForce;
  ErrorShares errors;
  errors.control = not_negative(table["control"], motion);
  errors.kinematic = not_negative(table["kinematic"], motion);
  errors.backlash = not_negative(table["backlash"], motion);
  errors.friction = not_negative(table["friction"], load);
  return errors;
}

TransmissionDefinition read_transmission(StrictTable& table, Names& names) {
  TransmissionDefinition transmission;
  const Value name = table["name"];
  transmission.name = name.title();
  names.transmissions.add(transmission.name, name);
  transmission.stages = read_stages(table);
  bool empty = true;
  for (const auto& stage : transmission.stages) {
    empty = empty && stage.elements.empty();
  }
  if (empty) {
    throw table.refusal("S003", "lacks [[transmission.stage.element]]",
                        "Give at least one element that yields.");
  }
  const bool angular = transmission.stages.back().angular;
  if (const auto unit = table.find("ball_screw_unit")) {
    transmission.ball_screw_unit =
        unit->choice<BallScrewUnit>({{"corrected", BallScrewUnit::kCorrected},
                                     {"published", BallScrewUnit::kPublished}});
  }
  if (const auto inertia = table.find("motor_inertia")) {
    transmission.motor_inertia = inertia->positive(Dimension::kMassMoment);
  }
  if (const auto inertia = table.find("load_inertia")) {
    transmission.load_inertia =
        inertia->positive(angular ? Dimension::kMassMoment : Dimension::kMass);
  }
  const Dimension load = angular ? Dimension::kTorque : Dimension::kForce;
  if (table.has("errors")) {
    transmission.load = table["load"].quantity(load);
    transmission.errors = read_errors(table.table("errors"), angular);
  } else if (const auto given = table.find("load")) {
    transmission.load = given->quantity(load);
  }
  return transmission;
}

}  // namespace

std::vector<TransmissionDefinition> read_transmissions(StrictTable& root,
                                                       Names& names) {
  std::vector<TransmissionDefinition> transmissions;
  for (StrictTable& table : root.tables("transmission")) {
    transmissions.push_back(read_transmission(table, names));
  }
  return transmissions;
}

}  // namespace clevis::scene

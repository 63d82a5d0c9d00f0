#include <fmt/format.h>

#include "scene/readers.h"

namespace clevis::scene {
namespace {

using mechanism::ForceDefinition;
using mechanism::MarkerDefinition;

/// A name for messages and files of entities that need none.
std::string name_or_number(StrictTable& table, std::string_view kind,
                           std::size_t count, NameIndex& index) {
  const auto name = table.find("name");
  const std::string text =
      name ? name->title() : fmt::format("{}_{}", kind, count + 1);
  index.add(text, name ? *name : table["type"]);
  return text;
}

ForceDefinition read_constant_force(const std::string& name, StrictTable& table,
                                    const Names& names) {
  ForceDefinition force;
  force.place = table.place();
  force.name = name;
  const Value body = table["body"];
  force.body = names.bodies.find(body.name(), body);
  force.p_LP = table["point"].vector(Dimension::kLength);
  force.f_W = table["force"].vector(Dimension::kForce);
  if (const auto moment = table.find("moment")) {
    force.t_W = moment->vector(Dimension::kTorque);
  }
  table.finish("with type = \"constant\"");
  return force;
}

MarkerDefinition read_marker(StrictTable& table, Names& names) {
  MarkerDefinition marker;
  const Value name = table["name"];
  marker.name = name.name();
  names.markers.add(marker.name, name);
  const Value body = table["body"];
  marker.body = names.bodies.find(body.name(), body);
  marker.p_LP = table["point"].vector(Dimension::kLength);
  return marker;
}

}  // namespace

void read_forces(StrictTable& root, Names& names,
                 mechanism::MechanismDefinition& mechanism) {
  std::size_t count = 0;
  for (StrictTable& table : root.tables("force")) {
    const auto type = table["type"].choice<ElementType>(
        {{"constant", ElementType::kConstant},
         {"spring", ElementType::kSpring},
         {"friction", ElementType::kFriction},
         {"stop", ElementType::kStop},
         {"table", ElementType::kTable},
         {"contact", ElementType::kContact},
         {"impedance", ElementType::kImpedance},
         {"gas_cylinder", ElementType::kGasCylinder},
         {"motor", ElementType::kMotor},
         {"servo", ElementType::kServo}});
    const std::string name =
        name_or_number(table, "force", count++, names.forces);
    if (type == ElementType::kConstant) {
      mechanism.forces.push_back(read_constant_force(name, table, names));
    } else {
      mechanism.elements.push_back(
          read_element(type, name, table, mechanism.joints, names));
    }
  }
}

std::vector<MarkerDefinition> read_markers(StrictTable& root, Names& names) {
  std::vector<MarkerDefinition> markers;
  for (StrictTable& table : root.tables("marker")) {
    markers.push_back(read_marker(table, names));
  }
  return markers;
}

mechanism::SimulationSettings read_simulation(StrictTable table) {
  constexpr int kMostInstants = 100'000;
  mechanism::SimulationSettings settings;
  settings.duration = table["duration"].positive(Dimension::kTime);
  if (const auto instants = table.find("instants")) {
    settings.instants = instants->integer(2, kMostInstants);
  }
  if (const auto tolerance = table.find("tolerance")) {
    settings.tolerance = tolerance->number(1e-14, 1e-3);
  }
  if (const auto motion = table.find("motion")) {
    settings.motion = motion->choice<mechanism::MotionKind>(
        {{"auto", mechanism::MotionKind::kAuto},
         {"driven", mechanism::MotionKind::kDriven},
         {"dynamic", mechanism::MotionKind::kDynamic}});
  }
  if (const auto integrator = table.find("integrator")) {
    using enum numerics::IntegratorChoice;
    settings.integrator = integrator->choice<numerics::IntegratorChoice>(
        {{"auto", kAuto}, {"explicit", kExplicit}, {"implicit", kImplicit}});
  }
  if (const auto singularity = table.find("at_singularity")) {
    settings.at_singularity = singularity->choice<mechanism::AtSingularity>(
        {{"report", mechanism::AtSingularity::kReport},
         {"continue", mechanism::AtSingularity::kContinue},
         {"stop", mechanism::AtSingularity::kStop}});
  }
  if (const auto links = table.find("links")) {
    settings.links = links->choice<mechanism::LinkStiffness>(
        {{"rigid", mechanism::LinkStiffness::kRigid},
         {"elastic", mechanism::LinkStiffness::kElastic}});
  }
  return settings;
}

}  // namespace clevis::scene

#include "scene/motion/read_motion.h"

#include <fmt/format.h>

#include "scene/text/names.h"

namespace clevis::scene {
namespace {

using mechanism::MarkerDefinition;

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

#include "scene/machine/read_compliances.h"

#include <fmt/format.h>

namespace clevis::scene {
namespace {

using namespace machine;

enum class Type {
  kBar,
  kShaft,
  kKey,
  kSpline,
  kGearTeeth,
  kThread,
  kBallScrew,
  kGiven,
  kSeries,
  kParallel
};

double length(StrictTable& table, std::string_view key) {
  return table[key].positive(Dimension::kLength);
}

/// A diameter inside another one. @throws Error S006.
double inner(const Value& value, double outer, const char* name) {
  const double diameter = value.positive(Dimension::kLength);
  if (diameter >= outer) {
    throw value.refusal("S006", fmt::format("is not below the {}", name),
                        "Exchange the two, or correct one.");
  }
  return diameter;
}

Shaft read_shaft(StrictTable& table) {
  Shaft shaft;
  shaft.length = length(table, "length");
  shaft.diameter = length(table, "diameter");
  if (const auto bore = table.find("bore")) {
    shaft.bore = inner(*bore, shaft.diameter, "diameter");
  }
  shaft.shear_modulus = table["shear_modulus"].elastic_modulus();
  return shaft;
}

/// K of the source's (5.56) by the form of the key, or given [m³/N].
double key_constant(StrictTable& table, bool spline) {
  constexpr double kUnit = 1e-9;  // of mm³/N
  constexpr double kPrismatic = 6.5e-3 * kUnit, kSegment = 14e-3 * kUnit;
  constexpr double kSpline = 4e-3 * kUnit;
  if (table.has("constant")) {
    return table["constant"].positive(Dimension::kVolumePerForce);
  }
  if (spline) return kSpline;
  return table["form"].choice<double>(
      {{"prismatic", kPrismatic}, {"segment", kSegment}});
}

Key read_key(StrictTable& table, bool spline) {
  constexpr int kMostKeys = 200;
  Key key;
  key.spline = spline;
  key.diameter = length(table, "diameter");
  key.length = length(table, "length");
  key.height = length(table, "height");
  if (const auto count = table.find("count")) {
    key.count = count->integer(1, kMostKeys);
  } else if (spline) {
    key.count = table["count"].integer(1, kMostKeys);
  }
  key.constant = key_constant(table, spline);
  return key;
}

Thread read_thread(StrictTable& table) {
  Thread thread;
  thread.diameter = length(table, "diameter");
  thread.root_diameter =
      inner(table["root_diameter"], thread.diameter, "diameter");
  thread.constant = table["constant"].positive(Dimension::kVolumePerForce);
  return thread;
}

BallScrew read_ball_screw(StrictTable& table) {
  constexpr double kMostTurns = 100.0, kLeast = 0.01;
  BallScrew screw;
  screw.circle_diameter = length(table, "circle_diameter");
  screw.ball_diameter =
      inner(table["ball_diameter"], screw.circle_diameter, "circle_diameter");
  screw.turns = table["turns"].number(kLeast, kMostTurns);
  screw.preload = table["preload"].positive(Dimension::kForce);
  screw.class_factor = table["class_factor"].number(kLeast, kMostTurns);
  return screw;
}

ElementGroup read_group(StrictTable& table, bool parallel, bool angular) {
  ElementGroup group;
  group.parallel = parallel;
  const Value elements = table["elements"];
  for (const Value& element : elements.elements()) {
    StrictTable below(element, "transmission.stage.element");
    group.elements.push_back(read_compliance(below, angular));
  }
  if (group.elements.empty()) {
    throw elements.refusal("S006", "is empty", "Give one element or more.");
  }
  return group;
}

Type read_type(StrictTable& table) {
  return table["type"].choice<Type>({{"bar", Type::kBar},
                                     {"shaft", Type::kShaft},
                                     {"key", Type::kKey},
                                     {"spline", Type::kSpline},
                                     {"gear_teeth", Type::kGearTeeth},
                                     {"thread", Type::kThread},
                                     {"ball_screw", Type::kBallScrew},
                                     {"given", Type::kGiven},
                                     {"series", Type::kSeries},
                                     {"parallel", Type::kParallel}});
}

void read_law(StrictTable& table, Type type, bool angular,
              CompliantElement& element) {
  switch (type) {
    case Type::kBar:
      element.law =
          Bar{length(table, "length"), table["area"].positive(Dimension::kArea),
              table["youngs_modulus"].elastic_modulus()};
      return;
    case Type::kShaft:
      element.law = read_shaft(table);
      return;
    case Type::kKey:
    case Type::kSpline:
      element.law = read_key(table, type == Type::kSpline);
      return;
    case Type::kGearTeeth:
      element.law = GearTeeth{length(table, "radius"), length(table, "width"),
                              table["modulus"].elastic_modulus()};
      return;
    case Type::kThread:
      element.law = read_thread(table);
      return;
    case Type::kBallScrew:
      element.law = read_ball_screw(table);
      return;
    case Type::kGiven:
      element.law = GivenCompliance{
          table["compliance"].positive(angular ? Dimension::kAngularCompliance
                                               : Dimension::kCompliance),
          angular};
      return;
    case Type::kSeries:
    case Type::kParallel:
      element.law = read_group(table, type == Type::kParallel, angular);
      return;
  }
}

}  // namespace

CompliantElement read_compliance(StrictTable& table, bool angular) {
  CompliantElement element;
  element.place = table.place();
  if (const auto name = table.find("name")) element.name = name->title();
  const Type type = read_type(table);
  read_law(table, type, angular, element);
  table.finish(fmt::format("with type = \"{}\"", type_name(element)));
  if (is_angular(element) != angular) {
    throw table["type"].refusal(
        "S010",
        fmt::format("= \"{}\" {}, its stage {}", type_name(element),
                    angular ? "moves along a line" : "turns",
                    angular ? "turns" : "moves along a line"),
        "Put it on a stage before or after the lead or pinion_radius.");
  }
  return element;
}

}  // namespace clevis::scene

#include "scene/text/keys.h"

#include <algorithm>
#include <array>
#include <cassert>

namespace clevis::scene {
namespace {

using Key = std::string_view;

constexpr Key kScene[] = {
    "schema",      "name",    "world",        "material", "mechanism",
    "body",        "joint",   "coupling",     "drive",    "force",
    "initial",     "marker",  "simulation",   "part",     "accuracy",
    "closed_form", "bearing", "transmission", "ejector",  "impact",
    "vary"};
constexpr Key kWorld[] = {"gravity"};
constexpr Key kMaterial[] = {"youngs_modulus", "poissons_ratio", "density",
                             "yield_strength"};
constexpr Key kMechanism[] = {"dimension"};
constexpr Key kBody[] = {"name",           "part",    "mass",
                         "center_of_mass", "inertia", "placement"};
constexpr Key kPlacement[] = {"origin", "angle", "x_axis", "y_axis"};
constexpr Key kJoint[] = {"name", "type",   "between", "at",     "point",
                          "axis", "normal", "lead",    "length", "compliance"};
constexpr Key kCompliance[] = {"force", "moment"};
constexpr Key kCoupling[] = {
    "name",   "type",   "joints",         "coordinates", "ratio",
    "radius", "offset", "pressure_angle", "helix_angle", "mid_face"};
constexpr Key kDrive[] = {"joint",     "coordinate", "law",       "from",
                          "to",        "start",      "duration",  "amplitude",
                          "frequency", "times",      "positions", "ends",
                          "speed"};
constexpr Key kForce[] = {"name",
                          "type",
                          "body",
                          "point",
                          "force",
                          "moment",
                          "joint",
                          "coordinate",
                          "between",
                          "from",
                          "to",
                          "axis",
                          "stiffness",
                          "damping",
                          "free",
                          "preload",
                          "acts_on",
                          "full_speed",
                          "model",
                          "breakaway",
                          "kinetic",
                          "viscous",
                          "stribeck_speed",
                          "regularizing_speed",
                          "bristle_stiffness",
                          "bristle_damping",
                          "lower",
                          "upper",
                          "transition",
                          "times",
                          "positions",
                          "efforts",
                          "center",
                          "radius",
                          "plane",
                          "plane_point",
                          "normal",
                          "static_friction",
                          "kinetic_friction",
                          "pin_radius",
                          "guide",
                          "critical_speed",
                          "target",
                          "targets",
                          "ends",
                          "damping_of",
                          "sections",
                          "gas",
                          "environment",
                          "supply",
                          "chamber",
                          "ratio",
                          "pole_pairs",
                          "resistance",
                          "inductance",
                          "flux",
                          "rotor_inertia",
                          "voltage",
                          "voltages",
                          "d_axis",
                          "law",
                          "start",
                          "duration",
                          "amplitude",
                          "frequency",
                          "speed",
                          "bandwidth",
                          "damping_ratio",
                          "inertia",
                          "limit",
                          "coupling",
                          "angular_stiffness",
                          "angular_damping",
                          "axis_to",
                          "normal_to"};
constexpr Key kGuide[] = {"body", "length"};
constexpr Key kGasCoupling[] = {"step"};
constexpr Key kGas[] = {"gas_constant", "specific_heat"};
constexpr Key kGasState[] = {"pressure", "temperature"};
constexpr Key kSupply[] = {"pressure", "gauge_pressure", "temperature",
                           "volume"};
constexpr Key kChamber[] = {
    "name",        "pushes",           "bore",     "rod",  "area",
    "origin",      "dead_volume",      "pressure", "heat", "gauge_pressure",
    "temperature", "wall_conductance", "valve"};
constexpr Key kValve[] = {"kv",
                          "cv",
                          "sonic_conductance",
                          "area",
                          "discharge_coefficient",
                          "critical_ratio",
                          "laminar_ratio",
                          "leakage",
                          "smoothing",
                          "opening",
                          "opening_start",
                          "opening_time",
                          "times",
                          "openings"};
constexpr Key kInitial[] = {"joint", "position", "rate",
                            "body",  "velocity", "angular_velocity"};
constexpr Key kBearing[] = {"name",
                            "joint",
                            "kind",
                            "dynamic_rating",
                            "static_rating",
                            "radial_factor",
                            "axial_factor",
                            "axial_threshold",
                            "static_radial_factor",
                            "static_axial_factor",
                            "service_factor",
                            "life_wanted",
                            "static_safety_wanted",
                            "bore",
                            "outer_diameter",
                            "width"};
constexpr Key kTransmission[] = {"name", "motor_inertia", "load_inertia",
                                 "load", "errors",        "ball_screw_unit",
                                 "stage"};
constexpr Key kTransmissionErrors[] = {"control", "kinematic", "backlash",
                                       "friction"};
constexpr Key kStage[] = {"name",          "ratio",         "lead",
                          "pinion_radius", "wheel_inertia", "pinion_inertia",
                          "element"};
constexpr Key kElement[] = {"name",
                            "type",
                            "length",
                            "area",
                            "youngs_modulus",
                            "diameter",
                            "bore",
                            "shear_modulus",
                            "height",
                            "count",
                            "form",
                            "constant",
                            "radius",
                            "width",
                            "modulus",
                            "root_diameter",
                            "circle_diameter",
                            "ball_diameter",
                            "turns",
                            "preload",
                            "class_factor",
                            "compliance",
                            "elements"};
constexpr Key kEjector[] = {"name",          "arm_magnet", "arm_pusher",
                            "arm_spring",    "inertia",    "magnet_force",
                            "range",         "travel",     "spring_stiffness",
                            "spring_preset", "workpiece"};
constexpr Key kImpact[] = {"name",  "part",      "face",        "direction",
                           "fixed", "contact",   "mass",        "speed",
                           "force", "stiffness", "ball_radius", "duration"};
constexpr Key kWorkpiece[] = {"material", "diameter", "length",
                              "safety_factor"};
constexpr Key kMarker[] = {"name", "body", "point"};
constexpr Key kSimulation[] = {"duration", "instants",   "tolerance",
                               "motion",   "integrator", "at_singularity",
                               "links"};
constexpr Key kPart[] = {"name",        "geometry",  "parameters", "mesh",
                         "length_unit", "thickness", "material",   "pins",
                         "drives",      "forces",    "limits",     "damping",
                         "case",        "history",   "faces",      "mesh_size",
                         "sweep",       "refine",    "joints"};
constexpr Key kPartFaces[] = {"cylinder", "plane", "nearest", "label",
                              "all_of"};
constexpr Key kCylinder[] = {"diameter", "near", "axis"};
constexpr Key kPlane[] = {"normal", "through"};
constexpr Key kPartPins[] = {"group", "groups", "length", "width", "offset"};
constexpr Key kPartDrives[] = {"face", "pressurized"};
constexpr Key kPartForces[] = {"face", "pressurized", "chamber"};
constexpr Key kLimits[] = {"safety_factor", "deflection", "buckling",
                           "singular_zones"};
constexpr Key kCase[] = {"name",
                         "pins",
                         "pressure",
                         "traction",
                         "fixed",
                         "foundation",
                         "held_by_pin",
                         "acceleration",
                         "gravity",
                         "angular_velocity",
                         "angular_acceleration",
                         "probes"};
constexpr Key kHistory[] = {
    "name",       "file",  "frame",      "pins",          "faces",
    "gravity",    "fixed", "foundation", "interpolation", "largest_imbalance",
    "held_by_pin"};
constexpr Key kHistoryPins[] = {"group", "about"};
constexpr Key kFoundation[] = {"normal", "tangential"};
constexpr Key kProbes[] = {"name", "at", "quantity", "reference"};
constexpr Key kVary[] = {"design", "samples", "seed", "quantity"};
constexpr Key kVaryQuantity[] = {"path", "values", "from", "to", "count"};
constexpr Key kAccuracy[] = {"peak_stress"};
constexpr Key kClosedForm[] = {"slide_lever"};
constexpr Key kSlideLever[] = {"FD", "ED",  "DC",    "EC",
                               "AD", "DD1", "drive", "marker"};

constexpr auto kTables = std::to_array<TableKeys>({
    {"", kScene},
    {"world", kWorld},
    {"material", kMaterial},
    {"mechanism", kMechanism},
    {"body", kBody},
    {"body.placement", kPlacement},
    {"joint", kJoint},
    {"joint.compliance", kCompliance},
    {"coupling", kCoupling},
    {"drive", kDrive},
    {"force", kForce},
    {"force.guide", kGuide},
    {"force.gas", kGas},
    {"force.coupling", kGasCoupling},
    {"force.environment", kGasState},
    {"force.supply", kSupply},
    {"force.chamber", kChamber},
    {"force.chamber.valve", kValve},
    {"initial", kInitial},
    {"marker", kMarker},
    {"bearing", kBearing},
    {"transmission", kTransmission},
    {"transmission.errors", kTransmissionErrors},
    {"transmission.stage", kStage},
    {"transmission.stage.element", kElement},
    {"ejector", kEjector},
    {"ejector.workpiece", kWorkpiece},
    {"impact", kImpact},
    {"simulation", kSimulation},
    {"part", kPart},
    {"part.pins", kPartPins},
    {"part.faces", kPartFaces},
    {"part.faces.cylinder", kCylinder},
    {"part.faces.plane", kPlane},
    {"part.drives", kPartDrives},
    {"part.forces", kPartForces},
    {"part.limits", kLimits},
    {"part.case", kCase},
    {"part.case.foundation", kFoundation},
    {"part.case.probes", kProbes},
    {"part.history", kHistory},
    {"part.history.pins", kHistoryPins},
    {"accuracy", kAccuracy},
    {"closed_form", kClosedForm},
    {"closed_form.slide_lever", kSlideLever},
    {"vary", kVary},
    {"vary.quantity", kVaryQuantity},
});

constexpr auto kRivals = std::to_array<Rivals>({
    {"force", "between", "joint"},
    {"force", "from", "joint"},
    {"force", "to", "joint"},
    {"force", "axis", "joint"},
    {"force", "coordinate", "between"},
    {"force", "breakaway", "kinetic_friction"},
    {"force", "kinetic", "kinetic_friction"},
    {"force", "stiffness", "bandwidth"},
    {"force", "damping", "bandwidth"},
    {"force", "voltage", "voltages"},
    {"force", "voltages", "voltage"},
    {"force", "target", "targets"},
    {"force", "targets", "target"},
    {"force", "positions", "times"},
    {"force.chamber", "bore", "area"},
    {"force.chamber", "rod", "area"},
    {"force.chamber", "pressure", "gauge_pressure"},
    {"force.chamber.valve", "cv", "kv"},
    {"force.chamber.valve", "sonic_conductance", "kv"},
    {"force.chamber.valve", "area", "kv"},
    {"force.chamber.valve", "sonic_conductance", "cv"},
    {"force.chamber.valve", "area", "cv"},
    {"force.chamber.valve", "area", "sonic_conductance"},
    {"force.chamber.valve", "openings", "opening"},
    {"force.chamber.valve", "opening", "openings"},
    {"force.supply", "pressure", "gauge_pressure"},
    {"vary.quantity", "from", "values"},
    {"vary.quantity", "to", "values"},
    {"vary.quantity", "count", "values"},
    {"transmission.stage", "ratio", "lead"},
    {"transmission.stage", "pinion_radius", "lead"},
    {"transmission.stage", "ratio", "pinion_radius"},
    {"impact", "mass", "contact"},
    {"impact", "speed", "contact"},
    {"impact", "force", "contact"},
    {"impact", "stiffness", "ball_radius"},
    {"initial", "velocity", "joint"},
    {"initial", "angular_velocity", "joint"},
});

}  // namespace

std::span<const Rivals> rivals() {
  return kRivals;
}

std::span<const TableKeys> scene_tables() {
  return kTables;
}

std::span<const std::string_view> keys_of(std::string_view path) {
  const auto found = std::ranges::find(kTables, path, &TableKeys::path);
  assert(found != kTables.end() && "path is no table of the scene format");
  return found->keys;
}

}  // namespace clevis::scene

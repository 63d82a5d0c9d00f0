#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <string>

#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <unistd.h>

#include "base/messages/errors.h"
#include "scene/motion/plausible_mechanism.h"
#include "scene/scene.h"
#include "support/source_dir.h"

namespace clevis::scene {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using mechanism::kGround;

const std::filesystem::path kScenes =
    support::source_dir() / "tests/data/scenes";

// Round-off of unit conversion and rotation of values of the order of 1.
constexpr double kRoundOff = 1e-15;

void expect_near(const Vector3d& got, const Vector3d& wanted) {
  EXPECT_LT((got - wanted).norm(), kRoundOff) << got.transpose();
}

void expect_rotation(const Matrix3d& rotation) {
  EXPECT_LT((rotation.transpose() * rotation - Matrix3d::Identity()).norm(),
            4 * kRoundOff);
  EXPECT_NEAR(rotation.determinant(), 1.0, 4 * kRoundOff);
}

Scene lever() {
  return read_scene(kScenes / "geometry/lever/scene.toml");
}

TEST(SceneReader, ReadsSettings) {
  const Scene scene = lever();
  EXPECT_EQ(scene.name, "lever with a cylinder");
  EXPECT_TRUE(scene.has_mechanism);
  EXPECT_EQ(scene.mechanism.dimension, mechanism::SpaceDimension::kPlanar);
  expect_near(scene.mechanism.gravity_W, {0, -9.81, 0});
  EXPECT_DOUBLE_EQ(scene.simulation.duration, 3.0);
  EXPECT_EQ(scene.simulation.instants, 61);
  EXPECT_EQ(scene.simulation.tolerance, 1e-9);
  EXPECT_DOUBLE_EQ(scene.peak_stress_tolerance, 0.02);
}

TEST(SceneReader, DefaultsAreThoseOfTheFormat) {
  const Scene driven = read_scene(kScenes / "driven_parts.toml");
  EXPECT_EQ(driven.simulation.instants, 201);
  EXPECT_EQ(driven.simulation.tolerance, 1e-8);
  EXPECT_EQ(driven.peak_stress_tolerance, 0.01);
  EXPECT_EQ(driven.mechanism.dimension, mechanism::SpaceDimension::kAuto);
  EXPECT_EQ(name_of(driven.mechanism.elements.at(0)), "force_1");
  EXPECT_FALSE(driven.slide_lever);
}

TEST(SceneReader, ReadsBodiesWithPlacementAndMass) {
  const auto bodies = lever().mechanism.bodies;
  ASSERT_EQ(bodies.size(), 3u);
  EXPECT_EQ(bodies[0].name, "lever");
  EXPECT_EQ(bodies[0].part, "lever");
  EXPECT_EQ(bodies[0].mass_properties.mass, 0.0);  // the part brings it
  expect_near(bodies[0].placement.p_WL, {0, 0.06, 0});
  expect_near(bodies[0].placement.R_WL * Vector3d::UnitX(), Vector3d::UnitY());
  // x_axis = (4, 3, 0)/5
  expect_near(bodies[1].placement.R_WL * Vector3d(5, 0, 0), {4, 3, 0});
  expect_rotation(bodies[1].placement.R_WL);
  EXPECT_DOUBLE_EQ(bodies[1].mass_properties.mass, 0.4);
  expect_near(bodies[1].mass_properties.p_LCm, {0.05, 0, 0});
  expect_near(bodies[1].mass_properties.inertia_LCm.diagonal(),
              {80e-6, 400e-6, 400e-6});
  EXPECT_NEAR(bodies[2].mass_properties.inertia_LCm(0, 1), 1e-6, kRoundOff);
  EXPECT_NEAR(bodies[2].mass_properties.inertia_LCm(1, 0), 1e-6, kRoundOff);
}

TEST(SceneReader, ResolvesJointFrames) {
  const auto joints = lever().mechanism.joints;
  ASSERT_EQ(joints.size(), 4u);
  // One point in the world: D lies at the origin of the lever.
  EXPECT_EQ(joints[0].body_a, kGround);
  EXPECT_EQ(joints[0].body_b, 0);
  expect_near(joints[0].frame_a.p_LJ, {0, 0.06, 0});
  expect_near(joints[0].frame_b.p_LJ, {0, 0, 0});
  // A point for each body.
  expect_near(joints[2].frame_a.p_LJ, {0.01, 0, 0});
  expect_near(joints[2].frame_b.p_LJ, {-0.005, 0, 0});
  EXPECT_EQ(joints[2].type, mechanism::JointType::kPrismatic);
  // Slide axis z = (1,0,0) in both bodies, normal x = world z.
  expect_near(joints[2].frame_a.R_LJ.col(2), Vector3d::UnitX());
  expect_near(joints[2].frame_a.R_LJ.col(0), Vector3d::UnitZ());
  for (const auto& joint : joints) {
    expect_rotation(joint.frame_a.R_LJ);
    expect_rotation(joint.frame_b.R_LJ);
  }
}

// What is said once, in the world, must be one and the same direction there
// from both bodies.
TEST(SceneReader, WorldDirectionsAgreeOnBothBodies) {
  const auto mechanism = lever().mechanism;
  for (const std::size_t j : {0u, 1u, 3u}) {
    const auto& joint = mechanism.joints[j];
    const auto in_world = [&](mechanism::BodyIndex body,
                              const mechanism::JointFrame& frame) -> Matrix3d {
      if (body == kGround) return frame.R_LJ;
      return mechanism.bodies[static_cast<std::size_t>(body)].placement.R_WL *
             frame.R_LJ;
    };
    const Matrix3d a = in_world(joint.body_a, joint.frame_a);
    const Matrix3d b = in_world(joint.body_b, joint.frame_b);
    EXPECT_LT((a - b).norm(), 4 * kRoundOff) << joint.name;
    expect_near(a.col(2), Vector3d::UnitZ());
  }
  // normal = (1, 1, 5), of which only (1, 1, 0) is across the axis.
  expect_near(mechanism.joints[1].frame_a.R_LJ.col(0),
              Vector3d(1, 1, 0) / std::numbers::sqrt2);
}

TEST(SceneReader, ReadsDrives) {
  const auto quintic = lever().mechanism.drives.at(0);
  EXPECT_EQ(quintic.joint, 2);
  EXPECT_EQ(quintic.law, mechanism::DriveLaw::kQuintic);
  EXPECT_DOUBLE_EQ(quintic.from, 0.16);
  EXPECT_DOUBLE_EQ(quintic.to, 0.26);
  EXPECT_DOUBLE_EQ(quintic.start, 0.5);
  EXPECT_DOUBLE_EQ(quintic.duration, 2.0);
  const auto drives =
      read_scene(kScenes / "driven_parts.toml").mechanism.drives;
  EXPECT_DOUBLE_EQ(drives.at(0).amplitude, 0.005);
  EXPECT_DOUBLE_EQ(drives.at(0).frequency, 25.0);
  EXPECT_DOUBLE_EQ(drives.at(0).start, 0.01);
  EXPECT_DOUBLE_EQ(drives.at(1).from, std::numbers::pi / 6);  // a revolute
  EXPECT_DOUBLE_EQ(drives.at(1).to, drives.at(1).from);
}

TEST(SceneReader, ReadsForcesMarkersAndClosedForm) {
  const Scene scene = lever();
  const auto& force =
      std::get<mechanism::ConstantForce>(scene.mechanism.elements.at(0));
  EXPECT_EQ(force.name, "wheel");
  EXPECT_EQ(force.point.body, 0);
  expect_near(force.point.p_L, {0.14, 0, 0});
  expect_near(force.f_W, {500, 1000, 0});
  expect_near(force.t_W, {0, 0, 3});
  EXPECT_EQ(scene.mechanism.markers.at(0).name, "C");
  expect_near(scene.mechanism.markers.at(0).p_LP, {0.14, 0, 0});
  ASSERT_TRUE(scene.slide_lever);
  EXPECT_DOUBLE_EQ(scene.slide_lever->FD, 0.21024);
  EXPECT_DOUBLE_EQ(scene.slide_lever->DD1, 0.21);
  EXPECT_EQ(scene.slide_lever->drive, 0);
  EXPECT_EQ(scene.slide_lever->marker, "C");
}

TEST(SceneReader, ReadsPartsWithSeats) {
  const auto part = lever().parts.at(0);
  EXPECT_EQ(part.name, "lever");
  EXPECT_DOUBLE_EQ(part.length_unit, 1e-3);
  EXPECT_EQ(part.material.name, "steel_45");
  EXPECT_DOUBLE_EQ(part.material.youngs_modulus, 210e9);
  EXPECT_DOUBLE_EQ(part.material.poissons_ratio, 0.3);
  EXPECT_DOUBLE_EQ(part.material.density, 7850.0);
  EXPECT_DOUBLE_EQ(part.material.yield_strength, 355e6);
  EXPECT_DOUBLE_EQ(part.limits.safety_factor.value(), 1.5);
  EXPECT_DOUBLE_EQ(part.limits.buckling.value(), 2.5);
  EXPECT_DOUBLE_EQ(part.limits.deflection.value(), 5e-4);
  ASSERT_EQ(part.seats.size(), 2u);
  EXPECT_EQ(part.seats[1].joint, "E");
  EXPECT_EQ(part.seats[1].group, "bore_E");
  EXPECT_TRUE(part.place.ends_with("scene.toml:94:1")) << part.place;
  const auto barrel = read_scene(kScenes / "driven_parts.toml").parts.at(0);
  ASSERT_EQ(barrel.drive_seats.size(), 1u);
  EXPECT_EQ(barrel.drive_seats[0].drive, "slide");
  EXPECT_EQ(barrel.drive_seats[0].group, "bottom");
  EXPECT_EQ(barrel.drive_seats[0].pressurized,
            (std::vector<std::string>{"wall", "lid"}));
}

TEST(SceneReader, ReadsWhatASlideTouches) {
  const auto parts = read_scene(kScenes / "driven_parts.toml").parts;
  const part::Seat& wall = parts.at(0).seats.at(1);
  EXPECT_EQ(wall.group, "wall");
  EXPECT_EQ(wall.slide.opposite, "roof");
  EXPECT_DOUBLE_EQ(wall.slide.length.value(), 0.02);
  EXPECT_DOUBLE_EQ(wall.slide.width.value(), 0.008);
  EXPECT_DOUBLE_EQ(wall.slide.offset, -0.003);
  EXPECT_EQ(parts.at(1).seats.at(0).group, "bore_hinge");
  EXPECT_FALSE(parts.at(1).seats.at(1).slide.length);
}

TEST(SceneReader, ReadsSeatsOfForces) {
  const auto seats =
      read_scene(kScenes / "force_seats.toml").parts.at(0).force_seats;
  ASSERT_EQ(seats.size(), 4u);
  const auto seat = [&](const std::string& force) {
    return *std::ranges::find(seats, force, &part::ForceSeat::force);
  };
  EXPECT_EQ(seat("gas").group, "bottom");
  EXPECT_EQ(seat("gas").chamber, "rod");
  EXPECT_EQ(seat("gas").pressurized, std::vector<std::string>{"wall"});
  EXPECT_EQ(seat("end of stroke").group, "rim");
  EXPECT_TRUE(seat("end of stroke").pressurized.empty());
  EXPECT_EQ(seat("force_3").pressurized.size(), 2u);
  EXPECT_EQ(seat("hose").group, "bore_hose");
}

TEST(SceneReader, ReadsHistories) {
  const auto part = read_scene(kScenes / "part_alone.toml").parts.at(0);
  ASSERT_EQ(part.series.size(), 2u);
  EXPECT_EQ(part.series[0].between, part::BetweenRows::kUnknown);
  EXPECT_EQ(part.series[1].between, part::BetweenRows::kLinear);
}

TEST(SceneReader, ReadsCases) {
  const Scene scene = read_scene(kScenes / "part_alone.toml");
  EXPECT_FALSE(scene.has_mechanism);
  const auto part = scene.parts.at(0);
  EXPECT_DOUBLE_EQ(part.length_unit, 0.0254);
  EXPECT_DOUBLE_EQ(part.thickness.value(), 0.008);
  EXPECT_FALSE(lever().parts.at(0).thickness);
  ASSERT_EQ(part.cases.size(), 4u);
  EXPECT_EQ(part.cases[2].held_by_pin, std::vector<std::string>{"bore_A"});
  const auto& root = part.cases[3].foundations.at("root");
  EXPECT_DOUBLE_EQ(root.normal, 50e9);
  EXPECT_DOUBLE_EQ(root.tangential, 50e9);
  const auto& foot = part.cases[3].foundations.at("foot");
  EXPECT_DOUBLE_EQ(foot.normal, 20e9);
  EXPECT_DOUBLE_EQ(foot.tangential, 5e9);
  expect_near(part.cases[0].pins.at("bore_A"), {-1000, 0, 0});
  const auto& held = part.cases[1];
  EXPECT_DOUBLE_EQ(held.pressure.at("top"), 1e6);
  expect_near(held.traction.at("tip"), {0, 6.25e6, 0});
  EXPECT_EQ(held.fixed.at("root"), (std::array{true, false, true}));
  EXPECT_EQ(held.fixed.at("foot"), (std::array{false, true, false}));
  // acceleration minus gravity: a part at rest on the ground is pressed down
  expect_near(held.acceleration, {1, 9.81, 0});
  EXPECT_NEAR(held.angular_velocity.z(), 50 * std::numbers::pi, 1e-12);
  expect_near(held.angular_acceleration, {0, 0, 7});
  ASSERT_EQ(held.probes.size(), 1u);
  EXPECT_EQ(held.probes[0].name, "D");
  EXPECT_EQ(held.probes[0].quantity, "stress_yy");
  EXPECT_EQ(held.probes[0].reference, 92.7e6);
  expect_near(held.probes[0].at, {2, 0, 0.3});
}

/// The mesh of the lever as its scene sees it from another working folder.
std::filesystem::path absolute_mesh(const std::filesystem::path& scene,
                                    std::size_t part) {
  return std::filesystem::absolute(read_scene(scene).parts.at(part).mesh)
      .lexically_normal();
}

TEST(SceneReader, FindsMeshesBesideTheGeometryTree) {
  EXPECT_EQ(absolute_mesh(kScenes / "geometry/lever/scene.toml", 0),
            kScenes / "meshes/lever/lever.msh");
  EXPECT_EQ(lever().parts.at(0).geometry, kScenes / "geometry/lever/lever.geo");
  // Outside of a geometry tree: beside the .geo; `mesh` wins.
  EXPECT_EQ(absolute_mesh(kScenes / "driven_parts.toml", 1),
            kScenes / "rod.msh");
  EXPECT_EQ(absolute_mesh(kScenes / "driven_parts.toml", 0),
            kScenes / "barrel.msh");
}

/// Code of the refusal of a file with this text.
/// What a scene of this text is refused for: its code, and the problem.
std::pair<std::string, std::string> refusal_with_problem(
    const std::string& text) {
  const auto file = std::filesystem::temp_directory_path() /
                    ("scene_reader_test_" + std::to_string(getpid()));
  std::ofstream(file, std::ios::binary) << text;
  std::pair<std::string, std::string> refusal{"accepted", ""};
  try {
    read_scene(file);
  } catch (const Error& error) {
    refusal = {error.code(), error.problem()};
  }
  std::filesystem::remove(file);
  return refusal;
}

std::string refusal_of_text(const std::string& text) {
  return refusal_with_problem(text).first;
}

std::string problem_of_text(const std::string& text) {
  return refusal_with_problem(text).second;
}

TEST(SceneReader, RefusesWhatIsNoSceneFile) {
  EXPECT_EQ(refusal_of_text(""), "S003");
  EXPECT_EQ(refusal_of_text("\xEF\xBB\xBF"), "S003");
  EXPECT_EQ(refusal_of_text(std::string(100, '\0')), "S001");
  EXPECT_EQ(refusal_of_text("\xFF\xFEs\0c\0"), "S001");
  EXPECT_EQ(refusal_of_text(std::string(10 << 20, '#')), "S003");
  EXPECT_EQ(refusal_of_text(std::string(17 << 20, '#')), "I001");
  for (const auto& path : {kScenes, kScenes / "none.toml"}) {
    try {
      read_scene(path);
      FAIL() << path;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), "I001");
      EXPECT_EQ(error.place(), path.string());
    }
  }
}

// Tables and keys are no values; what is a number is not quoted.
TEST(SceneReader, QuotationMarksAreWantedOfValuesAlone) {
  for (const char* text :
       {"[part steel]\n", "  [[part steel]]\n", "schema 1\n",
        "a = 2024-13-01\n", "a = 0.3.1\n", "a = \"x\" y\n", "a = \n", "a",
        "= b", "a = [1, 2", "a = inf\nb c\n", "\n\n["}) {
    EXPECT_EQ(problem_of_text(text).find("quotation marks"), std::string::npos)
        << text;
  }
  for (const char* text : {"a = b", "\"ä\" = é\n", "a = [\n1,\n2 mm]\n",
                           "a = { b = 3 % }\n", "\r\na = 10mm # 3\r\n"}) {
    EXPECT_NE(problem_of_text(text).find("quotation marks"), std::string::npos)
        << text << problem_of_text(text);
  }
}

// toml++ 3.3 alone overflows the stack here.
TEST(SceneReader, SurvivesKeysOfManyLevels) {
  std::string levels;
  for (int i = 0; i < 100'000; ++i) levels += "a.";
  EXPECT_EQ(refusal_of_text(levels + "a = 1\n"), "S001");
  EXPECT_EQ(refusal_of_text("[" + levels + "a]\n"), "S001");
  EXPECT_EQ(refusal_of_text("a = " + std::string(100'000, '[')), "S001");
}

TEST(SceneReader, PartsTakeTheOnlyMaterial) {
  const std::string steel =
      "= { youngs_modulus = \"210 GPa\", poissons_ratio = 0.3, density = "
      "\"7850 kg/m^3\", yield_strength = \"355 MPa\" }\n";
  const auto scene = [](const std::string& materials) {
    return "schema = 1\nname = \"rod\"\n[material]\n" + materials +
           "[[part]]\nname = \"rod\"\nmesh = \"rod.msh\"\nlength_unit = "
           "\"mm\"\n[[part.case]]\nname = \"pull\"\npressure = { a = \"1 MPa\" "
           "}"
           "\nfixed = { b = [\"x\", \"y\", \"z\"] }\n";
  };
  EXPECT_EQ(refusal_of_text(scene("steel " + steel)), "accepted");
  EXPECT_EQ(refusal_of_text(scene("steel " + steel + "brass " + steel)),
            "S003");
  EXPECT_EQ(refusal_of_text(scene("")), "S003");
}

TEST(SceneReader, BomBeforeAValidSceneIsIgnored) {
  std::ifstream file(kScenes / "impacts.toml");
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  EXPECT_EQ(refusal_of_text("\xEF\xBB\xBF" + text), "accepted");
}

TEST(SceneReader, PartsWithoutJointsNeedNoPins) {
  const auto scene = [](const std::string& joints) {
    const std::string zero = "[\"0 mm\", \"0 mm\", \"0 mm\"]\n";
    return "schema = 1\nname = \"rod\"\n[world]\ngravity = [\"0 m/s^2\", "
           "\"0 m/s^2\", \"0 m/s^2\"]\n[material.steel]\n"
           "youngs_modulus = \"210 GPa\"\npoissons_ratio = 0.3\n"
           "density = \"7850 kg/m^3\"\nyield_strength = \"355 MPa\"\n"
           "[[body]]\nname = \"rod\"\npart = \"rod\"\n" +
           joints +
           "[[force]]\ntype = \"spring\"\nname = \"foot\"\n"
           "between = [\"ground\", \"rod\"]\naxis = [0, 1, 0]\nfrom = " +
           zero + "to = " + zero +
           "stiffness = \"1 N/mm\"\nfree = \"0 mm\"\n"
           "[simulation]\nmotion = \"dynamic\"\nduration = \"1 s\"\n"
           "[[part]]\nname = \"rod\"\nmesh = \"rod.msh\"\n"
           "length_unit = \"mm\"\nforces = { foot = { face = \"a\" } }\n";
  };
  EXPECT_EQ(refusal_of_text(scene("")), "accepted");
  EXPECT_EQ(refusal_of_text(
                scene("[[joint]]\nname = \"A\"\ntype = \"revolute\"\n"
                      "between = [\"ground\", \"rod\"]\npoint = [\"0 mm\", "
                      "\"0 mm\", \"0 mm\"]\naxis = [0, 0, 1]\n")),
            "S003");
}

// A rotor on an arm that stands on a bushing: how long the arm is its mesh
// alone tells. A rotor on one joint may be out of balance by a hair: that is no
// link's length; the radius of gyration of a tower is no rotor's.
TEST(PlausibleMechanism, PartOnOneJointMayBeLong) {
  mechanism::MechanismDefinition m;
  mechanism::BodyDefinition arm, rotor;
  arm.part = "arm";
  rotor.mass_properties.mass = 3.0;
  rotor.mass_properties.inertia_LCm = 0.01 * Eigen::Matrix3d::Identity();
  rotor.mass_properties.p_LCm = {1e-4, 0.0, 0.0};
  m.bodies = {arm, rotor};
  m.joints.resize(1);
  m.joints[0].body_a = 0;
  m.joints[0].body_b = 1;
  EXPECT_NO_THROW(require_plausible(m));
  m.bodies[0].part.clear();
  m.bodies[0].mass_properties = m.bodies[1].mass_properties;
  for (const double off : {0.0, 1e-6, 1e-4, 1e-3}) {
    for (auto& body : m.bodies) body.mass_properties.p_LCm.x() = off;
    EXPECT_NO_THROW(require_plausible(m)) << off;
  }
  m.bodies[1].mass_properties.inertia_LCm *= 1e6;
  EXPECT_THROW(require_plausible(m), Error);
}

}  // namespace
}  // namespace clevis::scene

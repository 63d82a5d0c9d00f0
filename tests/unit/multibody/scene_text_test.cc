#include "multibody/scene_text.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>

#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <unistd.h>

#include "base/messages/errors.h"
#include "scene/scene.h"

namespace clevis::multibody {
namespace {

namespace fs = std::filesystem;
using Eigen::Vector3d;

Link link(const std::string& name, double mass = 1.0) {
  Link result{.name = name, .mass = mass};
  result.inertia_LCm = mass * Eigen::Matrix3d::Identity();
  return result;
}

Axis axis(const Vector3d& direction) {
  Axis result;
  result.direction = direction;
  return result;
}

Joint joint(const std::string& type, const std::string& parent,
            const std::string& child, std::vector<Axis> axes) {
  return {.name = parent + "_" + child,
          .type = type,
          .parent = parent,
          .child = child,
          .axes = std::move(axes)};
}

Model arm(const std::string& type, std::vector<Axis> axes) {
  Model model;
  model.name = "arm";
  model.links = {link("arm")};
  model.joints = {joint(type, "", "arm", std::move(axes))};
  return model;
}

scene::Scene read(const SceneText& made) {
  const fs::path file =
      fs::temp_directory_path() /
      ("clevis_scene_text_" + std::to_string(getpid()) + ".toml");
  std::ofstream(file) << made.text;
  scene::Scene result = scene::read_scene(file);
  fs::remove(file);
  return result;
}

bool tells(const SceneText& made, const std::string& what) {
  return std::ranges::any_of(made.told, [&](const std::string& line) {
    return line.find(what) != line.npos;
  });
}

/// The code by which a model is refused.
std::string refusal(const Model& model) {
  try {
    scene_text(model, "a.sdf");
  } catch (const Error& error) {
    return error.code();
  }
  return "";
}

TEST(SceneText, EveryJointTypeIsReadByTheScene) {
  using mechanism::JointType;
  const Axis x = axis(Vector3d::UnitX()), y = axis(Vector3d::UnitY());
  const std::vector<std::tuple<const char*, std::vector<Axis>, JointType>>
      types{{"revolute", {x}, JointType::kRevolute},
            {"continuous", {x}, JointType::kRevolute},
            {"prismatic", {x}, JointType::kPrismatic},
            {"fixed", {}, JointType::kWeld},
            {"ball", {}, JointType::kSpherical},
            {"universal", {x, y}, JointType::kUniversal},
            {"screw", {x}, JointType::kScrew},
            {"planar", {x}, JointType::kPlanar}};
  for (const auto& [word, axes, type] : types) {
    Model model = arm(word, axes);
    model.joints[0].lead = 0.002;
    const scene::Scene scene = read(scene_text(model, "a.sdf"));
    ASSERT_EQ(scene.mechanism.joints.size(), 1U) << word;
    EXPECT_EQ(scene.mechanism.joints[0].type, type) << word;
  }
}

TEST(SceneText, AnUnknownJointIsLeftOutAndTold) {
  const SceneText made =
      scene_text(arm("gearbox", {axis(Vector3d::UnitX())}), "a.sdf");
  EXPECT_EQ(made.joints, 0U);
  EXPECT_TRUE(tells(made, "joint _arm: clevis has no gearbox joint"));
  EXPECT_TRUE(tells(made, "link arm: no joint leads from it to the ground"));
  EXPECT_EQ(read(made).mechanism.bodies.size(), 1U);
}

TEST(SceneText, LimitsAndDynamicsBecomeForces) {
  Axis x = axis(Vector3d::UnitX());
  x.lower = -0.5;
  x.upper = 0.25;
  x.damping = 2.0;
  x.friction = 0.1;
  x.spring_stiffness = 3.0;
  x.spring_reference = 0.125;
  for (const char* type : {"revolute", "prismatic", "screw"}) {
    Model model = arm(type, {x});
    model.joints[0].lead = 0.002;
    const SceneText made = scene_text(model, "a.sdf");
    EXPECT_EQ(made.forces, 3U) << type;
    EXPECT_EQ(read(made).mechanism.elements.size(), 3U) << type;
  }
}

TEST(SceneText, EqualLimitsAtZeroAreAWeld) {
  Axis x = axis(Vector3d::UnitX());
  x.lower = x.upper = 0.0;
  const SceneText made = scene_text(arm("revolute", {x}), "a.urdf");
  EXPECT_EQ(made.forces, 0U);
  EXPECT_TRUE(tells(made, "a weld"));
  EXPECT_EQ(read(made).mechanism.joints[0].type, mechanism::JointType::kWeld);
}

TEST(SceneText, LimitsThatZeroIsBeyondAreTold) {
  Axis x = axis(Vector3d::UnitX());
  x.lower = 0.5;
  const SceneText made = scene_text(arm("revolute", {x}), "a.sdf");
  EXPECT_EQ(made.forces, 0U);
  EXPECT_TRUE(tells(made, "zero is beyond its limits"));
}

TEST(SceneText, ALinkWithoutMassIsAPlaceOnItsNeighbour) {
  Model model = arm("revolute", {axis(Vector3d::UnitZ())});
  model.links.push_back(link("flange", 0.0));
  model.links.push_back(link("hand"));
  model.joints.push_back(joint("fixed", "arm", "flange", {}));
  model.joints.push_back(
      joint("revolute", "flange", "hand", {axis(Vector3d::UnitZ())}));
  const SceneText made = scene_text(model, "a.urdf");
  EXPECT_TRUE(tells(made, "link flange: no mass; it is a place on arm"));
  const scene::Scene scene = read(made);
  ASSERT_EQ(scene.mechanism.bodies.size(), 2U);
  ASSERT_EQ(scene.mechanism.joints.size(), 2U);
}

TEST(SceneText, AnEndWithoutMassIsLeftOutOneBetweenOthersRefused) {
  Model model = arm("revolute", {axis(Vector3d::UnitZ())});
  model.links.push_back(link("tip", 0.0));
  model.joints.push_back(
      joint("revolute", "arm", "tip", {axis(Vector3d::UnitZ())}));
  const SceneText made = scene_text(model, "a.urdf");
  EXPECT_TRUE(tells(made, "link tip: no mass; left out"));
  EXPECT_EQ(read(made).mechanism.bodies.size(), 1U);
  model.links.push_back(link("hand"));
  model.joints.push_back(
      joint("revolute", "tip", "hand", {axis(Vector3d::UnitX())}));
  EXPECT_EQ(refusal(model), "S015");
}

TEST(SceneText, RefusesWhatNoSceneCanHold) {
  const auto changed = [](const std::function<void(Model&)>& change) {
    Model model = arm("revolute", {axis(Vector3d::UnitZ())});
    change(model);
    return refusal(model);
  };
  EXPECT_EQ(changed([](Model&) {}), "");
  EXPECT_EQ(changed([](Model& m) {
              m.links[0].mass = -1.0;
            }),
            "S015");
  EXPECT_EQ(changed([](Model& m) {
              m.links[0].is_fixed = true;
            }),
            "S015");
  EXPECT_EQ(changed([](Model& m) {
              m.links[0].inertia_LCm.setZero();
            }),
            "S015");
  EXPECT_EQ(changed([](Model& m) {
              m.links[0].p_WL.x() = 1.0 / 0.0;
            }),
            "S015");
  EXPECT_EQ(changed([](Model& m) {
              m.joints[0].axes.clear();
            }),
            "S015");
  EXPECT_EQ(changed([](Model& m) {
              m.joints[0].child = "hand";
            }),
            "S014");
}

TEST(SceneText, NamesAndCommentsCannotLeaveTheirPlace) {
  Model model = arm("revolute", {axis(Vector3d::UnitZ())});
  model.name = "a\"\n[world]\nx = 1 \\";
  model.links[0].name = "b\"]\n[[body]]";
  model.joints[0].child = model.links[0].name;
  model.told = {"lost\n[[body]]\nname = 1"};
  const SceneText made = scene_text(model, "a\n[x].sdf");
  const scene::Scene scene = read(made);
  ASSERT_EQ(scene.mechanism.bodies.size(), 1U);
  EXPECT_EQ(scene.mechanism.bodies[0].name, "b_____body__");
}

TEST(SceneText, FramesAreThoseOfTheModel) {
  Model model = arm("revolute", {axis(Vector3d(0.0, 0.6, 0.8))});
  model.links[0].p_WL << 0.1, 0.2, 0.3;
  model.links[0].R_WL =
      Eigen::AngleAxisd(0.7, Vector3d(1.0, 2.0, 3.0).normalized())
          .toRotationMatrix();
  model.links[0].inertia_LCm << 1.0, 0.1, 0.2, 0.1, 1.1, 0.3, 0.2, 0.3, 1.2;
  const scene::Scene scene = read(scene_text(model, "a.sdf"));
  const auto& body = scene.mechanism.bodies[0];
  EXPECT_LT((body.placement.R_WL - model.links[0].R_WL).norm(), 1e-15);
  EXPECT_EQ(body.placement.p_WL, model.links[0].p_WL);
  EXPECT_LT(
      (body.mass_properties.inertia_LCm - model.links[0].inertia_LCm).norm(),
      1e-15);
}

}  // namespace
}  // namespace clevis::multibody

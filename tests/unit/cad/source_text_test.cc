#include "cad/source_text.h"

#include <set>

#include <gtest/gtest.h>

namespace clevis::cad {
namespace {

TEST(SourceText, TellsWhatMakesAnotherMesh) {
  part::SolidSource source;
  source.faces = {
      {"bore_B", {part::CylinderSelector{0.012, {}, {}}, "scene:1:1"}}};
  source.joints = {{"A", "bore_A", {0, 0, 0}, {0, 0, 1}, "scene:2:1"}};
  std::set<std::string> texts{text_of(source)};
  const auto add = [&texts](const part::SolidSource& changed) {
    EXPECT_TRUE(texts.insert(text_of(changed)).second) << text_of(changed);
  };
  auto other = source;
  other.mesh_size = 0.004;
  add(other);
  other = source;
  other.sweep = false;
  add(other);
  other = source;
  other.length_unit = 0.0254;
  add(other);
  other = source;
  other.joints[0].p_LJ.x() = 1e-3;
  add(other);
  other = source;
  other.faces[0].group = "bore_C";
  add(other);
  other.faces[0].selector.what = part::NearestSelector{{0, 0, 0}};
  add(other);
  other.faces[0].selector.what = part::PlaneSelector{{0, 0, 1}, {}};
  add(other);
  other.faces[0].selector.what = part::LabelSelector{"PIN"};
  add(other);
  other.faces[0].selector.what = std::vector{source.faces[0].selector};
  add(other);
}

TEST(SourceText, PlacesInTheSceneMakeNoOtherMesh) {
  part::SolidSource source;
  source.joints = {{"A", "bore_A", {0, 0, 0}, {0, 0, 1}, "scene:2:1"}};
  auto moved = source;
  moved.joints[0].place = "scene:99:1";
  EXPECT_EQ(text_of(moved), text_of(source));
}

}  // namespace
}  // namespace clevis::cad

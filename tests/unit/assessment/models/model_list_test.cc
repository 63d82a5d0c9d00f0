#include "assessment/models/model_list.h"

#include <fstream>
#include <iterator>
#include <numbers>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include "assessment/models/plate_models.h"
#include "assessment/models/solid_model.h"
#include "base/messages/errors.h"
#include "support/annulus_mesh.h"
#include "support/simplex_mesh.h"
#include "support/source_dir.h"

namespace clevis::assessment {
namespace {

using Eigen::Vector3d;

std::string document(const char* path) {
  std::ifstream file(support::source_dir() / path);
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST(ModelList, HasEveryKindOnceInTheOrderOfTheTraits) {
  const auto list = model_list();
  ASSERT_EQ(list.size(), kModels.size());
  std::set<std::string_view> words;
  for (std::size_t i = 0; i < list.size(); ++i) {
    EXPECT_EQ(list[i].traits.word, kModels[i].word);
    EXPECT_EQ(kModels[i].kind, static_cast<ModelKind>(i));
    EXPECT_EQ(find_model(kModels[i].word), kModels[i].kind);
    words.insert(kModels[i].word);
  }
  EXPECT_EQ(words.size(), kModels.size());
  EXPECT_FALSE(find_model("auto"));
  EXPECT_FALSE(find_model("plane"));
}

TEST(ModelList, DocumentsHaveItsTableAndItsWords) {
  const std::string theory = document("docs/theory/09_elasticity.md");
  std::vector<std::string_view> words{"auto"};
  for (const ModelTraits& model : kModels) {
    const std::string row = fmt::format(
        "| `{}` | {} | {} | {} | {} |", model.word, model.name, model.suits,
        model.highest_degree, model.answers_in_time ? "yes" : "no");
    EXPECT_NE(theory.find(row), std::string::npos) << row;
    words.push_back(model.word);
  }
  const std::string option = fmt::format("[--model {}]", fmt::join(words, "|"));
  EXPECT_NE(document("README.md").find(option), std::string::npos) << option;
}

/// A flat ring with a pressure in its bore.
PartJob pressed_ring() {
  PartJob job;
  job.part.name = "ring";
  job.part.material = {"steel", 210e9, 0.3, 7850.0, 300e6};
  job.mesh = support::ring_mesh<3>({.inner = 0.02,
                                    .outer = 0.04,
                                    .thickness = 0.02,
                                    .radial = 2,
                                    .angular = 8,
                                    .axial = 1});
  loads::SurfaceLoad load;
  load.group = "x0";
  load.pressure = 60e6;
  load.total = load.pressure * 2 * std::numbers::pi * 0.02 * 0.02;
  LoadSet set;
  set.history.instants.push_back({.label = "press", .surface_loads = {load}});
  job.load_sets.push_back(set);
  return job;
}

std::vector<std::string_view> words_for(const PartJob& job) {
  const PartShape shape(job);
  std::vector<std::string_view> words;
  for (const Model* model : models_for(shape)) {
    words.push_back(model->traits.word);
  }
  return words;
}

using Words = std::vector<std::string_view>;

TEST(ModelList, SupportsAndLoadsDecideWhatSuits) {
  PartJob job = pressed_ring();
  EXPECT_EQ(words_for(job),
            (Words{"plane-stress", "layered", "revolution", "3d"}));
  auto& set = job.load_sets.front();
  set.fixed["x1"] = {true, true, false};  // nothing holds it along the axis
  EXPECT_EQ(words_for(job), (Words{"plane-stress", "layered"}));
  set.fixed["x1"] = {true, true, true};
  EXPECT_EQ(words_for(job), (Words{"revolution", "3d"}));
  set.fixed["x1"] = {true, false, true};
  EXPECT_EQ(words_for(job), (Words{"3d"}));
  set.fixed.clear();
  auto& load = set.history.instants.front().surface_loads.front();
  load.group = "z1";  // a lid, all round
  EXPECT_EQ(words_for(job), (Words{"revolution", "3d"}));
  load.group = "x0";
  load.traction = Vector3d(0.0, 0.0, 1e6);
  EXPECT_EQ(words_for(job), (Words{"layered", "revolution", "3d"}));
  set.foundations["z1"] = {};
  EXPECT_EQ(words_for(job), (Words{"3d"}));
}

/// The ring with a pin in its bore, in L about the bore's middle [N], [N m].
PartJob pinned_ring(const loads::Wrench& wrench) {
  PartJob job = pressed_ring();
  LoadSet set;
  set.history.seats = {{.name = "P",
                        .group = "x0",
                        .kind = loads::SeatKind::kBearing,
                        .p_LS = {0.0, 0.0, 0.01}},
                       {.name = "M",
                        .group = "x1",
                        .kind = loads::SeatKind::kTraction,
                        .p_LS = {0.0, 0.0, 0.01}}};
  set.history.instants.push_back(
      {.label = "pull", .wrenches = {wrench, {-wrench.force, -wrench.moment}}});
  job.load_sets = {set};
  return job;
}

bool is_pressed_through(const PartJob& job) {
  const PartShape shape(job);
  return shape.plate()->is_pressed_through;
}

// 20 mm thick: a force along x lifts off from 20 mm / 6 off the middle.
TEST(PlateShape, APinThatTiltsLiftsOffWithinTheThickness) {
  const Vector3d force(1e3, 0.0, 0.0);
  const auto off_middle = [&](double z) {
    return pinned_ring({force, Vector3d(0.0, 0.0, z).cross(force)});
  };
  EXPECT_TRUE(is_pressed_through(off_middle(0.0)));
  EXPECT_TRUE(is_pressed_through(off_middle(3.3e-3)));
  EXPECT_FALSE(is_pressed_through(off_middle(3.4e-3)));
  EXPECT_FALSE(is_pressed_through(off_middle(-3.4e-3)));
  // The moment is about the seat's own point.
  PartJob moved = off_middle(3.4e-3);
  moved.load_sets[0].history.seats[0].p_LS.z() = 0.0134;
  moved.load_sets[0].history.instants[0].wrenches[0].moment.setZero();
  EXPECT_FALSE(is_pressed_through(moved));
  moved.load_sets[0].history.instants[0].wrenches[0].moment =
      Vector3d(0.0, 0.0, -3.4e-3).cross(force);
  EXPECT_TRUE(is_pressed_through(moved));
  // A welded face pulls as it presses.
  PartJob welded = off_middle(3.4e-3);
  welded.load_sets[0].history.seats[0].kind = loads::SeatKind::kTraction;
  EXPECT_TRUE(is_pressed_through(welded));
}

TEST(PlateShape, LoadsBelowATenthOfTheLargestDoNotLiftOff) {
  const Vector3d small(10.0, 0.0, 0.0);
  PartJob job = pinned_ring({small, Vector3d(0.0, 0.05, 0.0)});
  EXPECT_FALSE(is_pressed_through(job));
  auto& instants = job.load_sets[0].history.instants;
  instants.push_back(pinned_ring({Vector3d(1e3, 0.0, 0.0), Vector3d::Zero()})
                         .load_sets[0]
                         .history.instants[0]);
  EXPECT_TRUE(is_pressed_through(job));
}

TEST(PlateShape, ASlideMayEndWithinTheThickness) {
  PartJob job = pinned_ring({Vector3d(1e3, 0.0, 0.0), Vector3d::Zero()});
  LoadSet& set = job.load_sets[0];
  set.history.seats[0].slide = loads::SlideWall{
      Vector3d::UnitZ(), Vector3d::UnitY(), Vector3d::UnitX(), ""};
  loads::ContactZone zone;
  set.history.instants[0].zones = {zone, {}};
  EXPECT_TRUE(is_pressed_through(job));
  set.history.instants[0].zones[0].low[0] = -5e-3;
  EXPECT_FALSE(is_pressed_through(job));
  set.history.instants[0].zones[0].low[0] = -10e-3;
  EXPECT_TRUE(is_pressed_through(job));
}

// Hexahedra in one layer follow a kink less than terms do.
TEST(ModelList, APlateWhosePinLiftsOffIsNotSolvedInSpace) {
  const PartJob job =
      pinned_ring({Vector3d(1e3, 0.0, 0.0), Vector3d(0.0, 20.0, 0.0)});
  const PartShape shape(job);
  const Model& layered = entry_of(ModelKind::kLayered);
  PartResult open;
  open.peak.value = 1.0;
  open.peak.model_error = 1.0;
  EXPECT_FALSE(layered.next_may_help(shape, open));
  const PartJob even = pinned_ring({Vector3d(1e3, 0.0, 0.0), Vector3d::Zero()});
  EXPECT_TRUE(layered.next_may_help(PartShape(even), open));
}

PartJob tilted_pin() {
  return pinned_ring({Vector3d(1e3, 0.0, 0.0), Vector3d(0.0, 20.0, 0.0)});
}

PartJob even_pin() {
  return pinned_ring({Vector3d(1e3, 0.0, 0.0), Vector3d::Zero()});
}

// Cells that are wider than the plate is thick overshoot beside a tilted pin.
TEST(ModelList, ATiltedPinsBandIsHalfOfTheChangeBefore) {
  const auto share = [](const PartJob& job) {
    const AnyFeModel model = layered_model(PartShape(job), {.terms = 2});
    return std::get<FeModel<3>>(model).share_of_change_before;
  };
  EXPECT_EQ(share(tilted_pin()), 0.5);
  EXPECT_EQ(share(even_pin()), stress::kShareOfChangeBefore);
}

// What one layer misses of a kink counts when hexahedra are asked for; an even
// pressure has none, and tetrahedra no layers.
TEST(ModelList, OneLayerMissesPartOfATiltedPin) {
  const auto error = [](PartJob job) {
    job.model = ModelKind::kSolid;
    return solid_settings(PartShape(job))->error;
  };
  EXPECT_GT(error(tilted_pin()), 1e-3);
  EXPECT_LT(error(tilted_pin()), 0.5);
  EXPECT_EQ(error(even_pin()), 0.0);
  EXPECT_EQ(solid_settings(PartShape(tilted_pin()))->error, 0.0);
}

TEST(ModelList, ManyCellsOfAPlateAreSolvedInSpace) {
  PartJob job = pressed_ring();
  job.mesh = support::ring_mesh<3>({.inner = 0.02,
                                    .outer = 0.04,
                                    .thickness = 0.02,
                                    .radial = 32,
                                    .angular = 96,
                                    .axial = 1});
  EXPECT_EQ(words_for(job), (Words{"revolution", "3d"}));
  job.model = ModelKind::kPlaneStress;
  EXPECT_EQ(words_for(job), (Words{"plane-stress"}));
  job.model.reset();
  // Many instants outweigh the choice; 3-D may not suit at all.
  auto& instants = job.load_sets.front().history.instants;
  instants.resize(11, instants.front());
  EXPECT_EQ(words_for(job),
            (Words{"plane-stress", "layered", "revolution", "3d"}));
  instants.resize(1);
  job.load_sets.front().fixed["x1"] = {true, true, false};
  EXPECT_EQ(words_for(job), (Words{"plane-stress", "layered"}));
}

TEST(ModelList, OneAskedForStandsAloneOrIsRefused) {
  PartJob job = pressed_ring();
  for (const ModelTraits& model : kModels) {
    job.model = model.kind;
    EXPECT_EQ(words_for(job), (Words{model.word}));
  }
  job.load_sets.front().fixed["x1"] = {true, false, true};
  for (const ModelKind kind :
       {ModelKind::kPlaneStress, ModelKind::kRevolution}) {
    job.model = kind;
    try {
      words_for(job);
      FAIL() << traits_of(kind).word;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), "F005");
    }
  }
  job.model = ModelKind::kLayered;  // dear where held across, but it suits
  EXPECT_EQ(words_for(job), (Words{"layered"}));
}

TEST(ModelList, ImpactsVibrationAndModesTakeModelsThatAnswerInTime) {
  PartJob job = pressed_ring();
  const auto cheapest = [&job] {
    return cheapest_in_time(PartShape(job)).traits.word;
  };
  const auto finest = [&job] {
    return finest_in_time(PartShape(job)).traits.word;
  };
  EXPECT_EQ(cheapest(), "plane-stress");
  EXPECT_EQ(finest(), "3d");
  job.model = ModelKind::kSolid;
  EXPECT_EQ(cheapest(), "3d");
  job.model = ModelKind::kRevolution;  // which does not
  EXPECT_EQ(cheapest(), "plane-stress");
  job.model.reset();
  auto& set = job.load_sets.front();
  set.fixed["x1"] = {true, true, false};
  EXPECT_EQ(finest(), "plane-stress");
  set.fixed["x1"] = {true, true, true};
  EXPECT_EQ(cheapest(), "3d");
  set.history = {};  // modes have no loads
  set.fixed["x1"] = {true, true, false};
  EXPECT_EQ(finest(), "plane-stress");
}

// Nested dissection of a cube of n³ nodes takes some 10 n⁶ products of blocks
// of 3 x 3: 2e12 of 13³ · 6 tetrahedra of degree 4, 7e9 of 4³ · 6.
TEST(SolidModel, LeavesOutADegreeOfManyTetrahedraThatWouldTakeMinutes) {
  const auto cube = [](int n) {
    PartJob job;
    job.mesh = support::simplex_mesh<3>({n, n, n}, 1, [](const Vector3d& x) {
      return x;
    });
    return job;
  };
  const auto model_of = [](const PartJob& job) {
    return std::get<FeModel<3>>(solid_model(PartShape(job), {}));
  };
  const PartJob small = cube(4), large = cube(13);
  EXPECT_EQ(model_of(small).highest_degree, 4);
  EXPECT_FALSE(model_of(small).remark);
  const auto model = model_of(large);
  EXPECT_EQ(model.highest_degree, 3);
  PartResult result;
  result.peak.verdict = PeakVerdict::kNotConverged;
  model.remark(result);
  EXPECT_NE(result.stopped_because.find("degree 4 is left out"),
            std::string::npos);
  result = {};
  result.peak.verdict = PeakVerdict::kConverged;
  model.remark(result);
  EXPECT_EQ(result.stopped_because, "");
}

}  // namespace
}  // namespace clevis::assessment

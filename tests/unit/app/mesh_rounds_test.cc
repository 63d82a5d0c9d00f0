#include "app/solids/mesh_rounds.h"

#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "base/messages/errors.h"

namespace clevis::app {
namespace {

using assessment::PartAssessment;
using assessment::PartJob;
using assessment::PeakVerdict;
using Eigen::Vector3d;

constexpr double kTolerance = 0.01;

PartJob part_of(std::size_t cells) {
  PartJob job;
  job.tolerance = kTolerance;
  job.mesh.cells.resize(cells);
  return job;
}

/// The answer of a check whose peak is open by so much [1].
PartAssessment open_by(double mesh, PeakVerdict verdict) {
  PartAssessment assessment;
  assessment.result.peak.value = 100e6;
  assessment.result.peak.verdict = verdict;
  assessment.result.peak.shares.mesh = mesh * 100e6;
  assessment.result.seconds.factor = 2.0;
  assessment.result.seconds.total = 3.0;
  return assessment;
}

/// A part that is checked, open by `opens` one after the other, and what was
/// asked for meanwhile.
struct Rounds {
  std::vector<double> opens;
  std::size_t more = 100;  ///< cells per round
  std::vector<bool> may_be_finer = {};
  std::vector<cad::Refinement> finer = {};
  int dim = 3;  ///< of the model
  std::vector<bool> in_space = {};
  bool is_judged = false;  ///< though it is open
  std::vector<double> late_after = {};

  CheckedPart start(std::size_t cells, int rounds,
                    std::optional<double> seconds = std::nullopt) {
    return check_in_rounds(
        part_of(cells), {rounds, seconds},
        [this](const PartJob& job) {
          const double open = opens.at(may_be_finer.size());
          may_be_finer.push_back(job.may_be_meshed_finer);
          if (job.late_after) late_after.push_back(std::round(*job.late_after));
          auto answer =
              open_by(open, open > kTolerance ? PeakVerdict::kNotConverged
                                              : PeakVerdict::kConverged);
          answer.fields.dim = dim;
          answer.is_judged = is_judged;
          return answer;
        },
        [this, cells](const cad::Refinement& refinement, bool by_solid) {
          in_space.push_back(by_solid);
          finer.push_back(refinement);
          return part_of(cells + finer.size() * more);
        });
  }
};

TEST(MeshRounds, EndWhereTheMeshLeavesNoMoreThanTheTolerance) {
  Rounds run{{0.05, 0.004}};
  const CheckedPart checked = run.start(1000, 5);
  EXPECT_EQ(run.may_be_finer, (std::vector{true, true}));
  EXPECT_EQ(checked.job.mesh.cells.size(), 1100U);
  ASSERT_EQ(checked.assessment.result.notes.size(), 1U);
  EXPECT_NE(checked.assessment.result.notes[0].find(
                "1000 cells left 5 % open, now 1100"),
            std::string::npos);
}

TEST(MeshRounds, TellWhetherSolidCellsAreFarOff) {
  Rounds far{{0.26, 0.004}}, near{{0.24, 0.004}}, plate{{0.26, 0.004}};
  plate.dim = 2;
  for (Rounds* run : {&far, &near, &plate}) run->start(1000, 5);
  EXPECT_EQ(far.in_space, std::vector{true});
  EXPECT_EQ(near.in_space, std::vector{false});
  EXPECT_EQ(plate.in_space, std::vector{false});
  // What is meshed in space stays so, however little is left.
  Rounds again{{0.26, 0.04, 0.004}};
  again.start(1000, 5);
  EXPECT_EQ(again.in_space, (std::vector{true, true}));
}

TEST(MeshRounds, CheckAMeshOfHardlyMoreCellsWithAllDegrees) {
  Rounds run{{0.0109, 0.0018}};
  run.more = 30;  // 3 %
  EXPECT_EQ(run.start(1000, 2).job.mesh.cells.size(), 1030U);
  EXPECT_EQ(run.may_be_finer, (std::vector{true, false}));
  // Where that does not close it another mesh does, if there may be one.
  Rounds stays{{0.02, 0.015, 0.004}};
  stays.more = 30;
  EXPECT_EQ(stays.start(1000, 2).job.mesh.cells.size(), 1060U);
  EXPECT_EQ(stays.may_be_finer, (std::vector{true, false, false}));
  // Far off, or of many more cells: the mesh comes first.
  Rounds far{{0.05, 0.004}}, more{{0.0109, 0.004}};
  far.more = 30;
  more.more = 150;
  far.start(1000, 2);
  more.start(1000, 2);
  EXPECT_EQ(far.may_be_finer, (std::vector{true, true}));
  EXPECT_EQ(more.may_be_finer, (std::vector{true, true}));
}

TEST(MeshRounds, CheckTheLastMeshWithAllDegrees) {
  Rounds run{{0.05, 0.03, 0.02}};
  const CheckedPart checked = run.start(1000, 2);
  EXPECT_EQ(run.may_be_finer, (std::vector{true, true, false}));
  EXPECT_EQ(checked.assessment.result.notes.size(), 2U);
}

TEST(MeshRounds, EndWhereTheMeshComesOutAsItWas) {
  Rounds run{{0.05, 0.05}};
  run.more = 0;
  const CheckedPart checked = run.start(1000, 5);
  EXPECT_EQ(run.may_be_finer, (std::vector{true, false}));
  ASSERT_EQ(checked.assessment.result.notes.size(), 1U);
  EXPECT_EQ(checked.assessment.result.notes[0],
            "not meshed finer: the mesh comes out as it was");
}

TEST(MeshRounds, CountTheSecondsOfAll) {
  Rounds run{{0.05, 0.004}};
  const auto& seconds = run.start(1000, 2).assessment.result.seconds;
  EXPECT_DOUBLE_EQ(seconds.factor, 4.0);
  EXPECT_GE(seconds.total, 6.0);
}

TEST(MeshRounds, StopAt20000Cells) {
  Rounds run{{0.05}};
  const CheckedPart checked = run.start(20001, 2);
  EXPECT_EQ(run.may_be_finer, (std::vector{false}));
  EXPECT_TRUE(run.finer.empty());
  ASSERT_EQ(checked.assessment.result.notes.size(), 1U);
  EXPECT_NE(checked.assessment.result.notes[0].find(
                "20001 cells leave 5 % open; a finer mesh would take minutes"),
            std::string::npos);
  Rounds below{{0.05, 0.03}, 1};
  EXPECT_EQ(below.start(20000, 2).job.mesh.cells.size(), 20001U);
  EXPECT_EQ(below.may_be_finer, (std::vector{true, false}));
}

// Each check takes 3 s.
TEST(MeshRounds, StopWhereTheTimeIsOver) {
  // It is judged once more by the degrees that it has.
  Rounds run{{0.05, 0.03, 0.03}};
  const CheckedPart checked = run.start(1000, 5, 5.0);
  EXPECT_EQ(run.may_be_finer, (std::vector{true, true, true}));
  EXPECT_TRUE(checked.job.judges_open_peak);
  EXPECT_EQ(checked.job.mesh.cells.size(), 1100U);
  ASSERT_EQ(checked.assessment.result.notes.size(), 2U);
  EXPECT_NE(checked.assessment.result.notes[1].find(
                "no finer mesh and no higher degree: the part took 6"),
            std::string::npos)
      << checked.assessment.result.notes[1];
  // Nor that, where the check knew that it was late.
  Rounds judged{{0.05, 0.03}};
  judged.is_judged = true;
  judged.start(1000, 5, 5.0);
  EXPECT_EQ(judged.late_after, (std::vector{5.0, 2.0}));
  Rounds in_time{{0.05, 0.004}};
  EXPECT_EQ(in_time.start(1000, 5, 100.0).assessment.result.notes.size(), 1U);
}

TEST(MeshRounds, NoneWhereNoneIsWanted) {
  Rounds run{{0.05}};
  EXPECT_TRUE(run.start(1000, 0).assessment.result.notes.empty());
  EXPECT_EQ(run.may_be_finer, (std::vector{false}));
}

TEST(MeshRounds, WhatNoMeshClosesTakesAllDegrees) {
  std::vector<bool> may_be_finer;
  check_in_rounds(
      part_of(1000), {2, std::nullopt},
      [&](const PartJob& job) {
        may_be_finer.push_back(job.may_be_meshed_finer);
        return open_by(0.004, PeakVerdict::kNotConverged);
      },
      [](const cad::Refinement&, bool) -> PartJob {
        throw std::logic_error("meshed again");
      });
  EXPECT_EQ(may_be_finer, (std::vector{true, false}));
}

/// Two rounds of an open part whose finer mesh is refused.
/// @param may_be_finer  whether its mesh could be, check by check.
CheckedPart refused_by(const Error& error, std::vector<bool>& may_be_finer) {
  return check_in_rounds(
      part_of(1000), {2, std::nullopt},
      [&](const PartJob& job) {
        may_be_finer.push_back(job.may_be_meshed_finer);
        return open_by(0.05, PeakVerdict::kNotConverged);
      },
      [&](const cad::Refinement&, bool) -> PartJob {
        throw Error(error);
      });
}

TEST(MeshRounds, KeepTheMeshWhereNoFinerOneCanBeMade) {
  std::vector<bool> may_be_finer;
  const CheckedPart checked = refused_by(
      Error("M010", "part.step", "gmsh says no", "Repair it."), may_be_finer);
  EXPECT_EQ(may_be_finer, (std::vector{true, false}));
  EXPECT_EQ(checked.job.mesh.cells.size(), 1000U);
  EXPECT_EQ(checked.assessment.result.notes,
            std::vector<std::string>{"not meshed finer: gmsh says no"});
}

TEST(MeshRounds, KeepTheMeshWhereAFinerOneHasTooManyUnknowns) {
  std::vector<bool> may_be_finer;
  const CheckedPart checked = refused_by(
      Error("F007", "part bar", "9 degrees of freedom", "Give more."),
      may_be_finer);
  EXPECT_EQ(may_be_finer, (std::vector{true, false}));
  EXPECT_EQ(checked.assessment.result.notes,
            std::vector<std::string>{"not meshed finer: 9 degrees of freedom"});
}

TEST(FinerMesh, IsFinerWhereTheErrorIsLarger) {
  const Vector3d small(1.0, 0.0, 0.0), large(0.0, 2.0, 0.0);
  const auto finer =
      finer_mesh({}, {{small, 1.5}, {large, 3.0}, {large, 50.0}}, {});
  EXPECT_EQ(finer.everywhere, 1.0);
  ASSERT_EQ(finer.at.size(), 3U);
  EXPECT_EQ(finer.at[0].at, small);
  EXPECT_LT(finer.at[0].times, finer.at[1].times);
  EXPECT_DOUBLE_EQ(finer.at[2].times, 6.0);
}

TEST(FinerMesh, WithoutPlacesIsFinerEverywhere) {
  const Vector3d peak(1.0, 2.0, 3.0);
  const auto finer = finer_mesh(finer_mesh({}, {}, peak), {}, peak);
  EXPECT_DOUBLE_EQ(finer.everywhere, 1.25 * 1.25);
  ASSERT_EQ(finer.at.size(), 2U);
  EXPECT_EQ(finer.at[1].at, peak);
}

}  // namespace
}  // namespace clevis::app

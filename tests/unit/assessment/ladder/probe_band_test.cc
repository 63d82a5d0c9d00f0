#include "assessment/ladder/probe_band.h"

#include <gtest/gtest.h>

#include "support/structured_mesh.h"

namespace clevis::assessment {
namespace {

DegreeLadder<2> ladder_with(double jump) {
  static const PartJob job;
  DegreeLadder<2> ladder(
      job, support::structured_mesh<2>({1, 1}, 1, [](const auto& x) {
        return x;
      }));
  for (const auto& [degree, value] :
       {std::pair{2, 100.0}, {3, 101.0}, {4, 101.1}}) {
    SequenceMember member;
    member.degree = degree;
    ladder.sequence.push_back(member);
    ladder.probes.push_back({{value, jump}});
  }
  return ladder;
}

// The sequence comes to rest within 0.1; the cells differ by 6.
TEST(ProbeBand, HoldsHalfTheJumpOfTheCellsThatMeet) {
  const auto alike =
      probe_band<2>(ladder_with(0.0), 0, "pull", "von_mises", 0.01);
  EXPECT_LT(alike.high - alike.low, 0.5);
  const auto apart =
      probe_band<2>(ladder_with(6.0), 0, "pull", "von_mises", 0.01);
  EXPECT_LE(apart.low, apart.value - 3.0);
  EXPECT_GE(apart.high, apart.value + 3.0);
}

TEST(ProbeBand, OfThePartsToleranceOfThePeak) {
  PartJob job;
  part::LoadCaseDefinition& pull = job.part.cases.emplace_back();
  pull.name = "pull";
  pull.probes = {{"corner", {0.0, 0.0, 0.0}, "von_mises"}};
  for (const auto& [jump, is_within] : {std::pair{2.0, true}, {6.0, false}}) {
    auto ladder = ladder_with(jump);
    ladder.level.member.peak = 200.0;
    EXPECT_EQ(probes_are_within(ladder, job, 0.01), is_within) << jump;
  }
}

}  // namespace
}  // namespace clevis::assessment

#include "assessment/ladder/governing_instants.h"

#include <gtest/gtest.h>

namespace clevis::assessment {
namespace {

/// A motion of 201 instants, 10 ms apart.
PartJob moving_part() {
  PartJob job;
  LoadSet set;
  for (int i = 0; i < 201; ++i) {
    loads::InstantLoad instant;
    instant.time = 0.01 * i;
    set.history.instants.push_back(instant);
  }
  job.load_sets = {set};
  return job;
}

/// The job's set with some of its instants.
std::vector<LoadSet> governed_by(const PartJob& job,
                                 const std::vector<std::size_t>& instants) {
  LoadSet chosen = job.load_sets.front();
  chosen.history.instants.clear();
  for (const std::size_t i : instants) {
    chosen.history.instants.push_back(
        job.load_sets.front().history.instants[i]);
  }
  return {chosen};
}

TEST(GoverningInstants, KeepsTheGoverningOnesAndTheirNeighbours) {
  const PartJob job = moving_part();
  const GoverningInstants chosen(job, governed_by(job, {0, 100}));
  ASSERT_EQ(chosen.sets().size(), 1U);
  EXPECT_EQ(chosen.sets()[0].history.instants.size(), 4U + 7U);
  EXPECT_TRUE(chosen.contains(0, 3));
  EXPECT_FALSE(chosen.contains(0, 4));
  EXPECT_FALSE(chosen.contains(0, 96));
  EXPECT_TRUE(chosen.contains(0, 97));
  EXPECT_FALSE(chosen.contains(0, 200));
}

TEST(GoverningInstants, AreNoneWhereTheySaveNothing) {
  PartJob job = moving_part();
  EXPECT_TRUE(GoverningInstants(job, {}).sets().empty());
  job.load_sets.front().history.instants.resize(9);
  EXPECT_TRUE(GoverningInstants(job, governed_by(job, {4})).sets().empty());
}

TEST(GoverningInstants, AreNoneWhereProbesWantEveryDegree) {
  PartJob job = moving_part();
  part::LoadCaseDefinition load_case;
  load_case.probes.resize(1);
  job.part.cases = {load_case};
  EXPECT_TRUE(GoverningInstants(job, governed_by(job, {0})).sets().empty());
}

}  // namespace
}  // namespace clevis::assessment

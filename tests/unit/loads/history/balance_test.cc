#include "loads/history/balance.h"

#include <vector>

#include <gtest/gtest.h>

#include "base/messages/errors.h"

namespace clevis::loads {
namespace {

using Eigen::Vector3d;

part::MassProperties mass_of(double mass, const Vector3d& centre) {
  part::MassProperties result;
  result.mass = mass;
  result.p_LCm = centre;
  result.inertia_LCm = (mass * Vector3d(2e-4, 3e-4, 4e-4)).asDiagonal();
  return result;
}

// Balanced by one mesh's inertia, then by that of another.
TEST(Balance, FloatsOnTheMassOfAnotherMesh) {
  const auto coarse = mass_of(0.2, {0.01, 0.02, -0.005});
  const auto fine = mass_of(0.2001, {0.01001, 0.02, -0.00501});
  LoadHistory history;
  history.seats.emplace_back().p_LS = {0.03, -0.01, 0.0};
  InstantLoad& instant = history.instants.emplace_back();
  instant.wrenches.push_back({{200.0, -30.0, 5.0}, {0.1, -0.2, 0.3}});
  instant.rigid.omega = {0.0, 3.0, 60.0};
  float_on(coarse, history);
  const auto off = [&](const part::MassProperties& mass) {
    return imbalance(history, instant, mass, 0.1).relative();
  };
  EXPECT_LT(off(coarse), 1e-13);
  EXPECT_GT(off(fine), 1e-6);
  EXPECT_THROW(require_balance(history, fine, 0.1, "part"), Error);
  float_on(fine, history);
  EXPECT_LT(off(fine), 1e-13);
  EXPECT_NO_THROW(require_balance(history, fine, 0.1, "part"));
}

// Faces of a ring that spins about its middle all have theirs there.
TEST(Balance, ARingHasTheSizeOfItsGyration) {
  auto ring = mass_of(0.4, Vector3d::Zero());
  ring.inertia_LCm = Vector3d(5e-4, 5e-4, 1e-3).asDiagonal();
  std::vector<GroupGeometry> groups(2);
  EXPECT_NEAR(part_size(groups, ring), 0.1, 1e-12);
  groups[1].centroid = {0.3, 0.0, 0.4};  // farther out
  EXPECT_NEAR(part_size(groups, ring), 0.5, 1e-12);
}

// Shares of next to nothing of a loaded mechanism carry the round-off of that.
TEST(Balance, RoundOffOfTheMechanismIsNoLoad) {
  const auto mass = mass_of(0.2, {0.0, 0.0, 0.0});
  LoadHistory history;
  history.seats.resize(2);
  InstantLoad& instant = history.instants.emplace_back();
  instant.wrenches = {{.force = {1e-6, 0.0, 0.0}},
                      {.force = {-1e-6 + 2e-12, 0.0, 0.0}}};
  EXPECT_THROW(require_balance(history, mass, 0.1, "part"), Error);
  EXPECT_NO_THROW(require_balance(history, mass, 0.1, "part", 3e4));
  EXPECT_THROW(require_balance(history, mass, 0.1, "part", 3e2), Error);
}

// Couples press a part as forces at its ends do: what they leave of a force by
// round-off is no load.
TEST(Balance, CouplesAloneBalance) {
  const auto mass = mass_of(0.2, {0.0, 0.0, 0.0});
  const double size = 0.1, couple = 30.0;
  LoadHistory history;
  history.seats.resize(2);
  InstantLoad& instant = history.instants.emplace_back();
  const auto leave = [&](double force) {
    instant.wrenches = {
        {.force = {force, 0.0, 0.0}, .moment = {0.0, 0.0, couple}},
        {.moment = {0.0, 0.0, -couple}}};
  };
  leave(2e-13);
  EXPECT_NO_THROW(require_balance(history, mass, size, "part"));
  leave(1e-3 * couple / size);
  EXPECT_THROW(require_balance(history, mass, size, "part"), Error);
}

}  // namespace
}  // namespace clevis::loads

#include "mechanism/sampling/slide_times.h"

#include <algorithm>
#include <cmath>

#include "base/values/index.h"

namespace clevis::mechanism {
namespace {

using Eigen::Matrix3Xd;

// Ways of a slide from instant to instant, over all of its way: a bending
// moment that is a parabola of the place is then met to (1/64)^2 = 2.4e-4.
constexpr double kStep = 1.0 / 64.0;
constexpr std::size_t kMost = 4000;  // times
constexpr double kRest = 1e-9;       // of where it stands: round-off, no way

/// Where a joint stands on its body a at each instant [m].
Matrix3Xd places(const JointDefinition& joint, int j,
                 const std::vector<Instant>& instants) {
  Matrix3Xd result(3, static_cast<Eigen::Index>(instants.size()));
  for (std::size_t i = 0; i < instants.size(); ++i) {
    part::Pose a;
    if (joint.body_a != kGround)
      a = instants[i].bodies[index(joint.body_a)].pose;
    result.col(static_cast<Eigen::Index>(i)) =
        a.R_WL.transpose() * (instants[i].joints[index(j)].p_WJ - a.p_WL);
  }
  return result;
}

}  // namespace

std::vector<double> slide_times(const MechanismDefinition& definition,
                                const std::vector<int>& slides,
                                const std::vector<Instant>& instants) {
  // parts of each gap that one of the slides asks for
  std::vector<double> parts(instants.size(), 1.0);
  for (const int j : slides) {
    const Matrix3Xd at = places(definition.joints[index(j)], j, instants);
    const double way =
        (at.rowwise().maxCoeff() - at.rowwise().minCoeff()).norm();
    double far = 0.0;
    for (const Instant& instant : instants) {
      far = std::max(far, instant.joints[index(j)].p_WJ.norm());
    }
    if (!(way > kRest * far)) continue;
    for (std::size_t i = 0; i + 1 < instants.size(); ++i) {
      const auto k = static_cast<Eigen::Index>(i);
      const double step = (at.col(k + 1) - at.col(k)).norm() / way;
      parts[i] = std::max(parts[i], std::ceil(step / kStep));
    }
  }
  double more = 0.0;
  for (const double count : parts) more += count - 1.0;
  const double coarser = std::max(1.0, more / static_cast<double>(kMost));
  std::vector<double> times;
  for (std::size_t i = 0; i + 1 < instants.size(); ++i) {
    const double count = std::ceil(parts[i] / coarser);
    for (double k = 1.0; k < count; k += 1.0) {
      times.push_back(instants[i].t +
                      k / count * (instants[i + 1].t - instants[i].t));
    }
  }
  return times;
}

}  // namespace clevis::mechanism

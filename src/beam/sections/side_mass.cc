#include "beam/sections/side_mass.h"

#include <algorithm>
#include <cstddef>

#include <Eigen/Geometry>

namespace clevis::beam {

using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

Matrix3d spread(const Vector3d& p) {
  return p.squaredNorm() * Matrix3d::Identity() - p * p.transpose();
}

// a + factor · b
MassMoments combined(const MassMoments& a, double factor,
                     const MassMoments& b) {
  return {a.mass + factor * b.mass, a.first + factor * b.first,
          a.second + factor * b.second};
}

}  // namespace

MassMoments& MassMoments::operator+=(const MassMoments& other) {
  return *this = combined(*this, 1.0, other);
}

MassMoments moments_of(const part::MassProperties& mass) {
  return {mass.mass, mass.mass * mass.p_LCm,
          mass.inertia_LCm + mass.mass * spread(mass.p_LCm)};
}

loads::Wrench inertia_of(const MassMoments& moments,
                         const loads::RigidAcceleration& rigid) {
  const Vector3d& omega = rigid.omega;
  const Vector3d& first = moments.first;
  const Vector3d spin = moments.second * omega;
  return {
      .force = -(moments.mass * rigid.acceleration + rigid.alpha.cross(first) +
                 omega.cross(omega.cross(first))),
      .moment = -(first.cross(rigid.acceleration) +
                  moments.second * rigid.alpha + omega.cross(spin))};
}

std::vector<MassMoments> moments_beyond(const std::vector<Lump>& lumps,
                                        const part::MassProperties& mass,
                                        const Vector3d& direction,
                                        const std::vector<double>& positions) {
  double volume = 0.0;
  for (const Lump& lump : lumps) volume += lump.volume;
  // Material between neighbouring planes, then summed from the far end.
  std::vector<MassMoments> slices(positions.size() + 1);
  for (const Lump& lump : lumps) {
    const auto plane =
        std::ranges::lower_bound(positions, lump.p_LQ.dot(direction));
    const double m = mass.mass * lump.volume / volume;
    slices[static_cast<std::size_t>(plane - positions.begin())] +=
        {m, m * lump.p_LQ, m * spread(lump.p_LQ)};
  }
  std::vector<MassMoments> beyond(positions.size());
  MassMoments sum;
  for (std::size_t i = positions.size(); i-- > 0;) {
    sum += slices[i + 1];
    beyond[i] = sum;
  }
  if (lumps.empty() || mass.mass == 0.0) return beyond;
  sum += slices[0];
  const MassMoments missed = combined(moments_of(mass), -1.0, sum);
  for (MassMoments& side : beyond) {
    side = combined(side, side.mass / mass.mass, missed);
  }
  return beyond;
}

}  // namespace clevis::beam

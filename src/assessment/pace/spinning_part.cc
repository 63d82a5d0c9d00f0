#include "assessment/pace/spinning_part.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <fmt/format.h>

#include "assessment/pace/acting_forces.h"
#include "assessment/pace/load_pace.h"
#include "assessment/verdict/governing_peak.h"
#include "loads/history/turning_loads.h"

namespace clevis::assessment {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// Axis of the least inertia, in L.
Vector3d length_axis(const PartJob& job) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> inertia(
      job.mass.inertia_LCm);
  return inertia.eigenvectors().col(0);
}

/// The angle by which the part has turned about its length at each instant.
VectorXd turned(const LoadSet& motion, const Vector3d& axis) {
  const auto& instants = motion.history.instants;
  VectorXd angles = VectorXd::Zero(static_cast<Index>(instants.size()));
  for (Index i = 1; i < angles.size(); ++i) {
    const auto& before = instants[static_cast<std::size_t>(i - 1)];
    const auto& here = instants[static_cast<std::size_t>(i)];
    angles[i] = angles[i - 1] +
                0.5 * (here.time - before.time) *
                    (here.rigid.omega.dot(axis) + before.rigid.omega.dot(axis));
  }
  return angles;
}

/// Visits the vectors of an instant's loads that turn with the part.
template <class Visit>
void visit_vectors(loads::InstantLoad& instant, const Visit& visit) {
  for (loads::Wrench& wrench : instant.wrenches) {
    visit(wrench.force);
    visit(wrench.moment);
  }
  for (auto& load : instant.surface_loads) {
    visit(load.resultant.force);
    visit(load.resultant.moment);
  }
  visit(instant.rigid.acceleration);
  visit(instant.rigid.alpha);
}

/// Takes out what of the loads turns with a part that turns on at one speed.
void take_common_out(const VectorXd& angles, LoadSet& motion) {
  std::vector<std::vector<Vector3d*>> vectors;
  for (loads::InstantLoad& instant : motion.history.instants) {
    auto& of_instant = vectors.emplace_back();
    visit_vectors(instant, [&](Vector3d& vector) {
      of_instant.push_back(&vector);
    });
  }
  const auto count = static_cast<Index>(vectors.front().size());
  MatrixXd values(angles.size(), 3 * count);
  for (Index i = 0; i < angles.size(); ++i) {
    for (Index k = 0; k < count; ++k) {
      values.row(i).segment<3>(3 * k) =
          vectors[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)]
              ->transpose();
    }
  }
  const VectorXd common = loads::share_that_turns_with(angles, values);
  for (auto& of_instant : vectors) {
    for (Index k = 0; k < count; ++k) {
      *of_instant[static_cast<std::size_t>(k)] -= common.segment<3>(3 * k);
    }
  }
}

/// The motion's loads as they stand in space, turned by the part's spin, less
/// what turns with it.
LoadSet loads_in_space(const PartJob& job, LoadSet motion) {
  constexpr double kSteady = 0.02;
  constexpr Index kFewest = 8;
  const Vector3d axis = length_axis(job);
  const VectorXd angles = turned(motion, axis);
  auto& instants = motion.history.instants;
  const double speed = instants.front().rigid.omega.dot(axis);
  const bool is_steady =
      std::ranges::all_of(instants, [&](const loads::InstantLoad& instant) {
        return std::abs(instant.rigid.omega.dot(axis) - speed) <=
               kSteady * std::abs(speed);
      });
  if (is_steady && angles.size() >= kFewest &&
      std::abs(angles[angles.size() - 1]) >= std::numbers::pi) {
    take_common_out(angles, motion);
  }
  for (Index i = 0; i < angles.size(); ++i) {
    const Eigen::Matrix3d turn =
        Eigen::AngleAxisd(angles[i], axis).toRotationMatrix();
    auto& instant = instants[static_cast<std::size_t>(i)];
    visit_vectors(instant, [&](Vector3d& vector) {
      vector = turn * vector;
    });
    instant.rigid.omega = turn * instant.rigid.omega;
  }
  return motion;
}

/// How far a load that stands in space swings a part whose sections are uneven:
/// its sag changes twice a turn, over the largest change [1]. Resonance at half
/// of the first frequency.
/// @param share  speed of spin over the first frequency [1].
double uneven_swing(const PartJob& job, double share) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> inertia(
      job.mass.inertia_LCm, Eigen::EigenvaluesOnly);
  const Vector3d& of = inertia.eigenvalues();
  const double uneven = (of[2] - of[1]) / of[0];
  const double rest =
      std::max(std::abs(1.0 - 4.0 * share * share), 2.0 * job.part.damping);
  return uneven * std::max(0.0, 1.0 / rest - 1.0);
}

/// Turn about other axes than the part's length [rad/s].
double turn_across(const loads::InstantLoad& instant, const Vector3d& axis) {
  const Vector3d& omega = instant.rigid.omega;
  return (omega - omega.dot(axis) * axis).norm();
}

/// Of what stiffens and what pulls on, over the square of the fastest turn: of
/// a cantilever 1.2 and 1.6 times its root's arm over its length, outwards 1.
double largest_shift(const PartJob& job, const LoadSet& motion, double fastest,
                     const Vector3d& axis) {
  constexpr double kOwn = 1.25, kArm = 1.6, kTurns = 0.3;
  double arm = 0.0;  // of the part's origin, by what it is accelerated [m]
  for (const loads::InstantLoad& instant : motion.history.instants) {
    const double turn = turn_across(instant, axis);
    if (!(turn > kTurns * fastest)) continue;
    arm = std::max(arm, instant.rigid.acceleration.norm() / (turn * turn));
  }
  return kOwn + kArm * arm / job.sides()[2];
}

}  // namespace

double spin_about_length(const PartJob& job, const LoadSet& set) {
  const Vector3d axis = length_axis(job);
  double most = 0.0;
  for (const loads::InstantLoad& instant : set.history.instants) {
    most = std::max(most, std::abs(instant.rigid.omega.dot(axis)));
  }
  return most;
}

bool spins_fast(const PartJob& job, const LoadSet& motion, double first) {
  constexpr double kCounts = 0.01;  // of its first frequency: of its damping
  return spin_about_length(job, motion) * first >
         kCounts * 2.0 * std::numbers::pi;
}

bool stand_in_space(const PartJob& job, const LoadSet& motion, double first) {
  // Of what changes in the part's frame: the angle's own error. Of all:
  // round-off of what turns with it.
  constexpr double kStill = 1e-5, kRoundOff = 1e-10;
  const double share =
      spin_about_length(job, motion) * first / (2.0 * std::numbers::pi);
  if (uneven_swing(job, share) > kPaceCounts - 1.0) return false;
  const LoadSet in_space = loads_in_space(job, motion);
  // Without what holds the part together as it spins, which dwarfs the rest.
  const auto forces = [&](LoadSet set) {
    for (auto& instant : set.history.instants) instant.rigid.omega.setZero();
    return ActingForces(job, set).values();
  };
  const auto change = [](const MatrixXd& values) {
    return (values.colwise() - values.col(0)).lpNorm<Eigen::Infinity>();
  };
  const MatrixXd here = forces(motion);
  if (change(forces(in_space)) <=
      kStill * change(here) + kRoundOff * here.lpNorm<Eigen::Infinity>()) {
    return true;
  }
  return load_spectrum(job, load_components(job, in_space), first)
             .amplification <= kPaceCounts;
}

TurningPart turning_part(const PartJob& job, const LoadSet& motion,
                         double first) {
  constexpr double kCounts = 0.02;  // moves a frequency by 5e-4 or less
  const Vector3d axis = length_axis(job);
  double fastest = 0.0;
  for (const loads::InstantLoad& instant : motion.history.instants) {
    fastest = std::max(fastest, turn_across(instant, axis));
  }
  TurningPart part{.speed = fastest * first / (2.0 * std::numbers::pi)};
  if (part.speed >= kCounts) {
    part.shift =
        largest_shift(job, motion, fastest, axis) * part.speed * part.speed;
  }
  return part;
}

std::string not_known_by_spin(
    const PartJob& job, const PartResult& result, const LoadSet& motion,
    const std::vector<elasticity::SeatShapes::Moved>& frequencies) {
  // Steps and pulses answer 1 to 2 at any frequency.
  constexpr double kFirst = 1.1, kLater = 2.0;
  constexpr std::size_t kPair = 2;  // of a part that bends both ways alike
  constexpr double kCounts = 1e-3, kWidth = 0.02;
  constexpr double kTurn = 2.0 * std::numbers::pi;
  const dynamics::LoadPath components = load_components(job, motion);
  for (std::size_t k = 0; k < frequencies.size(); ++k) {
    const auto& [still, moved] = frequencies[k];
    const double ratio = moved / still;
    if (std::abs(ratio - 1.0) < kCounts) continue;
    const double low = std::min(1.0, (1.0 - kWidth) * ratio);
    const double high = std::max(1.0, (1.0 + kWidth) * ratio);
    const double rise =
        rise_near(job, components, kTurn / still, low * low, high * high);
    if (rise <= (k < kPair ? kFirst : kLater) ||
        !rise_decides(job.part, result, rise)) {
      continue;
    }
    return fmt::format(
        "a body that spins on it moves its frequency of {:.3g} Hz to {:.3g} "
        "Hz, and its gyroscopic moment is not in the vibration: it may swing "
        "{:.2g} times as far",
        still / kTurn, moved / kTurn, rise);
  }
  return {};
}

}  // namespace clevis::assessment

#include "assessment/vibration/load_pace.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/QR>

#include "loads/history/motion_instants.h"

namespace clevis::assessment {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// Forces, and moments over the size, that act on the surface and, of a mass in
/// its far corner, by inertia [N].
VectorXd acting_forces(const loads::InstantLoad& instant, double mass,
                       double size) {
  std::vector<double> all;
  const auto put = [&](const loads::Wrench& wrench) {
    all.insert(all.end(), wrench.force.begin(), wrench.force.end());
    for (const double moment : wrench.moment) all.push_back(moment / size);
  };
  for (const loads::Wrench& wrench : instant.wrenches) put(wrench);
  for (const auto& load : instant.surface_loads) {
    put(load.resultant);
    all.push_back(load.total);
  }
  const loads::RigidAcceleration& rigid = instant.rigid;
  for (int k = 0; k < 3; ++k) {
    all.push_back(mass * rigid.acceleration[k]);
    all.push_back(mass * size * rigid.alpha[k]);
    for (int i = 0; i <= k; ++i) {
      all.push_back(mass * size * rigid.omega[i] * rigid.omega[k]);
    }
  }
  return Eigen::Map<const VectorXd>(all.data(), static_cast<Index>(all.size()));
}

/// From the longest to the shortest, each so much of the one before.
VectorXd falling(double longest, double shortest, double step) {
  const auto count = static_cast<Index>(
      std::ceil(std::log(shortest / longest) / std::log(step)));
  VectorXd periods(count + 1);
  for (Index i = 0; i <= count; ++i) {
    periods[i] = longest * std::pow(step, static_cast<double>(i));
  }
  return periods;
}

/// Of the mechanism, at an end of a bar about its own mass there [kg].
double added_mass(const LoadSet& set, double width) {
  // A quarter of a clamped bar's mass moves with its end.
  constexpr double kAtTheEnd = 4.2, kGyration = 3.5;  // of the width: 1/√12
  if (!set.history.hold || !set.fixed.empty()) return 0.0;
  const MatrixXd weighed = set.history.hold_that_counts().weighed;
  double sum = 0.0;
  for (Index row = 0; row < weighed.rows(); ++row) {
    const bool turns = row % 6 >= 3;
    const double lever = turns ? kGyration / width : 1.0;
    sum += (lever * weighed.row(row)).squaredNorm();
  }
  return kAtTheEnd * sum;
}

// Of the first period or that of waves: shorter ones hold little of a load.
constexpr double kShortest = 0.02;

}  // namespace

LoadSet motion_loads(const LoadSet& set) {
  LoadSet motion = set;
  auto& all = motion.history.instants;
  all.resize(loads::motion_length(set.history));
  all.insert(all.end(), set.history.repeats.begin(), set.history.repeats.end());
  std::ranges::stable_sort(all, {}, &loads::InstantLoad::time);
  motion.history.repeats.clear();
  return motion;
}

LoadSet followed_loads(const LoadSet& set) {
  LoadSet motion = motion_loads(set);
  std::erase_if(motion.history.instants, [&](const loads::InstantLoad& load) {
    return load.time > set.history.followed_until;
  });
  return motion;
}

namespace {

/// Axis of the least inertia, in L.
Vector3d length_axis(const PartJob& job) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> inertia(
      job.mass.inertia_LCm);
  return inertia.eigenvectors().col(0);
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

namespace {

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

/// Takes out what of the loads turns with a part that turns on at one speed:
/// the even share of each component beside sine and cosine of its angle.
void take_common_out(const VectorXd& angles, LoadSet& motion) {
  auto& instants = motion.history.instants;
  MatrixXd terms(angles.size(), 3);
  terms << VectorXd::Ones(angles.size()), angles.array().cos().matrix(),
      angles.array().sin().matrix();
  std::vector<std::vector<Vector3d*>> vectors;
  for (loads::InstantLoad& instant : instants) {
    auto& of_instant = vectors.emplace_back();
    visit_vectors(instant, [&](Vector3d& vector) {
      of_instant.push_back(&vector);
    });
  }
  const Eigen::ColPivHouseholderQR<MatrixXd> fit(terms);
  for (std::size_t k = 0; k < vectors.front().size(); ++k) {
    MatrixXd values(angles.size(), 3);
    for (Index i = 0; i < angles.size(); ++i) {
      values.row(i) = vectors[static_cast<std::size_t>(i)][k]->transpose();
    }
    const Vector3d even = fit.solve(values).row(0);
    for (auto& of_instant : vectors) *of_instant[k] -= even;
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

}  // namespace

namespace {

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

}  // namespace

bool spins_fast(const PartJob& job, const LoadSet& motion, double first) {
  constexpr double kCounts = 0.01;  // of its first frequency: of its damping
  return spin_about_length(job, motion) * first >
         kCounts * 2.0 * std::numbers::pi;
}

bool stand_in_space(const PartJob& job, const LoadSet& motion, double first) {
  constexpr double kStill = 1e-5;  // of the largest: the angle's own error
  const double share =
      spin_about_length(job, motion) * first / (2.0 * std::numbers::pi);
  if (uneven_swing(job, share) > kPaceCounts - 1.0) return false;
  const LoadSet in_space = loads_in_space(job, motion);
  // Without what holds the part together as it spins, which dwarfs the rest.
  const auto forces = [&](const LoadSet& set, std::size_t i) {
    loads::InstantLoad instant = set.history.instants[i];
    instant.rigid.omega.setZero();
    return acting_forces(instant, job.mass.mass, job.sides()[2]);
  };
  const VectorXd start = forces(in_space, 0);
  double largest = 0.0, change = 0.0;
  for (std::size_t i = 0; i < motion.history.instants.size(); ++i) {
    largest = std::max(largest, forces(motion, i).lpNorm<Eigen::Infinity>());
    change = std::max(change,
                      (forces(in_space, i) - start).lpNorm<Eigen::Infinity>());
  }
  if (change <= kStill * largest) return true;
  return load_spectrum(job, load_components(job, in_space), first)
             .amplification <= kPaceCounts;
}

dynamics::LoadPath::Between between_instants(const LoadSet& set) {
  return set.history.rows ? dynamics::LoadPath::Between::kLinear
                          : dynamics::LoadPath::Between::kCubic;
}

dynamics::LoadPath load_components(const PartJob& job, const LoadSet& motion) {
  constexpr double kNothing = 1e-6, kRoundOff = 1e-8;
  const auto& instants = motion.history.instants;
  const auto length = static_cast<Index>(instants.size());
  if (length < 2) return {VectorXd(0), MatrixXd(0, 0), 0.0};
  const double size = job.sides()[2];
  const double mass = job.mass.mass;
  MatrixXd forces(acting_forces(instants.front(), mass, size).size(), length);
  VectorXd time(length);
  for (Index i = 0; i < length; ++i) {
    const auto& instant = instants[static_cast<std::size_t>(i)];
    forces.col(i) = acting_forces(instant, mass, size);
    time[i] = instant.time;
  }
  const double largest = forces.lpNorm<Eigen::Infinity>();
  // What stands still excites nothing, however large beside what changes.
  forces.colwise() -= VectorXd(forces.col(0));
  const VectorXd change = forces.rowwise().lpNorm<Eigen::Infinity>();
  const double least =
      std::max(kNothing * change.maxCoeff(), kRoundOff * largest);
  std::vector<Index> counting;
  for (Index k = 0; k < change.size(); ++k) {
    if (change[k] > least) counting.push_back(k);
  }
  MatrixXd components(static_cast<Index>(counting.size()), length);
  for (Index k = 0; k < components.rows(); ++k) {
    const Index row = counting[static_cast<std::size_t>(k)];
    components.row(k) = forces.row(row) / change[row];
  }
  return {time, components,
          loads::kEventSides * loads::motion_duration(motion.history),
          between_instants(motion)};
}

double period_of_waves(const PartJob& job) {
  return 2.0 * job.sides()[2] *
         std::sqrt(job.part.material.density /
                   job.part.material.youngs_modulus);
}

double longest_period(const PartJob& job, const LoadSet& set) {
  constexpr double kSure = 4.0;  // held at one end: 3.1
  const Eigen::Vector3d sides = job.sides();
  // A free bar of the mean thickness bends in half the waves' period times
  // length over thickness.
  const double thickness =
      job.mass.mass / job.part.material.density / (sides[1] * sides[2]);
  return kSure * period_of_waves(job) * std::max(1.0, sides[2] / thickness) *
         std::sqrt(1.0 + added_mass(set, sides[1]) / job.mass.mass);
}

double longest_period_in_plane(const PartJob& job) {
  constexpr double kSure = 4.0;
  const Eigen::Vector3d sides = job.sides();
  const double thickness =
      job.mass.mass / job.part.material.density / (sides[0] * sides[2]);
  return kSure * period_of_waves(job) * std::max(1.0, sides[2] / thickness);
}

double softest_period(const PartJob& job, const LoadSet& set) {
  constexpr double kSofter = 40.0;
  return kSofter * longest_period(job, set);
}

bool is_slow(const PartJob& job, const LoadSet& set,
             const dynamics::LoadPath& components) {
  constexpr double kStep = 0.9;
  const auto spectrum =
      response_spectrum(components,
                        falling(softest_period(job, set),
                                kShortest * period_of_waves(job), kStep),
                        job.part.damping, kPaceCounts);
  return spectrum.amplification <= kPaceCounts;
}

dynamics::ResponseSpectrum load_spectrum(const PartJob& job,
                                         const dynamics::LoadPath& components,
                                         double first) {
  constexpr double kStep = 0.95;
  const double shortest = kShortest * std::min(first, period_of_waves(job));
  return response_spectrum(components, falling(first, shortest, kStep),
                           job.part.damping, kPaceCounts);
}

}  // namespace clevis::assessment

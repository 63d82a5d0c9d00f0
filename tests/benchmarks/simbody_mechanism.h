#pragma once

#include <cmath>
#include <vector>

#include <Simbody.h>

#include "benchmarks/reference_trajectories.h"

/// What the mechanisms in Simbody share.
namespace clevis::benchmarks {

using SimTK::Vec3;

class SimbodyMechanism {
 public:
  SimbodyMechanism() : matter_(system_), forces_(system_) {}
  virtual ~SimbodyMechanism() = default;

  const SimTK::MultibodySystem& system() const { return system_; }
  const SimTK::State& start() const { return state_; }

  /// Every value at a state, with reactions.
  Sample sample(const SimTK::State& now) const {
    system_.realize(now, SimTK::Stage::Acceleration);
    Sample sample;
    if (conservative_) sample.energy = system_.calcEnergy(now);
    if (now.getNQErr() > 0) sample.gap = now.getQErr().normInf();
    SimTK::Vector_<SimTK::SpatialVec> reactions;
    matter_.calcMobilizerReactionForces(now, reactions);
    sample.pin = reactions[bodies_[0].getMobilizedBodyIndex()][1].norm();
    look(now, sample);
    return sample;
  }

 protected:
  virtual void look(const SimTK::State& now, Sample& sample) const = 0;

  void gravity(const Vec3& g) {
    SimTK::Force::UniformGravity(forces_, matter_, g);
  }

  static SimTK::Body::Rigid rigid(double mass, const Vec3& centre,
                                  const Vec3& inertia) {
    return SimTK::Body::Rigid(SimTK::MassProperties(
        mass, centre,
        SimTK::Inertia(inertia).shiftFromMassCenter(centre, mass)));
  }

  static SimTK::Body::Rigid uniform_bar() {
    return rigid(1.0, {0.5, 0, 0}, {1e-4, 1.0 / 12.0, 1.0 / 12.0});
  }

  SimTK::MobilizedBody& add(const SimTK::MobilizedBody& body) {
    bodies_.push_back(body);
    return bodies_.back();
  }

  SimTK::MobilizedBody& ground() { return matter_.updGround(); }

  static Vec3 at(const SimTK::MobilizedBody& body, const SimTK::State& now,
                 const Vec3& station) {
    return body.findStationLocationInGround(now, station);
  }

  /// Rates that keep the constraints, the first one given.
  void make_consistent(double first_rate) {
    state_.updU() = 0.0;
    state_.updU()[0] = first_rate;
    system_.realize(state_, SimTK::Stage::Velocity);
    SimTK::Matrix G;
    matter_.calcG(state_, G);
    const SimTK::Vector right = -G(0) * first_rate;
    const SimTK::Matrix rest = G(0, 1, G.nrow(), G.ncol() - 1);
    SimTK::Vector others;
    SimTK::FactorQTZ(rest).solve(right, others);
    for (int i = 0; i < others.size(); ++i) state_.updU()[i + 1] = others[i];
  }

  SimTK::MultibodySystem system_;
  SimTK::SimbodyMatterSubsystem matter_;
  SimTK::GeneralForceSubsystem forces_;
  std::vector<SimTK::MobilizedBody> bodies_;
  SimTK::State state_;
  bool conservative_ = true;
};

inline Eigen::Vector3d plain(const Vec3& v) {
  return {v[0], v[1], v[2]};
}

inline SimTK::Rotation turned(const Eigen::Matrix3d& R) {
  return SimTK::Rotation(SimTK::Mat33(R(0, 0), R(0, 1), R(0, 2), R(1, 0),
                                      R(1, 1), R(1, 2), R(2, 0), R(2, 1),
                                      R(2, 2)));
}

}  // namespace clevis::benchmarks

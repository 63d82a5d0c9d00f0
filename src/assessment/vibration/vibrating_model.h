#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "assessment/job/part_job.h"
#include "assessment/stretches/vibration_times.h"
#include "dynamics/load_vibration/load_answer.h"
#include "dynamics/load_vibration/load_path.h"
#include "elasticity/vibration/load_vibration.h"
#include "stress/zones/singular_zone.h"
#include "stress/zones/zone_mask.h"

namespace clevis::assessment {

/// When a part vibrates.
struct VibrationTimes {
  std::vector<VibrationWindow> driven;  ///< vibration_windows()
  std::vector<VibrationWindow> swing;   ///< swing_windows() of them
  /// Of a motion that is held otherwise at other times: these do not count.
  bool is_stretch = false;
};

/// Peak of a part that vibrates about its quasi-static answer, over its times
/// and all instants; of a stretch those in its swing windows.
template <int dim>
struct VibratingAnswer {
  stress::PartialPeak peak;  ///< outside the singular zones
  double time{};             ///< of it [s]
  double sampling_error{};   ///< between the times [1]
  /// Of pulses as short as the spread of fronts: what they reach without it,
  /// and twice what the shapes cannot follow, for two may meet; over the
  /// peak [1].
  double front_error{};
  /// Of what waves make as short as that spread, over the peak [1].
  double spread_error{};
  bool mesh_spreads_more{};  ///< than so many shapes do
  std::string group;
  Eigen::Vector3d at = Eigen::Vector3d::Zero();  ///< in L [m]
  int shapes{};
  double lowest{}, highest{};                ///< of them [Hz]
  elasticity::DisplacementBasis<dim> basis;  ///< of all times
};

enum class Fronts { kTaken, kJudged };

/// A part at rest under the loads of its motion at one degree: what its
/// vibrations in all stretches of the motion are about.
template <int dim>
class RestingModel {
 public:
  /// @param job, mesh, set  outlive the object.
  /// @throws Error of elasticity::part_at_rest.
  RestingModel(const PartJob& job, const mesh::PartMesh<dim>& mesh,
               const LoadSet& set, int degree);

  const PartJob& job() const { return job_; }
  const LoadSet& loads() const { return set_; }
  const elasticity::PartAtRest<dim>& part() const { return part_; }
  int degree() const { return degree_; }
  /// Of the quasi-static answer.
  const dynamics::LoadPath& path() const { return path_; }
  /// Quasi-static peak over all instants.
  const stress::PartialPeak& peak() const { return peak_; }
  const std::vector<stress::SingularZone>& zones() const { return zones_; }
  /// Shortest spread of a sharp change that the mesh carries [s].
  double mesh_front() const { return mesh_front_; }

 private:
  dynamics::LoadPath make_path() const;
  stress::PartialPeak make_peak() const;

  const PartJob& job_;
  const LoadSet& set_;
  int degree_;
  elasticity::PartAtRest<dim> part_;
  double mesh_front_;
  std::vector<stress::SingularZone> zones_;
  dynamics::LoadPath path_;
  stress::PartialPeak peak_;
};

/// The same in vibration, in a stretch of the motion.
template <int dim>
class VibratingModel {
 public:
  /// @param rest, times  outlive the object.
  /// @param hold_time    when the mechanism holds it so [s].
  /// @throws Error of elasticity::LoadVibration.
  VibratingModel(const RestingModel<dim>& rest, double hold_time,
                 const VibrationTimes& times);

  /// @param path    that of the loads, or thinned.
  /// @param fronts  whether the errors of front and spread are wanted, two or
  ///   three answers more.
  VibratingAnswer<dim> answer(int shapes, const dynamics::LoadPath& path,
                              Fronts fronts);

 private:
  using Basis = elasticity::DisplacementBasis<dim>;

  /// Even times, closer where the loads drive the vibration than where it
  /// swings out. @param lowest  frequency [Hz].
  Eigen::VectorXd even_times(double lowest) const;
  /// Every sixth time, and that of the quasi-static peak.
  std::vector<Eigen::Index> times_to_look_at(const Eigen::VectorXd& time) const;
  /// Lattice points outside the zones that come near the peak.
  std::vector<stress::FieldPoint> points_near_peak(const Basis& basis) const;
  Basis basis_of(const typename elasticity::LoadVibration<dim>::Shapes& shapes,
                 const dynamics::LoadAnswer& moving) const;

  const RestingModel<dim>& rest_;
  const VibrationTimes& times_;
  elasticity::LoadVibration<dim> part_;
  int count_ = 0;  ///< wanted of shapes_
  typename elasticity::LoadVibration<dim>::Shapes shapes_;
  /// Points near their peak, under the first path that was asked for.
  std::vector<stress::FieldPoint> points_;
};

}  // namespace clevis::assessment

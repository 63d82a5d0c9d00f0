#pragma once

#include <optional>
#include <vector>

#include "assessment/models/level.h"
#include "mesh/derived/graded_mesh.h"
#include "stress/peaks/peak_band.h"
#include "stress/zones/singular_zone.h"
#include "stress/zones/zone_mask.h"

namespace clevis::assessment {

/// The largest stress of a part outside its singular zones at one degree.
struct OutsidePeak {
  std::size_t set{};
  stress::FieldPoint at;
  int instant{};
  double sampling_error{};  ///< between lattice points [Pa]
  double time_error{};      ///< between instants [Pa]
  SequenceMember member;
};

/// Follows a part's singular zones through the degrees of the ladder.
///
/// Plane meshes of quadrilaterals are graded towards the zones, so that the
/// field tells the exponent and the rest of the part is not polluted. A zone
/// governs if its stress, where it is resolved no further, is above the peak
/// outside of all zones and grows: measured on the rings of the graded mesh,
/// the innermost a millionth of a cell; elsewhere what the zone's largest
/// stress becomes with the theoretical exponent at kFinest of the radius.
template <int dim>
class ZoneTracker {
 public:
  /// @param job, mesh  outlive the object.
  ZoneTracker(const PartJob& job, const mesh::PartMesh<dim>& mesh);

  /// The mesh to solve on: the given one, or graded.
  const mesh::PartMesh<dim>& mesh() const {
    return graded_ ? *graded_ : *given_;
  }

  bool has_zones() const;

  /// Takes one more degree in.
  void take(const Level<dim>& level);

  /// Whether a zone governs at the last degree.
  bool is_singular() const;
  /// By how much the stress beside a governing zone may exceed what its cells
  /// show, where they are many times as large as the zone: as distance^(λ − 1)
  /// from kResolved radii to their size [1]; 1: they resolve it.
  double unresolved_growth() const;
  /// Along the zones whose cells say so: where smaller ones would change that.
  /// Nothing where that growth is a small part of the tolerance.
  std::vector<OpenPlace> coarse_places() const;
  /// The peaks outside of the zones that govern, per degree.
  const std::vector<OutsidePeak>& outside() const { return outside_; }
  /// Of the last degree's sets, with −1 in the zones that govern.
  std::vector<stress::StressHistory> outside_histories() const;
  std::vector<ZoneResult> results() const;
  /// Zone of the set's lattice points, 1, 2 … in the order of results(), 0
  /// outside [1]; points × cells. Nothing if the set has no zones.
  std::optional<Eigen::MatrixXd> marks(std::size_t set) const;

 private:
  struct Zone {
    stress::SingularZone zone;
    std::vector<std::vector<int>> rings;  ///< empty: mesh not graded
    std::optional<double> exponent;       ///< as measured
    bool governs{};
  };
  struct Set {
    std::vector<Zone> zones;
    Eigen::MatrixXi zone_of;
    std::vector<stress::PointBeside> beside;
  };
  struct Taken {  // one degree
    int degree{}, dofs{};
    std::vector<stress::StressHistory> histories;  // per set
    std::vector<Eigen::VectorXd> energies;         // per set
  };

  /// Ends of shear are told where they govern: most surfaces have some.
  static bool is_told(const Zone& zone) {
    return zone.governs || !(zone.zone.rise > 0.0);
  }
  void grade(const mesh::PartMesh<dim>& mesh);
  void measure(const Level<dim>& level, double outside_peak);
  OutsidePeak peak_of(const Taken& taken, bool without_all) const;
  double time_error(const Level<dim>& level, const OutsidePeak& peak) const;
  /// By which the stress beside a zone may grow when cells resolve it [1].
  static double growth(const Zone& zone);

  const PartJob& job_;
  const mesh::PartMesh<dim>* given_;
  std::optional<mesh::PartMesh<dim>> graded_;
  std::vector<Set> sets_;
  std::vector<Taken> taken_;
  std::vector<OutsidePeak> outside_;
};

}  // namespace clevis::assessment

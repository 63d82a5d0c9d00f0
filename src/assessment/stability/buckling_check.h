#pragma once

#include <optional>
#include <string>
#include <vector>

#include "assessment/job/part_job.h"
#include "assessment/stability/buckling_model.h"
#include "elasticity/buckling/buckling.h"

namespace clevis::assessment {

/// Of a factor from which on first order theory is enough: EN 1993-1-1, 5.2.1.
constexpr double kFirstOrderIsEnough = 10.0;

/// How loads leave a part that stands while its motion lasts.
struct Standing {
  elasticity::BucklingOnSprings::Position position;
  std::string label;  ///< of the motion's last instant
  double instant{};   ///< [s]

  /// Of several load sets: that with the least factor, open if one is.
  void take(const Standing& other);
};

/// Linear buckling of the part, and its shape.
struct BucklingCheck {
  BucklingResult result;
  std::optional<BucklingShape> shape;
  /// By load set, of its motion alone: by how much its stresses raise the
  /// square of a first frequency at most [1].
  std::vector<double> stiffening;
  /// By the model's lowest_degree(); 0: not known.
  double of_lowest_degree{};
  /// By the lowest degree, of the load set with the largest yield.
  elasticity::BucklingMode::OnSprings on_springs;
  Standing standing;
  double seconds{};
};

/// Linear buckling of a part under all its load sets, with rising degrees: all
/// instants with the first, the one that governs with the others, until the
/// limit lies outside the band. Plates by terms through their thickness, else
/// the mesh as it is. What cannot be computed (memory) is left out, and the
/// remark says why.
/// @param swings  by load set, or none; factors are looked for as far as these
///   make loads larger.
/// @throws Error of elasticity::lowest_buckling but F001, F002, F004, F007,
/// M005.
BucklingCheck check_buckling(const PartJob& job,
                             const std::vector<Swing>& swings,
                             BucklingModel& model);

/// Of a part on springs of its mechanism: where they and its joints hold it as
/// often as balance needs the factor is that on springs; else the band reaches
/// down to where both buckle together at the latest.
/// @return whether the band has changed.
/// @param of_lowest_degree  factor by which `on` is measured [1]; 0: not known.
/// @param result  as its seats hold the part.
bool count_springs(const PartJob& job,
                   const elasticity::BucklingMode::OnSprings& on,
                   double of_lowest_degree, BucklingResult& result);

/// The part has no more than the factor of its position, however stiff it is;
/// nothing changes where its loads do not push it over.
void count_standing(const Standing& standing, BucklingResult& result);

/// Of a part that joints hold more often than balance needs: its band goes on
/// to the factor that it has if all hold.
/// @return whether the band has grown.
bool widen_by_all_holds(const PartJob& job, const std::vector<Swing>& swings,
                        BucklingModel& model, BucklingResult& result);

}  // namespace clevis::assessment

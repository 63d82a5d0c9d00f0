#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "beam/sections/part_model.h"
#include "part/bore.h"

namespace clevis::beam {

/// The material around a bore, seen from its axis in its middle plane.
class LugGeometry {
 public:
  /// @param outline  of the part in the plane through the bore's middle,
  ///   normal to its axis.
  LugGeometry(const part::Bore& bore, const Outline& outline);

  /// Whether material surrounds the cylinder (a bore) or fills it (a journal
  /// or piston, whose `edge` means nothing).
  bool is_bore() const { return is_bore_; }

  /// Distance from the axis to where the material ends [m]; the direction is
  /// any vector, only its part normal to the axis counts.
  double edge(const Eigen::Vector3d& direction) const;
  double smallest_edge() const;

 private:
  part::Bore bore_;
  Eigen::Vector3d e_1_, e_2_;
  std::vector<double> edges_;  // one per degree from e_1 towards e_2 [m]
  bool is_bore_{};
};

/// Nominal stresses of a lug under the force of its pin.
struct LugStress {
  double bearing{};  ///< mean pressure F/(d t) [Pa]
  /// F over both ligaments beside the bore, normal to the force [Pa]; only
  /// where the pin pulls towards the nearer edge.
  std::optional<double> net_section;
  /// √3 F/(2 t e), e from the wall to the edge ahead of the pin [Pa]; as
  /// above.
  std::optional<double> shear_out;
};

/// @param force  of the pin on the lug [N], in L; its axial part is left out.
LugStress lug_stress(const LugGeometry& lug, const part::Bore& bore,
                     const Eigen::Vector3d& force);

}  // namespace clevis::beam

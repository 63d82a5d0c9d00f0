#pragma once

#include <memory>
#include <string>

#include <Eigen/Core>

#include "elasticity/fe_space/discretization.h"
#include "part/material.h"
#include "part/supports.h"

namespace clevis::elasticity {

/// Coordinates in which a part's stiffness is the identity: K = F Fᵀ and
/// Y = Fᵀ U, so that the square of Y is twice the energy of the displacements
/// U. F is made of one Cholesky factor per parity class of the part, which K
/// does not couple.
class EnergyCoordinates {
 public:
  virtual ~EnergyCoordinates() = default;
  virtual Eigen::Index size() const = 0;
  /// F⁻ᵀ Y, dofs × columns [m]; of a free part up to a rigid motion.
  virtual Eigen::MatrixXd displacements(const Eigen::MatrixXd& y) const = 0;
  /// F⁻¹ L of nodal loads [N], of a free part in balance.
  virtual Eigen::MatrixXd of_loads(const Eigen::MatrixXd& loads) const = 0;
};

/// What holds a part.
struct PartSupports {
  const part::Supports& fixed;           ///< empty: nothing
  const part::Foundations& foundations;  ///< elastic beds under faces
};

/// Classes by the mirrors of the mesh and its supports (Folding); a part on
/// beds is one class.
/// @throws Error F001, F002, F004, M005.
std::unique_ptr<EnergyCoordinates> solid_coordinates(
    const Discretization<3>& part, const part::Material& material,
    const PartSupports& hold, const std::string& name);

/// Of a plate: classes of what stretches it and what bends it.
/// @param layer  over the plane, of degree 3 through the thickness.
/// @throws Error F001, F002, F004, M005.
std::unique_ptr<EnergyCoordinates> plate_coordinates(
    const Discretization<2>& plane, const Discretization<3>& layer,
    const part::Material& material, const part::Supports& fixed,
    const std::string& name);

}  // namespace clevis::elasticity

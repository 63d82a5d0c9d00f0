#pragma once

#include <vector>

#include <Eigen/Core>

#include "beam/sections/part_model.h"
#include "loads/history/load_history.h"
#include "part/mass_properties.h"

namespace clevis::beam {

/// Mass, first moment ∫ρ p_LQ dV and second moment ∫ρ (|p|² I − p pᵀ) dV
/// about Lo of some of the material.
struct MassMoments {
  double mass{};                                     ///< [kg]
  Eigen::Vector3d first = Eigen::Vector3d::Zero();   ///< [kg m]
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();  ///< [kg m²]

  MassMoments& operator+=(const MassMoments& other);
};

MassMoments moments_of(const part::MassProperties& mass);

/// Force [N] and moment [N m] about Lo of the inertia of that material
/// (d'Alembert).
loads::Wrench inertia_of(const MassMoments& moments,
                         const loads::RigidAcceleration& rigid);

/// Moments of the material beyond each of several parallel planes
/// p · direction = position.
///
/// Lumps go to the side of their middle; what they miss of the exact mass
/// properties is spread in proportion to the mass, so that the moments of
/// both sides add up to those of the part exactly.
/// @param direction  unit vector in L. @param positions  from Lo [m].
std::vector<MassMoments> moments_beyond(const std::vector<Lump>& lumps,
                                        const part::MassProperties& mass,
                                        const Eigen::Vector3d& direction,
                                        const std::vector<double>& positions);

}  // namespace clevis::beam

#pragma once

#include <memory>

#include <Eigen/Core>

#include "dynamics/struck_body/struck_body.h"
#include "dynamics/systems/linear_system.h"

namespace clevis::dynamics {

/// A body by the damping scheme, four solves a step: waves too short for the
/// step die out, those that it resolves stay.
/// @param contact  c [1]; outlives the body, as the system does.
std::unique_ptr<StruckBody> damped_body(const LinearSystem& system,
                                        const Eigen::VectorXd& contact);

}  // namespace clevis::dynamics

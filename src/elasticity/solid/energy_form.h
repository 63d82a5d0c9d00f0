#pragma once

#include <Eigen/Core>

namespace clevis::elasticity {

/// A of the energy ½ xᵀ A x of loads that are combined, by polarisation.
/// @param single  energy of each load alone [J].
/// @param pairs   of each two together: 0 1, 0 2, …, 1 2, ….
Eigen::MatrixXd energy_form(const Eigen::VectorXd& single,
                            const Eigen::VectorXd& pairs);

}  // namespace clevis::elasticity

#pragma once

#include <string>

#include <Eigen/Core>

#include "mechanism/integration/dynamic_model.h"

namespace clevis::mechanism {

/// What changes fastest beside a state, which is what keeps steps short.
struct FastestRate {
  double rate{};     ///< largest growth of a small change of the state [1/s]
  std::string what;  ///< "body rod, by spring S1 (scene.toml:40:1)"; may be
                     ///< empty
};

/// By some steps of power iteration on the derivative of the rate: its order of
/// size. Time t [s], y in the units of StateLayout.
FastestRate fastest_rate(DynamicModel& model, double t,
                         const Eigen::VectorXd& y);

}  // namespace clevis::mechanism

#pragma once

#include <Eigen/Core>

namespace clevis::assessment {

/// By how much the top of a curve may stand above its largest sample, at even
/// steps: a smooth top by its parabola, a cusp by where its sides may meet
/// (kink of the slope over 4); what bends its sides alike is no cusp. In the
/// units of the samples.
double rise_between_samples(const Eigen::VectorXd& values);

}  // namespace clevis::assessment

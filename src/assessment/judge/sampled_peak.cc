#include "assessment/judge/sampled_peak.h"

#include <algorithm>

namespace clevis::assessment {

double rise_between_samples(const Eigen::VectorXd& values) {
  Eigen::Index top = 0;
  if (values.size() == 0) return 0.0;
  values.maxCoeff(&top);
  const auto bend = [&](Eigen::Index i) {
    if (i < 1 || i + 1 >= values.size()) return 0.0;
    return 2.0 * values[i] - values[i - 1] - values[i + 1];
  };
  const double sides = std::max({bend(top - 2), bend(top + 2), 0.0});
  const double kink = bend(top - 1) + bend(top) + bend(top + 1) - 3.0 * sides;
  return std::max({bend(top) / 8.0, kink / 4.0, 0.0});
}

}  // namespace clevis::assessment

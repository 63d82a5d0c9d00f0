#include "mechanism/dynamic_motion/fastest_rate.h"

#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "base/values/index.h"
#include "mechanism/force_elements/force_element.h"

namespace clevis::mechanism {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// The body whose velocity changes most along a direction.
std::string body_of(const DynamicModel& model, const VectorXd& direction) {
  const StateLayout& layout = model.equations.layout();
  const Index per_body = layout.is_planar() ? 3 : 6;
  Index largest = 0;
  direction.segment(layout.velocity_index(), per_body * layout.bodies())
      .cwiseAbs()
      .maxCoeff(&largest);
  return model.definition.bodies[index(largest / per_body)].name;
}

std::vector<ElementState> elements_at(DynamicModel& model, double t,
                                      const VectorXd& y) {
  return model.equations.forces().results(
      model.equations.evaluate_forces(t, y).loads.forces);
}

/// The force element whose forces change most along a change of the state.
const ForceElement* element_of(DynamicModel& model, double t, const VectorXd& y,
                               const VectorXd& change) {
  const auto before = elements_at(model, t, y);
  const auto after = elements_at(model, t, y + change);
  const ForceElement* found = nullptr;
  double most = 0.0;  // [N]
  for (std::size_t k = 0; k < before.size(); ++k) {
    double difference = 0.0;
    for (std::size_t end = 0; end < 2; ++end) {
      const ElementAction &a = before[k].actions[end],
                          &b = after[k].actions[end];
      difference +=
          (b.f_W - a.f_W).norm() + (b.t_W - a.t_W).norm() / model.frame.length;
    }
    if (!(difference > most)) continue;
    most = difference;
    found = &model.definition.elements[k];
  }
  return found;
}

}  // namespace

FastestRate fastest_rate(DynamicModel& model, double t, const VectorXd& y) {
  constexpr int kIterations = 30;
  constexpr double kSmall = 1e-6;
  ForwardDynamics& dynamics = model.dynamics;
  VectorXd size(y.size()), before(y.size()), after(y.size());
  dynamics.scales(y, size);
  const VectorXd inverse =
      (size.array() > 0.0).select(size.array().inverse(), 0.0).matrix();
  dynamics.rate(t, y, before);
  VectorXd direction = size;
  FastestRate fastest;
  double previous = 0.0;
  for (int i = 0; i < kIterations; ++i) {
    const VectorXd change = kSmall * direction;
    dynamics.rate(t, y + change, after);
    const VectorXd growth = inverse.cwiseProduct(after - before);
    const double now = growth.norm() / inverse.cwiseProduct(change).norm();
    if (!std::isfinite(now) || now == 0.0) break;
    // What oscillates grows in positions and in speeds by turns.
    fastest.rate = i == 0 ? now : std::sqrt(now * previous);
    previous = now;
    direction = growth.cwiseProduct(size) / growth.norm();
  }
  if (fastest.rate == 0.0) return fastest;
  fastest.what = "body " + body_of(model, direction);
  if (const auto* element = element_of(model, t, y, kSmall * direction)) {
    fastest.what += fmt::format(", by force {} ({})", name_of(*element),
                                place_of(*element));
  }
  return fastest;
}

}  // namespace clevis::mechanism

#include "mechanism/driven_loads/load_scales.h"

#include <utility>

namespace clevis::mechanism {

using Eigen::Index;

LoadScales::LoadScales(DrivenTrajectory& trajectory,
                       std::function<bool(double)> beside)
    : trajectory_(trajectory), beside_(std::move(beside)) {
  largest_.setZero(static_cast<Index>(loads().vectors().size()));
  inverse_.setZero(loads().size());
  update();
}

void LoadScales::note(const DrivenTrajectory::Look& look) {
  if (!beside_(look.t)) {
    largest_ = largest_.cwiseMax(loads().lengths(look.loads));
  }
}

void LoadScales::update() {
  for (const auto& look : trajectory_.looks()) note(look);
  scales_ = loads().scales(largest_);
  for (std::size_t v = 0; v < loads().vectors().size(); ++v) {
    const BodyLoads::Vector& vector = loads().vectors()[v];
    const double scale = scales_[static_cast<Index>(v)];
    inverse_.segment(vector.begin, vector.count)
        .setConstant(scale > 0.0 ? 1.0 / scale : 0.0);
  }
}

}  // namespace clevis::mechanism

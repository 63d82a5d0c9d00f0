#include "assessment/pace/acting_forces.h"

#include <numbers>

#include <Eigen/Geometry>

namespace clevis::assessment {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::RowVectorXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// Of symmetric matrices, with the length that no frame changes.
VectorXd square_of(const Vector3d& omega) {
  constexpr double kRoot = std::numbers::sqrt2;  // they stand there twice
  return VectorXd{{omega.x() * omega.x(), omega.y() * omega.y(),
                   omega.z() * omega.z(), kRoot * omega.x() * omega.y(),
                   kRoot * omega.y() * omega.z(),
                   kRoot * omega.z() * omega.x()}};
}

std::vector<VectorXd> vectors_of(const loads::InstantLoad& instant,
                                 const part::MassProperties& body,
                                 double size) {
  std::vector<VectorXd> all;
  for (const loads::Wrench& wrench : instant.wrenches) {
    all.emplace_back(wrench.force);
    all.emplace_back(wrench.moment / size);
  }
  const Vector3d& center = body.p_LCm;
  for (const loads::SurfaceLoad& load : instant.surface_loads) {
    const loads::Wrench& about_origin = load.resultant;
    all.emplace_back(about_origin.force);
    all.emplace_back((about_origin.moment - center.cross(about_origin.force)) /
                     size);
    all.emplace_back(VectorXd::Constant(1, load.total));
  }
  const auto& [acceleration, alpha, omega] = instant.rigid;
  all.emplace_back(body.mass * (acceleration + alpha.cross(center) +
                                omega.cross(omega.cross(center))));
  all.emplace_back(body.mass * size * alpha);
  all.emplace_back(body.mass * size * square_of(omega));
  return all;
}

}  // namespace

ActingForces::ActingForces(const PartJob& job, const LoadSet& set)
    : begins_{0} {
  const auto& instants = set.history.instants;
  const double size = job.sides()[2];
  for (std::size_t i = 0; i < instants.size(); ++i) {
    const auto vectors = vectors_of(instants[i], job.mass, size);
    if (i == 0) {
      for (const VectorXd& vector : vectors) {
        begins_.push_back(begins_.back() + vector.size());
      }
      values_.resize(begins_.back(), std::ssize(instants));
    }
    for (std::size_t k = 0; k < vectors.size(); ++k) {
      values_.col(static_cast<Index>(i))
          .segment(begins_[k], vectors[k].size()) = vectors[k];
    }
  }
}

MatrixXd ActingForces::along_own_axes(MatrixXd values, double least) const {
  constexpr double kLike = 1.0 - 1e-6;
  std::vector<RowVectorXd> components;
  for (std::size_t k = 0; k + 1 < begins_.size(); ++k) {
    const Index count = begins_[k + 1] - begins_[k];
    auto rest = values.middleRows(begins_[k], count);
    for (Index axis = 0; axis < count; ++axis) {
      const RowVectorXd size = rest.colwise().norm();
      const double most = size.maxCoeff();
      if (!(most > least)) break;
      Index at = 0;
      while (size[at] < kLike * most) ++at;
      const VectorXd along = rest.col(at) / size[at];
      components.emplace_back(along.transpose() * rest);
      rest -= along * components.back();
    }
  }
  MatrixXd all(std::ssize(components), values.cols());
  for (Index row = 0; row < all.rows(); ++row) {
    all.row(row) = components[static_cast<std::size_t>(row)];
  }
  return all;
}

}  // namespace clevis::assessment

#pragma once

#include <Eigen/Core>

#include "assessment/job/part_job.h"

namespace clevis::assessment {

/// Per instant of a load set, away from all singular zones.
struct RoughAnswers {
  Eigen::VectorXd stress;      ///< largest von Mises [Pa]
  Eigen::VectorXd deflection;  ///< largest [m]
};

/// Largest over instants.
struct RoughPeak {
  double stress{};      ///< [Pa]
  double deflection{};  ///< [m]
};
RoughPeak largest_of(const RoughAnswers& answers, Eigen::Index first,
                     Eigen::Index count);

/// By a low degree of the cheapest model that suits the loads and is quick to
/// look at: to compare loads with each other.
RoughAnswers rough_answers(const PartJob& job, const LoadSet& set);

}  // namespace clevis::assessment

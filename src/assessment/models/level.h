#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "assessment/job/part_job.h"
#include "assessment/models/fe_model.h"
#include "elasticity/problem/displacement_basis.h"
#include "loads/holds/holding_groups.h"
#include "stress/displacement/deflection.h"
#include "stress/field/probe.h"

namespace clevis::assessment {

/// One degree: all load sets solved, the governing one kept.
template <int dim>
struct Level {
  std::shared_ptr<elasticity::DisplacementBasis<dim>> governing;
  std::vector<std::shared_ptr<elasticity::DisplacementBasis<dim>>>
      bases;                                     ///< per set
  std::vector<stress::StressHistory> histories;  ///< per set
  std::vector<stress::Deflection> deflections;   ///< per set
  std::vector<Eigen::VectorXd> admitted;         ///< per set, or empty: none
  std::size_t set{};                             ///< the governing one
  SequenceMember member;
  std::optional<SupportStress> held;  ///< without band; absent: no plane face
  std::vector<std::string> support_sections;  ///< groups with plane faces
  std::vector<stress::PointValue> probes;     ///< case after case

  const stress::StressHistory& history() const { return histories[set]; }
};

/// What holds the part as a whole, to which deflections refer.
loads::PartHold reference_hold(const LoadSet& set);

/// Solves load sets of a part with one degree of a model; displacements
/// relative to its pins.
/// @param sets  the job's, or of each some instants.
/// @param seconds  the stages' times are added here.
/// @param admitted  per set, as ElasticProblem::admitted_load_error; empty:
/// none
///   of any.
/// @throws Error L005 if a probe lies outside the part; see elasticity.
template <int dim>
Level<dim> solve_level(const PartJob& job, const std::vector<LoadSet>& sets,
                       const mesh::PartMesh<dim>& mesh,
                       const FeModel<dim>& model, int degree,
                       PartSeconds& seconds,
                       const std::vector<Eigen::VectorXd>& admitted = {});

}  // namespace clevis::assessment

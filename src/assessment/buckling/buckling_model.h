#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "assessment/job/part_job.h"
#include "assessment/models/part_shape.h"
#include "base/messages/errors.h"
#include "elasticity/buckling/buckling_problem.h"
#include "elasticity/fe_space/discretization.h"

namespace clevis::assessment {

/// A part of one degree.
struct PartSpace {
  elasticity::Discretization<3> whole;
  /// That it is a layer over.
  std::optional<elasticity::Discretization<2>> plane = {};
};

/// Whether a part without this can be told of all the same: its supports hold
/// it in its plane only, its cells fold with a low degree, memory, --max-dofs.
bool is_bearable(const Error& error);

/// The part's discretisation for bending and twisting: of plates one layer.
class BucklingModel {
 public:
  /// @param job  outlives the object.
  explicit BucklingModel(const PartJob& job);

  PartSpace discretize(int degree) const;
  /// Bends and twists the part well enough.
  int lowest_degree() const { return is_compact_ ? 2 : 3; }
  /// Of a load set. A plate that these hold in its plane alone counts as held
  /// across it at the same faces: it may buckle within it.
  part::Supports supports(const LoadSet& set) const;
  /// Factors the problem's stiffness, unless it is known. Kept are those of
  /// lowest_degree(), which buckling and second order take, if they are small.
  /// @param set  whose supports the problem has.
  void factor(const LoadSet& set, elasticity::BucklingProblem& problem);
  /// Of compact cells the first degree is not thrice too high.
  bool is_compact() const { return is_compact_; }
  std::string name(int degree) const;

 private:
  struct Factored {
    part::Supports fixed;
    part::Foundations foundations;
    std::shared_ptr<const elasticity::EnergyCoordinates> coordinates;
  };

  const PartJob& job_;
  PartShape shape_;
  bool is_compact_;
  std::vector<Factored> factored_;
};

}  // namespace clevis::assessment

#pragma once

#include <optional>
#include <string>

#include "assessment/job/part_job.h"
#include "assessment/models/part_shape.h"
#include "base/messages/errors.h"
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
  /// Of compact cells the first degree is not thrice too high.
  bool is_compact() const { return is_compact_; }
  std::string name(int degree) const;

 private:
  const PartJob& job_;
  PartShape shape_;
  bool is_compact_;
};

}  // namespace clevis::assessment

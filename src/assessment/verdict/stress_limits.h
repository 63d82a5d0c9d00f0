#pragma once

#include <optional>

#include "assessment/job/part_result.h"
#include "assessment/verdict/judgement.h"
#include "part/part_definition.h"

namespace clevis::assessment {

/// What the peak says against a part, and the nominal stress of a zone left
/// out, which stands for what it hides; nothing: it holds.
std::optional<Judgement> judge_stress(const part::PartDefinition& part,
                                      const PartResult& result);
std::optional<Judgement> judge_nominal(const part::PartDefinition& part,
                                       const PartResult& result);

}  // namespace clevis::assessment

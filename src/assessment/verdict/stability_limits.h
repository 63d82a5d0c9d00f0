#pragma once

#include <optional>

#include "assessment/job/part_result.h"
#include "assessment/verdict/judgement.h"
#include "part/part_definition.h"

namespace clevis::assessment {

/// What second order and buckling say against a part that passes by linear
/// theory; nothing: it holds.
std::optional<Judgement> judge_second_order(const part::PartDefinition& part,
                                            const PartResult& result);
std::optional<Judgement> judge_buckling(const part::PartDefinition& part,
                                        const PartResult& result);

}  // namespace clevis::assessment

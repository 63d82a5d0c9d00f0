#pragma once

#include <string>
#include <string_view>

#include "assessment/job/part_result.h"

namespace clevis::report {

/// A part's result as text that a worker process sends to its parent: JSON,
/// SI, every double to the same bits. (result.json is for people and has
/// their units: result_json.h.)
/// @throws Error F003 if a number is not finite.
std::string encode(const assessment::PartResult& result);

/// The result that `text` was made from.
/// @throws Error X001 if the text is not what encode() writes, as when the
///   worker died while it wrote.
assessment::PartResult decode_part_result(std::string_view text);

}  // namespace clevis::report

#pragma once

#include <string>

#include "part/verdict.h"

namespace clevis::assessment {

/// Of a part against one of its limits.
struct Judgement {
  part::Verdict verdict{};
  std::string why;  ///< one line: limit and value, or why not judged
};

}  // namespace clevis::assessment

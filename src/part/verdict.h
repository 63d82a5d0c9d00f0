#pragma once

#include <string_view>

namespace clevis::part {

/// Of a part or a bearing against its limits.
enum class Verdict { kPass, kFail, kNotJudged };

/// As tables and files say it.
constexpr std::string_view text(Verdict verdict) {
  switch (verdict) {
    case Verdict::kPass:
      return "pass";
    case Verdict::kFail:
      return "fail";
    case Verdict::kNotJudged:
      break;
  }
  return "not judged";
}

}  // namespace clevis::part

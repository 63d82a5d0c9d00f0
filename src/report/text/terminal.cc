#include "report/text/terminal.h"

#include <algorithm>
#include <cstdlib>

#include <unistd.h>

namespace clevis::report {

Colour colour_of(int descriptor) {
  const char* no_color = std::getenv("NO_COLOR");
  const char* terminal = std::getenv("TERM");
  const bool refused = no_color != nullptr && *no_color != '\0';
  const bool dumb = terminal == nullptr || std::string_view(terminal) == "dumb";
  return !refused && !dumb && ::isatty(descriptor) == 1 ? Colour::kAnsi
                                                        : Colour::kNone;
}

Tone tone_of(part::Verdict verdict) {
  switch (verdict) {
    case part::Verdict::kPass:
      return Tone::kGood;
    case part::Verdict::kFail:
      return Tone::kBad;
    case part::Verdict::kNotJudged:
      break;
  }
  return Tone::kDoubtful;
}

std::string paint(std::string_view text, Tone tone, Colour colour) {
  if (colour == Colour::kNone || tone == Tone::kPlain) return std::string(text);
  const std::string_view code = tone == Tone::kGood  ? "\033[32m"
                                : tone == Tone::kBad ? "\033[1;31m"
                                                     : "\033[33m";
  return std::string(code).append(text).append("\033[0m");
}

std::string printable(std::string_view text) {
  std::string clean(text);
  std::ranges::replace_if(
      clean,
      [](char c) {
        const auto byte = static_cast<unsigned char>(c);
        return byte < 0x20 || byte == 0x7f;
      },
      '?');
  return clean;
}

}  // namespace clevis::report

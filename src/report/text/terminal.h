#pragma once

#include <string>
#include <string_view>

#include "part/verdict.h"

namespace clevis::report {

enum class Colour { kNone, kAnsi };

/// Whether text on a file descriptor may be coloured: a terminal that is not
/// "dumb", and NO_COLOR unset or empty (no-color.org).
Colour colour_of(int descriptor);

enum class Tone { kPlain, kGood, kBad, kDoubtful };

Tone tone_of(part::Verdict verdict);

/// `text` between the escape codes of `tone`, or as it is.
std::string paint(std::string_view text, Tone tone, Colour colour);

/// `text` with every control character as '?': names come from the user's
/// files and must not steer the terminal.
std::string printable(std::string_view text);

}  // namespace clevis::report

#pragma once

#include <string>

namespace clevis::app {

/// The text as one word of a POSIX shell: as it is if the shell leaves it
/// alone, else in single quotes.
std::string shell_word(const std::string& text);

}  // namespace clevis::app

#pragma once

#include <cstddef>
#include <string>

#include "cad/first_case.h"

namespace clevis::app {

/// Groups of plane faces in a scene that `clevis init` writes of a solid.
inline constexpr const char* kBase = "base";
inline constexpr const char* kEnd = "end";

/// "bore_A" of bore 0. @param bore  below 26.
std::string bore_name(std::size_t bore);

/// The load case of a solid of which nothing but its shape is known.
struct FirstCaseText {
  std::string toml;   ///< commented [[part.case]]
  std::string about;  ///< for the terminal: "bore_A held by its pin, …"
};

/// The load is 10 MPa on the smaller bore, or on the end: a number that stands
/// for the user's, as the comments say.
FirstCaseText first_case_text(const cad::FirstCase& made);

}  // namespace clevis::app

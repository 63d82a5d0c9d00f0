#pragma once

#include <optional>
#include <string>

#include "report/page/result_folder.h"

namespace clevis::report {

/// The moving parts of a stored result at the first, the middle and the last
/// instant over each other, the last in front, coloured by stress, as SVG. A
/// plane mechanism is seen along its axes, others askew; up is against gravity,
/// else +y.
/// @return nothing if no part moves.
/// @throws Error I003.
std::optional<std::string> mechanism_picture(const StoredPage& page);

}  // namespace clevis::report

#pragma once

#include <string>

#include "report/text/terminal.h"
#include "report/variants/collection.h"

namespace clevis::report {

/// One line per variant, what is missing, the lightest that passes and how to
/// get its scene.
std::string collection_table(const Collection& collection, Colour colour);

}  // namespace clevis::report

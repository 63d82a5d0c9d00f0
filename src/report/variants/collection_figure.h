#pragma once

#include <string>

#include "report/variants/collection.h"

namespace clevis::report {

/// A figure in SVG: peak stress with its band against each setting that varies,
/// a row of panels for each part, the limit dashed. Settings that are no
/// numbers stand in the order of their first variant.
std::string collection_figure(const Collection& collection);

}  // namespace clevis::report

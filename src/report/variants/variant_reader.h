#pragma once

#include <filesystem>

#include "report/variants/collection.h"
#include "report/variants/plan_file.h"

namespace clevis::report {

/// The results of a plan in the folders of its variants. What is not there,
/// not whole, of other inputs than planned or damaged is told in the variant.
/// @throws Error I003, I007 if the plan itself cannot be read.
Collection read_collection(const std::filesystem::path& folder);

}  // namespace clevis::report

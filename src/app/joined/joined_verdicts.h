#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "assessment/job/part_job.h"
#include "assessment/job/part_result.h"
#include "mechanism/definition/definition.h"

namespace clevis::app {

/// Doubts parts for what else in their mechanism yields.
/// @return names of parts whose verdict has changed.
std::vector<std::string> doubt_joined_parts(
    const mechanism::MechanismDefinition& mechanism,
    const std::vector<assessment::PartJob>& jobs,
    std::vector<assessment::PartResult>& results);

/// Pictures of parts whose verdict changed after they were drawn.
/// @param folder  of a whole result.
void draw_anew(const std::vector<std::string>& parts,
               const std::filesystem::path& folder);

}  // namespace clevis::app

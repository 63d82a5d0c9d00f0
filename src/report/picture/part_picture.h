#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "assessment/job/part_result.h"
#include "report/page/result_folder.h"
#include "report/view/part_view.h"

namespace clevis::report {

/// NAME.svg: a part at its worst instant, coloured by stress, with its mesh,
/// the worst place marked, legend and band. The file is written into the folder
/// of the result.
/// @throws Error I002.
void write_part_picture(const PartView& view,
                        const assessment::PartResult& result,
                        const std::filesystem::path& folder);

/// Parts of a stored result.
/// @throws Error I003.
std::vector<std::string> part_names(const StoredPage& page);

/// The same of a part of a stored result, as SVG.
/// @throws Error I003, S007 if there is no such part.
std::string stored_part_picture(const StoredPage& page,
                                const std::string& part);

}  // namespace clevis::report

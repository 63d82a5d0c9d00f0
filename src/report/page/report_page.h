#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "report/page/result_folder.h"

namespace clevis::report {

/// The JSON text with every `<` of its strings as `\u003c`, so that nothing in
/// it ends the element that holds it.
std::string escape_json_for_html(std::string_view json);

/// report.html: one file that needs no other and no network. Its content
/// policy admits its own script and style, by their hashes, and nothing else.
std::string report_page(const StoredPage& page);

/// Reads the result in `folder` and writes its page, report.html.
/// @returns the file.
/// @throws Error as read_result_folder(), I002.
std::filesystem::path write_report(const std::filesystem::path& folder,
                                   ResultKind kind);

}  // namespace clevis::report

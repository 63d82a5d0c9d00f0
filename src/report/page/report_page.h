#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "report/page/result_folder.h"

namespace clevis::report {

/// The JSON text with every `<` of its strings as `\u003c`, so that nothing in
/// it ends the element that holds it.
std::string escape_json_for_html(std::string_view json);

/// report.html: one file that needs no other and no network. Its content
/// policy admits its own script and style, by their hashes, and nothing else.
/// @param watch_run  number of the run of a watched check that made it: the
///   page then looks again and again at the mark beside it (watch_mark.h), a
///   picture of the same folder, which its policy admits too.
std::string report_page(const StoredPage& page,
                        std::optional<int> watch_run = {});

/// Reads the result in `folder` and writes its page, report.html.
/// @returns the file.
/// @throws Error as read_result_folder(), I002.
std::filesystem::path write_report(const std::filesystem::path& folder,
                                   ResultKind kind,
                                   std::optional<int> watch_run = {});

}  // namespace clevis::report

#pragma once

#include <filesystem>

#include "report/check/check_report.h"

namespace clevis::report {

/// Writes parts.csv, junit.xml and, last, result.json into `folder`: where
/// there is a result.json, the files beside it are whole and of one run.
///
/// An older result.json goes first, so that a crash in between leaves none
/// that belongs to other files.
/// @throws Error I002; F003 before anything is written if a number is not
///   finite.
void write_result_files(const CheckReport& report,
                        const std::filesystem::path& folder);

}  // namespace clevis::report

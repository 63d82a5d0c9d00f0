#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "report/view/view_files.h"

namespace clevis::report {

/// A result as the page of a report holds it: texts of its JSON files.
struct StoredPage {
  std::string title;               ///< scene and verdict
  std::string result;              ///< result.json or simulate.json
  std::string motion;              ///< view/motion.json
  std::vector<std::string> parts;  ///< view/part_NAME.json, in their order
  /// The same of parts that could not be computed, as far as it is there.
  std::vector<std::string> shapes = {};
};

/// Kind of result in the folder; of both the check.
/// @throws Error I001 if it is not there, I008 if neither is in it.
ResultKind result_kind(const std::filesystem::path& folder);

/// Reads the folder that `clevis check` or `clevis simulate` wrote.
/// @throws Error I003 if a file is damaged, I008 if the folder lacks what a
///   report shows, or holds that of another scene or version.
StoredPage read_result_folder(const std::filesystem::path& folder,
                              ResultKind kind);

}  // namespace clevis::report

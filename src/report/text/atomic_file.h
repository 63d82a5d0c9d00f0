#pragma once

#include <filesystem>
#include <functional>
#include <string_view>

namespace clevis::report {

/// Whether `name` may become the name of an output file: 1–64 characters of
/// A–Z a–z 0–9 . _ - and not a step in the folder tree (".", "..").
///
/// Part and group names come from the user's files, so they pass here before
/// they name a file.
bool is_file_name(std::string_view name);

/// Whether a name that a user gives on the command line may: also blanks within
/// and letters of all scripts (valid UTF-8), 128 bytes in all, which every file
/// system of today takes; no controls, no marks that turn the direction.
bool is_own_file_name(std::string_view name);

/// Writes `content` so that `file` is at every moment either the old content
/// or the whole new one, also after a crash or Ctrl-C: temporary name in the
/// same folder, fsync, rename. Missing folders are created. A symbolic link
/// at `file` is replaced, not followed.
///
/// @throws Error I002 with the system's reason if the name is not allowed or
///   the folder or file cannot be written; no temporary file stays behind.
void write_file(const std::filesystem::path& file, std::string_view content);

/// Takes the next piece of a file.
using TextSink = std::function<void(std::string_view)>;

/// Likewise, of a content that need not stand in memory at once.
/// @param write  hands all pieces on; where it throws, `file` stays as it was.
void write_file(const std::filesystem::path& file,
                const std::function<void(const TextSink&)>& write);

/// Folders within that of a result: the series over time; what only a report
/// reads.
inline constexpr const char* kFramesFolder = "frames";
inline constexpr const char* kViewFolder = "view";

/// Removes from `folder` and these folders within what processes that are gone
/// left inside write_file(), nothing else. Nobody else may be writing there.
void remove_unfinished(const std::filesystem::path& folder);

}  // namespace clevis::report

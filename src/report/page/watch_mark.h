#pragma once

#include <filesystem>

namespace clevis::report {

/// File beside a report.html that `clevis check --watch` writes.
inline constexpr const char* kWatchMark = "report_watch.svg";

/// What a watched check does: the report is of the files as they are, a new one
/// is on its way, or the files as they are give none.
enum class WatchState { kCurrent = 1, kChecking = 2, kRefused = 3 };

/// Writes the mark, an empty picture: its width is the number of the run that
/// report.html is of, its height the state. A page that was opened from disk
/// can read nothing of another file but the size of a picture.
/// @throws Error I002.
void write_watch_mark(const std::filesystem::path& folder, int run,
                      WatchState state);

}  // namespace clevis::report

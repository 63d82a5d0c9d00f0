#include "app/watch/report_mark.h"

#include <random>
#include <string>

#include <fmt/format.h>
#include <sys/stat.h>

#include "app/request/output_folder.h"
#include "base/messages/errors.h"
#include "report/page/report_page.h"
#include "report/page/watch_mark.h"

namespace clevis::app {
namespace {

namespace fs = std::filesystem;
using report::WatchState;

/// Differs for every file that was put in its place.
std::string stamp_of_report(const fs::path& folder) {
  struct stat found {};
  const fs::path file = folder / "report.html";
  if (stat(file.c_str(), &found) != 0) return {};
  return fmt::format("{}:{}.{}", found.st_ino, found.st_mtim.tv_sec,
                     found.st_mtim.tv_nsec);
}

void write_mark(const fs::path& folder, int run, WatchState state) {
  try {
    report::write_watch_mark(folder, run, state);
  } catch (const Error&) {  // the check tells it
  }
}

}  // namespace

ReportMark::ReportMark(const Options& options)
    : folder_(output_folder(options)), has_report_(options.report) {
  // Reports of an earlier watch must not take this one's for theirs.
  constexpr unsigned kStarts = 15000;
  run_ = static_cast<int>(std::random_device()() % kStarts) + 1;
}

int ReportMark::begin_run() {
  constexpr int kMost = 30000;
  run_ = run_ % kMost + 1;
  stamp_ = stamp_of_report(folder_);
  if (shown_ > 0) write_mark(folder_, shown_, WatchState::kChecking);
  return run_;
}

void ReportMark::end_run() {
  if (!has_report_) return;
  const bool is_new = stamp_of_report(folder_) != stamp_;
  if (is_new) shown_ = run_;
  if (shown_ > 0) {
    write_mark(folder_, shown_,
               is_new ? WatchState::kCurrent : WatchState::kRefused);
  }
}

ReportMark::~ReportMark() {
  if (shown_ == 0) return;
  std::error_code ignored;
  fs::remove(folder_ / report::kWatchMark, ignored);
  try {
    report::write_report(folder_, report::ResultKind::kCheck);
  } catch (const std::exception&) {  // no whole result: the last one stays
  }
}

}  // namespace clevis::app

#pragma once

#include <filesystem>
#include <string>

#include "app/request/options.h"

namespace clevis::app {

/// The mark beside report.html by which an open report of a watched check
/// learns of a newer one. Without --report it does nothing. At its end the mark
/// goes, and the report becomes one that follows nothing.
class ReportMark {
 public:
  explicit ReportMark(const Options& options);
  ~ReportMark();
  ReportMark(const ReportMark&) = delete;
  ReportMark& operator=(const ReportMark&) = delete;

  /// Says that a run is on its way. @return the run's number.
  int begin_run();

  /// Says whether the run wrote a report.
  void end_run();

 private:
  std::filesystem::path folder_;
  bool has_report_{};
  int run_{};    ///< latest
  int shown_{};  ///< that report.html is of
  std::string stamp_;
};

}  // namespace clevis::app

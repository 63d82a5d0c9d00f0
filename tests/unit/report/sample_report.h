#pragma once

#include <filesystem>

#include "report/check/check_report.h"

namespace clevis::report {

/// A part with every field set to a value of its own.
assessment::PartResult sample_part(const std::string& name);

/// Two parts with limits that pass, a mechanism, phases.
CheckReport sample_report();

/// A folder of this test's own, empty, removed at the end.
class TestFolder {
 public:
  TestFolder();
  ~TestFolder();
  TestFolder(const TestFolder&) = delete;
  TestFolder& operator=(const TestFolder&) = delete;
  std::filesystem::path operator/(const std::string& name) const {
    return path_ / name;
  }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

std::string content_of(const std::filesystem::path& file);

}  // namespace clevis::report

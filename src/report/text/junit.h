#pragma once

#include <string>
#include <vector>

namespace clevis::report {

/// JUnit's words: a failure is a limit that is exceeded, an error a check
/// that could not be judged.
enum class JunitStatus { kPassed, kFailure, kError, kSkipped };

struct JunitCase {
  std::string classname;  ///< "clevis.DCE"
  std::string name;       ///< "safety factor"
  JunitStatus status{};
  /// Holds the numbers, since viewers drop properties.
  std::string message;
  double seconds{};
};

/// A JUnit XML document with one suite.
std::string junit_xml(const std::string& suite,
                      const std::vector<JunitCase>& cases);

}  // namespace clevis::report

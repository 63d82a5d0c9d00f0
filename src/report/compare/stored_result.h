#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <string>
#include <variant>
#include <vector>

namespace clevis::report {

/// One value of a result, in the units of result.json.
using ResultValue = std::variant<double, std::string, std::array<double, 3>>;

/// Something that a result tells about: a part, a joint, the check itself.
struct Subject {
  std::string name;  ///< "part DCE", "joint D", "probe DCE/tip", "mechanism"
  /// By quantity, a name of tolerance_rules().
  std::map<std::string, ResultValue, std::less<>> values;
};

/// Quantities of a result.json or transmission.json for `clevis compare`.
struct StoredResult {
  std::filesystem::path file;
  std::string scene, version;
  std::vector<Subject> subjects;
  /// A baseline may bring its own: quantity -> "0.2 %".
  std::map<std::string, std::string> tolerances;
};

}  // namespace clevis::report

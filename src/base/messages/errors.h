#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

#include "base/messages/exit_code.h"

namespace clevis {

/// A refusal: what is wrong, where, and what to do about it.
///
/// Every error that a user can cause is thrown as this type and caught in
/// app/main.cc only. The code must stand in the catalogue
/// (base/messages/diagnostics.h), which also fixes the exit code.
class Error : public std::runtime_error {
 public:
  /// @param code     catalogue code, e.g. "S003".
  /// @param place    "file:line:column", or the entity ("part DCE, bore_C").
  /// @param problem  one sentence: what was found, with value and unit.
  /// @param remedy   one sentence: what to do.
  Error(std::string_view code, std::string place, std::string problem,
        std::string remedy);

  const std::string& code() const { return code_; }
  const std::string& place() const { return place_; }
  const std::string& problem() const { return problem_; }
  const std::string& remedy() const { return remedy_; }
  ExitCode exit_code() const;

 private:
  std::string code_, place_, problem_, remedy_;
};

}  // namespace clevis

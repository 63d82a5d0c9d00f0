#include "base/messages/errors.h"

#include <utility>

#include <fmt/format.h>

#include "base/messages/diagnostics.h"

namespace clevis {

Error::Error(std::string_view code, std::string place, std::string problem,
             std::string remedy)
    : std::runtime_error(fmt::format("{}: {} ({})", place, problem, code)),
      code_(code),
      place_(std::move(place)),
      problem_(std::move(problem)),
      remedy_(std::move(remedy)) {}

ExitCode Error::exit_code() const {
  return find_diagnostic(code_).exit_code;
}

}  // namespace clevis

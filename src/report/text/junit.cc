#include "report/text/junit.h"

#include <algorithm>

#include <fmt/format.h>

#include "report/text/json_text.h"
#include "report/text/markup.h"
#include "report/text/terminal.h"

namespace clevis::report {
namespace {

std::string escape(const std::string& text) {
  return escape_markup(printable(valid_utf8(text)));
}

std::string element(const JunitCase& test) {
  const std::string message = escape(test.message);
  switch (test.status) {
    case JunitStatus::kPassed:
      return fmt::format("<system-out>{}</system-out>", message);
    case JunitStatus::kFailure:
      return fmt::format(
          "<failure type=\"limit exceeded\" message=\"{0}\">{0}</failure>",
          message);
    case JunitStatus::kError:
      return fmt::format(
          "<error type=\"not judged\" message=\"{0}\">{0}</error>", message);
    case JunitStatus::kSkipped:
      return fmt::format("<skipped message=\"{}\"/>", message);
  }
  return {};
}

}  // namespace

std::string junit_xml(const std::string& suite,
                      const std::vector<JunitCase>& cases) {
  const auto count = [&](JunitStatus status) {
    return std::ranges::count(cases, status, &JunitCase::status);
  };
  double seconds = 0.0;
  for (const JunitCase& test : cases) seconds += test.seconds;
  std::string xml = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<testsuites>\n"
      "  <testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"{}\" "
      "skipped=\"{}\" time=\"{:.3f}\">\n",
      escape(suite), cases.size(), count(JunitStatus::kFailure),
      count(JunitStatus::kError), count(JunitStatus::kSkipped), seconds);
  for (const JunitCase& test : cases) {
    xml += fmt::format(
        "    <testcase classname=\"{}\" name=\"{}\" time=\"{:.3f}\">{}"
        "</testcase>\n",
        escape(test.classname), escape(test.name), test.seconds, element(test));
  }
  return xml + "  </testsuite>\n</testsuites>\n";
}

}  // namespace clevis::report

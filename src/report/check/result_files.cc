#include "report/check/result_files.h"

#include <system_error>

#include "report/check/check_junit.h"
#include "report/check/parts_csv.h"
#include "report/check/result_json.h"
#include "report/text/atomic_file.h"

namespace clevis::report {

void write_result_files(const CheckReport& report,
                        const std::filesystem::path& folder) {
  const std::string result = result_json(report);
  const std::filesystem::path result_file = folder / "result.json";
  std::error_code failure;
  std::filesystem::remove(result_file, failure);
  if (failure) {
    throw Error("I002", result_file.string(),
                "cannot replace file: " + failure.message(),
                "Check that the folder may be written.");
  }
  write_file(folder / "parts.csv", parts_csv(report));
  if (!report.bearings.empty()) {
    write_file(folder / "bearings.csv", bearings_csv(report.bearings));
  }
  write_file(folder / "junit.xml", check_junit(report));
  write_file(result_file, result);
}

}  // namespace clevis::report

#include "app/variants/finished_check.h"

#include <fstream>
#include <iostream>
#include <iterator>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/request/error_text.h"
#include "app/request/output_folder.h"
#include "app/variants/check_inputs.h"
#include "base/system/mpi_run.h"
#include "report/text/atomic_file.h"

namespace clevis::app {
namespace {

using nlohmann::ordered_json;

/// By the words of part::Verdict.
std::optional<ExitCode> code_of(const std::string& verdict) {
  if (verdict == "pass") return ExitCode::kPass;
  if (verdict == "fail") return ExitCode::kLimitExceeded;
  if (verdict == "not judged") return ExitCode::kNotJudged;
  return std::nullopt;
}

bool is_finished(const ordered_json& result,
                 const report::CheckInputs& inputs) {
  return result.is_object() && result.value("complete", false) &&
         result.value("failures", ordered_json("none")).empty() &&
         result.value("version", "") == inputs.version &&
         result.value("inputs", ordered_json()) == report::inputs_json(inputs);
}

}  // namespace

std::optional<ExitCode> finished_check(const Options& options) {
  const std::filesystem::path folder = output_folder(options);
  const std::filesystem::path file = folder / "result.json";
  std::error_code failure;
  if (!std::filesystem::is_regular_file(file, failure)) return std::nullopt;
  std::ifstream stream(file, std::ios::binary);
  const std::string text(std::istreambuf_iterator<char>(stream), {});
  const auto result = ordered_json::parse(text, nullptr, false);
  const report::CheckInputs inputs =
      check_inputs(options, scene::read_scene(options.scene, options.settings));
  std::string verdict;
  try {
    if (!is_finished(result, inputs)) return std::nullopt;
    verdict = result.value("verdict", "");
  } catch (const nlohmann::json::exception&) {  // a key of another type
    return std::nullopt;
  }
  const auto code = code_of(verdict);
  if (!code) return std::nullopt;
  std::filesystem::remove(folder / "error.json", failure);  // of other inputs
  std::cout << (options.json ? text
                             : fmt::format("finished before: {} ({})\n",
                                           verdict, file.string()));
  return code;
}

void write_refusal(const Options& options, const Error& error) {
  if (mpi_rank() > 0) return;
  try {
    report::write_file(output_folder(options) / "error.json",
                       error_document(error));
  } catch (const Error&) {  // the refusal itself is told all the same
  }
}

}  // namespace clevis::app

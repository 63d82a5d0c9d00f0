#include "study/table.h"

#include <cmath>

#include <fmt/format.h>

#include "report/text/text_table.h"

namespace clevis::study {
namespace {

constexpr const char* kCheckSeries = "clevis check";

std::string percent(double ratio) {
  return fmt::format("{:.3g}", 100.0 * ratio);
}

/// No error where the run is the reference itself.
std::string error_of(double value, const Reference& reference) {
  const double error = relative_error(value, reference);
  return error != 0.0 ? percent(error) : "reference";
}

std::vector<report::TextTable::Cell> row(const PartStudy& part,
                                         const Run& run) {
  return {{part.name},
          {run.series},
          {run.setting},
          {fmt::format("{}", run.dofs)},
          {fmt::format("{:.3g}", run.cpu_seconds)},
          {fmt::format("{:.3g}", run.seconds.total)},
          {fmt::format("{:.0f}", run.memory / 1e6)},
          {fmt::format("{:#.6g}", run.peak / 1e6)},
          {error_of(run.peak, part.peak)},
          {error_of(run.energy, part.energy)},
          {run.displacement_difference ? percent(*run.displacement_difference)
                                       : ""}};
}

std::string words(const std::optional<Run>& run) {
  return run ? fmt::format("{}, {}: {:.3g} CPU s, {:.0f} MB", run->series,
                           run->setting, run->cpu_seconds, run->memory / 1e6)
             : std::string("none");
}

std::string summary(const PartStudy& part, bool has_other) {
  std::string text = fmt::format(
      "{}, {}: reference {:#.6g} +- {:.1g} MPa, {:#.7g} +- {:.1g} mJ ({})\n",
      part.name, part.load, part.peak.value / 1e6, part.peak.uncertainty / 1e6,
      part.energy.value * 1e3, part.energy.uncertainty * 1e3,
      part.reference_run);
  for (const double tolerance : {0.01, 0.001}) {
    if (part.peak.uncertainty > tolerance * std::abs(part.peak.value)) {
      text += fmt::format("  the reference itself is not known to {:g} %\n",
                          100.0 * tolerance);
      continue;
    }
    text +=
        fmt::format("  peak within {:g} %: {}\n", 100.0 * tolerance,
                    words(fastest_within(part, tolerance, Program::kClevis)));
    if (!has_other) continue;
    text += fmt::format(
        "    {}\n", words(fastest_within(part, tolerance, Program::kOther)));
  }
  return text;
}

bool is_of(const Run& run, Program program) {
  const bool is_other = run.series.starts_with("CalculiX");
  return program == Program::kOther ? is_other
                                    : !is_other && run.series != kCheckSeries;
}

}  // namespace

std::optional<Run> fastest_within(const PartStudy& part, double tolerance,
                                  Program program) {
  std::optional<Run> best;
  for (std::size_t r = 0; r < part.runs.size(); ++r) {
    const Run& run = part.runs[r];
    if (!is_of(run, program) || !run.left_out.empty()) continue;
    bool holds = true;
    for (std::size_t s = r; s < part.runs.size(); ++s) {
      const Run& finer = part.runs[s];
      if (finer.series != run.series || !finer.left_out.empty()) continue;
      holds = holds && relative_error(finer.peak, part.peak) <= tolerance;
    }
    if (holds && (!best || run.cpu_seconds < best->cpu_seconds)) best = run;
  }
  return best;
}

std::string study_table(const Study& study, report::Colour colour) {
  using enum report::Align;
  report::TextTable table({{"part", kLeft},
                           {"model", kLeft},
                           {"", kLeft},
                           {"DoF", kRight},
                           {"CPU s", kRight},
                           {"wall s", kRight},
                           {"MB", kRight},
                           {"peak MPa", kRight},
                           {"error %", kRight},
                           {"energy error %", kRight},
                           {"displ. diff. %", kRight}});
  std::string summaries;
  for (const PartStudy& part : study.parts) {
    bool has_other = false;
    for (const Run& run : part.runs) {
      if (!run.left_out.empty()) {
        table.add_note(fmt::format("    {}, {}, {}: left out, {}", part.name,
                                   run.series, run.setting, run.left_out));
        continue;
      }
      has_other = has_other || is_of(run, Program::kOther);
      table.add_row(row(part, run));
    }
    summaries += summary(part, has_other);
  }
  std::string text = study.scene + "\n" + table.text(colour) + "\n" + summaries;
  text += "CalculiX: " + study.calculix + "\n";
  if (!study.complete) text += "interrupted: not all runs were made\n";
  return text;
}

}  // namespace clevis::study

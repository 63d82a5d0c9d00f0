#include "report/check/check_table.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "part/verdict.h"
#include "report/parts/buckling_output.h"
#include "report/parts/part_impact_output.h"
#include "report/parts/peak_quantities.h"
#include "report/parts/probe_quantities.h"
#include "report/text/text_table.h"
#include "report/text/units.h"

namespace clevis::report {
namespace {

using assessment::PartResult;
using assessment::PeakVerdict;
using part::Verdict;

/// "-" where beam theory says nothing.
/// @param unit  of the text, in SI.
std::string or_dash(const std::optional<double>& value, double unit,
                    const char* format) {
  return value ? fmt::format(fmt::runtime(format), *value / unit) : "-";
}

std::vector<TextTable::Cell> part_row(const PartResult& part) {
  const assessment::PeakStress& peak = part.peak;
  return {
      {part.name},
      {fmt::format("{:#.5g}", megapascals(peak.value))},
      {fmt::format("[{:#.5g}, {:#.5g}]", megapascals(peak.band_low),
                   megapascals(peak.band_high))},
      {peak.group + " " + place_text(peak.at)},
      {peak.label},
      {part.model},
      {judged_peak(part).value > 0.0  // of no stress there is none
           ? fmt::format("{:#.4g}", part.safety_factor)
           : "-"},
      {fmt::format("{:#.4g}", millimetres(part.deflection))},
      {or_dash(part.beam.peak_stress, 1e6, "{:#.4g}")},
      {or_dash(part.beam.ratio_fe_to_beam, 1.0, "{:.3f}")},
      {std::string(text(part.verdict)), tone_of(part.verdict)},
      {fmt::format("{:.2f}", part.seconds.total)},
  };
}

void add_probes(TextTable& table, const PartResult& part) {
  for (const auto& probe : part.probes) {
    const bool length = is_displacement(probe);
    const auto in_unit = [&](double value) {
      return length ? millimetres(value) : megapascals(value);
    };
    table.add_note(fmt::format(
        "probe {}: {} = {:#.5g} [{:#.5g}, {:#.5g}] {}", probe.name,
        probe.quantity, in_unit(probe.value), in_unit(probe.band_low),
        in_unit(probe.band_high), length ? "mm" : "MPa"));
  }
}

void add_zones(TextTable& table, const PartResult& part) {
  for (const auto& zone : part.singular_zones) {
    std::string line = fmt::format("singular zone: {}, stress ~ ", zone.name);
    line += zone.exponent < 1.0 ? fmt::format("r^{:.4f}", zone.exponent - 1.0)
                                : std::string("ln r");
    if (zone.exponent_measured) {
      line += fmt::format(" (measured {:.4f})", *zone.exponent_measured - 1.0);
    }
    line += fmt::format(", radius {:#.3g} mm", millimetres(zone.radius));
    table.add_note(zone.governs ? line : line + ", does not govern");
  }
  if (part.held) table.add_note(support_section_text(*part.held));
  if (!part.peak_outside) return;
  const assessment::PeakStress& outside = *part.peak_outside;
  table.add_note(fmt::format(
      "away from the singular zones: {:#.5g} [{:#.5g}, {:#.5g}] MPa at {} {}, "
      "{}",
      megapascals(outside.value), megapascals(outside.band_low),
      megapascals(outside.band_high), outside.group, place_text(outside.at),
      text(outside.verdict)));
}

void add_pin_reactions(TextTable& table, const PartResult& part) {
  for (const assessment::PinReaction& pin : part.pin_reactions) {
    const auto text = [](const Eigen::Vector3d& v, double small) {
      const Eigen::Vector3d shown = v.unaryExpr([small](double x) {
        return std::abs(x) <= small ? 0.0 : x;
      });
      return fmt::format("({:.5g}, {:.5g}, {:.5g})", shown.x(), shown.y(),
                         shown.z());
    };
    constexpr double kRoundOff = 1e-9;
    const double small = kRoundOff * (pin.force.norm() + pin.moment.norm());
    std::string line =
        fmt::format("case {}: the pin in {} holds with {} N", pin.label,
                    pin.group, text(pin.force, small));
    if (pin.moment.norm() > small) {
      line += fmt::format(" and {} N m", text(pin.moment, small));
    }
    table.add_note(pin.unique ? line
                              : line + ", as the part's compliance shares it");
  }
}

void add_deflection(TextTable& table, const PartResult& part) {
  if (part.deflection == 0.0) return;
  table.add_note(fmt::format(
      "deflection: {:#.4g} [{:#.4g}, {:#.4g}] mm", millimetres(part.deflection),
      millimetres(part.deflection_low), millimetres(part.deflection_high)));
}

/// Whether the engine is worth a line: it was asked for, or it may well have
/// been the other.
bool tells_engine(const PartResult& part, const std::string& asked) {
  constexpr int kManyUnknowns = 100000;
  return !part.engine_why.empty() && (asked != "auto" || part.engine != "own" ||
                                      part.dofs >= kManyUnknowns);
}

void add_reasons(TextTable& table, const PartResult& part,
                 const std::string& engine_asked) {
  if (!part.stopped_because.empty()) table.add_note(part.stopped_because);
  if (tells_engine(part, engine_asked)) {
    table.add_note(fmt::format("engine {}: {}", part.engine, part.engine_why));
  }
  if (part.peak.verdict != PeakVerdict::kConverged) {
    table.add_note(fmt::format("peak: {}", text(part.peak.verdict)));
  }
  if (!part.why.empty()) {
    table.add_note(fmt::format("{}: {}", text(part.verdict), part.why));
  }
  const std::string buckling = buckling_text(part.buckling);
  if (!buckling.empty()) table.add_note(buckling);
  if (!part.beam.reason.empty()) {
    table.add_note("FE/beam: " + part.beam.reason);
  }
  for (const std::string& note : part.notes) table.add_note(note);
}

std::string not_unique_line(const MechanismSummary& mechanism) {
  if (mechanism.not_unique.empty()) return "";
  return fmt::format(
      "  reactions not unique, shared by compliance: {}\n",
      printable(fmt::format("{}", fmt::join(mechanism.not_unique, ", "))));
}

std::string change_point_lines(const MechanismSummary& mechanism) {
  if (mechanism.change_points.empty()) return "";
  std::string text;
  for (const PassedChangePoint& point : mechanism.change_points) {
    text += fmt::format("  change point at {:.8g} s, passed on its branch: ",
                        point.at);
    text += point.joint.empty()
                ? "rigid reactions have no bound there\n"
                : fmt::format(
                      "joints that give way carry {:.4g} N at most, in "
                      "{}\n",
                      point.largest_force, printable(point.joint));
  }
  if (mechanism.instants_left_out > 0) {
    text += fmt::format(
        "  left out of the parts' loads: {} {} just there, where they balance "
        "in "
        "the deflected position only\n",
        mechanism.instants_left_out,
        mechanism.instants_left_out == 1 ? "instant" : "instants");
  }
  return text +
         "  towards a change point rigid reactions grow without bound: peaks "
         "of parts depend on the instants\n";
}

std::string mechanism_line(const MechanismSummary& mechanism) {
  return fmt::format(
             "mechanism: mobility {}, {} redundant constraints, {} instants, "
             "closure "
             "{:.1e} mm, power balance {:.1e}\n",
             mechanism.mobility, mechanism.redundant_constraints,
             mechanism.instants, millimetres(mechanism.max_closure_error),
             mechanism.max_power_balance_error) +
         note_lines(mechanism.notes) + not_unique_line(mechanism) +
         change_point_lines(mechanism) +
         drive_jump_lines(mechanism.drive_jumps);
}

std::string last_line(const CheckReport& report, Colour colour) {
  const part::Verdict verdict = overall_verdict(report);
  std::string line =
      "verdict: " + paint(text(verdict), tone_of(verdict), colour);
  if (!report.complete) line += " (interrupted: parts are missing)";
  const auto total = std::ranges::find(report.seconds, "total",
                                       &std::pair<std::string, double>::first);
  if (total != report.seconds.end()) {
    line += fmt::format("   {:.2f} s", total->second);
  }
  return line + "\n";
}

}  // namespace

std::string check_table(const CheckReport& report, Colour colour) {
  TextTable table({{"part"},
                   {"peak MPa", Align::kRight},
                   {"band MPa"},
                   {"where (x, y, z mm)"},
                   {"when"},
                   {"model"},
                   {"safety", Align::kRight},
                   {"defl. mm", Align::kRight},
                   {"beam MPa", Align::kRight},
                   {"FE/beam", Align::kRight},
                   {"verdict"},
                   {"s", Align::kRight}});
  for (const PartResult& part : report.parts) {
    table.add_row(part_row(part));
    add_probes(table, part);
    add_deflection(table, part);
    add_zones(table, part);
    add_pin_reactions(table, part);
    add_reasons(table, part, report.inputs.engine);
  }
  for (const PartFailure& failure : report.failures) {
    table.add_note(fmt::format("{}: not computed: {} {}", failure.name,
                               failure.error.what(), failure.error.remedy()));
  }
  std::string all = fmt::format("{} ({})\n", printable(report.scene),
                                printable(report.file.string()));
  if (report.mechanism) all += mechanism_line(*report.mechanism);
  if (report.mechanism && !report.mechanism->impacts.empty()) {
    all += "\n" + impacts_text(report.mechanism->impacts, colour);
  }
  const bool is_empty = report.parts.empty() && report.failures.empty();
  if (!is_empty) {
    all += "\n" + table.text(colour);
  } else if (report.complete) {
    all += "\nthe scene has no [[part]], so no stress is judged\n";
  }
  for (const PartResult& part : report.parts) {
    all += part_impacts_text(part, colour);
  }
  if (!report.bearings.empty()) {
    all += "\n" + bearings_text(report.bearings, colour);
  }
  return all + "\n" + last_line(report, colour);
}

}  // namespace clevis::report

#include "report/motion/motion_table.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "report/forces/coupling_output.h"
#include "report/forces/element_output.h"
#include "report/summary/mechanism_summary.h"
#include "report/text/text_table.h"
#include "report/text/units.h"

namespace clevis::report {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double kDegree = std::numbers::pi / 180.0;

/// Seconds, forces and lengths; −0.000 prints as 0.000.
std::string number(double value, int decimals) {
  const double unit = std::pow(10.0, -decimals);
  const bool vanishes = std::abs(value) < 0.5 * unit;
  return fmt::format("{:.{}f}", vanishes ? 0.0 : value, decimals);
}

/// Forces: four digits or thousandths.
std::string newtons(double value) {
  return number(value, 3);
}

std::string point(const Vector2d& metres) {
  const Vector2d mm = millimetres(metres);
  return fmt::format("({}, {})", number(mm.x(), 3), number(mm.y(), 3));
}

std::string redundancy(int count, const std::vector<std::string>& joints) {
  if (count == 0) return "0";
  return fmt::format("{} (among {})", count, fmt::join(joints, ", "));
}

std::string inputs_text(const std::vector<std::string>& joints) {
  if (joints.empty()) return "";
  return fmt::format(", with {} as input{}", fmt::join(joints, ", "),
                     joints.size() > 1 ? "s" : "");
}

std::string structure_text(const mechanism::Structure& s) {
  std::string text = fmt::format(
      "structure   {} mechanism, {} moving links, {} pairs\n"
      "mobility    {} by Chebyshev, {} by rank; redundant constraints: {}\n",
      s.planar ? "planar" : "spatial", s.moving_links, s.pairs, s.chebyshev,
      s.mobility, redundancy(s.redundant, s.redundant_in));
  if (!s.planar) return text;
  text += fmt::format(
      "  as spatial {} by Chebyshev, {} by rank; redundant constraints: {}\n",
      s.spatial_chebyshev, s.spatial_mobility,
      redundancy(s.spatial_redundant, s.spatial_redundant_in));
  if (!s.assur_corrected.empty()) {
    text += fmt::format("groups      {}: class {}{}\n", s.assur_corrected,
                        s.assur_class_corrected, inputs_text(s.assur_inputs));
  }
  if (!s.assur_none.empty()) {
    text += fmt::format("groups      none: {}\n", s.assur_none);
  }
  if (!s.assur_published.empty()) {
    text += fmt::format("  remainder taken as one group: {}: class {}\n",
                        s.assur_published, s.assur_class_published);
  }
  return text;
}

std::string change_point_text(const MotionReport& report) {
  std::string text;
  for (const auto& point : report.motion.change_points) {
    text += fmt::format("  change point at {:.8g} s, passed on its branch: ",
                        point.t);
    if (!point.at && report.motion.integration) {
      text += "rigid reactions have no bound there\n";
      continue;
    }
    if (!point.at) {
      text += "not even joints that give way hold the loads\n";
      continue;
    }
    const auto& joints = point.at->joints;
    const auto largest =
        std::ranges::max_element(joints, {}, [](const auto& joint) {
          return joint.f_W.norm();
        });
    const auto index = static_cast<std::size_t>(largest - joints.begin());
    text += fmt::format("joints that give way carry {} N at most, in {}\n",
                        newtons(largest->f_W.norm()),
                        report.definition.joints[index].name);
  }
  if (!text.empty()) {
    text +=
        "  towards a change point rigid reactions grow without bound: their "
        "peaks depend on the instants\n";
  }
  return text;
}

std::string quality_text(const MotionReport& report,
                         const MechanismSummary& summary) {
  std::string text = fmt::format(
      "motion      {} instants, 0 to {:.6g} s; largest gap {:.1e} mm; power "
      "balance to {:.1e}\n",
      summary.instants, report.motion.instants.back().t,
      millimetres(summary.max_closure_error), summary.max_power_balance_error);
  if (const auto& run = report.motion.integration) {
    text += fmt::format(
        "  integrated by {}: {} steps{}, {} rejected, {} evaluations; energy "
        "balance to {:.1e} J, {:.1e} of the largest\n",
        run->method, run->steps,
        run->implicit_steps > 0 && run->implicit_steps < run->steps
            ? fmt::format(" ({} implicit)", run->implicit_steps)
            : "",
        run->rejected, run->evaluations, run->energy_error,
        run->relative_energy_error);
  }
  return text + note_lines(summary.notes) + change_point_text(report) +
         drive_jump_lines(named_drive_jumps(report.definition, report.motion));
}

std::string reactions_text(const MotionReport& report,
                           const MechanismSummary& summary, Colour colour) {
  std::vector<TextTable::Column> columns{{"joint"}};
  const std::vector<std::size_t> shown = shown_instants(report.motion);
  for (const std::size_t i : shown) {
    columns.push_back(
        {fmt::format("N at {:.6g} s", report.motion.instants[i].t),
         Align::kRight});
  }
  for (const char* title : {"peak N", "at s", "peak N m", "at s"}) {
    columns.push_back({title, Align::kRight});
  }
  columns.push_back({"unique"});
  TextTable table(columns);
  for (std::size_t j = 0; j < summary.joints.size(); ++j) {
    const JointPeaks& peaks = summary.joints[j];
    const bool unique =
        std::ranges::all_of(report.motion.instants, [j](const auto& instant) {
          return instant.joints[j].unique;
        });
    std::vector<TextTable::Cell> cells{{peaks.name}};
    for (const std::size_t i : shown) {
      cells.push_back(
          {newtons(report.motion.instants[i].joints[j].f_W.norm())});
    }
    for (const Peak& peak : {peaks.force, peaks.moment}) {
      const std::string value = newtons(peak.value);
      cells.push_back({value});
      cells.push_back(
          {value == "0.000" ? "-" : fmt::format("{:.6g}", peak.at)});
    }
    cells.push_back({unique ? "yes" : "no"});
    table.add_row(cells);
  }
  return table.text(colour);
}

/// Reactions that redundancy leaves to the joints' compliance.
std::string open_components_text(const MechanismSummary& summary,
                                 Colour colour) {
  TextTable table({{"left open by equilibrium"},
                   {"component"},
                   {"peak", Align::kRight},
                   {"at s", Align::kRight},
                   {"compliances x2 or /2", Align::kRight}});
  int left_out = 0;
  for (const OpenComponent& open : summary.open_components) {
    const std::string value = newtons(open.peak.value);
    const std::string spread = newtons(open.spread);
    if (value == "0.000" && spread == "0.000") {
      ++left_out;
      continue;
    }
    const char* unit = open.is_moment ? " N m" : " N";
    table.add_row({{open.joint},
                   {open.component},
                   {value + unit},
                   {fmt::format("{:.6g}", open.peak.at)},
                   {"+-" + spread + unit}});
  }
  if (left_out > 0) {
    table.add_note(fmt::format("{} more that carry nothing", left_out));
  }
  return table.text(colour);
}

std::string drives_text(const MotionReport& report,
                        const MechanismSummary& summary, Colour colour) {
  TextTable table({{"drive"},
                   {"t s", Align::kRight},
                   {"position", Align::kRight},
                   {"effort", Align::kRight}});
  for (std::size_t d = 0; d < summary.drives.size(); ++d) {
    const DrivePeak& peak = summary.drives[d];
    const bool force = peak.kind == EffortKind::kForce;
    for (const std::size_t i : shown_instants(report.motion)) {
      const auto& instant = report.motion.instants[i];
      const auto& drive = instant.drives[d];
      table.add_row({{peak.name},
                     {fmt::format("{:.6g}", instant.t)},
                     {force ? number(millimetres(drive.position), 3) + " mm"
                            : number(drive.position / kDegree, 3) + " deg"},
                     {newtons(drive.effort) + (force ? " N" : " N m")}});
    }
    table.add_note(fmt::format("{}: peak effort {} {} at {:.6g} s", peak.name,
                               newtons(peak.effort.value), force ? "N" : "N m",
                               peak.effort.at));
  }
  return table.text(colour);
}

std::string markers_text(const MotionReport& report, Colour colour) {
  TextTable table({{"marker"},
                   {"t s", Align::kRight},
                   {"x mm", Align::kRight},
                   {"y mm", Align::kRight},
                   {"z mm", Align::kRight}});
  for (const auto& marker : report.definition.markers) {
    for (const std::size_t i : shown_instants(report.motion)) {
      const auto& instant = report.motion.instants[i];
      const Vector3d at = millimetres(marker_position(marker, instant));
      table.add_row({{marker.name},
                     {fmt::format("{:.6g}", instant.t)},
                     {number(at.x(), 3)},
                     {number(at.y(), 3)},
                     {number(at.z(), 3)}});
    }
  }
  return table.text(colour);
}

std::string slide_lever_text(const SlideLeverComparison& lever, Colour colour) {
  TextTable table({{"closed form"},
                   {"l_x mm", Align::kRight},
                   {"C mm", Align::kRight},
                   {"|DC| mm", Align::kRight},
                   {"v_C/v_cyl", Align::kRight}});
  for (const SlideLeverRow& row : lever.rows) {
    const std::string l_x = number(millimetres(row.cylinder_length), 3);
    const auto add = [&](const char* name, const Vector2d& C, double DC,
                         double ratio) {
      table.add_row({{name},
                     {l_x},
                     {point(C)},
                     {number(millimetres(DC), 3)},
                     {number(ratio, 4)}});
    };
    add("simulated", row.simulated, row.simulated_DC, row.simulated_ratio);
    add("corrected", row.corrected.C, row.corrected.DC,
        row.corrected.C_rate.norm());
    add("published (2.9)", row.published.C, row.published.DC,
        row.published.C_rate.norm());
  }
  table.add_note(fmt::format(
      "{} turns by {} deg; over all instants |DC| by the corrected form is {} "
      "mm to {:.1e}, its C within {:.1e} mm of the simulation",
      lever.body, number(std::abs(lever.rotation) / kDegree, 2),
      number(millimetres(lever.link_DC), 3), lever.largest_DC_error,
      millimetres(lever.largest_C_distance)));
  return table.text(colour);
}

}  // namespace

std::string motion_table(const MotionReport& report, Colour colour) {
  const MechanismSummary summary =
      summarise(report.definition, report.structure, report.motion);
  std::string text = printable(report.scene);
  text += '\n';
  text += structure_text(report.structure);
  text += quality_text(report, summary);
  text += '\n';
  text += reactions_text(report, summary, colour);
  if (!summary.open_components.empty()) {
    text += '\n';
    text += open_components_text(summary, colour);
  }
  if (!report.definition.drives.empty()) {
    text += '\n';
    text += drives_text(report, summary, colour);
  }
  if (!report.definition.couplings.empty()) {
    text += '\n';
    text += couplings_text(report, colour);
  }
  if (const std::string forces = forces_text(report, colour); !forces.empty()) {
    text += '\n';
    text += forces;
  }
  if (!report.bearings.empty()) {
    text += '\n';
    text += bearings_text(report.bearings, colour);
  }
  if (!report.definition.markers.empty()) {
    text += '\n';
    text += markers_text(report, colour);
  }
  if (report.slide_lever) {
    text += '\n';
    text += slide_lever_text(*report.slide_lever, colour);
  }
  return text;
}

}  // namespace clevis::report

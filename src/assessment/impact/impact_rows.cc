#include "assessment/impact/impact_rows.h"

#include <cmath>
#include <string>

#include <fmt/format.h>

#include "base/values/stopwatch.h"

namespace clevis::assessment {
namespace {

std::string percent(double part) {
  return fmt::format("{:.2g} %", 100.0 * std::abs(part));
}

}  // namespace

std::optional<beam::BarOfPart> bar_of(const PartJob& job,
                                      const ImpactJob& impact) {
  if (impact.fixed.size() != 1) return std::nullopt;
  const auto& [root, held] = *impact.fixed.begin();
  if (!(held[0] && held[1] && held[2])) return std::nullopt;
  return beam::bar_of_part(
      job.mesh, job.part.material, job.mass.mass, group_of(job, root).centroid,
      group_of(job, impact.strike.group).centroid, impact.strike.direction);
}

/// The published model takes twice the speed and a third of the stiffness.
void add_beam_rows(const beam::BarOfPart& bar, const loads::Strike& strike,
                   std::vector<ImpactRow>& rows) {
  const beam::Blow blow{
      .mass = strike.mass, .speed = strike.speed, .force = strike.force};
  beam::Blow twice = blow;
  twice.speed *= 2.0;
  const auto add = [&rows](ImpactModel model, auto compute) {
    Stopwatch watch;
    const beam::BarImpact found = compute();
    rows.push_back({.model = model,
                    .nominal = found.stress,
                    .face = found.deflection,
                    .seconds = watch.lap()});
  };
  add(ImpactModel::kBeamPublished, [&] {
    return beam::impact(bar.published, twice);
  });
  add(ImpactModel::kBeamCorrected, [&] {
    return beam::impact(bar.bar, blow);
  });
  add(ImpactModel::kBeamMovingAlong, [&] {
    return beam::impact(bar.bar, blow, beam::StruckMass::kMovesAlong);
  });
}

std::optional<double> beam_factor(const beam::BarOfPart& bar,
                                  const loads::Strike& strike) {
  return beam::impact(bar.bar, {.mass = strike.mass,
                                .speed = strike.speed,
                                .force = strike.force})
      .factor;
}

template <int dim>
ImpactRow struck_row(const StruckRun<dim>& run, int degree, double error) {
  const auto& solution = run.response.solution;
  std::optional<double> nominal;
  if (run.root.value > 0.0) nominal = run.root.value;
  return {.model = ImpactModel::kElementsInTime,
          .scheme = solution.is_modal ? fmt::format("{} shapes", solution.modes)
                                      : fmt::format("{} steps", solution.steps),
          .degree = degree,
          .stress = run.stress,
          .nominal = nominal,
          .face = run.response.motion().peak_contact,
          .deflection = run.deflection.value,
          .error = error,
          .seconds = run.seconds};
}

std::string remark_on(const ImpactRow& row, const ImpactResult& impact,
                      double face, double part_stiffness) {
  constexpr double kEqual = 0.02, kClose = 0.10;
  if (!row.ratio) return "knows a section's stress alone: none is held";
  const double off = *row.ratio - 1.0;
  std::string text = std::abs(off) < kEqual ? "agrees"
                     : off < 0.0            ? "unsafe by " + percent(off)
                                            : "safe by " + percent(off);
  const double bent = row.face / face;
  if (bent > 1.0 + kClose || bent < 1.0 - kClose) {
    text += fmt::format(", face moves {:.2f} times", bent);
  }
  if (row.model == ImpactModel::kBeamPublished) {
    return text + ": twice the speed on a third of the stiffness";
  }
  if (off < -kEqual) {
    text +=
        fmt::format(": {}, mass ratio {:.2g}, load for {:.2g} periods",
                    impact.is_axial ? "waves along the rod" : "higher modes",
                    impact.mass / impact.part_mass,
                    impact.load_duration / impact.first_period);
  } else if (off > kEqual && impact.exponent == 1.0 &&
             impact.stiffness < 10.0 * part_stiffness) {
    text += fmt::format(
        ": the contact, {:.2g} times as stiff as the part, takes its share",
        impact.stiffness / part_stiffness);
  } else if (off > kEqual) {
    text += fmt::format(
        ": part of the energy goes into the part's own motion, "
        "mass ratio {:.2g}",
        impact.mass / impact.part_mass);
  }
  return text;
}

template ImpactRow struck_row<2>(const StruckRun<2>&, int, double);
template ImpactRow struck_row<3>(const StruckRun<3>&, int, double);

}  // namespace clevis::assessment

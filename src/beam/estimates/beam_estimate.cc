#include "beam/estimates/beam_estimate.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <utility>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "beam/estimates/deflection.h"
#include "beam/estimates/slide_positions.h"
#include "beam/sections/lug.h"
#include "beam/sections/pin_line.h"
#include "beam/theory/formulas.h"
#include "loads/history/balance.h"
#include "loads/holds/holding_groups.h"

namespace clevis::beam {

namespace {

// Loads that leave more than this of themselves are taken by supports, whose
// reactions beam theory does not know.
constexpr double kBalanceTolerance = 1e-6;

bool is_self_balanced(const loads::LoadHistory& history,
                      const part::MassProperties& mass) {
  for (const loads::InstantLoad& instant : history.instants) {
    double scale = mass.mass * instant.rigid.acceleration.norm();
    for (const loads::Wrench& wrench : instant.wrenches) {
      scale += wrench.force.norm();
    }
    for (const loads::SurfaceLoad& load : instant.surface_loads) {
      scale += load.total;
    }
    const loads::Wrench left = loads::residual(history, instant, mass);
    if (left.force.norm() > kBalanceTolerance * scale) return false;
  }
  return true;
}

// Keeps the largest stress of one formula.
class Worst {
 public:
  explicit Worst(std::string formula) { worst_.formula = std::move(formula); }
  /// Of the nominal stress of sections.
  static Worst of_sections(std::string formula) {
    Worst worst(std::move(formula));
    worst.worst_.is_section = true;
    return worst;
  }

  /// @return whether it is the largest up to now.
  template <typename Where>
  bool offer(double stress, double instant, const Where& where) {
    if (stress <= worst_.stress) return false;
    worst_.stress = stress;
    worst_.instant = instant;
    worst_.where = where();
    return true;
  }
  void name(std::string formula) { worst_.formula = std::move(formula); }
  void add_to(std::vector<BeamStress>& stresses) const {
    if (worst_.stress > 0.0) stresses.push_back(worst_);
  }

 private:
  BeamStress worst_;
};

void add_span_stresses(const Span& span, const loads::LoadHistory& history,
                       std::vector<BeamStress>& stresses) {
  Worst fibre = Worst::of_sections("axial + bending");
  Worst neutral("axial + shear");
  for (std::size_t k = 0; k < span.stations.size(); ++k) {
    const Station& station = span.stations[k];
    const auto offer = [&](double position) {
      const auto where = [&] {
        return fmt::format("{}-{} at {:.4g} mm", history.seats[span.from].name,
                           history.seats[span.to].name, position * 1e3);
      };
      const Eigen::Vector3d shift =
          (position - span.positions[k]) * station.normal();
      for (const loads::InstantLoad& instant : history.instants) {
        loads::Wrench w =
            section_force(history, instant, span.beyond[k], station);
        w.moment -= shift.cross(w.force);
        if (fibre.offer(station.fibre_stress(w), instant.time, where)) {
          fibre.name(station.is_twisted(w) ? "axial + bending + torsion"
                                           : "axial + bending");
        }
        neutral.offer(station.neutral_axis_stress(w), instant.time, where);
      }
    };
    offer(span.positions[k]);
    // Where a pin's force bends most, with the section beside its bore.
    if (k == 0 && span.starts_at_seat) offer(0.0);
    if (k + 1 == span.stations.size() && span.ends_at_seat) offer(span.length);
  }
  fibre.add_to(stresses);
  neutral.add_to(stresses);
}

/// Length of the strut hinged at both ends that buckles as the span does: the
/// way between two seats that hold the line; beyond them, or of one that is
/// held by a single seat, twice the way to its end; its own where none is on
/// the line [m].
double strut_length(const PinLine& line, const Span& span,
                    const loads::LoadHistory& history,
                    const loads::HoldingGroups& hold) {
  const auto position = [&](std::size_t seat) {
    return history.seats[seat].p_LS.dot(line.direction);
  };
  std::vector<double> held;
  for (const std::size_t seat : line.seats) {
    if (std::ranges::find(hold, loads::holder_of(history.seats, seat)) !=
        hold.end()) {
      held.push_back(position(seat));
    }
  }
  const double own =
      (history.seats[span.to].p_LS - history.seats[span.from].p_LS).norm();
  if (held.empty()) return own;
  const auto [first, last] = std::ranges::minmax(held);
  const double middle = 0.5 * (position(span.from) + position(span.to));
  if (middle > first && middle < last) return last - first;
  double end = 0.0;
  for (const std::size_t seat : line.seats) {
    const double beyond =
        middle <= first ? first - position(seat) : position(seat) - last;
    end = std::max(end, beyond);
  }
  return 2.0 * end;
}

// Keeps the span of the smallest safety. The ends of a span are thick bosses:
// only its middle half counts.
void add_buckling(const PinLine& line, const Span& span,
                  const loads::LoadHistory& history,
                  const std::vector<loads::HoldingGroups>& holds,
                  double youngs_modulus, std::optional<double> buckling_length,
                  BeamEstimate& estimate) {
  const std::size_t n = span.stations.size();
  double compression = 0.0, largest = 0.0;
  double second_moment = std::numeric_limits<double>::infinity();
  for (std::size_t k = n / 4; k < n - n / 4; ++k) {
    const Station& station = span.stations[k];
    second_moment = std::min(second_moment, station.smallest_second_moment());
    for (const loads::InstantLoad& instant : history.instants) {
      const loads::Wrench w =
          section_force(history, instant, span.beyond[k], station);
      compression = std::max(compression, -w.force.dot(line.direction));
      largest = std::max(largest, w.force.norm());
    }
  }
  // Round-off of a span that is pulled or bent is no compression.
  if (compression <= 1e-9 * largest) return;
  double length = buckling_length.value_or(0.0);
  for (const loads::HoldingGroups& hold : holds) {
    if (buckling_length) break;
    length = std::max(length, strut_length(line, span, history, hold));
  }
  const double load = euler_load(youngs_modulus, second_moment, length);
  const double safety = load / compression;
  if (!estimate.buckling || safety < estimate.buckling->safety) {
    estimate.buckling = {load, safety};
  }
}

const loads::GroupGeometry* find_cylinder(
    const std::vector<loads::GroupGeometry>& groups, const std::string& name) {
  const auto found =
      std::ranges::find(groups, name, &loads::GroupGeometry::name);
  return found != groups.end() && found->is_cylinder ? &*found : nullptr;
}

void add_lug_stresses(const PartModel& model, const part::Bore& bore,
                      std::size_t seat, const loads::LoadHistory& history,
                      std::vector<BeamStress>& stresses) {
  const LugGeometry lug(bore, model.outline(bore.p_LC, bore.axis_L));
  Worst bearing("bearing pressure"), net("lug net section"),
      shear_out("lug shear-out");
  const auto where = [&] {
    return history.seats[seat].group;
  };
  for (const loads::InstantLoad& instant : history.instants) {
    const LugStress stress =
        lug_stress(lug, bore, instant.wrenches[seat].force);
    bearing.offer(stress.bearing, instant.time, where);
    net.offer(stress.net_section.value_or(0.0), instant.time, where);
    shear_out.offer(stress.shear_out.value_or(0.0), instant.time, where);
  }
  bearing.add_to(stresses);
  net.add_to(stresses);
  shear_out.add_to(stresses);
}

void add_pressure_stresses(const PartModel& model,
                           const std::vector<loads::GroupGeometry>& groups,
                           const loads::LoadHistory& history,
                           std::vector<BeamStress>& stresses) {
  if (history.instants.empty()) return;
  const auto& loads = history.instants.front().surface_loads;
  for (std::size_t i = 0; i < loads.size(); ++i) {
    const auto* group = find_cylinder(groups, loads[i].group);
    if (group == nullptr) continue;
    const part::Bore& bore = group->cylinder;
    const LugGeometry wall(bore, model.outline(bore.p_LC, bore.axis_L));
    if (!wall.is_bore()) continue;
    Worst lame("thick cylinder under pressure");
    for (const loads::InstantLoad& instant : history.instants) {
      lame.offer(lame_equivalent_stress(instant.surface_loads[i].pressure,
                                        bore.radius, wall.smallest_edge()),
                 instant.time, [&] {
                   return group->name;
                 });
    }
    lame.add_to(stresses);
  }
}

}  // namespace

BeamEstimate estimate(const PartModel& model, const part::Material& material,
                      const part::MassProperties& mass,
                      const std::vector<loads::GroupGeometry>& groups,
                      const loads::LoadHistory& history,
                      std::optional<double> buckling_length) {
  BeamEstimate estimate;
  if (is_self_balanced(history, mass)) {
    const auto holds = loads::holding_groups(history);
    for (const loads::LoadHistory& here : at_slide_positions(history)) {
      for (const PinLine& line : pin_lines(model, mass, groups, here)) {
        for (const Span& span : line.spans) {
          add_span_stresses(span, here, estimate.stresses);
          add_buckling(line, span, here, holds, material.youngs_modulus,
                       buckling_length, estimate);
        }
        estimate.deflection = std::max(
            estimate.deflection, beam_deflection(line, here, holds.front(),
                                                 material.youngs_modulus));
      }
    }
  }
  for (std::size_t i = 0; i < history.seats.size(); ++i) {
    if (history.seats[i].kind != loads::SeatKind::kBearing) continue;
    if (const auto* group = find_cylinder(groups, history.seats[i].group)) {
      add_lug_stresses(model, group->cylinder, i, history, estimate.stresses);
    }
  }
  add_pressure_stresses(model, groups, history, estimate.stresses);
  std::ranges::stable_sort(estimate.stresses, std::ranges::greater{},
                           &BeamStress::stress);
  return estimate;
}

BeamEstimate estimate(const mesh::PartMesh<3>& mesh,
                      const part::Material& material,
                      const part::MassProperties& mass,
                      const std::vector<loads::GroupGeometry>& groups,
                      const loads::LoadHistory& history,
                      std::optional<double> buckling_length) {
  return estimate(part_model(mesh), material, mass, groups, history,
                  buckling_length);
}

}  // namespace clevis::beam

#include "mechanism/line_elements/table.h"

#include <algorithm>

#include "mechanism/element_base/line_force.h"

namespace clevis::mechanism {
namespace {

/// The first mode of a table over positions is the piece that holds: 0 before
/// the first point, positions.size() behind the last.
class Table final : public OneSenseForce {
 public:
  Table(const LineDefinition& definition, const TableLaw& law,
        const ReferenceFrame& frame)
      : OneSenseForce(definition, frame), law_(law) {}

  bool may_switch() const override {
    return over_position() || OneSenseForce::may_switch();
  }
  void choose_modes(const ElementResponse& now) override;
  double event_value(int end, const ElementResponse& now) const override;
  void pass_event(int end, const ElementResponse& now) override;
  std::vector<ElementGuard> guards() const override;

 protected:
  LineTangent tangent(const ElementState& state) const override;
  double full_effort(const ActingState& state,
                     const ElementResponse& now) const override;

 private:
  bool over_position() const { return !law_.positions.empty(); }
  double piece_effort(double q) const;
  double way_left(int end, double q) const;

  const TableLaw& law_;
};

double Table::full_effort(const ActingState& state,
                          const ElementResponse& now) const {
  return over_position() ? piece_effort(now.q)
                         : numerics::linear_at(law_.times, law_.efforts,
                                               state.t, state.side);
}

LineTangent Table::tangent(const ElementState& state) const {
  if (!over_position() || (!acts_in_both() && state.effort == 0.0)) return {};
  constexpr double kOnBend = 1e-6;  // of the table's range
  const auto& positions = law_.positions;
  const double q = state.position;
  const double near = kOnBend * (positions.back() - positions.front());
  const auto stiffness = [&](double position) {
    const auto next = std::ranges::upper_bound(positions, position);
    if (next == positions.begin() || next == positions.end()) return 0.0;
    const auto at = static_cast<std::size_t>(next - positions.begin());
    return -(law_.efforts[at] - law_.efforts[at - 1]) /
           (positions[at] - positions[at - 1]);
  };
  // On a bend it may give way to either side.
  return {std::min({stiffness(q - near), stiffness(q), stiffness(q + near)}),
          0.0};
}

/// Effort by the piece of the mode, which goes on beyond its ends.
double Table::piece_effort(double q) const {
  const auto at = static_cast<std::size_t>(modes[0]);
  if (at == 0) return law_.efforts.front();
  if (at == law_.positions.size()) return law_.efforts.back();
  const double s = (q - law_.positions[at - 1]) /
                   (law_.positions[at] - law_.positions[at - 1]);
  return law_.efforts[at - 1] + s * (law_.efforts[at] - law_.efforts[at - 1]);
}

/// How far the position is from an end of its piece; 1 where there is none.
double Table::way_left(int end, double q) const {
  const auto at = static_cast<std::size_t>(modes[0]);
  if (end == 0) return at == 0 ? 1.0 : q - law_.positions[at - 1];
  return at == law_.positions.size() ? 1.0 : law_.positions[at] - q;
}

void Table::choose_modes(const ElementResponse& now) {
  OneSenseForce::choose_modes(now);
  if (!over_position()) return;
  modes[0] = static_cast<int>(std::ranges::upper_bound(law_.positions, now.q) -
                              law_.positions.begin());
}

double Table::event_value(int end, const ElementResponse& now) const {
  const bool has_sense = sharp_sense() != 0.0;
  if (!over_position() || (has_sense && end == 1)) {
    return OneSenseForce::event_value(end, now);
  }
  return has_sense ? std::min(way_left(0, now.q), way_left(1, now.q))
                   : way_left(end, now.q);
}

void Table::pass_event(int end, const ElementResponse& now) {
  const bool has_sense = sharp_sense() != 0.0;
  if (!over_position() || (has_sense && end == 1)) {
    OneSenseForce::pass_event(end, now);
    return;
  }
  const bool back =
      has_sense ? way_left(0, now.q) < way_left(1, now.q) : end == 0;
  modes[0] += back ? -1 : 1;
}

std::vector<ElementGuard> Table::guards() const {
  std::vector<ElementGuard> all = OneSenseForce::guards();
  for (const double at : law_.positions) {
    all.push_back({ElementGuard::Kind::kPosition, 0, at});
  }
  return all;
}

}  // namespace

ElementProperties properties(const TableLaw& law) {
  ElementProperties result{.type = "table", .may_be_pressure = true};
  if (!law.times.empty()) result.actuation = Actuation::kForce;
  result.breakpoints = law.times;
  result.breaks = law.times;
  for (std::size_t i = 1; i < law.times.size(); ++i) {
    if (law.times[i] == law.times[i - 1]) result.steps.push_back(law.times[i]);
  }
  return result;
}

std::unique_ptr<ActingElement> place(const LineDefinition& definition,
                                     const TableLaw& law,
                                     const ReferenceFrame& frame) {
  return std::make_unique<Table>(definition, law, frame);
}

}  // namespace clevis::mechanism

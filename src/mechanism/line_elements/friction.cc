#include "mechanism/line_elements/friction.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>

#include "mechanism/element_base/line_force.h"

namespace clevis::mechanism {
namespace {

class Friction final : public LineForce {
 public:
  Friction(const LineDefinition& definition, const FrictionLaw& law,
           const ReferenceFrame& frame)
      : LineForce(definition, frame), law_(law) {
    if (is_switched()) modes[0] = 1;  // free, until modes are chosen
  }

  int internal_states() const override { return has_bristles() ? 1 : 0; }
  void scales(const double* own, double* scales) const override;

  bool may_switch() const override { return is_switched(); }
  void choose_modes(const ElementResponse& now) override;
  double event_value(int end, const ElementResponse& now) const override;
  void pass_event(int end, const ElementResponse& now) override;
  const char* name_of_change(int end, int mode_before) const override;
  std::vector<ElementGuard> guards() const override;

  std::optional<double> slow_stiffness(const LineAtRest& line) const override;
  bool is_dry() const override { return law_.model == FrictionModel::kCoulomb; }
  bool follows_reaction() const override { return law_.follows_reaction; }
  Guide guide() const override { return law_.guide; }
  double breakaway_per_load() const override { return law_.breakaway; }
  double stribeck_zone() const override;
  double bristle_deflection() const override;
  void hold_tangent(const ElementResponse& there,
                    const double* states) override;
  void release_tangent() override { tangent_.holds = false; }

 protected:
  /// Of bristles that stick.
  LineTangent tangent(const ElementState& state) const override {
    if (!has_bristles() || std::abs(state.effort) >= law_.kinetic) return {};
    return {law_.bristle_stiffness, law_.bristle_damping + law_.viscous};
  }
  double law_effort(const ActingState& state,
                    ElementResponse& now) const override;

 private:
  bool has_bristles() const { return law_.model == FrictionModel::kLuGre; }
  /// Whether events separate its modes.
  bool is_switched() const { return law_.model != FrictionModel::kRegularized; }
  double bristle(const double* states) const {
    return has_bristles() ? states[internal] : 0.0;
  }
  double zone_value(double rate) const;

  /// The law at the state of hold_tangent(); acts instead of it.
  struct Tangent {
    bool holds = false;
    double rate{}, bristle{};
    FrictionEffort effort;
  };

  const FrictionLaw& law_;
  Tangent tangent_;
};

double Friction::law_effort(const ActingState& state,
                            ElementResponse& now) const {
  const double rate = now.rate;
  const double deflection = bristle(state.internal);
  const FrictionEffort f =
      tangent_.holds
          ? friction_along_tangent(law_, tangent_.effort, rate - tangent_.rate,
                                   deflection - tangent_.bristle)
          : friction_effort(law_, modes[0], rate, deflection,
                            velocity_tolerance);
  if (has_bristles()) now.internal_rates[0] = f.bristle_rate;
  now.load = law_.follows_reaction ? 0.0 : 1.0;
  now.per_load = f.per_load;
  now.own_effort = f.own;
  return now.load * f.per_load + f.own;
}

void Friction::scales(const double* /*own*/, double* scales) const {
  scales[0] = bristle_deflection();
}

double Friction::bristle_deflection() const {
  return has_bristles() ? law_.breakaway / law_.bristle_stiffness
                        : ActingElement::bristle_deflection();
}

/// To where it breaks away, by bristles at most.
std::optional<double> Friction::slow_stiffness(const LineAtRest& line) const {
  if (!is_switched()) return std::nullopt;  // it creeps
  const double reserve =
      std::max(0.0, line.load * law_.breakaway - std::abs(line.state.effort));
  return has_bristles() ? std::min(reserve / line.sway, law_.bristle_stiffness)
                        : reserve / line.sway;
}

double Friction::stribeck_zone() const {
  constexpr double kTimesSpeed = 6.0;  // exp(−36) is round-off
  return is_switched() ? kTimesSpeed * law_.stribeck_speed : 0.0;
}

void Friction::hold_tangent(const ElementResponse& there,
                            const double* states) {
  tangent_.rate = there.rate;
  tangent_.bristle = bristle(states);
  tangent_.effort = friction_effort(law_, modes[0], there.rate,
                                    tangent_.bristle, velocity_tolerance);
  tangent_.holds = true;
}

void Friction::choose_modes(const ElementResponse& now) {
  if (!is_switched()) return;
  const double rate = now.rate;
  modes[0] = rate > 0.0 ? 1 : rate < 0.0 ? -1 : 0;
  modes[1] = std::abs(rate) < stribeck_zone() ? 1 : 0;
  if (has_bristles() && modes[0] == 0) modes[0] = 1;
}

/// With the sign of the speed, so that no step over the zone and zero hides
/// both.
double Friction::zone_value(double rate) const {
  const double zone = stribeck_zone();
  if (zone <= 0.0) return 1.0;
  const bool slips = std::abs(modes[0]) == 1;
  const double inside = zone - (slips ? modes[0] * rate : std::abs(rate));
  return modes[1] == 1 ? inside : -inside;
}

double Friction::event_value(int end, const ElementResponse& now) const {
  if (!is_switched()) return 1.0;
  if (end == 1) return zone_value(now.rate);
  if (sticks()) return breakaway(now) - std::abs(now.effort);
  if (std::abs(modes[0]) >= 2) return break_free_speed - std::abs(now.rate);
  return modes[0] * now.rate +
         (has_bristles() ? 1.0 : kOfTolerance) * velocity_tolerance;
}

void Friction::pass_event(int end, const ElementResponse& now) {
  if (!is_switched()) return;
  if (end == 1) {
    modes[1] = 1 - modes[1];
    return;
  }
  int& mode = modes[0];
  if (has_bristles()) {
    mode = -mode;
  } else if (mode == 0) {
    mode = now.effort > 0.0 ? -2 : 2;
  } else if (std::abs(mode) >= 2) {
    mode = now.rate > 0.0 ? 1 : -1;
  } else {
    mode = 0;
  }
}

const char* Friction::name_of_change(int end, int mode_before) const {
  if (!is_switched() || end == 1) return nullptr;
  const int mode = modes[0];
  const auto slips = [](int m) {
    return std::abs(m) == 1;
  };
  if (mode == mode_before || (!slips(mode) && !slips(mode_before))) {
    return nullptr;
  }
  if (!slips(mode)) return "stick";
  return slips(mode_before) ? "turn" : "slip";
}

/// Rest, and the speeds about it in which friction changes most.
std::vector<ElementGuard> Friction::guards() const {
  using enum ElementGuard::Kind;
  constexpr double kTimes = 4.0;
  const double regular = is_switched() ? 0.0 : kTimes * law_.regularizing_speed;
  const double quick = std::max(stribeck_zone(), regular);
  std::vector<ElementGuard> all{{kRate, 0, 0.0}};
  if (quick > 0.0) {
    all.push_back({kRate, 0, quick});
    all.push_back({kRate, 0, -quick});
  }
  return all;
}

}  // namespace

ElementProperties properties(const FrictionLaw& law) {
  return {.type = "friction",
          .follows_reaction = law.follows_reaction,
          .guide_length = law.guide.length,
          .friction = law.follows_reaction ? law.breakaway : 0.0};
}

std::unique_ptr<ActingElement> place(const LineDefinition& definition,
                                     const FrictionLaw& law,
                                     const ReferenceFrame& frame) {
  return std::make_unique<Friction>(definition, law, frame);
}

}  // namespace clevis::mechanism

#include "mechanism/line_elements/servo.h"

#include <algorithm>
#include <cmath>

#include "mechanism/drives/drive_law.h"
#include "mechanism/element_base/line_force.h"

namespace clevis::mechanism {
namespace {

class Servo final : public LineForce {
 public:
  Servo(const LineDefinition& definition, const ServoLaw& law,
        const ReferenceFrame& frame)
      : LineForce(definition, frame), law_(law) {}

  bool has_smooth_effort() const override { return true; }

  /// Its limit, of either sign.
  std::vector<ElementGuard> guards() const override {
    using enum ElementGuard::Kind;
    if (!law_.limit) return {};
    return {{kOwn, 0, *law_.limit}, {kOwn, 0, -*law_.limit}};
  }
  double guard_value(const ElementGuard& guard, double t,
                     const ElementResponse& now) const override {
    return wanted(drive_target(law_.reference, t), now) - guard.level;
  }

 protected:
  LineTangent tangent(const ElementState& state) const override {
    if (law_.limit && std::abs(state.effort) >= *law_.limit) return {};
    return {law_.stiffness, law_.damping};
  }
  double law_effort(const ActingState& state,
                    ElementResponse& now) const override {
    const DriveTarget target = drive_target(law_.reference, state.t);
    now.channels = {target.position};
    const double free = wanted(target, now);
    return law_.limit ? std::clamp(free, -*law_.limit, *law_.limit) : free;
  }

 private:
  /// Effort without its limit.
  double wanted(const DriveTarget& target, const ElementResponse& now) const {
    return -law_.stiffness * (now.q - target.position) -
           law_.damping * (now.rate - target.rate);
  }

  const ServoLaw& law_;
};

}  // namespace

ElementProperties properties(const ServoLaw& law) {
  const DriveDefinition& drive = law.reference;
  ElementProperties result{.type = "servo",
                           .actuation = Actuation::kMachine,
                           .channels = {{"target", true}}};
  result.breaks = {drive.start, drive.start + drive.duration};
  for (const double t : drive.table.times) {
    result.breaks.push_back(drive.start + t);
  }
  result.reference = &drive;
  return result;
}

std::unique_ptr<ActingElement> place(const LineDefinition& definition,
                                     const ServoLaw& law,
                                     const ReferenceFrame& frame) {
  return std::make_unique<Servo>(definition, law, frame);
}

}  // namespace clevis::mechanism

#include "mechanism/driven_search/driven_guards.h"

#include <algorithm>
#include <limits>

#include "mechanism/force_laws/force_laws.h"
#include "mechanism/forces/element_modes.h"

namespace clevis::mechanism {

using Eigen::Index;
using Eigen::VectorXd;

namespace {

const ActingElement& element_of(const ForceModel& forces, int k) {
  return forces.element(static_cast<std::size_t>(k));
}

/// The speeds about rest in which friction changes most.
double quick_speed(const FrictionLaw& law, const ActingElement& e) {
  constexpr double kTimes = 4.0;
  const double regular = law.model == FrictionModel::kRegularized
                             ? kTimes * law.regularizing_speed
                             : 0.0;
  return std::max(stribeck_zone(e), regular);
}

double sliding_zone(const ActingElement& e) {
  constexpr double kTimes = 4.0;
  return std::max(
      stribeck_zone(e),
      kTimes * std::get<ContactElement>(*e.definition).critical_speed);
}

/// With the sign of a pressed contact's force.
double force_sign(const ContactLaw& law, double depth, double rate) {
  return law.model == ContactModel::kHuntCrossley
             ? 1.0 + law.damping * rate
             : law.stiffness * depth + law.damping * rate;
}

}  // namespace

DrivenGuards::DrivenGuards(const ForceModel& forces) {
  for (int k = 0; k < static_cast<int>(forces.size()); ++k) {
    const ActingElement& e = element_of(forces, k);
    const ForceElement& definition = *e.definition;
    if (const auto* line = std::get_if<LineElement>(&definition)) {
      add_line(k, *line, e);
    }
    if (const ContactLaw* law = contact_law(definition)) {
      add_ends(k, definition, *law);
    }
    const auto* contact = std::get_if<ContactElement>(&definition);
    if (contact != nullptr && contact->static_friction > 0.0) {
      all_.push_back({k, Kind::kSliding, 0, sliding_zone(e)});
    }
  }
}

void DrivenGuards::add_ends(int k, const ForceElement& element,
                            const ContactLaw& law) {
  const auto* line = std::get_if<LineElement>(&element);
  const StopLaw* stop = line ? std::get_if<StopLaw>(&line->law) : nullptr;
  for (const std::size_t end : {std::size_t{0}, std::size_t{1}}) {
    const bool exists = stop == nullptr ? end == 0
                        : end == 0      ? stop->lower.has_value()
                                        : stop->upper.has_value();
    if (!exists) continue;
    all_.push_back({k, Kind::kDepth, end, 0.0});
    if (law.transition > 0.0) {
      all_.push_back({k, Kind::kDepth, end, law.transition});
    }
    if (law.damping > 0.0 && !may_pull(law)) {
      all_.push_back({k, Kind::kForce, end, 0.0});
    }
  }
}

void DrivenGuards::add_line(int k, const LineElement& line,
                            const ActingElement& e) {
  const auto add = [&](Kind kind, double level) {
    all_.push_back({k, kind, 0, level});
  };
  if (line.acts_on != ActsOn::kBoth) {
    add(Kind::kRate, 0.0);
    const bool grows = line.acts_on == ActsOn::kIncreasing;
    if (line.full_speed > 0.0) {
      add(Kind::kRate, grows ? line.full_speed : -line.full_speed);
    }
  }
  if (const auto* friction = std::get_if<FrictionLaw>(&line.law)) {
    add(Kind::kRate, 0.0);
    const double quick = quick_speed(*friction, e);
    if (quick > 0.0) {
      add(Kind::kRate, quick);
      add(Kind::kRate, -quick);
    }
  } else if (const auto* table = std::get_if<TableLaw>(&line.law)) {
    for (const double q : table->positions) add(Kind::kPosition, q);
  } else if (const auto* servo = std::get_if<ServoLaw>(&line.law)) {
    if (!servo->limit) return;
    add(Kind::kServo, *servo->limit);
    add(Kind::kServo, -*servo->limit);
  }
}

VectorXd DrivenGuards::values(const ForceModel& forces, double t) const {
  VectorXd values(size());
  for (Index i = 0; i < size(); ++i) {
    const Guard& guard = all_[static_cast<std::size_t>(i)];
    const ActingElement& e = element_of(forces, guard.element);
    switch (guard.kind) {
      case Kind::kDepth:
        values[i] = e.depth[guard.end] - guard.level;
        break;
      case Kind::kForce:
        values[i] = force_sign(*contact_law(*e.definition), e.depth[guard.end],
                               e.depth_rate[guard.end]);
        break;
      case Kind::kRate:
        values[i] = e.rate - guard.level;
        break;
      case Kind::kPosition:
        values[i] = e.q - guard.level;
        break;
      case Kind::kServo:
        values[i] =
            unlimited_servo_effort(*servo_law(*e.definition), t, e.q, e.rate) -
            guard.level;
        break;
      case Kind::kSliding:
        values[i] = guard.level - e.sliding.squaredNorm() / guard.level;
    }
  }
  return values;
}

VectorXd DrivenGuards::rates(const ForceModel& forces) const {
  VectorXd rates =
      VectorXd::Constant(size(), std::numeric_limits<double>::quiet_NaN());
  for (Index i = 0; i < size(); ++i) {
    const Guard& guard = all_[static_cast<std::size_t>(i)];
    const ActingElement& e = element_of(forces, guard.element);
    if (guard.kind == Kind::kDepth) rates[i] = e.depth_rate[guard.end];
    if (guard.kind == Kind::kPosition) rates[i] = e.rate;
  }
  return rates;
}

bool DrivenGuards::matters(Index i, const ForceModel& forces) const {
  const Guard& guard = all_[static_cast<std::size_t>(i)];
  const ActingElement& e = element_of(forces, guard.element);
  if (guard.kind == Kind::kForce) return e.depth[guard.end] > 0.0;
  if (guard.kind == Kind::kSliding) return e.depth[0] > 0.0;
  return true;
}

}  // namespace clevis::mechanism

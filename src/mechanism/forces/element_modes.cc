#include "mechanism/forces/element_modes.h"

#include <algorithm>
#include <cmath>

#include "mechanism/force_laws/force_laws.h"

namespace clevis::mechanism {
namespace {

// Friction turns late by so much of the slack, so that the turned mode does not
// find itself behind its own event.
constexpr double kOfSlack = 1e-3;

const StopLaw* stop_law(const ForceElement& element) {
  const auto* line = std::get_if<LineElement>(&element);
  return line ? std::get_if<StopLaw>(&line->law) : nullptr;
}

bool has_end(const ForceElement& element, std::size_t end) {
  const StopLaw* stop = stop_law(element);
  if (stop == nullptr) return end == 0;
  return (end == 0 ? stop->lower : stop->upper).has_value();
}

/// Where a line's effort sets in at once with one sense of its motion: that
/// sense, else 0.
double sharp_sense(const ForceElement& element) {
  const auto* line = std::get_if<LineElement>(&element);
  if (line == nullptr || line->full_speed > 0.0) return 0.0;
  return line->acts_on == ActsOn::kBoth         ? 0.0
         : line->acts_on == ActsOn::kIncreasing ? 1.0
                                                : -1.0;
}

bool is_contact(const ActingElement& e) {
  return std::holds_alternative<ContactElement>(*e.definition);
}

double contact_value(const ActingElement& e, const ContactLaw& law,
                     std::size_t end) {
  const double depth = e.depth[end], rate = e.depth_rate[end];
  if (e.modes[end] == 0) return -depth;
  // without force: until it is out, or pressed again
  if (e.modes[end] == 2) return std::min(depth, -e.unbounded[end]);
  if (may_pull(law)) return depth;
  // the sign of the force, without the factors that vanish with the depth
  return law.model == ContactModel::kHuntCrossley
             ? std::min(depth, 1.0 + law.damping * rate)
             : law.stiffness * depth + law.damping * rate;
}

/// Positive while a line moves in the sense of its mode.
double sense_value(const ActingElement& e, double sense) {
  const double forward = e.modes[1] == 1 ? sense : -sense;
  return forward * e.rate + kOfSlack * e.slack;
}

/// How far a position is from the end of its piece; 1 where there is none.
double way_left(const TableLaw& law, int piece, int end, double position) {
  const auto at = static_cast<std::size_t>(piece);
  if (end == 0) return at == 0 ? 1.0 : position - law.positions[at - 1];
  return at == law.positions.size() ? 1.0 : law.positions[at] - position;
}

void pass_contact(ActingElement& e, const ContactLaw& law, std::size_t end) {
  int& mode = e.modes[end];
  if (mode == 0) {
    mode = 1;
  } else if (mode == 1) {
    mode = !may_pull(law) && e.depth[end] > 0.0 ? 2 : 0;
  } else {
    const bool leaves = e.depth_rate[end] < 0.0 && e.unbounded[end] <= 0.0;
    mode = leaves ? 0 : 1;
  }
}

/// Whether sliding at a pressed contact is slow enough for the peak of its
/// friction to count.
int mode_of_sliding(const ActingElement& e) {
  return e.modes[0] == 1 && e.sliding.norm() < stribeck_zone(e) ? 1 : 0;
}

/// Squares: smooth where the sliding turns round, so that a short dip shows.
double sliding_value(const ActingElement& e) {
  const double zone = stribeck_zone(e);
  if (zone <= 0.0 || e.modes[0] != 1) return 1.0;
  const double inside = zone - e.sliding.squaredNorm() / zone;
  return e.modes[1] == 1 ? inside : -inside;
}

}  // namespace

double stribeck_zone(const ActingElement& e) {
  constexpr double kTimesSpeed = 6.0;  // exp(−36) is round-off
  if (const auto* contact = std::get_if<ContactElement>(e.definition)) {
    if (!(contact->static_friction > 0.0)) return 0.0;
    return (1.0 + kTimesSpeed) * std::max(contact->critical_speed, e.slack);
  }
  const FrictionLaw* law = switched_friction(*e.definition);
  return law == nullptr ? 0.0 : kTimesSpeed * law->stribeck_speed;
}

bool sticks(const ActingElement& e) {
  const FrictionLaw* law = switched_friction(*e.definition);
  return law != nullptr && law->model == FrictionModel::kCoulomb &&
         e.modes[0] == 0;
}

void choose_modes(ActingElement& e) {
  if (const FrictionLaw* law = switched_friction(*e.definition)) {
    e.modes[0] = e.rate > 0.0 ? 1 : e.rate < 0.0 ? -1 : 0;
    e.modes[1] = std::abs(e.rate) < stribeck_zone(e) ? 1 : 0;
    if (law->model == FrictionModel::kLuGre && e.modes[0] == 0) {
      e.modes[0] = 1;
    }
  } else if (const ContactLaw* contact = contact_law(*e.definition)) {
    for (const std::size_t end : {0, 1}) {
      const bool deep = has_end(*e.definition, end) && e.depth[end] > 0.0;
      const bool presses = e.unbounded[end] >= 0.0 || may_pull(*contact);
      e.modes[end] = !deep ? 0 : presses ? 1 : 2;
    }
    if (is_contact(e)) e.modes[1] = mode_of_sliding(e);
  } else {
    const TableLaw* table = position_table(*e.definition);
    if (table != nullptr) e.modes[0] = piece_at(*table, e.q);
    const double sense = sharp_sense(*e.definition);
    if (sense != 0.0) e.modes[1] = sense * e.rate > 0.0 ? 1 : 0;
  }
}

bool may_switch(const ForceElement& definition) {
  return switched_friction(definition) != nullptr ||
         position_table(definition) != nullptr ||
         contact_law(definition) != nullptr || sharp_sense(definition) != 0.0;
}

double event_value(const ActingElement& e, int end) {
  const auto at = static_cast<std::size_t>(end);
  if (const FrictionLaw* friction = switched_friction(*e.definition)) {
    if (end == 1) {
      const double zone = stribeck_zone(e);
      if (zone <= 0.0) return 1.0;
      // with its sign, so that no step over the zone and zero hides both
      const bool slips = std::abs(e.modes[0]) == 1;
      const double inside =
          zone - (slips ? e.modes[0] * e.rate : std::abs(e.rate));
      return e.modes[1] == 1 ? inside : -inside;
    }
    if (sticks(e)) return e.load * friction->breakaway - std::abs(e.effort);
    if (std::abs(e.modes[0]) >= 2) return e.leaving - std::abs(e.rate);
    const bool bristles = friction->model == FrictionModel::kLuGre;
    return e.modes[0] * e.rate + (bristles ? 1.0 : kOfSlack) * e.slack;
  }
  const double sense = sharp_sense(*e.definition);
  if (sense != 0.0 && end == 1) return sense_value(e, sense);
  if (const TableLaw* table = position_table(*e.definition)) {
    if (sense == 0.0) return way_left(*table, e.modes[0], end, e.q);
    return std::min(way_left(*table, e.modes[0], 0, e.q),
                    way_left(*table, e.modes[0], 1, e.q));
  }
  if (end == 1 && is_contact(e)) return sliding_value(e);
  const ContactLaw* law = contact_law(*e.definition);
  if (law == nullptr || !has_end(*e.definition, at)) return 1.0;
  return contact_value(e, *law, at);
}

void pass_event(ActingElement& e, int end) {
  const auto at = static_cast<std::size_t>(end);
  if (const FrictionLaw* law = switched_friction(*e.definition)) {
    if (end == 1) {
      e.modes[1] = 1 - e.modes[1];
      return;
    }
    int& mode = e.modes[0];
    if (law->model == FrictionModel::kLuGre) {
      mode = -mode;
    } else if (mode == 0) {
      mode = e.effort > 0.0 ? -2 : 2;
    } else if (std::abs(mode) >= 2) {
      mode = e.rate > 0.0 ? 1 : -1;
    } else {
      mode = 0;
    }
  } else if (end == 1 && is_contact(e)) {
    e.modes[1] = 1 - e.modes[1];
  } else if (const ContactLaw* contact = contact_law(*e.definition)) {
    pass_contact(e, *contact, at);
    if (is_contact(e)) e.modes[1] = mode_of_sliding(e);
  } else if (end == 1 && sharp_sense(*e.definition) != 0.0) {
    e.modes[1] = 1 - e.modes[1];
  } else if (const TableLaw* table = position_table(*e.definition)) {
    const bool back = sharp_sense(*e.definition) == 0.0
                          ? end == 0
                          : way_left(*table, e.modes[0], 0, e.q) <
                                way_left(*table, e.modes[0], 1, e.q);
    e.modes[0] += back ? -1 : 1;
  }
}

const char* name_of_change(const ActingElement& e, int end, int mode_before) {
  const int mode = e.modes[static_cast<std::size_t>(end)];
  if (end == 1 && is_contact(e)) return nullptr;  // its sliding
  if (contact_law(*e.definition) != nullptr) {
    if (mode == 1) return "press";
    return mode_before == 1 ? "release" : nullptr;  // else force was 0 before
  }
  if (sharp_sense(*e.definition) != 0.0 && end == 1) {
    return mode == mode_before ? nullptr : mode == 1 ? "act" : "rest";
  }
  if (switched_friction(*e.definition) == nullptr) return nullptr;
  if (end == 1) return nullptr;  // of friction: in or out of Stribeck's zone
  const auto slips = [](int m) {
    return std::abs(m) == 1;
  };
  if (mode == mode_before || (!slips(mode) && !slips(mode_before))) {
    return nullptr;
  }
  if (!slips(mode)) return "stick";
  return slips(mode_before) ? "turn" : "slip";
}

}  // namespace clevis::mechanism

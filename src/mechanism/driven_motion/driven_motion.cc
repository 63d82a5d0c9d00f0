#include "mechanism/driven_motion/driven_motion.h"

#include <utility>

#include "mechanism/driven_motion/driven_start.h"
#include "mechanism/forces/line_motion.h"
#include "mechanism/reactions/power_balance.h"
#include "mechanism/sampling/instant_brackets.h"

namespace clevis::mechanism {

DrivenMotion::DrivenMotion(const MechanismDefinition& definition,
                           const SimulationSettings& settings)
    : settings_(settings),
      model_(definition, settings),
      instants_(model_),
      change_points_(model_, instants_, settings.at_singularity),
      path_(definition, model_.frame, counts_turns(instants_.forces())) {}

DrivenMoment DrivenMotion::start(Motion& motion) {
  return start_driven(model_, instants_, settings_, motion);
}

void DrivenMotion::advance(DrivenMoment& last, std::optional<double>& singular,
                           double t, Motion& motion) {
  for (const double at : path_.steps(last.t, t)) {
    DrivenMoment next(model_.follow(last, at), at);
    if (!next.at.factor.full_column_rank()) {
      if (!singular) singular = at;
      continue;
    }
    if (singular) {
      change_points_.note_singular(last, *singular, &next, motion);
      singular.reset();
    } else {
      change_points_.note_between(last, next, motion);
    }
    last = std::move(next);
    if (counts_turns(instants_.forces())) instants_.sense(last);
  }
}

Motion DrivenMotion::run_through(const std::vector<double>& times,
                                 const std::vector<Configuration>& positions) {
  Motion motion;
  motion.instants.reserve(times.size());
  path_.require_few_steps(settings_.duration, settings_.instants);
  start(motion);
  for (std::size_t i = 1; i < times.size(); ++i) {
    const DrivenMoment moment = model_.moment(positions[i], times[i]);
    motion.instants.push_back(instants_.regular(moment.at, times[i]));
  }
  judge_power_balance(model_.definition, motion);
  return motion;
}

/// @param last  the last regular moment, before or at t; behind it between a
///   start at a change point and a little beyond that.
Instant DrivenMotion::instant_at(const DrivenMoment& last, double t) {
  if (last.t == t) return instants_.regular(last.at, t);
  const ClosedConfiguration at = model_.follow(last, t);
  if (at.factor.full_column_rank()) return instants_.regular(at, t);
  std::optional<Instant> there;
  if (settings_.at_singularity == AtSingularity::kContinue) {
    there = change_points_.instant(last, t);
  }
  if (!there) model_.refuse_change_point(at, t);
  return std::move(*there);
}

Motion DrivenMotion::run_at(const std::vector<double>& times) {
  Motion motion;
  motion.instants.reserve(times.size());
  path_.require_few_steps(settings_.duration, settings_.instants);
  DrivenMoment last = start(motion);  // that was regular
  std::optional<double> singular;
  for (std::size_t i = 1; i < times.size(); ++i) {
    if (times[i] > last.t) advance(last, singular, times[i], motion);
    motion.instants.push_back(instant_at(last, times[i]));
  }
  if (singular) {
    change_points_.note_singular(last, *singular, nullptr, motion);
  }
  bracket_by_instants(motion.instants, motion.change_points);
  judge_power_balance(model_.definition, motion);
  return motion;
}

}  // namespace clevis::mechanism

#pragma once

#include <optional>

#include "mechanism/definition/motion.h"
#include "mechanism/driven_motion/driven_instants.h"
#include "mechanism/driven_motion/driven_model.h"

namespace clevis::mechanism {

/// The change points that a driven motion passes, each told from the positions
/// before and behind it. Times [s].
class DrivenChangePoints {
 public:
  /// @param model, instants  outlive this.
  /// @param policy  kStop: they are refused.
  DrivenChangePoints(const DrivenModel& model, DrivenInstants& instants,
                     AtSingularity policy)
      : model_(model), instants_(instants), policy_(policy) {}

  /// Notes those between two regular moments.
  /// @throws Error K005 where one is met that must not be.
  void note_between(const DrivenMoment& from, const DrivenMoment& to,
                    Motion& motion);
  /// Notes that at which a step ended, and those beside it.
  /// @param last  regular, before it.
  /// @param singular  a time behind `last` at which J has no full rank [s].
  /// @param next  the next regular moment, or null. @throws Error K005.
  void note_singular(const DrivenMoment& last, double singular,
                     const DrivenMoment* next, Motion& motion);
  /// The instant at a singular time behind a regular moment; nothing where no
  /// regular branch goes there.
  std::optional<Instant> instant(const DrivenMoment& last, double singular);

 private:
  std::optional<double> singular_between(const DrivenMoment& from,
                                         const DrivenMoment& to,
                                         int& halvings) const;
  DrivenMoment edge(DrivenMoment regular, double singular) const;
  std::optional<Instant> just_behind(const DrivenMoment& before, double t);
  void note(const DrivenMoment& before, double t, Motion& motion);

  const DrivenModel& model_;
  DrivenInstants& instants_;
  AtSingularity policy_;
};

}  // namespace clevis::mechanism

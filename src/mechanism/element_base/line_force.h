#pragma once

#include "mechanism/element_base/acting_element.h"

namespace clevis::mechanism {

/// A force element with a scalar effort along a line.
class LineForce : public ActingElement {
 public:
  LineForce(const LineDefinition& definition, const ReferenceFrame& frame);

  bool is_line() const override { return true; }
  ElementSpring spring(const Configuration& x,
                       const ElementState& state) const final;

 protected:
  /// Effort on b, > 0 pushes apart, by q and rate of `now`.
  virtual double law_effort(const ActingState& state,
                            ElementResponse& now) const = 0;
  /// Of its effort in a state of a motion.
  virtual LineTangent tangent(const ElementState& /*state*/) const {
    return {};
  }
  void act(const ActingState& state, const Twist& a, const Twist& b,
           ElementResponse& now) const override;
  /// Sets levers and q of the placed line.
  void measure(ElementResponse& now) const;
};

/// A line force that may act in one sense of its motion alone: its second mode
/// tells whether the line moves so.
class OneSenseForce : public LineForce {
 public:
  OneSenseForce(const LineDefinition& definition, const ReferenceFrame& frame);

  bool may_switch() const override { return sharp_sense_ != 0.0; }
  void choose_modes(const ElementResponse& now) override;
  double event_value(int end, const ElementResponse& now) const override;
  void pass_event(int end, const ElementResponse& now) override;
  const char* name_of_change(int end, int mode_before) const override;
  std::vector<ElementGuard> guards() const override;

 protected:
  /// Effort of a line that acts in both senses.
  virtual double full_effort(const ActingState& state,
                             const ElementResponse& now) const = 0;
  double law_effort(const ActingState& state, ElementResponse& now) const final;
  bool acts_in_both() const { return acts_on_ == ActsOn::kBoth; }
  /// Sense in which the effort sets in at once, as a mode tells; else 0.
  double sharp_sense() const { return sharp_sense_; }

 private:
  double part_in_sense(double rate) const;

  ActsOn acts_on_;
  double full_speed_;
  double sharp_sense_;
};

/// Friction and senses turn late by so much of the tolerance, so that the
/// turned mode does not find itself behind its own event.
inline constexpr double kOfTolerance = 1e-3;

}  // namespace clevis::mechanism

#pragma once

#include <limits>

#include "mechanism/element_base/element_response.h"
#include "mechanism/force_laws/guide.h"

namespace clevis::mechanism {

/// Friction of a force element as an integration sees it. An element without
/// friction keeps the defaults.
class FrictionTraits {
 public:
  /// Coulomb friction, whose modes are decided together.
  virtual bool is_dry() const { return false; }
  /// Whether its friction is per newton of its joint's force.
  virtual bool follows_reaction() const { return false; }
  /// Where that force presses.
  virtual Guide guide() const { return {}; }
  /// Breakaway effort over the load: [N], [N m], [1] or [m].
  virtual double breakaway_per_load() const { return 0.0; }
  /// Speed below which Stribeck's term of friction counts, of a contact the
  /// peak about its critical speed; 0 without one [m/s], [rad/s]. A step that
  /// passes it must be short, as nothing else tells of a peak so narrow.
  virtual double stribeck_zone() const { return 0.0; }
  /// Deflection of bristles at breakaway [m] or [rad]; infinite without them.
  virtual double bristle_deflection() const {
    return std::numeric_limits<double>::infinity();
  }
  /// Its friction acts by the tangent at a state until release_tangent().
  /// @param internal  all internal states there (SI).
  virtual void hold_tangent(const ElementResponse& /*there*/,
                            const double* /*internal*/) {}
  virtual void release_tangent() {}

 protected:
  ~FrictionTraits() = default;
};

}  // namespace clevis::mechanism

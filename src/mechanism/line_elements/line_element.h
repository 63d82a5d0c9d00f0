#pragma once

#include <memory>
#include <variant>

#include "mechanism/line_elements/friction.h"
#include "mechanism/line_elements/gas_cylinder.h"
#include "mechanism/line_elements/motor.h"
#include "mechanism/line_elements/servo.h"
#include "mechanism/line_elements/spring.h"
#include "mechanism/line_elements/stop.h"
#include "mechanism/line_elements/table.h"

namespace clevis::mechanism {

/// Registry of the laws along lines. A law has properties() and place().
using LineLaw = std::variant<SpringLaw, FrictionLaw, StopLaw, TableLaw,
                             GasCylinderLaw, MotorLaw, ServoLaw>;

/// An element with a scalar effort.
struct LineElement : LineDefinition {
  LineLaw law;

  std::array<int, 2> bodies(const std::vector<JointDefinition>& joints) const;
};

ElementProperties properties(const LineElement& element);
/// @param element  outlives the result.
std::unique_ptr<ActingElement> place(const LineElement& element,
                                     const ReferenceFrame& frame);

}  // namespace clevis::mechanism

#pragma once

#include <array>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "mechanism/force_elements/bushing.h"
#include "mechanism/force_elements/constant.h"
#include "mechanism/force_elements/contact.h"
#include "mechanism/force_elements/impedance.h"
#include "mechanism/line_elements/line_element.h"

namespace clevis::mechanism {

/// Registry of the force elements. A kind has a name, a place in the scene,
/// bodies(), properties() and place(); nothing else asks what kind it is.
using ForceElement = std::variant<LineElement, ContactElement, ImpedanceElement,
                                  ConstantForce, BushingElement>;

const std::string& name_of(const ForceElement& element);
/// Where the scene gives it, file:line:column.
const std::string& place_of(const ForceElement& element);
/// Bodies a and b, −1 ground. @param joints  of its mechanism.
std::array<int, 2> bodies_of(const ForceElement& element,
                             const std::vector<JointDefinition>& joints);
/// Whether it acts on a body.
bool acts_on(const ForceElement& element,
             const std::vector<JointDefinition>& joints, int body);
/// Its line, or null where it has none.
const ElementLine* line_of(const ForceElement& element);
/// The point of body b that its normal force goes through however b turns: the
/// centre of a wheel on a plane; or null.
const ElementPoint* rolling_centre(const ForceElement& element);
/// Whether its force keeps its direction in body a, and acts there in the point
/// where it acts on b: along an axis of a joint or of a, or of a bushing.
bool turns_with_first(const ForceElement& element);
/// Whether it measures an angle and gives a moment.
bool is_angle(const ForceElement& element,
              const std::vector<JointDefinition>& joints);
/// @param element  outlives the result.
ElementProperties properties(const ForceElement& element);
/// @param element  outlives the result.
std::unique_ptr<ActingElement> place(const ForceElement& element,
                                     const ReferenceFrame& frame);

}  // namespace clevis::mechanism

#pragma once

#include <optional>
#include <string>

#include "assessment/job/part_result.h"
#include "part/part_definition.h"

namespace clevis::assessment {

/// "edge of root at (0, 0) mm and 1 more" of the singular zones that govern.
/// @param has_section  of those only that have one, or none; nothing: of all.
std::string governing_zones(const PartResult& result,
                            std::optional<bool> has_section = {});

/// Whether the limits leave the zone out in which the part is stressed most.
bool leaves_zones_out(const part::PartDefinition& part,
                      const PartResult& result);

/// The nominal stress of a section that may lie in a zone left out.
struct NominalStress {
  double low{}, value{}, high{};  ///< [Pa]
  std::string what;               ///< "section root, impact blow"
};
/// The largest of the held faces' and of beam theory's sections, if one is
/// known. Formulas of lugs are none of a section.
std::optional<NominalStress> largest_nominal(const PartResult& result);

/// The judged peak, or the nominal stress of what the limits leave out, if that
/// is larger [Pa].
double governing_stress(const part::PartDefinition& part,
                        const PartResult& result);

/// Zones that a passing part was not held against; empty if there are none.
std::string left_out(const part::PartDefinition& part,
                     const PartResult& result);

}  // namespace clevis::assessment

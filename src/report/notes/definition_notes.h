#pragma once

#include <string>
#include <vector>

#include "mechanism/definition/definition.h"

namespace clevis::report {

/// Adds what a mechanism's numbers alone tell of a wrong unit: gravity that no
/// machine meets [m/s²]; bodies denser or lighter than any [kg/m³], or with
/// their mass far from their joints [m]; bodies that no joint holds.
void add_definition_notes(const mechanism::MechanismDefinition& definition,
                          std::vector<std::string>& notes);

/// A length of a mechanism's order [m]: of its bodies, from their origins to
/// their joints, or by their inertia. 0: points alone.
double mechanism_size(const mechanism::MechanismDefinition& definition);

}  // namespace clevis::report

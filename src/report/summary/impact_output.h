#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "mechanism/definition/definition.h"
#include "mechanism/definition/motion.h"
#include "report/text/terminal.h"

namespace clevis::report {

/// An impact with the words that a reader needs.
struct NamedImpact {
  std::string force;     ///< name of the contact or stop
  std::string end{};     ///< "lower", "upper" of a stop, else empty
  bool angular = false;  ///< moments and inertias
  mechanism::Impact impact;
};

/// The impacts of a motion, as they begin.
std::vector<NamedImpact> named_impacts(
    const mechanism::MechanismDefinition& definition,
    const mechanism::Motion& motion);

/// Table of the hardest; empty without any.
std::string impacts_text(const std::vector<NamedImpact>& impacts,
                         Colour colour);
/// Immovable parts have no mass, contacts that still press no duration: null.
nlohmann::ordered_json impacts_json(const std::vector<NamedImpact>& impacts);
std::string impacts_csv(const std::vector<NamedImpact>& impacts);

}  // namespace clevis::report

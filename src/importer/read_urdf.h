#pragma once

#include <string>

#include "multibody/model.h"

namespace clevis::importer {

/// The model that URDF describes, all of it in the world's frame [SI].
/// @param file  for messages.
/// @throws Error S014 as liburdfdom refuses it.
multibody::Model read_urdf(const std::string& xml, const std::string& file);

}  // namespace clevis::importer

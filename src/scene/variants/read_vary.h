#pragma once

#include <string>

#include "scene/text/strict_table.h"
#include "scene/variants/vary_table.h"

namespace clevis::scene {

/// @throws Error S003–S010 at the key that is wrong.
VaryTable read_vary(StrictTable table);

/// A node as the value of a setting: TOML, or a text without its quotes.
std::string setting_value(const toml::node& node);

}  // namespace clevis::scene

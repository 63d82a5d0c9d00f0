#pragma once

#include <vector>

#include <toml++/toml.h>

#include "scene/variants/setting.h"

namespace clevis::scene {

/// Puts the settings into a scene's tree as if they stood in its file, so that
/// readers refuse them as they refuse the file, with the setting's place.
///
/// A list of named entries is entered by name: that of an entry's `name`, or,
/// if it has none, its `joint` or `body`. Keys that the scene lacks are added;
/// entries are not.
/// @throws Error S005 if a path leads through a value, S007 if it is none or
///   names an entry that is not there, S008 if several bear the name,
///   S010 if two settings have one path.
void apply_settings(const std::vector<Setting>& settings, toml::table& root);

}  // namespace clevis::scene

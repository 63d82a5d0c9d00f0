#pragma once

#include <string>
#include <vector>

#include "multibody/model.h"

namespace clevis::multibody {

/// A scene.toml, and what its reader should know.
struct SceneText {
  std::string text;
  std::vector<std::string> told;  ///< what was lost or assumed, a line each
  std::size_t bodies = 0, joints = 0, forces = 0;
};

/// The model as a scene whose motion its forces decide, from rest, with the
/// joints at zero: bodies, joints, limits as stops, springs, damping and
/// friction as forces.
/// @param file  of the model, for messages and comments.
/// @throws Error S015 if no scene can hold it, S014 if a joint's link is
///   missing.
SceneText scene_text(const Model& model, const std::string& file);

}  // namespace clevis::multibody

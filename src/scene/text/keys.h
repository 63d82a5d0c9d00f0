#pragma once

#include <span>
#include <string_view>

namespace clevis::scene {

/// The keys of one table of the scene format.
struct TableKeys {
  std::string_view path;  ///< "part.case"; "" is the file itself
  std::span<const std::string_view> keys;
};

/// Every table of the format whose keys are fixed. Tables that are indexed by
/// the user's own names (material, pins, pressure …) have no row; their
/// elements have, if they are tables. docs/scene.schema.json holds the same
/// keys, which a test proves.
std::span<const TableKeys> scene_tables();

/// @pre path is a row of scene_tables().
std::span<const std::string_view> keys_of(std::string_view path);

/// Of two keys that exclude each other, the one that is read if both stand.
struct Rivals {
  std::string_view path, key, winner;
};
std::span<const Rivals> rivals();

}  // namespace clevis::scene

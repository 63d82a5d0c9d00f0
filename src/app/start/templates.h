#pragma once

#include <span>
#include <string_view>

namespace clevis::app {

/// A file of a template.
struct TemplateFile {
  std::string_view name, text;
};

/// A scene to start from, with its geometry.
struct Template {
  std::string_view word;   ///< of `clevis init --template`
  std::string_view about;  ///< for the help
  std::span<const TemplateFile> files;
};

std::span<const Template> templates();

/// JSON Schema of scenes (docs/scene.schema.json): editors that know it
/// complete keys and mark wrong ones.
std::string_view scene_schema();

}  // namespace clevis::app

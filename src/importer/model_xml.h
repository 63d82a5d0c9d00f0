#pragma once

#include <string>
#include <vector>

namespace clevis::importer {

/// A model's XML without what clevis does not read.
struct ModelXml {
  std::string text;
  bool is_urdf = false;
  std::vector<std::string> lost;  ///< a line each: path, and what it was
};

/// Leaves only elements that describe links, joints and frames: shapes,
/// plugins, includes and whatever else might be opened or run never meets the
/// libraries behind.
/// @param file  for messages.
/// @throws Error S013 if the root is another one, S014 if the XML is damaged
///   or declares a document type, S015 if it has more than 4000 links, joints,
///   frames and models.
ModelXml model_xml(const std::string& text, const std::string& file);

}  // namespace clevis::importer

#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace clevis::report {

/// The binary part of a glTF file, and what its JSON says of it.
class GlbBuffer {
 public:
  /// Use of an accessor: glTF's bufferView targets.
  enum class Use { kAnimation = 0, kVertices = 34962, kIndices = 34963 };

  /// Adds numbers as an accessor. @param type  "SCALAR", "VEC3" …
  /// @returns its index.
  int add(const std::vector<float>& numbers, const char* type, Use use);
  int add(const std::vector<std::uint32_t>& numbers, Use use);
  /// Colours as normalised bytes, four each.
  int add_colours(const std::vector<std::uint8_t>& bytes);

  /// Least and largest of an accessor's items, which glTF wants of positions
  /// and times.
  void add_bounds(int accessor, const std::vector<float>& numbers, int items);

  /// The .glb: header, JSON chunk, binary chunk.
  /// @param json  glTF without buffers, bufferViews and accessors.
  std::string file(nlohmann::ordered_json json) const;

 private:
  int add_accessor(const void* data, std::size_t bytes, std::size_t count,
                   int component, const char* type, Use use);

  std::string bytes_;
  nlohmann::ordered_json views_ = nlohmann::ordered_json::array();
  nlohmann::ordered_json accessors_ = nlohmann::ordered_json::array();
};

}  // namespace clevis::report

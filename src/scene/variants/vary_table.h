#pragma once

#include <optional>
#include <string>
#include <vector>

namespace clevis::scene {

/// Numbers from one end to the other, both counted in, with one unit.
struct VariedRange {
  double from{}, to{};  ///< in `unit`
  std::string unit;     ///< empty: pure numbers
  int count{};          ///< of a grid; 0 in samples
};

/// One value of the scene that variants differ in.
struct VariedQuantity {
  std::string path;
  std::vector<std::string> values;  ///< the choices, if there is no range
  std::optional<VariedRange> range;
  std::string place;
};

/// [vary]: which variants of a scene are wanted.
struct VaryTable {
  enum class Design { kGrid, kLatinHypercube };
  Design design = Design::kGrid;
  int samples{};  ///< of a Latin hypercube
  int seed = 1;
  std::vector<VariedQuantity> quantities;
  std::string place;
};

}  // namespace clevis::scene

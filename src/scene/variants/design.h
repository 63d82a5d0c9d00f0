#pragma once

#include <string>
#include <vector>

#include "scene/variants/setting.h"
#include "scene/variants/vary_table.h"

namespace clevis::scene {

/// A scene with some of its values replaced.
struct Variant {
  std::string name;  ///< of its folder: letters, digits, _ and -
  std::vector<Setting> settings;
};

/// The variants that [vary] asks for, called v001, v002 … A grid varies its
/// last quantity fastest. A Latin hypercube takes each n-th of every range
/// once, where in it and beside which of the others by the seed: the same on
/// every machine. Numbers have six digits.
/// @throws Error S006 at the table if there are more than 100 000.
std::vector<Variant> variants_of(const VaryTable& vary);

/// The n-th of `count` names v001 …
std::string numbered_name(std::size_t n, std::size_t count);

}  // namespace clevis::scene

#pragma once

#include <string>
#include <vector>

#include "multibody/model.h"

namespace clevis::multibody {

inline constexpr int kGround = -1;
inline constexpr int kNoBody = -2;  ///< left out

/// Which body each link belongs to: itself, as an index; the ground; or, of a
/// link without mass (a frame, a tool's tip), what it is fixed to.
/// @param told  takes what was joined or left out.
/// @throws Error S015 if a link without mass moves by itself between others.
std::vector<int> body_hosts(const Model& model, const std::string& file,
                            std::vector<std::string>& told);

/// Index of a link. @throws Error S014 if there is none of that name.
int link_index(const Model& model, const std::string& name,
               const std::string& file);

}  // namespace clevis::multibody

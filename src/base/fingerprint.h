#pragma once

#include <string>
#include <string_view>

namespace clevis {

/// 64-bit FNV-1a hash of bytes, 16 hexadecimal digits: tells versions of a
/// file apart, no guard against forgery.
std::string fingerprint(std::string_view bytes);

}  // namespace clevis

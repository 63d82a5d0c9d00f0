#pragma once

#include <string>
#include <string_view>

namespace clevis {

/// 64-bit FNV-1a hash of bytes, as 16 hexadecimal digits. It tells what was
/// changed by mistake; it is no protection against forgery.
std::string fingerprint(std::string_view bytes);

}  // namespace clevis

#pragma once

namespace clevis {

/// From now on this process may become the program at this very pointer, and
/// that program no other, nor may its children (Linux: seccomp). Without effect
/// where the kernel refuses. To be called between fork and exec.
/// @param program  null: this process becomes no other program either.
void allow_only(const char* program) noexcept;

}  // namespace clevis

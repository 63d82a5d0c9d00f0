#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <new>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace clevis::elasticity {

struct FreeBuffer {
  void operator()(void* numbers) const { std::free(numbers); }
};

/// Numbers that are written before they are read.
template <typename Real>
using LargeBuffer = std::unique_ptr<Real[], FreeBuffer>;

/// Large ones stand in pages of 2 MB where the system has such: their first
/// touch takes a good part of the factorisation's time.
/// @throws std::bad_alloc.
template <typename Real>
LargeBuffer<Real> large_buffer(std::size_t count) {
  constexpr std::size_t kPage = std::size_t{2} << 20;
  const std::size_t bytes = count * sizeof(Real);
  if (count > PTRDIFF_MAX / sizeof(Real)) throw std::bad_alloc();
  const bool is_large = bytes >= 2 * kPage;
  void* memory =
      is_large ? std::aligned_alloc(kPage, (bytes + kPage - 1) / kPage * kPage)
               : std::malloc(bytes > 0 ? bytes : 1);
  if (memory == nullptr) throw std::bad_alloc();
#if defined(MADV_HUGEPAGE)
  if (is_large) madvise(memory, bytes, MADV_HUGEPAGE);  // or as it is
#endif
  return LargeBuffer<Real>(static_cast<Real*>(memory));
}

}  // namespace clevis::elasticity

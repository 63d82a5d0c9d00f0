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
  void operator()(double* numbers) const { std::free(numbers); }
};

/// Numbers that are written before they are read.
using LargeBuffer = std::unique_ptr<double[], FreeBuffer>;

/// Large ones stand in pages of 2 MB where the system has such: their first
/// touch takes a good part of the factorisation's time.
/// @throws std::bad_alloc.
inline LargeBuffer large_buffer(std::size_t count) {
  constexpr std::size_t kPage = std::size_t{2} << 20;
  const std::size_t bytes = count * sizeof(double);
  if (count > PTRDIFF_MAX / sizeof(double)) throw std::bad_alloc();
  const bool is_large = bytes >= 2 * kPage;
  void* memory =
      is_large ? std::aligned_alloc(kPage, (bytes + kPage - 1) / kPage * kPage)
               : std::malloc(bytes > 0 ? bytes : 1);
  if (memory == nullptr) throw std::bad_alloc();
#if defined(MADV_HUGEPAGE)
  if (is_large) madvise(memory, bytes, MADV_HUGEPAGE);  // or as it is
#endif
  return LargeBuffer(static_cast<double*>(memory));
}

}  // namespace clevis::elasticity

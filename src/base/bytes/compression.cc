#include "base/bytes/compression.h"

#include <new>

#include <zlib.h>

namespace clevis {

std::vector<std::byte> compressed(std::span<const std::byte> bytes,
                                  Effort effort) {
  uLongf size = compressBound(static_cast<uLong>(bytes.size()));
  std::vector<std::byte> packed(size);
  if (compress2(reinterpret_cast<Bytef*>(packed.data()), &size,
                reinterpret_cast<const Bytef*>(bytes.data()),
                static_cast<uLong>(bytes.size()),
                effort == Effort::kFast ? Z_BEST_SPEED
                                        : Z_DEFAULT_COMPRESSION) != Z_OK) {
    throw std::bad_alloc();  // the only way in which it fails
  }
  packed.resize(size);
  return packed;
}

}  // namespace clevis

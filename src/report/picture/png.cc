#include "report/picture/png.h"

#include <png.h>

#include "base/messages/errors.h"

namespace clevis::report {

std::string png_of(const std::vector<std::uint8_t>& rgb, int width,
                   int height) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(width);
  image.height = static_cast<png_uint_32>(height);
  image.format = PNG_FORMAT_RGB;
  image.flags = PNG_IMAGE_FLAG_FAST;
  std::string file(PNG_IMAGE_PNG_SIZE_MAX(image), '\0');
  png_alloc_size_t size = file.size();
  if (png_image_write_to_memory(&image, file.data(), &size, 0, rgb.data(), 0,
                                nullptr) == 0) {
    throw Error("X001", "picture", image.message,
                "Please report this with the scene and its mesh.");
  }
  file.resize(size);
  return file;
}

}  // namespace clevis::report

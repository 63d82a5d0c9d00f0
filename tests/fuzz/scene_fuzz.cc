// Scene files.
#include "base/messages/errors.h"
#include "fuzz/fuzz_target.h"
#include "scene/scene.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    clevis::scene::read_scene(
        clevis::testing::as_file(data, size, "scene.toml"));
  } catch (const clevis::Error&) {  // refused, as it should be
  }
  return 0;
}

// Values of --set, put into a scene.
#include <string_view>

#include "base/messages/errors.h"
#include "fuzz/fuzz_target.h"
#include "scene/scene.h"
#include "scene/variants/setting.h"
#include "support/source_dir.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const auto kScene =
      clevis::support::source_dir() / "tests/data/scenes/every_joint.toml";
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  try {
    clevis::scene::read_scene(kScene,
                              {clevis::scene::parse_setting(text, "--set 1")});
  } catch (const clevis::Error&) {  // refused, as it should be
  }
  return 0;
}

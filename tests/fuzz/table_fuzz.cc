// Tables of load histories and of variants.
#include "base/messages/errors.h"
#include "fuzz/fuzz_target.h"
#include "scene/cases/load_table.h"
#include "scene/variants/variant_list.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const auto file = clevis::testing::as_file(data, size, "table.csv");
    if (size % 2 == 0) {
      clevis::scene::LoadTable table(file);
    } else {
      clevis::scene::read_variant_list(file);
    }
  } catch (const clevis::Error&) {  // refused, as it should be
  }
  return 0;
}

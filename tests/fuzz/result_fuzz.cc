// Results and baselines of clevis compare.
#include "base/messages/errors.h"
#include "fuzz/fuzz_target.h"
#include "report/compare/result_reader.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    clevis::report::read_result(
        clevis::testing::as_file(data, size, "result.json"));
  } catch (const clevis::Error&) {  // refused, as it should be
  }
  return 0;
}

#include "base/system/system_failure.h"

#include <filesystem>
#include <new>
#include <stdexcept>
#include <system_error>

#include <gtest/gtest.h>

namespace clevis {
namespace {

TEST(SystemFailure, IsTakenByWhatWasThrown) {
  const auto code = [](const std::exception& thrown) {
    return system_failure(thrown, "here").code();
  };
  EXPECT_EQ(code(std::bad_alloc()), "X002");
  EXPECT_EQ(code(std::system_error(std::make_error_code(
                std::errc::resource_unavailable_try_again))),
            "X002");
  EXPECT_EQ(code(std::system_error(
                std::make_error_code(std::errc::operation_not_permitted))),
            "X001");
  EXPECT_EQ(code(std::runtime_error("a fault")), "X001");
}

TEST(SystemFailure, NamesThePath) {
  const Error error =
      system_failure(std::filesystem::filesystem_error(
                         "status", "some/path",
                         std::make_error_code(std::errc::filename_too_long)),
                     "here");
  EXPECT_EQ(error.code(), "I001");
  EXPECT_EQ(error.place(), "some/path");
  EXPECT_EQ(error.exit_code(), ExitCode::kIo);
}

TEST(SystemFailure, TellsMissingLibrariesFromMissingMemory) {
  EXPECT_EQ(load_failure("a.so",
                         "a.so: cannot open shared object file: No "
                         "such file or directory")
                .code(),
            "I001");
  EXPECT_EQ(load_failure("a.so",
                         "b.so: failed to map segment from shared "
                         "object")
                .code(),
            "X002");
}

}  // namespace
}  // namespace clevis

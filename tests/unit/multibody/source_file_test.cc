#include "multibody/source_file.h"

#include <fstream>
#include <string>

#include <gtest/gtest.h>
#include <unistd.h>

#include "base/messages/errors.h"

namespace clevis::multibody {
namespace {

namespace fs = std::filesystem;

class ModelFile : public testing::Test {
 protected:
  ModelFile()
      : file_(fs::temp_directory_path() /
              ("clevis_model_file_" + std::to_string(getpid()) + ".sdf")) {}
  ~ModelFile() override { fs::remove(file_); }

  /// The code by which a file of this content is refused.
  std::string refusal(const std::string& content) {
    std::ofstream(file_, std::ios::binary) << content;
    try {
      require_model_file(file_);
    } catch (const Error& error) {
      return error.code();
    }
    return "";
  }

  fs::path file_;
};

TEST_F(ModelFile, TakesWhatBeginsAsXmlDoes) {
  EXPECT_EQ(refusal("<sdf/>"), "");
  EXPECT_EQ(refusal("\xEF\xBB\xBF \r\n<?xml version=\"1.0\"?><robot/>"), "");
}

TEST_F(ModelFile, RefusesWhatDoesNot) {
  EXPECT_EQ(refusal(""), "S013");
  EXPECT_EQ(refusal("#!/bin/sh\n<sdf/>"), "S013");
  EXPECT_EQ(refusal("<sdf>" + std::string(std::size_t{16} << 20, ' ')), "S013");
}

TEST_F(ModelFile, RefusesWhatIsNoFile) {
  EXPECT_THROW(require_model_file("no/such.sdf"), Error);
  try {
    require_model_file(fs::temp_directory_path());
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), "I001");
  }
}

}  // namespace
}  // namespace clevis::multibody

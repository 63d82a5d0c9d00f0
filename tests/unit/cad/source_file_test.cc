#include "cad/source_file.h"

#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>
#include <unistd.h>

#include "base/messages/errors.h"

namespace clevis::cad {
namespace {

namespace fs = std::filesystem;

class SourceFile : public testing::Test {
 protected:
  SourceFile()
      : folder_(fs::temp_directory_path() /
                ("clevis_source_file_" + std::to_string(getpid()))) {
    fs::create_directories(folder_);
  }
  ~SourceFile() override { fs::remove_all(folder_); }

  /// The code by which a file of this name and content is refused.
  std::string refusal(const std::string& name, const std::string& content) {
    std::ofstream(folder_ / name, std::ios::binary) << content;
    try {
      require_solid_file(folder_ / name);
    } catch (const Error& error) {
      return error.code();
    }
    return "";
  }

  fs::path folder_;
};

const std::string kIges = std::string(72, ' ') + "S      1\n";

TEST_F(SourceFile, TakesWhatBeginsAsItsExtensionPromises) {
  EXPECT_EQ(refusal("a.step", "ISO-10303-21;\nHEADER;\n"), "");
  EXPECT_EQ(refusal("a.STP", "\xEF\xBB\xBF \r\nISO-10303-21;\n"), "");
  EXPECT_EQ(refusal("a.igs", kIges), "");
  EXPECT_EQ(refusal("a.brep", "DBRep_DrawableShape\n\nCASCADE\n"), "");
}

TEST_F(SourceFile, RefusesWhatIsSomethingElse) {
  const std::string script = "SystemCall \"touch ran\";\n";
  for (const char* name : {"a.step", "a.stp", "a.iges", "a.igs", "a.brep"}) {
    EXPECT_EQ(refusal(name, script), "M015") << name;
    EXPECT_EQ(refusal(name, ""), "M015") << name;
  }
  EXPECT_EQ(refusal("a.igs", "ISO-10303-21;\n"), "M015");
  EXPECT_EQ(refusal("a.step", kIges), "M015");
  // The right head behind something else.
  EXPECT_EQ(refusal("a.step", script + "ISO-10303-21;\n"), "M015");
}

TEST_F(SourceFile, RefusesWhatIsNoFileOrTooLarge) {
  fs::create_directory(folder_ / "folder.step");
  EXPECT_THROW(require_solid_file(folder_ / "folder.step"), Error);
  EXPECT_THROW(require_solid_file(folder_ / "none.step"), Error);
  refusal("large.step", "ISO-10303-21;\n");
  fs::resize_file(folder_ / "large.step", (256u << 20) + (1u << 20));
  EXPECT_THROW(require_solid_file(folder_ / "large.step"), Error);
}

}  // namespace
}  // namespace clevis::cad

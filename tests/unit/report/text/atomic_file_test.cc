#include "report/text/atomic_file.h"

#include <fstream>
#include <iterator>

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/messages/errors.h"
#include "unit/report/sample_report.h"

namespace clevis::report {
namespace {

namespace fs = std::filesystem;

std::string refusal(const fs::path& file) {
  try {
    write_file(file, "content");
  } catch (const Error& error) {
    return error.code() + " " + error.problem();
  }
  return {};
}

std::ptrdiff_t entries(const fs::path& folder) {
  return std::distance(fs::directory_iterator(folder), {});
}

TEST(AtomicFile, CreatesFoldersAndReplacesOldContent) {
  const TestFolder folder;
  const fs::path file = folder / "a/b/result.json";
  write_file(file, "a longer first content");
  write_file(file, "second");
  EXPECT_EQ(content_of(file), "second");
  EXPECT_EQ(entries(file.parent_path()), 1) << "temporary file left behind";
}

TEST(AtomicFile, KeepsEveryByte) {
  const TestFolder folder;
  std::string bytes(3'000'000, '\0');
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    bytes[i] = static_cast<char>(i * 2654435761u >> 13);
  }
  write_file(folder / "field.vtu", bytes);
  EXPECT_TRUE(content_of(folder / "field.vtu") == bytes);
}

TEST(AtomicFile, OfPiecesIsOldOrWhole) {
  const TestFolder folder;
  const fs::path file = folder / "field.vtu";
  write_file(file, [](const TextSink& sink) {
    sink("one, ");
    sink("two");
  });
  EXPECT_EQ(content_of(file), "one, two");
  const auto fails = [](const TextSink& sink) {
    sink("half");
    throw Error("X001", "test", "problem", "hint");
  };
  EXPECT_THROW(write_file(file, fails), Error);
  EXPECT_EQ(content_of(file), "one, two");
  EXPECT_EQ(entries(folder / ""), 1) << "temporary file left behind";
}

TEST(AtomicFile, NamesThatLeaveTheWhitelistAreRefused) {
  EXPECT_TRUE(is_file_name("DCE-2_b.vtu"));
  EXPECT_TRUE(is_file_name(std::string(64, 'x')));
  for (const std::string& name :
       {std::string(), std::string("."), std::string(".."), std::string("a/b"),
        std::string("a b"), std::string("a\n"), std::string("bore_\xc3\xa4"),
        std::string("a\0b", 3), std::string(65, 'x')}) {
    EXPECT_FALSE(is_file_name(name)) << name;
  }
  const TestFolder folder;
  EXPECT_EQ(refusal(folder / "..").substr(0, 4), "I002");
  EXPECT_EQ(refusal(folder / "$(x)").substr(0, 4), "I002");
  EXPECT_EQ(entries(folder.path()), 0);
}

TEST(AtomicFile, OwnNamesMayHaveBlanksAndLettersOfAllScripts) {
  for (const std::string& name :
       {std::string("my plot 2.svg"), std::string("Tr\xc3\xa4ger.html"),
        std::string("\xe6\xa2\x81.json"), std::string(128, 'x')}) {
    EXPECT_TRUE(is_own_file_name(name)) << name;
    const TestFolder folder;
    write_file(folder / name, "content");
    EXPECT_EQ(content_of(folder / name), "content");
    EXPECT_EQ(entries(folder.path()), 1);
  }
  for (const std::string& name :
       {std::string(), std::string(".."), std::string(" a"), std::string("a "),
        std::string("a\nb"), std::string("a\0b", 3), std::string("a:b"),
        std::string("a?"), std::string("a\xff"), std::string("a\xc2\x85"),
        std::string("gpj.\xe2\x80\xae"), std::string(129, 'x')}) {
    EXPECT_FALSE(is_own_file_name(name)) << name;
  }
}

// The test may run as root, whom permissions do not stop: a file in the
// place of a folder and a folder in the place of a file do.
TEST(AtomicFile, FailureNamesTheReasonAndLeavesNothing) {
  const TestFolder folder;
  std::ofstream(folder / "plain") << "x";
  fs::create_directories(folder / "result.json");
  EXPECT_NE(refusal(folder / "plain/result.json").find("Not a directory"),
            std::string::npos);
  EXPECT_NE(refusal(folder / "result.json").find("Is a directory"),
            std::string::npos);
  EXPECT_EQ(entries(folder.path()), 2) << "temporary file left behind";
}

// As the superuser a rename would replace a device such as /dev/null.
TEST(AtomicFile, WhatIsNoFileStays) {
  const TestFolder folder;
  ASSERT_EQ(mkfifo((folder / "pipe").c_str(), 0600), 0);
  fs::create_symlink("pipe", folder / "link");
  for (const char* name : {"pipe", "link"}) {
    EXPECT_EQ(refusal(folder / name),
              "I002 cannot write file: it is a device or pipe");
  }
  EXPECT_TRUE(fs::is_fifo(folder / "pipe"));
  EXPECT_TRUE(fs::is_symlink(folder / "link"));
  EXPECT_EQ(entries(folder.path()), 2);
}

TEST(AtomicFile, LinkIsReplacedNotFollowed) {
  const TestFolder folder;
  write_file(folder / "other", "untouched");
  fs::create_symlink(folder / "other", folder / "result.json");
  write_file(folder / "result.json", "content");
  EXPECT_FALSE(fs::is_symlink(folder / "result.json"));
  EXPECT_EQ(content_of(folder / "result.json"), "content");
  EXPECT_EQ(content_of(folder / "other"), "untouched");
}

TEST(AtomicFile, RemainsOfKilledProcessesAreRemovedAndNothingElse) {
  const TestFolder folder;
  write_file(folder / "result.json", "content");
  write_file(folder / "frames/AB_0000.vtu", "content");
  write_file(folder / "view/motion.json", "content");
  // No system has process numbers above 2^22.
  std::ofstream(folder / "frames/.AB_0001.vtu.99999999-0123abcd.tmp") << "half";
  std::ofstream(folder / "view/.motion.json.99999999-0123abcd.tmp") << "half";
  std::ofstream(folder / ".result.json.99999999-0123abcd.tmp") << "half";
  const std::string of_a_living_process =
      "." + std::to_string(getpid()) + "-0123abcd.tmp";
  fs::create_directory(folder / "sub");
  for (const std::string name :
       {"sub/.AB.vtu.99999999-0123abcd.tmp", ".other.12.tmp", ".tmp",
        "notes.99999999-0123abcd.tmp"}) {
    std::ofstream(folder / name) << "a user's own";
  }
  std::ofstream(folder / (".AB.vtu" + of_a_living_process)) << "half";
  remove_unfinished(folder.path());
  // result.json, frames, view, sub, three of the user and the living process's
  EXPECT_EQ(entries(folder.path()), 8);
  EXPECT_EQ(entries(folder / "frames"), 1);
  EXPECT_EQ(entries(folder / "view"), 1);
  EXPECT_EQ(entries(folder / "sub"), 1);
  EXPECT_NO_THROW(remove_unfinished(folder / "not there"));
}

TEST(AtomicFile, RemainsOfAProcessThatNobodyAwaitedAreRemoved) {
  const TestFolder folder;
  const pid_t child = fork();
  if (child == 0) _exit(0);
  siginfo_t ended{};
  waitid(P_PID, static_cast<id_t>(child), &ended, WEXITED | WNOWAIT);
  std::ofstream(folder / (".AB.vtu." + std::to_string(child) + "-0123abcd.tmp"))
      << "half";
  remove_unfinished(folder.path());
  EXPECT_EQ(entries(folder.path()), 0);
  waitpid(child, nullptr, 0);
}

}  // namespace
}  // namespace clevis::report

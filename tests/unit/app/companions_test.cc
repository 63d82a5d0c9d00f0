#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "app/companions/model_importer.h"
#include "app/companions/sandbox.h"
#include "app/processes/child_process.h"
#include "app/processes/lone_program.h"
#include "app/processes/temporary_folder.h"
#include "base/messages/errors.h"

namespace clevis::app {
namespace {

namespace fs = std::filesystem;

void write(const fs::path& file, const std::string& text) {
  std::ofstream(file) << text;
}

/// What is said where the importer is a script that ends like this.
std::string refusal_of(const std::string& end) {
  const TemporaryFolder folder;
  const fs::path model = folder.path() / "a.urdf";
  const fs::path program = folder.path() / "importer";
  write(model, "<robot/>");
  write(program, "#!/bin/sh\n" + end + "\n");
  fs::permissions(program, fs::perms::owner_all);
  try {
    run_importer(model, program);
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), "S014");
    return error.problem();
  }
  return {};
}

TEST(Companions, TellTheirLimitOfMemory) {
  EXPECT_EQ(refusal_of("exit 21"),
            "the importer needs more memory for this file than its limit of "
            "2048 MiB");
  EXPECT_EQ(refusal_of("kill -SEGV $$"),
            "the importer died of signal 11 (2048 MiB are its limit) on this "
            "file");
  EXPECT_EQ(refusal_of("exit 1"),
            "the importer gave up on this file; 2048 MiB are its limit");
}

/// Runs a program in the sandbox with a file to read and a folder of its own.
struct Sandboxed {
  TemporaryFolder folder, elsewhere;
  fs::path input = elsewhere.path() / "input";
  fs::path other = elsewhere.path() / "other";

  Sandboxed() {
    write(input, "seen");
    write(other, "hidden");
  }

  /// Whether it succeeds, and what it printed.
  std::pair<bool, std::string> run(const std::string& name,
                                   std::vector<std::string> arguments) const {
    const fs::path program = fs::canonical(find_program(name));
    const fs::path log = folder.path() / "log";
    fs::remove(log);
    auto command = sandbox_command(program, {input}, folder.path());
    EXPECT_FALSE(command.empty());
    command.push_back(program.string());
    command.insert(command.end(), arguments.begin(), arguments.end());
    const auto outcome = run_child({.arguments = command,
                                    .folder = folder.path(),
                                    .log = log,
                                    .starts_others = true},
                                   std::chrono::seconds(10));
    std::ifstream text(log);
    return {outcome.succeeded(), {std::istreambuf_iterator<char>(text), {}}};
  }
};

TEST(Sandbox, ShowsTheInputAndTheFolderAlone) {
  const Sandboxed box;
  if (sandbox_command(fs::canonical(find_program("cat")), {}, "/tmp").empty()) {
    GTEST_SKIP() << about_sandbox();
  }
  EXPECT_EQ(box.run("cat", {box.input}), std::pair(true, std::string("seen")));
  EXPECT_FALSE(box.run("cat", {box.other}).first);
  EXPECT_FALSE(box.run("cat", {"/etc/passwd"}).first);
  EXPECT_TRUE(box.run("touch", {box.folder.path() / "made"}).first);
  EXPECT_TRUE(fs::exists(box.folder.path() / "made"));
  EXPECT_FALSE(box.run("touch", {box.input}).first);
  EXPECT_FALSE(box.run("touch", {"/usr/lib/made"}).first);
  EXPECT_FALSE(box.run("env", {"/usr/bin/id"}).first);  // no other program
  // Neither a network nor the other processes.
  const auto command = sandbox_command("/usr/bin/cat", {}, "/tmp");
  EXPECT_EQ(std::ranges::count(command, "--unshare-all"), 1);
  EXPECT_EQ(std::ranges::count(command, "--share-net"), 0);
}

TEST(Sandbox, IsNoneWhereBubblewrapIsNot) {
  EXPECT_TRUE(sandbox_command("/tmp/none", {}, "/tmp").empty());
}

}  // namespace
}  // namespace clevis::app

#include "report/text/atomic_file.h"

#include <cerrno>
#include <csignal>
#include <cstring>
#include <fstream>
#include <random>
#include <regex>
#include <string>
#include <system_error>
#include <vector>

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include "base/messages/errors.h"
#include "base/system/interrupts.h"
#include "report/text/json_text.h"

namespace clevis::report {
namespace {

constexpr std::size_t kLongestName = 64, kLongestOwnName = 128;  // [bytes]
constexpr std::string_view kPlain =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789._-";

[[noreturn]] void refuse(const std::filesystem::path& file,
                         const std::string& step, const std::string& reason) {
  throw Error("I002", file.string(), "cannot " + step + ": " + reason,
              "Check that the folder may be written and that the disk is not "
              "full.");
}

/// The temporary file: closed and removed unless it was renamed.
class TemporaryFile {
 public:
  explicit TemporaryFile(const std::filesystem::path& target)
      : target_(target),
        // Processes of other machines may have the same number.
        path_(target.parent_path() /
              fmt::format(".{}.{}-{:08x}.tmp", target.filename().string(),
                          ::getpid(), std::random_device()())) {
    descriptor_ =
        ::open(path_.c_str(),
               O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
    if (descriptor_ < 0) refuse(target_, "create file", std::strerror(errno));
  }
  ~TemporaryFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
    if (!published_) ::unlink(path_.c_str());
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  void write(std::string_view content) {
    while (!content.empty()) {
      const ssize_t written =
          ::write(descriptor_, content.data(), content.size());
      if (written < 0 && errno == EINTR) continue;
      if (written < 0) refuse(target_, "write file", std::strerror(errno));
      content.remove_prefix(static_cast<std::size_t>(written));
    }
  }

  void publish() {
    if (::fsync(descriptor_) != 0) {
      refuse(target_, "write file", std::strerror(errno));
    }
    const int closed = ::close(descriptor_);
    descriptor_ = -1;
    if (closed != 0) refuse(target_, "write file", std::strerror(errno));
    if (::rename(path_.c_str(), target_.c_str()) != 0) {
      refuse(target_, "rename file into place", std::strerror(errno));
    }
    published_ = true;
  }

 private:
  DeferredInterrupt deferred_;
  std::filesystem::path target_, path_;
  int descriptor_ = -1;
  bool published_ = false;
};

/// Whether a process has ended, also if nobody has asked how (a zombie).
bool is_gone(int process) {
  if (::kill(process, 0) != 0) return errno == ESRCH;
  std::ifstream stat(fmt::format("/proc/{}/stat", process));
  std::string line;
  std::getline(stat, line);
  const std::size_t name_end = line.rfind(')');
  return name_end != line.npos && line.substr(name_end).starts_with(") Z");
}

/// Whether the file is the temporary one of a process that is gone.
bool is_left_over(const std::string& name) {
  static const std::regex kPattern(
      R"(\.([^/]{1,128})\.(\d{1,9})-[0-9a-f]{8}\.tmp)");
  std::smatch match;
  if (!std::regex_match(name, match, kPattern)) return false;
  return is_gone(std::stoi(match[2]));
}

/// Whether a text begins with a control of Latin-1 (U+0080 to U+009F), a blank
/// or mark of general punctuation (U+2000 to U+207F), which may turn the
/// direction, or U+FEFF.
bool is_unseen(std::string_view text) {
  return (text.starts_with("\xC2") && text.size() > 1 && text[1] < '\xA0') ||
         text.starts_with("\xE2\x80") || text.starts_with("\xE2\x81") ||
         text.starts_with("\xEF\xBB\xBF");
}

/// Makes the rename itself survive a power cut. Not every file system allows
/// it, and the content is safe already: no error.
void sync_folder(const std::filesystem::path& folder) {
  const int descriptor =
      ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  ::fsync(descriptor);
  ::close(descriptor);
}

}  // namespace

bool is_file_name(std::string_view name) {
  return !name.empty() && name.size() <= kLongestName && name != "." &&
         name != ".." &&
         name.find_first_not_of(kPlain) == std::string_view::npos;
}

bool is_own_file_name(std::string_view name) {
  if (name.empty() || name.size() > kLongestOwnName || name == "." ||
      name == ".." || name.front() == ' ' || name.back() == ' ' ||
      valid_utf8(std::string(name)) != name) {
    return false;
  }
  for (std::size_t i = 0; i < name.size(); ++i) {
    const bool is_ascii = static_cast<unsigned char>(name[i]) < 0x80;
    if (is_ascii ? kPlain.find(name[i]) == kPlain.npos && name[i] != ' '
                 : is_unseen(name.substr(i))) {
      return false;
    }
  }
  return true;
}

void write_file(const std::filesystem::path& file, std::string_view content) {
  write_file(file, [&](const TextSink& sink) {
    sink(content);
  });
}

void write_file(const std::filesystem::path& file,
                const std::function<void(const TextSink&)>& write) {
  const std::string name = file.filename().string();
  if (!is_own_file_name(name)) {
    throw Error("I002", file.string(),
                "\"" + name + "\" is not allowed as the name of a file",
                "Use a name of letters, digits, '.', '_', '-' and blanks "
                "within, 128 bytes at most.");
  }
  const std::filesystem::path target = std::filesystem::absolute(file);
  std::error_code failure;
  const auto before = std::filesystem::status(target, failure);
  if (std::filesystem::exists(before) &&
      !std::filesystem::is_regular_file(before)) {
    refuse(target, "write file",
           std::filesystem::is_directory(before) ? std::strerror(EISDIR)
                                                 : "it is a device or pipe");
  }
  std::filesystem::create_directories(target.parent_path(), failure);
  if (failure) refuse(target.parent_path(), "create folder", failure.message());
  TemporaryFile temporary(target);
  write([&](std::string_view piece) {
    temporary.write(piece);
  });
  temporary.publish();
  sync_folder(target.parent_path());
}

void remove_unfinished(const std::filesystem::path& folder) {
  namespace fs = std::filesystem;
  std::error_code ignored;  // no folder: nothing is left
  std::vector<fs::path> left;
  for (const fs::path& place :
       {folder, folder / kFramesFolder, folder / kViewFolder}) {
    for (const auto& entry : fs::directory_iterator(place, ignored)) {
      if (is_left_over(entry.path().filename().string())) {
        left.push_back(entry.path());
      }
    }
  }
  for (const fs::path& file : left) fs::remove(file, ignored);
}

}  // namespace clevis::report

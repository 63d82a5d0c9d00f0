#include "base/system/huge_pages.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <system_error>

#include <unistd.h>

namespace clevis {
namespace {

namespace fs = std::filesystem;

constexpr const char* kSettings = "/sys/kernel/mm/transparent_hugepage";

std::string first_line(const fs::path& path) {
  std::string line;
  std::ifstream file(path);
  std::getline(file, line);
  return line;
}

/// Pages of more than some megabytes would be mostly empty.
bool are_on_request() {
  constexpr long kLargest = 4L << 20;
  const fs::path settings = kSettings;
  const long size = std::atol(first_line(settings / "hpage_pmd_size").c_str());
  return size > 0 && size <= kLargest &&
         first_line(settings / "enabled").find("[madvise]") !=
             std::string::npos;
}

}  // namespace

void restart_with_huge_pages(char** argv) {
#if defined(__GLIBC__)
  constexpr const char* kVariable = "GLIBC_TUNABLES";
  const char* known = std::getenv(kVariable);
  std::string tunables = known == nullptr ? "" : known;
  // Also what keeps this from going on for ever.
  if (tunables.find("glibc.malloc.hugetlb") != std::string::npos) return;
  if (!are_on_request()) return;
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  if (error) return;
  if (!tunables.empty()) tunables += ':';
  tunables += "glibc.malloc.hugetlb=1";
  if (setenv(kVariable, tunables.c_str(), 1) != 0) return;
  execv(program.c_str(), argv);
#else
  static_cast<void>(argv);
#endif
}

}  // namespace clevis

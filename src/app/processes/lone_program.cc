#include "app/processes/lone_program.h"

#include <array>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include <unistd.h>

namespace clevis::app {

using std::filesystem::path;

path find_program(const std::string& name) {
  const auto may_run = [](const path& file) {
    std::error_code none;
    return std::filesystem::is_regular_file(file, none) &&
           access(file.c_str(), X_OK) == 0;
  };
  if (name.find('/') != std::string::npos) {
    return may_run(name) ? std::filesystem::absolute(name) : path{};
  }
  const char* search = std::getenv("PATH");
  std::istringstream folders(search != nullptr ? search : "/usr/bin:/bin");
  for (std::string folder; std::getline(folders, folder, ':');) {
    const path file = path(folder.empty() ? "." : folder) / name;
    if (may_run(file)) return std::filesystem::absolute(file);
  }
  return {};
}

bool is_binary(const path& program) {
  std::array<char, 4> start{};
  std::ifstream(program, std::ios::binary).read(start.data(), start.size());
  return start == std::array<char, 4>{'\x7f', 'E', 'L', 'F'};
}

}  // namespace clevis::app

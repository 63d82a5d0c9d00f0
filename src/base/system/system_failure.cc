#include "base/system/system_failure.h"

#include <filesystem>
#include <new>
#include <system_error>

namespace clevis {

Error out_of_resources(const std::string& place, const std::string& what) {
  return {"X002", place, what,
          "Free memory, raise the limits of this shell (ulimit -a) or "
          "container, solve fewer parts at once (--jobs 1), or mesh coarser."};
}

Error load_failure(const std::string& library, const std::string& reason) {
  // As glibc's loader says it.
  for (const char* words : {"annot allocate memory", "failed to map segment"}) {
    if (reason.find(words) != std::string::npos) {
      return out_of_resources(library, reason);
    }
  }
  return {"I001", library, reason,
          "Reinstall clevis: this library belongs to it."};
}

Error system_failure(const std::exception& failure, const std::string& place) {
  if (dynamic_cast<const std::bad_alloc*>(&failure) != nullptr) {
    return out_of_resources(place, "the memory ran out");
  }
  if (const auto* file =
          dynamic_cast<const std::filesystem::filesystem_error*>(&failure)) {
    return {"I001", file->path1().empty() ? place : file->path1().string(),
            file->code().message(),
            "Check the path and the folder that clevis was started in."};
  }
  if (const auto* system = dynamic_cast<const std::system_error*>(&failure)) {
    const std::error_code code = system->code();
    if (code == std::errc::resource_unavailable_try_again ||
        code == std::errc::not_enough_memory) {
      return out_of_resources(
          place, "no more processes or threads: " + code.message());
    }
  }
  return {"X001", place, failure.what(),
          "Please report this with the scene, its mesh and the command."};
}

}  // namespace clevis

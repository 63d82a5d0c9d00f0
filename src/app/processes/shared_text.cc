#include "app/processes/shared_text.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <new>

#include <sys/mman.h>

#include "base/messages/errors.h"

namespace clevis::app {

static_assert(std::atomic<std::size_t>::is_always_lock_free);

SharedText::SharedText() {
  void* memory = mmap(nullptr, sizeof(Memory), PROT_READ | PROT_WRITE,
                      MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) {
    throw Error("I002", "shared memory", std::strerror(errno),
                "Free system resources.");
  }
  memory_ = new (memory) Memory{};
}

SharedText::~SharedText() {
  munmap(memory_, sizeof(Memory));
}

void SharedText::set(std::string_view text) {
  text = text.substr(0, kLongest);
  ++memory_->version;
  for (std::size_t i = 0; i < text.size(); ++i) memory_->bytes[i] = text[i];
  memory_->length = text.size();
  ++memory_->version;
}

std::string SharedText::get() const {
  const unsigned version = memory_->version;
  std::string text(std::min<std::size_t>(memory_->length, kLongest), '\0');
  for (std::size_t i = 0; i < text.size(); ++i) text[i] = memory_->bytes[i];
  return version % 2 == 0 && memory_->version == version ? text : "";
}

}  // namespace clevis::app

#include "base/system/processor_share.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <new>

#include <sys/mman.h>

#include "base/messages/errors.h"

namespace clevis {

namespace {

int all = 1;
const SharedCount* processes = nullptr;

}  // namespace

static_assert(std::atomic<int>::is_always_lock_free);  // else not across forks

SharedCount::SharedCount(int value) {
  void* memory = mmap(nullptr, sizeof(std::atomic<int>), PROT_READ | PROT_WRITE,
                      MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) {
    throw Error("I002", "shared memory", std::strerror(errno),
                "Free system resources.");
  }
  count_ = new (memory) std::atomic<int>(value);
}

SharedCount::~SharedCount() {
  munmap(count_, sizeof(std::atomic<int>));
}

void share_processors(int processors, const SharedCount& at_work) {
  all = processors;
  processes = &at_work;
}

int own_processors() {
  if (processes == nullptr) return 1;
  return std::max(1, all / std::max(1, processes->get()));
}

}  // namespace clevis

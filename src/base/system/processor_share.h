#pragma once

#include <atomic>

namespace clevis {

/// A number that this process and those that it forks see alike.
class SharedCount {
 public:
  /// @throws Error I002 if the system gives no memory to share.
  explicit SharedCount(int value);
  ~SharedCount();
  SharedCount(const SharedCount&) = delete;
  SharedCount& operator=(const SharedCount&) = delete;

  void set(int value) { *count_ = value; }
  int get() const { return *count_; }

 private:
  std::atomic<int>* count_;
};

/// Has this process and those that it forks share so many processors.
/// @param at_work  how many of them have work; outlives their work.
void share_processors(int processors, const SharedCount& at_work);

/// Processors that this process may keep busy at this moment; 1 where nobody
/// called share_processors().
int own_processors();

}  // namespace clevis

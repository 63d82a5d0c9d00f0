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

/// Processors that this process may keep busy, beside others that share them.
struct ProcessorShare {
  int all = 1;
  const SharedCount* at_work = nullptr;  ///< processes; none: this one alone

  /// At this moment; at least 1.
  int now() const;
};

}  // namespace clevis

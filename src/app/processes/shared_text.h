#pragma once

#include <atomic>
#include <cstddef>
#include <string>
#include <string_view>

namespace clevis::app {

/// A line that a worker writes and its parent reads at any moment, whole or not
/// at all.
class SharedText {
 public:
  /// @throws Error I002 if the system gives no memory to share.
  SharedText();
  ~SharedText();
  SharedText(const SharedText&) = delete;
  SharedText& operator=(const SharedText&) = delete;

  static constexpr std::size_t kLongest = 120;  // bytes; what follows is cut

  /// By one process at a time.
  void set(std::string_view text);
  /// The last one; empty: none, or one that is being written.
  std::string get() const;

 private:
  struct Memory {
    std::atomic<unsigned> version;  // odd: being written
    std::atomic<std::size_t> length;
    std::atomic<char> bytes[kLongest];
  };
  Memory* memory_;
};

}  // namespace clevis::app

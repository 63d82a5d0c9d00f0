#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace clevis::mesh {

/// Walks through the bytes of a mesh file; every step checks what is left.
class Cursor {
 public:
  Cursor(std::string_view bytes, std::string file)
      : bytes_(bytes), file_(std::move(file)) {}

  /// From now on integer(), size() and real() take binary numbers
  /// (int32, uint64, double, little-endian) instead of text.
  void set_binary() { binary_ = true; }
  bool binary() const { return binary_; }

  std::size_t remaining() const { return bytes_.size() - at_; }
  void skip_space();
  /// Rest of the line without its end; moves behind the end.
  std::string_view line();
  /// Moves behind the next occurrence of `text`.
  void skip_behind(std::string_view text);

  std::int64_t text_integer();
  /// A number as the file has it, in the units of the file.
  double text_real();
  int integer();
  std::uint64_t size();
  double real();  ///< in the units of the file

  /// A count just read, whose records take at least `bytes_each` bytes: fails
  /// unless that many can follow, before anybody allocates for them.
  std::size_t count(std::uint64_t claimed, std::size_t bytes_each,
                    std::string_view of) const;

  /// "file:line", in binary files "file: byte n".
  std::string place() const;
  /// @throws Error M002 here.
  [[noreturn]] void fail(const std::string& problem) const;

 private:
  template <class T>
  T raw();
  template <class T>
  T parse(std::string_view what);

  std::string_view bytes_;
  std::string file_;
  std::size_t at_ = 0;
  bool binary_ = false;
};

}  // namespace clevis::mesh

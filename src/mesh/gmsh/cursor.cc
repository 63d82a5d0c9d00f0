#include "mesh/gmsh/cursor.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cstring>
#include <limits>
#include <system_error>
#include <type_traits>

#include <fmt/format.h>

#include "base/messages/errors.h"

namespace clevis::mesh {

static_assert(std::endian::native == std::endian::little,
              "binary meshes are little-endian and read in place");

namespace {

bool is_space(char c) {
  return c == ' ' || c == '\n' || c == '\t' || c == '\r';
}

}  // namespace

void Cursor::skip_space() {
  while (at_ < bytes_.size() && is_space(bytes_[at_])) ++at_;
}

std::string_view Cursor::line() {
  const std::size_t end = std::min(bytes_.find('\n', at_), bytes_.size());
  std::string_view text = bytes_.substr(at_, end - at_);
  at_ = std::min(end + 1, bytes_.size());
  while (!text.empty() && is_space(text.back())) text.remove_suffix(1);
  return text;
}

void Cursor::skip_behind(std::string_view text) {
  const std::size_t found = bytes_.find(text, at_);
  if (found == std::string_view::npos) {
    fail(fmt::format("the file ends before {}", text));
  }
  at_ = found + text.size();
}

template <class T>
T Cursor::parse(std::string_view what) {
  skip_space();
  const char* const begin = bytes_.data() + at_;
  const char* const end = bytes_.data() + bytes_.size();
  T value{};
  const bool plus = begin != end && *begin == '+';
  const auto [stop, status] = std::from_chars(begin + plus, end, value);
  if constexpr (std::is_same_v<T, double>) {
    // 1e999: a number, but not one that a coordinate can have.
    if (status == std::errc::result_out_of_range) {
      value = std::numeric_limits<double>::infinity();
    } else if (status != std::errc{}) {
      fail(fmt::format("a {} was expected here", what));
    }
  } else if (status != std::errc{}) {
    fail(fmt::format("a {} was expected here", what));
  }
  if (stop != end && !is_space(*stop)) {
    fail(fmt::format("a {} was expected here", what));
  }
  at_ += std::size_t(stop - begin);
  return value;
}

std::int64_t Cursor::text_integer() {
  return parse<std::int64_t>("integer");
}
double Cursor::text_real() {
  return parse<double>("number");
}

template <class T>
T Cursor::raw() {
  if (remaining() < sizeof(T)) fail("the file ends in the middle of its data");
  T value;
  std::memcpy(&value, bytes_.data() + at_, sizeof(T));
  at_ += sizeof(T);
  return value;
}

int Cursor::integer() {
  if (binary_) return raw<std::int32_t>();
  return parse<std::int32_t>("integer");
}

std::uint64_t Cursor::size() {
  if (binary_) return raw<std::uint64_t>();
  return parse<std::uint64_t>("positive integer");
}

double Cursor::real() {
  return binary_ ? raw<double>() : text_real();
}

std::size_t Cursor::count(std::uint64_t claimed, std::size_t bytes_each,
                          std::string_view of) const {
  if (claimed > remaining() / bytes_each) {
    fail(fmt::format("{} {} are announced but only {} bytes follow", claimed,
                     of, remaining()));
  }
  return std::size_t(claimed);
}

std::string Cursor::place() const {
  if (binary_) return fmt::format("{}: byte {}", file_, at_);
  return fmt::format(
      "{}:{}", file_,
      1 + std::count(bytes_.begin(), bytes_.begin() + std::ptrdiff_t(at_),
                     '\n'));
}

void Cursor::fail(const std::string& problem) const {
  throw Error("M002", place(), problem,
              "Export the mesh again from its source.");
}

}  // namespace clevis::mesh

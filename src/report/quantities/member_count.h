#pragma once

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <utility>

namespace clevis::report {
namespace detail {

/// Stands for any member in an initialiser that is not evaluated.
struct AnyMember {
  template <class Member>
  operator Member() const;
};

template <class Aggregate, std::size_t... i>
constexpr bool takes(std::index_sequence<i...>) {
  return requires {
    Aggregate{(static_cast<void>(i), AnyMember{})...};
  };
}

}  // namespace detail

/// Number of members of an aggregate without arrays and bases.
template <class Aggregate, std::size_t from = 0>
constexpr std::size_t member_count() {
  if constexpr (detail::takes<Aggregate>(
                    std::make_index_sequence<from + 1>())) {
    return member_count<Aggregate, from + 1>();
  } else {
    return from;
  }
}

/// Number of names in "a, b, c"; at least one.
constexpr std::size_t name_count(std::string_view names) {
  return 1 + static_cast<std::size_t>(std::ranges::count(names, ','));
}

}  // namespace clevis::report

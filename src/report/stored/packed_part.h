#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

namespace clevis::report {

/// The view of a part (view/part_NAME.json) as bytes that compress well: the
/// length of a header (four bytes, little-endian), the header, and behind it
/// the lists of numbers. The header is the view with {"type", "count", "code",
/// "at"} in place of each list, `at` counted from the header's end. A list has
/// all lowest bytes of its numbers first, then all next ones, and so on;
/// `code` tells what the numbers are:
/// - "plain": the list's own;
/// - "steps": what each is more than the one before, 0, −1, 1, −2 … as 0, 1, 2,
///   3 …: of neighbours on a surface;
/// - "firsts": of a list that names things for the first time in their order,
///   how far below the next new one each is, 0 for that one itself.
/// @throws Error I003 if a list is damaged.
std::vector<std::byte> packed_part(std::string_view view);

}  // namespace clevis::report

#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "report/text/json_node.h"

namespace clevis::report {

/// Refuses what a view holds and cannot.
[[noreturn]] void refuse_view(const std::string& problem);

/// Calls `use` with a number of the type that a list of a view has.
/// @throws Error I003.
template <class Use>
decltype(auto) with_stored_type(const JsonNode& packed, const Use& use) {
  const std::string type = packed.at("type").text();
  if (type == "f32") return use(float{});
  if (type == "i8") return use(std::int8_t{});
  if (type == "i16") return use(std::int16_t{});
  if (type == "u16") return use(std::uint16_t{});
  if (type == "u32") return use(std::uint32_t{});
  refuse_view("numbers of type \"" + type + "\" are unknown");
}

/// Numbers that a view holds in base 64, whatever their type.
/// @throws Error I003.
std::vector<double> stored_numbers(const JsonNode& packed);

/// A packed field: points × instants, in the unit of its key.
/// @throws Error I003.
Eigen::MatrixXd stored_field(const JsonNode& field);

/// Where the points of a part stand: x, y, z of each, one after another [mm].
/// @throws Error I003.
std::vector<double> stored_points(const JsonNode& part);

}  // namespace clevis::report

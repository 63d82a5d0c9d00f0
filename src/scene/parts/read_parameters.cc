#include "scene/parts/read_parameters.h"

#include <algorithm>
#include <cctype>
#include <string>

#include <fmt/format.h>

namespace clevis::scene {
namespace {

void require_variable(const std::string& name, const Value& value) {
  constexpr std::size_t kLongest = 64;
  const auto is_word = [](unsigned char c) {
    return c < 0x80 && (std::isalnum(c) != 0 || c == '_');
  };
  if (name.size() <= kLongest && std::ranges::all_of(name, is_word) &&
      std::isdigit(static_cast<unsigned char>(name.front())) == 0) {
    return;
  }
  throw Error(
      "S006", value.place(),
      fmt::format("{:?} cannot be a variable of a .geo", name.substr(0, 80)),
      "Name it with 1 to 64 of A-Z a-z 0-9 _, not a digit first.");
}

/// Without the last digits, which a change of units leaves uncertain.
double rounded(double value) {
  return std::stod(fmt::format("{:.12g}", value));
}

double read_number(const Value& value, double length_unit) {
  if (value.node().is_number()) {
    throw value.refusal("S004", "has no unit",
                        "Write a length with its unit, e.g. \"8 mm\"; what is "
                        "no length with the unit 1, e.g. \"3 1\".");
  }
  try {
    return rounded(value.quantity(Dimension::kLength) / length_unit);
  } catch (const Error& no_length) {
    try {
      return rounded(value.quantity(Dimension::kRatio));
    } catch (const Error&) {
      throw no_length;
    }
  }
}

}  // namespace

std::vector<part::GeometryParameter> read_parameters(const Value& table,
                                                     double length_unit) {
  std::vector<part::GeometryParameter> parameters;
  for (const auto& [name, value] : table.entries()) {
    if (name.empty()) throw value.refusal("S006", "has no name", "Give one.");
    require_variable(name, value);
    parameters.push_back(
        {name, read_number(value, length_unit), value.place()});
  }
  std::ranges::sort(parameters, {}, &part::GeometryParameter::name);
  return parameters;
}

}  // namespace clevis::scene

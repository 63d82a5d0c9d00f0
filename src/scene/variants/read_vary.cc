#include "scene/variants/read_vary.h"

#include <cmath>
#include <cstdlib>
#include <sstream>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "scene/variants/key_path.h"

namespace clevis::scene {
namespace {

using Design = VaryTable::Design;

constexpr int kMostValues = 100'000;

bool is_toml(const std::string& text) {
  try {
    return toml::parse("v = " + text).size() == 1;
  } catch (const toml::parse_error&) {
    return false;
  }
}

/// Number and unit of "5 mm"; a bare number has no unit.
std::pair<double, std::string> split_number(const Value& value) {
  if (value.node().is_number()) {
    return {*value.node().value<double>(), ""};
  }
  const std::string text = value.text();
  char* end = nullptr;
  const double number = std::strtod(text.c_str(), &end);
  const std::string rest = end;
  const std::size_t unit = rest.find_first_not_of(' ');
  if (end == text.c_str() || !std::isfinite(number) || unit == rest.npos) {
    throw value.refusal(
        "S004", fmt::format("= \"{:.60}\" is no number with a unit", text),
        "Write e.g. from = \"5 mm\"; choices that are no "
        "numbers are a list, values = [...].");
  }
  return {number, rest.substr(unit)};
}

VariedRange read_range(StrictTable& table, Design design) {
  const Value from = table["from"];
  const Value to = table["to"];
  VariedRange range;
  std::tie(range.from, range.unit) = split_number(from);
  const auto [end, unit] = split_number(to);
  range.to = end;
  if (unit != range.unit) {
    throw to.refusal("S004",
                     fmt::format("has the unit \"{:.20}\", from has \"{:.20}\"",
                                 unit, range.unit),
                     "Give both ends in one unit.");
  }
  if (range.to == range.from) {
    throw to.refusal("S006", "is where the range starts",
                     "Give two ends, or leave the quantity out.");
  }
  if (design == Design::kGrid) {
    range.count = table["count"].integer(2, kMostValues);
  }
  return range;
}

std::vector<std::string> read_values(const Value& list) {
  std::vector<std::string> values;
  for (const Value& value : list.elements()) {
    values.push_back(setting_value(value.node()));
  }
  if (values.empty()) {
    throw list.refusal("S006", "has no element", "Give at least one value.");
  }
  return values;
}

VariedQuantity read_quantity(StrictTable& table, Design design) {
  VariedQuantity quantity;
  quantity.place = table.place();
  const Value path = table["path"];
  quantity.path = path.text();
  parse_path(quantity.path, path.place());
  if (const auto values = table.find("values")) {
    quantity.values = read_values(*values);
  } else {
    quantity.range = read_range(table, design);
  }
  table.finish("in a Latin hypercube, which has `samples`");
  return quantity;
}

}  // namespace

std::string setting_value(const toml::node& node) {
  std::ostringstream text;
  if (const auto* string = node.as_string()) {
    if (!is_toml(string->get())) return string->get();
    text << *string;
  } else {
    node.visit([&text](const auto& value) {
      text << value;
    });
  }
  return text.str();
}

VaryTable read_vary(StrictTable table) {
  VaryTable vary;
  vary.place = table.place();
  vary.design = table["design"].choice<Design>(
      {{"grid", Design::kGrid}, {"latin_hypercube", Design::kLatinHypercube}});
  if (vary.design == Design::kLatinHypercube) {
    vary.samples = table["samples"].integer(1, kMostValues);
    if (const auto seed = table.find("seed")) {
      constexpr int kLargest = 1'000'000'000;
      vary.seed = seed->integer(0, kLargest);
    }
  }
  for (StrictTable& entry : table.tables("quantity")) {
    vary.quantities.push_back(read_quantity(entry, vary.design));
  }
  if (vary.quantities.empty()) {
    throw table.refusal("S003", "lacks [[vary.quantity]]",
                        "Give at least one value to vary.");
  }
  table.finish("with design = \"grid\"");
  return vary;
}

}  // namespace clevis::scene

#include "scene/text/value.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include <fmt/format.h>

#include "scene/text/suggestion.h"

namespace clevis::scene {
namespace {

std::string_view type_name(const toml::node& node) {
  switch (node.type()) {
    case toml::node_type::table:
      return "a table";
    case toml::node_type::array:
      return "an array";
    case toml::node_type::string:
      return "a text";
    case toml::node_type::integer:
      return "an integer";
    case toml::node_type::floating_point:
      return "a number";
    case toml::node_type::boolean:
      return "a boolean";
    default:
      return "a date or time";
  }
}

std::string number_text(const toml::node& node) {
  if (const auto* integer = node.as_integer()) {
    return std::to_string(integer->get());
  }
  return fmt::format("{}", node.as_floating_point()->get());
}

bool is_control(char c) {
  return static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
}

}  // namespace

std::string place_of(const std::string& file, const toml::source_region& at) {
  if (at.path && *at.path != file) return *at.path;
  return fmt::format("{}:{}:{}", file, at.begin.line, at.begin.column);
}

Value::Value(const toml::node& node, std::string label, const std::string& file)
    : node_(&node), label_(std::move(label)), file_(&file) {}

Error Value::refusal(std::string_view code, std::string_view problem,
                     std::string remedy) const {
  return Error(code, place(), fmt::format("{} {}", label_, problem),
               std::move(remedy));
}

Error Value::wrong_type(std::string_view needed) const {
  return refusal("S005", fmt::format("is {}", type_name(*node_)),
                 fmt::format("Give {} here.", needed));
}

std::string Value::text() const {
  constexpr std::size_t kLongest = 4096;
  const auto* text = node_->as_string();
  if (text == nullptr) throw wrong_type("a text in double quotes");
  const std::string& content = text->get();
  if (content.empty() || content.size() > kLongest ||
      std::ranges::any_of(content, is_control)) {
    throw refusal("S006", "is empty, too long or holds control characters",
                  "Give a text of 1 to 4096 printable characters.");
  }
  return content;
}

std::string Value::title() const {
  constexpr std::size_t kLongest = 64;
  std::string title = text();
  if (title.size() > kLongest) {
    throw refusal("S006", "is longer than 64 bytes", "Give a shorter name.");
  }
  return title;
}

bool is_name(std::string_view text) {
  constexpr std::string_view kAllowed =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789._-";
  constexpr std::size_t kLongest = 64;
  return !text.empty() && text.size() <= kLongest && text[0] != '.' &&
         text[0] != '-' && text.find_first_not_of(kAllowed) == text.npos;
}

void require_name(const std::string& key, const Value& value) {
  if (is_name(key)) return;
  throw Error("S006", value.place(),
              fmt::format("{:?} cannot be a name", key.substr(0, 80)),
              "Names have 1 to 64 of the characters A-Z a-z 0-9 . _ - and "
              "start with neither . nor -, because files are named after "
              "them.");
}

std::string Value::name() const {
  const auto* text = node_->as_string();
  if (text == nullptr) throw wrong_type("a name in double quotes");
  require_name(text->get(), *this);
  return text->get();
}

double Value::number(double low, double high) const {
  if (!node_->is_number()) throw wrong_type("a number without quotes");
  const double number = *node_->value<double>();
  if (!(low <= number && number <= high)) {  // also NaN
    throw refusal("S006",
                  fmt::format("= {} is out of range", number_text(*node_)),
                  fmt::format("Give a number from {} to {}.", low, high));
  }
  return number;
}

int Value::integer(int low, int high) const {
  const auto* integer = node_->as_integer();
  if (integer == nullptr) throw wrong_type("an integer");
  if (integer->get() < low || integer->get() > high) {
    throw refusal("S006", fmt::format("= {} is out of range", integer->get()),
                  fmt::format("Give an integer from {} to {}.", low, high));
  }
  return static_cast<int>(integer->get());
}

double Value::quantity(Dimension dimension) const {
  if (node_->is_number()) {
    const std::string number = number_text(*node_);
    throw refusal("S004", fmt::format("= {} has no unit", number),
                  fmt::format("Write it as a text with one of the units {}.",
                              accepted_units(dimension)));
  }
  const auto* text = node_->as_string();
  if (text == nullptr) {
    throw wrong_type(fmt::format("a text with number and unit ({})",
                                 accepted_units(dimension)));
  }
  double value = 0.0;
  try {
    value = parse_quantity(text->get(), dimension, place());
  } catch (const Error& refused) {  // name the key, too
    throw refusal(refused.code(), "= " + refused.problem(), refused.remedy());
  }
  // Squares and products of such values must stay finite numbers.
  constexpr double kLargest = 1e30;
  if (std::abs(value) > kLargest) {
    throw refusal("S006",
                  fmt::format("= \"{:.60}\" is out of range", text->get()),
                  fmt::format("Give a value below {} in SI units.", kLargest));
  }
  return value;
}

double Value::positive(Dimension dimension) const {
  const double value = quantity(dimension);
  if (!(value > 0.0)) {
    throw refusal(
        "S006",
        fmt::format("= \"{:.60}\" is not positive", node_->as_string()->get()),
        "Give a value greater than zero.");
  }
  return value;
}

void Value::require_material(double x, double low, double high,
                             const char* range) const {
  if (low <= x && x <= high) return;
  throw refusal("S011",
                fmt::format("= \"{}\" is outside {}, the range of real "
                            "materials",
                            text(), range),
                "Check the number and its unit.");
}

double Value::elastic_modulus() const {
  constexpr double kSoftest = 1e7, kStiffest = 1.2e12;  // [Pa]
  const double modulus = positive(Dimension::kStress);
  require_material(modulus, kSoftest, kStiffest, "0.01 GPa to 1200 GPa");
  return modulus;
}

Eigen::Vector3d Value::vector(Dimension dimension) const {
  Eigen::Vector3d vector;
  Eigen::Index i = 0;
  for (const Value& element : elements(3)) {
    vector[i++] = element.quantity(dimension);
  }
  return vector;
}

Eigen::Vector3d Value::direction() const {
  constexpr double kLargest = 1e9;
  Eigen::Vector3d direction;
  Eigen::Index i = 0;
  for (const Value& element : elements(3)) {
    direction[i++] = element.number(-kLargest, kLargest);
  }
  constexpr double kSmallest = 1e-9;
  if (direction.norm() < kSmallest) {
    throw refusal("S006", "has no direction: its length is zero",
                  "Give three numbers that are not all zero.");
  }
  return direction.normalized();
}

std::vector<Value> Value::elements() const {
  const auto* array = node_->as_array();
  if (array == nullptr) throw wrong_type("an array in square brackets");
  std::vector<Value> elements;
  for (std::size_t i = 0; i < array->size(); ++i) {
    elements.emplace_back((*array)[i], fmt::format("{}[{}]", label_, i),
                          *file_);
  }
  return elements;
}

std::vector<Value> Value::elements(std::size_t count) const {
  std::vector<Value> found = elements();
  if (found.size() != count) {
    throw refusal("S005", fmt::format("has {} elements", found.size()),
                  fmt::format("Give {} elements in square brackets.", count));
  }
  return found;
}

std::vector<std::pair<std::string, Value>> Value::entries() const {
  const auto* table = node_->as_table();
  if (table == nullptr) throw wrong_type("a table");
  std::vector<std::pair<std::string, Value>> entries;
  for (const auto& [key, node] : *table) {
    entries.emplace_back(
        key.str(),
        Value(node, fmt::format("{}.{}", label_, key.str()), *file_));
  }
  const auto position = [](const auto& entry) {
    const auto& at = entry.second.node().source().begin;
    return std::tuple(at.line, at.column);
  };
  std::ranges::stable_sort(entries, {}, position);
  return entries;
}

void Value::refuse_choice(const std::string& found,
                          const std::vector<std::string_view>& choices) const {
  throw refusal("S009", fmt::format("= \"{:.60}\" is not known here", found),
                suggestion(found, choices));
}

}  // namespace clevis::scene

#include "report/page/stored_numbers.h"

#include <cstdint>
#include <cstring>

#include "base/base64.h"
#include "base/errors.h"

namespace clevis::report {
namespace {

using Eigen::Index;

[[noreturn]] void refuse(const std::string& problem) {
  throw Error("I003", "view of a result", problem, "Run `clevis check` again.");
}

template <class Number>
std::vector<double> numbers_of(const std::vector<std::byte>& bytes) {
  std::vector<Number> numbers(bytes.size() / sizeof(Number));
  std::memcpy(numbers.data(), bytes.data(), numbers.size() * sizeof(Number));
  return {numbers.begin(), numbers.end()};
}

}  // namespace

std::vector<double> stored_numbers(const JsonNode& packed) {
  const std::string type = packed.at("type").text();
  const auto bytes =
      bytes_of_base64(packed.at("base64").text(), "view of a result");
  if (type == "f32") return numbers_of<float>(bytes);
  if (type == "i8") return numbers_of<std::int8_t>(bytes);
  if (type == "i16") return numbers_of<std::int16_t>(bytes);
  if (type == "u16") return numbers_of<std::uint16_t>(bytes);
  if (type == "u32") return numbers_of<std::uint32_t>(bytes);
  refuse("numbers of type \"" + type + "\" are unknown");
}

Eigen::MatrixXd stored_field(const JsonNode& field) {
  const auto columns = field.at("columns").elements();
  const auto scale = field.at("scale").elements();
  const auto flat = stored_numbers(field.at("coefficients"));
  const auto rank = static_cast<Index>(columns.size());
  if (scale.size() != columns.size() ||
      (rank > 0 && flat.size() % columns.size() != 0)) {
    refuse("a field's columns and coefficients do not fit");
  }
  if (rank == 0) return {};
  const Eigen::Map<const Eigen::MatrixXd> coefficients(
      flat.data(), rank, static_cast<Index>(flat.size()) / rank);
  Eigen::MatrixXd values;
  for (Index k = 0; k < rank; ++k) {
    const auto at = static_cast<std::size_t>(k);
    const auto column = stored_numbers(columns[at]);
    const Eigen::Map<const Eigen::VectorXd> shape(
        column.data(), static_cast<Index>(column.size()));
    if (k == 0) values.setZero(shape.size(), coefficients.cols());
    if (shape.size() != values.rows()) refuse("columns differ in length");
    values += scale[at].number() * shape * coefficients.row(k);
  }
  return values;
}

}  // namespace clevis::report

#include "report/stored/stored_numbers.h"

#include <cstring>

#include "base/bytes/base64.h"
#include "base/messages/errors.h"

namespace clevis::report {
namespace {

using Eigen::Index;

template <class Number>
std::vector<double> numbers_of(const std::vector<std::byte>& bytes) {
  std::vector<Number> numbers(bytes.size() / sizeof(Number));
  std::memcpy(numbers.data(), bytes.data(), numbers.size() * sizeof(Number));
  return {numbers.begin(), numbers.end()};
}

}  // namespace

void refuse_view(const std::string& problem) {
  throw Error("I003", "view of a result", problem, "Run `clevis check` again.");
}

std::vector<double> stored_numbers(const JsonNode& packed) {
  const auto bytes =
      bytes_of_base64(packed.at("base64").text(), "view of a result");
  return with_stored_type(packed, [&](auto number) {
    return numbers_of<decltype(number)>(bytes);
  });
}

Eigen::MatrixXd stored_field(const JsonNode& field) {
  const auto columns = field.at("columns").elements();
  const auto scale = field.at("scale").elements();
  const auto flat = stored_numbers(field.at("coefficients"));
  const auto rank = static_cast<Index>(columns.size());
  if (scale.size() != columns.size() ||
      (rank > 0 && flat.size() % columns.size() != 0)) {
    refuse_view("a field's columns and coefficients do not fit");
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
    if (shape.size() != values.rows()) refuse_view("columns differ in length");
    values += scale[at].number() * shape * coefficients.row(k);
  }
  return values;
}

std::vector<double> stored_points(const JsonNode& part) {
  const JsonNode positions = part.at("positions_mm");
  const auto integers = stored_numbers(positions.at("integers"));
  const double scale = positions.at("scale").number();
  const auto origin = positions.at("origin").numbers<3>();
  const std::size_t places = integers.size() / 3;
  std::vector<double> points;
  for (const double place : stored_numbers(part.at("point_places"))) {
    if (!(place >= 0.0 && place < static_cast<double>(places))) {
      refuse_view("a point has no such place");
    }
    for (std::size_t d = 0; d < 3; ++d) {
      points.push_back(
          origin[d] +
          scale * integers[static_cast<std::size_t>(place) + d * places]);
    }
  }
  return points;
}

}  // namespace clevis::report

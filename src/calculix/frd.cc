#include "calculix/frd.h"

#include <charconv>
#include <cmath>
#include <limits>
#include <string_view>

#include <fmt/format.h>

#include "base/messages/errors.h"

namespace clevis::calculix {
namespace {

constexpr double kMetres = 1e-3;  // per millimetre
constexpr double kPascals = 1e6;  // per megapascal

[[noreturn]] void refuse(const std::string& place, const std::string& problem) {
  throw Error("I004", place, problem,
              "See the messages of ccx; run the deck by hand.");
}

/// A number in a field of fixed width; CalculiX pads with blanks.
template <class Number>
Number field(std::string_view line, std::size_t begin, std::size_t width,
             const std::string& place) {
  std::string_view text =
      begin < line.size() ? line.substr(begin, width) : std::string_view();
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  Number value{};
  const auto [end, error] =
      std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) {
    refuse(place, fmt::format("\"{}\" is no number", text));
  }
  return value;
}

/// The lines of a result block, " -1" + node (10) + components (12 each), up
/// to " -3".
Eigen::MatrixXd read_block(std::istream& in, int components, int nodes,
                           const std::string& place) {
  constexpr std::size_t kNode = 3, kNodeWidth = 10, kFirst = 13, kWidth = 12;
  Eigen::MatrixXd values = Eigen::MatrixXd::Constant(
      components, nodes, std::numeric_limits<double>::quiet_NaN());
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with(" -3")) {
      if (!values.allFinite()) refuse(place, "a node has no finite value");
      return values;
    }
    if (!line.starts_with(" -1")) continue;
    const int node = field<int>(line, kNode, kNodeWidth, place) - 1;
    if (node < 0 || node >= nodes) {
      refuse(place, fmt::format("node {} is not in the deck", node + 1));
    }
    for (int k = 0; k < components; ++k) {
      values(k, node) = field<double>(
          line, kFirst + kWidth * static_cast<std::size_t>(k), kWidth, place);
    }
  }
  refuse(place, "the file ends inside a block");
}

}  // namespace

std::vector<StepResult> read_frd(std::istream& in, int nodes,
                                 const std::string& place) {
  std::vector<StepResult> steps;
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with(" -4  DISP")) {
      steps.emplace_back();
      steps.back().displacement = kMetres * read_block(in, 3, nodes, place);
    } else if (line.starts_with(" -4  STRESS")) {
      if (steps.empty()) refuse(place, "stresses stand before displacements");
      steps.back().stress = kPascals * read_block(in, 6, nodes, place);
    }
  }
  for (const StepResult& step : steps) {
    if (step.stress.cols() != nodes) refuse(place, "a step has no stresses");
  }
  if (steps.empty()) refuse(place, "the file holds no displacements");
  return steps;
}

}  // namespace clevis::calculix

#include "calculix/deck.h"

#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "unit/calculix/cube.h"

namespace clevis::calculix {
namespace {

std::vector<std::string> lines_of(const Model& model) {
  std::ostringstream out;
  write_deck(out, model);
  std::istringstream in(out.str());
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

std::size_t count(const std::vector<std::string>& lines,
                  const std::string& text) {
  std::size_t found = 0;
  for (const auto& line : lines) found += line.find(text) != std::string::npos;
  return found;
}

/// Lines from behind the one that starts with `keyword` to the next keyword.
std::vector<std::string> section(const std::vector<std::string>& lines,
                                 const std::string& keyword) {
  std::vector<std::string> result;
  bool inside = false;
  for (const auto& line : lines) {
    if (line.starts_with("*")) {
      inside = line.starts_with(keyword);
    } else if (inside) {
      result.push_back(line);
    }
  }
  return result;
}

TEST(CalculixDeck, HoldsNodesElementsSetsAndAStepPerInstant) {
  Model model = pressed_cube(2, 1e6, Hexahedron::kReduced);
  model.loads.conservativeResize(Eigen::NoChange, 2);
  model.loads.col(1) = -model.loads.col(0);
  model.labels = {"push", "pull"};
  const auto lines = lines_of(model);
  EXPECT_EQ(section(lines, "*NODE, NSET=NALL").size(), 81U);
  EXPECT_EQ(section(lines, "*ELEMENT, TYPE=C3D20R").size(), 2U * 8U);
  EXPECT_EQ(count(lines, "*NSET, NSET=N_X1"), 1U);
  EXPECT_EQ(count(lines, "*SURFACE, NAME=S_X1, TYPE=ELEMENT"), 1U);
  EXPECT_EQ(count(lines, "*STEP"), 2U);
  EXPECT_EQ(count(lines, "*END STEP"), 2U);
  EXPECT_EQ(count(lines, "*CLOAD, OP=NEW"), 2U);
  EXPECT_EQ(count(lines, "** pull"), 1U);
}

TEST(CalculixDeck, UnitsAreMillimetresNewtonsAndTonnes) {
  const auto lines = lines_of(pressed_cube(1, 1e6));
  EXPECT_EQ(section(lines, "*ELASTIC").at(0), "210000, 0.3");
  EXPECT_EQ(section(lines, "*DENSITY").at(0), "7.85e-09");
  double sum = 0.0;
  for (const auto& line : section(lines, "*CLOAD")) {
    sum += std::stod(line.substr(line.rfind(',') + 1));
  }
  EXPECT_NEAR(sum, -1e6, 1e-3);  // 1 MPa on 1 m², in N
  double farthest = 0.0;
  for (const auto& line : section(lines, "*NODE, NSET=NALL")) {
    farthest = std::max(farthest, std::stod(line.substr(line.rfind(',') + 1)));
  }
  EXPECT_EQ(farthest, 1000.0);
}

// CalculiX reads 20 characters of a number and 16 numbers of a line.
TEST(CalculixDeck, KeepsToCalculixsFieldsAndLines) {
  Model model = pressed_cube(2, 1e6 / 3.0);
  model.nodes *= 1.0 / 7.0e3;
  for (const auto& line : lines_of(model)) {
    if (line.starts_with("*")) continue;
    std::istringstream fields(line);
    std::size_t numbers = 0;
    for (std::string field; std::getline(fields, field, ','); ++numbers) {
      if (line.starts_with("cube")) continue;
      EXPECT_LE(field.size() - (field.starts_with(" ") ? 1U : 0U), 20U) << line;
    }
    EXPECT_LE(numbers, 16U) << line;
  }
}

TEST(CalculixDeck, NamesOfGroupsAreCleanAndUnique) {
  Model model = pressed_cube(1, 1e6);
  model.groups[0].name = "end face, left";
  model.groups[1].name = "end_face__LEFT";
  model.labels[0] = "push\n*STEP";
  const auto lines = lines_of(model);
  EXPECT_EQ(count(lines, "NSET=N_END_FACE__LEFT"), 2U);
  EXPECT_EQ(count(lines, "NSET=N_END_FACE__LEFT_2"), 1U);
  EXPECT_EQ(section(lines, "*STEP").size(), 0U);
  std::size_t steps = 0;
  for (const auto& line : lines) steps += line.starts_with("*STEP");
  EXPECT_EQ(steps, 1U);
}

}  // namespace
}  // namespace clevis::calculix

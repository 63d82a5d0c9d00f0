#include "stress/output/field_output.h"

#include <regex>
#include <string>

#include <gtest/gtest.h>

#include "elasticity/fe_space/tabulation.h"
#include "elasticity/solid/solid_solve.h"
#include "support/eye_problem.h"

namespace clevis::stress {
namespace {

constexpr int kSubdivisions = 2;

struct Sample {
  InstantField field;
  int cells{};
};

Sample sample() {
  const auto eye = support::eye_problem(1);
  const auto basis = elasticity::solve<3>(eye.problem(), 2);
  return {instant_field<3>(basis, eye.material, kSubdivisions, 0),
          basis.discretization.cells()};
}

std::string vtu(const InstantField& field, CellOrder order,
                const part::Pose& pose = {},
                mesh::CellShape shape = mesh::CellShape::kTensor) {
  ScalarField worst{"worst_von_mises", "Pa", {}};
  worst.values = Eigen::MatrixXd::Ones(
      field.points[0].rows(), static_cast<Eigen::Index>(field.points.size()));
  std::string text;
  FieldOutput(3, shape, field, {worst}, pose)
      .write(order, [&](std::string_view piece) {
        text += piece;
      });
  return text;
}

int number(const std::string& text, const std::string& attribute) {
  std::smatch match;
  if (!std::regex_search(text, match, std::regex(attribute + "=\"(\\d+)\""))) {
    return -1;
  }
  return std::stoi(match[1]);
}

/// Every opened tag is closed in order.
bool is_well_formed(const std::string& text) {
  std::vector<std::string> open;
  const std::regex tag("<(/?)([A-Za-z]+)[^>]*?(/?)>");
  for (std::sregex_iterator it(text.begin(), text.end(), tag), end; it != end;
       ++it) {
    if ((*it)[1].length() > 0) {
      if (open.empty() || open.back() != (*it)[2]) return false;
      open.pop_back();
    } else if ((*it)[3].length() == 0) {
      open.push_back((*it)[2]);
    }
  }
  return open.empty();
}

TEST(FieldOutput, CellsAndPointsOfBothOrders) {
  const Sample s = sample();
  const int points = s.cells * 27;
  const std::string lagrange = vtu(s.field, CellOrder::kLagrange);
  const std::string linear = vtu(s.field, CellOrder::kLinear);
  EXPECT_TRUE(is_well_formed(lagrange));
  EXPECT_TRUE(is_well_formed(linear));
  EXPECT_EQ(number(lagrange, "NumberOfCells"), s.cells);
  EXPECT_EQ(number(lagrange, "NumberOfPoints"), points);
  EXPECT_EQ(number(linear, "NumberOfCells"), s.cells * 8);
  EXPECT_EQ(number(linear, "NumberOfPoints"), points);
}

TEST(FieldOutput, ArraysCarryNamesAndUnits) {
  const std::string text = vtu(sample().field, CellOrder::kLinear);
  for (const char* name :
       {"displacement", "stress_xx", "stress_yy", "stress_zz", "stress_xy",
        "stress_yz", "stress_xz", "von_mises", "worst_von_mises"}) {
    const std::regex array(std::string("<DataArray[^>]*Name=\"") + name +
                           "\"[^>]*units=\"(m|Pa)\"");
    std::smatch match;
    ASSERT_TRUE(std::regex_search(text, match, array)) << name;
    EXPECT_EQ(match[1], std::string(name) == "displacement" ? "m" : "Pa");
  }
}

TEST(FieldOutput, TetrahedraHaveOffsetsAndTypesInBothOrders) {
  InstantField field;
  field.subdivisions = 1;
  field.points = {Eigen::MatrixXd{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  field.displacement = {Eigen::MatrixXd::Zero(4, 3)};
  field.stress = {Eigen::MatrixXd::Ones(4, 6)};
  for (const CellOrder order : {CellOrder::kLagrange, CellOrder::kLinear}) {
    const std::string text = vtu(field, order, {}, mesh::CellShape::kSimplex);
    for (const char* name : {"connectivity", "offsets", "types"}) {
      const std::regex filled(std::string("Name=\"") + name +
                              "\"[^>]*>\\s*[A-Za-z0-9+/]");
      EXPECT_TRUE(std::regex_search(text, filled)) << name;
    }
  }
}

TEST(FieldOutput, ATetrahedronIsWrittenInItsParts) {
  const auto lattice = elasticity::lattice<3>(mesh::CellShape::kSimplex, 4);
  InstantField field;
  field.subdivisions = 4;
  field.points = {lattice.transpose()};
  field.displacement = {Eigen::MatrixXd::Zero(lattice.cols(), 3)};
  field.stress = {Eigen::MatrixXd::Ones(lattice.cols(), 6)};
  const std::string text =
      vtu(field, CellOrder::kLinear, {}, mesh::CellShape::kSimplex);
  EXPECT_NE(text.find("NumberOfCells=\"64\""), std::string::npos);
}

TEST(FieldOutput, SameBytesTwice) {
  const Sample s = sample();
  EXPECT_EQ(vtu(s.field, CellOrder::kLagrange),
            vtu(s.field, CellOrder::kLagrange));
  part::Pose pose;
  pose.p_WL.x() = 1.0;
  EXPECT_NE(vtu(s.field, CellOrder::kLagrange, pose),
            vtu(s.field, CellOrder::kLagrange));
}

}  // namespace
}  // namespace clevis::stress

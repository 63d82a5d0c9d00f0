#include <cmath>
#include <string>
#include <vector>

#include "band_catalogue.h"
#include "support/fillet_mesh.h"

namespace clevis::support {
namespace {

using Eigen::Vector2d;

/// Peak of a problem on a much finer mesh.
void add_with_reference(BandProblem<2> problem, const mesh::PartMesh<2>& fine,
                        std::vector<BandCase>& all) {
  constexpr int kDegree = 5;
  BandProblem<2> reference = problem;
  reference.mesh = fine;
  problem.peak = solved_peak<2>(reference, kDegree);
  problem.uncertainty =
      std::abs(problem.peak - solved_peak<2>(reference, kDegree - 1));
  add_cases<2>(problem, all);
}

/// An L whose legs are pulled apart: their ends take tractions in balance.
void add_fillets(std::vector<BandCase>& all) {
  for (const double ratio : {0.1, 0.3, 0.6}) {
    const Fillet shape{
        .radius = ratio * 0.01, .thickness = 1.0, .grading = 1.5};
    Fillet fine = shape;
    fine.along *= 3;
    fine.around *= 3;
    fine.across *= 3;
    BandProblem<2> problem;
    problem.problem = "fillet r/t = " + std::to_string(ratio);
    problem.variant = "quads";
    problem.mesh = fillet_mesh(shape);
    // Bending of both legs: linear in the way across, no force.
    const double middle = -0.5 * shape.width;
    const auto bend_x = [=](const Vector2d& x, const Vector2d&) {
      return Vector2d(1e6 * (x.y() - middle) / shape.width, 0.0);
    };
    const auto bend_y = [=](const Vector2d& x, const Vector2d&) {
      return Vector2d(0.0, 1e6 * (x.x() - middle) / shape.width);
    };
    problem.tractions = {{"x0", bend_x}, {"x1", bend_y}};
    add_with_reference(problem, fillet_mesh(fine), all);
  }
}

}  // namespace

std::vector<BandCase> converged_cases() {
  std::vector<BandCase> all;
  add_fillets(all);
  return all;
}

}  // namespace clevis::support

#include "stress/surface/surface_deviation.h"

#include <array>
#include <map>

#include <Eigen/LU>

#include "elasticity/fe_space/discretization.h"
#include "elasticity/fe_space/tabulation.h"
#include "stress/surface/surface_edge.h"

namespace clevis::stress {
namespace {

/// Areas of the boundary's faces [m²].
std::vector<double> face_areas(const mesh::PartMesh<3>& mesh) {
  constexpr int kGauss = 2;
  struct Reference {
    elasticity::FaceQuadrature<3> gauss;
    elasticity::CellInterpolation<3> geometry;
  };
  std::map<int, Reference> known;  // by the face's place in its cell
  std::vector<double> areas;
  for (const mesh::BoundaryFace& face : mesh.boundary) {
    const auto [at, is_new] = known.try_emplace(face.face);
    auto& [gauss, geometry] = at->second;
    if (is_new) {
      gauss = elasticity::face_gauss<3>(mesh.shape, face.face, kGauss);
      geometry = elasticity::CellInterpolation<3>(mesh.shape, mesh.degree,
                                                  gauss.points);
    }
    const auto cell = elasticity::cell_geometry<3>(
        mesh.cell_points[static_cast<std::size_t>(face.cell)], geometry);
    double area = 0.0;
    for (Eigen::Index q = 0; q < gauss.weights.size(); ++q) {
      area += gauss.weights[q] * cell.determinant[q] *
              (cell.inverse_jacobian[static_cast<std::size_t>(q)].transpose() *
               gauss.outward)
                  .norm();
    }
    areas.push_back(area);
  }
  return areas;
}

/// Mean of what stands at the smooth edges of a face: at edges of the part, as
/// cuts of symmetry, the surface bends as at those that are opposite.
struct EdgeMean {
  double sum = 0.0;
  int count = 0;

  void add(double value) {
    sum += value;
    ++count;
  }
  double mean() const { return count > 0 ? sum / count : 0.0; }
};

/// Reference direction along an edge of a tensor cell: opposite edges have the
/// same.
std::size_t direction(const EdgeSide& side) {
  Eigen::Index axis = 0;
  (side.points.col(kEdgeIntervals) - side.points.col(0))
      .cwiseAbs()
      .maxCoeff(&axis);
  return static_cast<std::size_t>(axis);
}

}  // namespace

std::vector<double> surface_deviation(const mesh::PartMesh<3>& mesh) {
  const bool is_simplex = mesh.shape == mesh::CellShape::kSimplex;
  // θ h/12 or θ h/60 of a quadrangle's two opposite edges; of a triangle's
  // three, h its heights, θ h/4 or a fifth of that, as on a sphere.
  const double share =
      (is_simplex ? 3.0 : 1.0) / (mesh.degree == 1 ? 12.0 : 60.0);
  const double widths = is_simplex ? 2.0 : 1.0;
  const std::vector<double> areas = face_areas(mesh);
  std::vector<std::array<EdgeMean, 3>> of_faces(mesh.boundary.size());
  const std::vector<char> all(mesh.vertices.size(), 1);
  for (const SurfaceEdge& edge : smooth_edges(mesh, all)) {
    for (const EdgeSide* side : {&edge.one, &edge.other}) {
      const auto face = static_cast<std::size_t>(side->face);
      const double width = widths * areas[face] / side->length;
      of_faces[face][is_simplex ? 0 : direction(*side)].add(edge.kink.mean() *
                                                            width);
    }
  }
  std::vector<double> deviation;
  for (const auto& means : of_faces) {
    deviation.push_back(share *
                        (means[0].mean() + means[1].mean() + means[2].mean()));
  }
  return deviation;
}

double energy_between(const mesh::PartMesh<3>& mesh,
                      const std::vector<double>& deviation,
                      const Eigen::MatrixXd& stress) {
  constexpr int kGauss = 2;
  const Eigen::VectorXd density = stress.colwise().squaredNorm();
  const auto gauss = elasticity::gauss<3>(mesh.shape, kGauss);
  const elasticity::CellInterpolation<3> geometry(mesh.shape, mesh.degree,
                                                  gauss.points);
  double whole = 0.0;
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    const auto cell =
        elasticity::cell_geometry<3>(mesh.cell_points[c], geometry);
    whole += density[static_cast<Eigen::Index>(c)] *
             gauss.weights.dot(cell.determinant);
  }
  const std::vector<double> areas = face_areas(mesh);
  double between = 0.0;
  for (std::size_t f = 0; f < deviation.size(); ++f) {
    between += deviation[f] * areas[f] * density[mesh.boundary[f].cell];
  }
  return whole > 0.0 ? between / whole : 0.0;
}

}  // namespace clevis::stress

#include "stress/field/field_output.h"

#include <array>
#include <tuple>

#include <deal.II/base/data_out_base.h>

#include "mesh/basis/simplex_basis.h"

namespace clevis::stress {
namespace {

using dealii::DataOutBase::Patch;
using Eigen::Index;

constexpr unsigned kDisplacement = 3;
constexpr unsigned kFixedArrays = 10;  // displacement, six stresses, von Mises
constexpr std::array<const char*, kFixedArrays> kNames = {
    "displacement", "displacement", "displacement", "stress_xx", "stress_yy",
    "stress_zz",    "stress_xy",    "stress_yz",    "stress_xz", "von_mises"};

/// Lattice points of a patch, and which of them are its corners in deal.II's
/// vertex order.
struct PatchShape {
  std::vector<Index> points, corners;
};

/// A tensor cell is one patch. deal.II 9.4 leaves offsets and types of
/// subdivided simplices empty, so each of a simplex's parts is a patch.
template <int dim>
std::vector<PatchShape> patch_shapes(mesh::CellShape shape, int subdivisions) {
  std::vector<PatchShape> shapes;
  if (shape == mesh::CellShape::kSimplex) {
    for (const auto& part : mesh::simplex_parts<dim>(subdivisions)) {
      PatchShape& patch = shapes.emplace_back();
      patch.points.assign(part.begin(), part.end());
      for (Index v = 0; v <= dim; ++v) patch.corners.push_back(v);
    }
    return shapes;
  }
  const Index n = subdivisions + 1;
  PatchShape& patch = shapes.emplace_back();
  Index stride = 1;
  patch.corners.assign(1, 0);
  for (unsigned d = 0; d < dim; ++d, stride *= n) {
    const auto so_far = patch.corners;
    for (const Index corner : so_far) {
      patch.corners.push_back(corner + (n - 1) * stride);
    }
  }
  for (Index q = 0; q < stride; ++q) patch.points.push_back(q);
  return shapes;
}

/// All that is written of a cell's lattice points: displacement, stresses,
/// von Mises, scalars, position; points × arrays.
Eigen::MatrixXd cell_data(const InstantField& field, std::size_t cell,
                          const std::vector<ScalarField>& scalars,
                          const part::Pose& pose) {
  const auto n_scalars = static_cast<Index>(scalars.size());
  Eigen::MatrixXd data(field.points[cell].rows(), kFixedArrays + n_scalars + 3);
  data.leftCols<kDisplacement>() =
      field.displacement[cell] * pose.R_WL.transpose();
  data.middleCols<6>(kDisplacement) = field.stress[cell];
  data.col(kFixedArrays - 1) = von_mises(field.stress[cell]);
  for (Index s = 0; s < n_scalars; ++s) {
    data.col(kFixedArrays + s) =
        scalars[static_cast<std::size_t>(s)].values.col(
            static_cast<Index>(cell));
  }
  data.rightCols<3>() = (field.points[cell] * pose.R_WL.transpose()).rowwise() +
                        pose.p_WL.transpose();
  return data;
}

template <int dim>
Patch<dim, 3> make_patch(const Eigen::MatrixXd& cell, const PatchShape& shape,
                         mesh::CellShape cell_shape, int subdivisions) {
  const bool simplex = cell_shape == mesh::CellShape::kSimplex;
  Patch<dim, 3> patch;
  patch.n_subdivisions = simplex ? 1 : static_cast<unsigned>(subdivisions);
  patch.points_are_available = true;
  patch.reference_cell = simplex ? dealii::ReferenceCells::get_simplex<dim>()
                                 : dealii::ReferenceCells::get_hypercube<dim>();
  for (unsigned v = 0; v < shape.corners.size(); ++v) {
    const Index at = shape.points[static_cast<std::size_t>(shape.corners[v])];
    for (unsigned d = 0; d < 3; ++d) {
      patch.vertices[v][d] = cell(at, cell.cols() - 3 + d);
    }
  }
  patch.data.reinit(static_cast<unsigned>(cell.cols()),
                    static_cast<unsigned>(shape.points.size()));
  for (unsigned q = 0; q < shape.points.size(); ++q) {
    for (unsigned row = 0; row < cell.cols(); ++row) {
      patch.data(row, q) = static_cast<float>(cell(shape.points[q], row));
    }
  }
  return patch;
}

dealii::DataOutBase::VtkFlags flags(mesh::CellShape shape,
                                    const std::vector<ScalarField>& scalars,
                                    CellOrder order) {
  dealii::DataOutBase::VtkFlags result;
  result.print_date_and_time = false;
  result.compression_level =
      dealii::DataOutBase::VtkFlags::ZlibCompressionLevel::best_speed;
  // deal.II 9.4 leaves offsets and types of higher-order simplices empty.
  result.write_higher_order_cells =
      order == CellOrder::kLagrange && shape == mesh::CellShape::kTensor;
  result.physical_units.emplace("displacement", "m");
  for (unsigned k = kDisplacement; k < kFixedArrays; ++k) {
    result.physical_units.emplace(kNames[k], "Pa");
  }
  for (const auto& scalar : scalars) {
    result.physical_units.emplace(scalar.name, scalar.unit);
  }
  return result;
}

}  // namespace

template <int dim>
void write_vtu(std::ostream& out, mesh::CellShape shape,
               const InstantField& field,
               const std::vector<ScalarField>& scalars, CellOrder order,
               const part::Pose& pose) {
  const auto shapes = patch_shapes<dim>(shape, field.subdivisions);
  std::vector<Patch<dim, 3>> patches;
  patches.reserve(field.points.size() * shapes.size());
  for (std::size_t c = 0; c < field.points.size(); ++c) {
    const Eigen::MatrixXd data = cell_data(field, c, scalars, pose);
    for (const PatchShape& part : shapes) {
      patches.push_back(make_patch<dim>(data, part, shape, field.subdivisions));
      patches.back().patch_index = static_cast<unsigned>(patches.size() - 1);
    }
  }
  std::vector<std::string> names(kNames.begin(), kNames.end());
  for (const auto& scalar : scalars) names.push_back(scalar.name);
  using dealii::DataComponentInterpretation::component_is_part_of_vector;
  const std::vector<std::tuple<
      unsigned, unsigned, std::string,
      dealii::DataComponentInterpretation::DataComponentInterpretation>>
      vectors = {
          {0U, kDisplacement - 1, "displacement", component_is_part_of_vector}};
  dealii::DataOutBase::write_vtu(patches, names, vectors,
                                 flags(shape, scalars, order), out);
}

template void write_vtu<2>(std::ostream&, mesh::CellShape, const InstantField&,
                           const std::vector<ScalarField>&, CellOrder,
                           const part::Pose&);
template void write_vtu<3>(std::ostream&, mesh::CellShape, const InstantField&,
                           const std::vector<ScalarField>&, CellOrder,
                           const part::Pose&);

}  // namespace clevis::stress

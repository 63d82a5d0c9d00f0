#include "stress/field_output.h"

#include <array>
#include <cassert>
#include <tuple>

#include <deal.II/base/data_out_base.h>

namespace clevis::stress {
namespace {

using dealii::DataOutBase::Patch;
using Eigen::Index;

constexpr unsigned kDisplacement = 3;
constexpr unsigned kFixedArrays = 10;  // displacement, six stresses, von Mises
constexpr std::array<const char*, kFixedArrays> kNames = {
    "displacement", "displacement", "displacement", "stress_xx", "stress_yy",
    "stress_zz",    "stress_xy",    "stress_yz",    "stress_xz", "von_mises"};

/// Lattice indices of a cell's corners, in deal.II's vertex order.
template <int dim>
std::vector<Index> corners(mesh::CellShape shape, int subdivisions) {
  if (shape == mesh::CellShape::kSimplex) {
    assert(subdivisions == 1 && "a simplex is written with its corners");
    return dim == 2 ? std::vector<Index>{0, 1, 2}
                    : std::vector<Index>{0, 1, 2, 3};
  }
  const Index n = subdivisions + 1;
  std::vector<Index> result;
  for (unsigned v = 0; v < (1U << dim); ++v) {
    Index index = 0;
    Index stride = 1;
    for (unsigned d = 0; d < dim; ++d, stride *= n) {
      if (((v >> d) & 1U) != 0) index += (n - 1) * stride;
    }
    result.push_back(index);
  }
  return result;
}

template <int dim>
Patch<dim, 3> make_patch(const InstantField& field, std::size_t cell,
                         const std::vector<ScalarField>& scalars,
                         const std::vector<Index>& corner,
                         mesh::CellShape shape, const Placement& placement) {
  const Eigen::MatrixXd points =
      (field.points[cell] * placement.rotation.transpose()).rowwise() +
      placement.origin.transpose();
  const Eigen::MatrixXd displacement =
      field.displacement[cell] * placement.rotation.transpose();
  const Eigen::VectorXd equivalent = von_mises(field.stress[cell]);
  const auto n = static_cast<unsigned>(points.rows());
  const auto n_scalars = static_cast<unsigned>(scalars.size());
  Patch<dim, 3> patch;
  patch.patch_index = static_cast<unsigned>(cell);
  patch.n_subdivisions = static_cast<unsigned>(field.subdivisions);
  patch.points_are_available = true;
  patch.reference_cell = shape == mesh::CellShape::kSimplex
                             ? dealii::ReferenceCells::get_simplex<dim>()
                             : dealii::ReferenceCells::get_hypercube<dim>();
  for (unsigned v = 0; v < corner.size(); ++v) {
    for (unsigned d = 0; d < 3; ++d) {
      patch.vertices[v][d] = points(corner[v], d);
    }
  }
  patch.data.reinit(kFixedArrays + n_scalars + 3, n);
  const auto set = [&](unsigned row, unsigned q, double value) {
    patch.data(row, q) = static_cast<float>(value);
  };
  for (unsigned q = 0; q < n; ++q) {
    for (unsigned d = 0; d < 3; ++d) set(d, q, displacement(q, d));
    for (unsigned k = 0; k < 6; ++k) {
      set(kDisplacement + k, q, field.stress[cell](q, k));
    }
    set(kFixedArrays - 1, q, equivalent[q]);
    for (unsigned s = 0; s < n_scalars; ++s) {
      set(kFixedArrays + s, q, scalars[s].values(q, static_cast<Index>(cell)));
    }
    for (unsigned d = 0; d < 3; ++d) {
      set(kFixedArrays + n_scalars + d, q, points(q, d));
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
               const Placement& placement) {
  const auto corner = corners<dim>(shape, field.subdivisions);
  std::vector<Patch<dim, 3>> patches;
  patches.reserve(field.points.size());
  for (std::size_t c = 0; c < field.points.size(); ++c) {
    patches.push_back(
        make_patch<dim>(field, c, scalars, corner, shape, placement));
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
                           const Placement&);
template void write_vtu<3>(std::ostream&, mesh::CellShape, const InstantField&,
                           const std::vector<ScalarField>&, CellOrder,
                           const Placement&);

}  // namespace clevis::stress

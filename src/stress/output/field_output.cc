#include "stress/output/field_output.h"

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <future>
#include <string_view>
#include <system_error>

#include <fmt/format.h>

#include "stress/output/vtk_cells.h"
#include "stress/output/vtu_array.h"

namespace clevis::stress {
namespace {

using Eigen::Index;

constexpr std::array<std::string_view, 6> kStresses = {
    "stress_xx", "stress_yy", "stress_zz",
    "stress_xy", "stress_yz", "stress_xz"};

std::string named(std::string_view name, std::string_view unit) {
  return fmt::format("Name=\"{}\" units=\"{}\"", name, unit);
}

/// An array of all points, cell after cell.
/// @param of_cell  points × components of a cell.
template <class OfCell>
std::string array_of(std::size_t cells, const std::string& attributes,
                     const OfCell& of_cell) {
  std::vector<float> values;
  for (std::size_t c = 0; c < cells; ++c) {
    const Eigen::MatrixXf here = of_cell(c).template cast<float>();
    if (c == 0) values.reserve(cells * static_cast<std::size_t>(here.size()));
    for (Index q = 0; q < here.rows(); ++q) {
      for (Index a = 0; a < here.cols(); ++a) values.push_back(here(q, a));
    }
  }
  return vtu_array(values, attributes);
}

/// Of tasks, in their order; made by two threads, for packing is most of it.
std::vector<std::string> texts_of(
    const std::vector<std::function<std::string()>>& tasks) {
  std::vector<std::string> texts(tasks.size());
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    for (std::size_t i = next++; i < tasks.size(); i = next++) {
      texts[i] = tasks[i]();
    }
  };
  std::future<void> other;
  try {
    other = std::async(std::launch::async, work);
  } catch (const std::system_error&) {  // no more threads: by one
  }
  work();
  if (other.valid()) other.get();
  return texts;
}

std::vector<std::string> values_of(const InstantField& field,
                                   const std::vector<ScalarField>& scalars,
                                   const part::Pose& pose) {
  const std::size_t cells = field.points.size();
  std::vector<std::function<std::string()>> arrays;
  arrays.emplace_back([&, cells] {
    return array_of(cells,
                    "NumberOfComponents=\"3\" " + named("displacement", "m"),
                    [&](std::size_t c) -> Eigen::MatrixXd {
                      return field.displacement[c] * pose.R_WL.transpose();
                    });
  });
  for (std::size_t k = 0; k < kStresses.size(); ++k) {
    arrays.emplace_back([&, cells, k] {
      return array_of(cells, named(kStresses[k], "Pa"), [&](std::size_t c) {
        return field.stress[c].col(static_cast<Index>(k));
      });
    });
  }
  arrays.emplace_back([&, cells] {
    return array_of(cells, named("von_mises", "Pa"), [&](std::size_t c) {
      return von_mises(field.stress[c]);
    });
  });
  for (const ScalarField& scalar : scalars) {
    arrays.emplace_back([&, cells] {
      return array_of(cells, named(scalar.name, scalar.unit),
                      [&](std::size_t c) {
                        return scalar.values.col(static_cast<Index>(c));
                      });
    });
  }
  return texts_of(arrays);
}

VtkCells cells_of(int dim, mesh::CellShape shape, int subdivisions,
                  CellOrder order) {
  // Of simplices the linear ones serve for both.
  if (order == CellOrder::kLagrange && shape == mesh::CellShape::kTensor) {
    return dim == 2 ? lagrange_cell<2>(subdivisions)
                    : lagrange_cell<3>(subdivisions);
  }
  return dim == 2 ? linear_cells<2>(shape, subdivisions)
                  : linear_cells<3>(shape, subdivisions);
}

/// What each of `cells` cells of the mesh is in VTK.
std::string topology(const VtkCells& vtk, int cells, int points_of_a_cell) {
  std::vector<std::int32_t> connectivity, offsets;
  for (int c = 0; c < cells; ++c) {
    for (const auto& points : vtk.points) {
      for (const int point : points) {
        connectivity.push_back(c * points_of_a_cell + point);
      }
      offsets.push_back(static_cast<std::int32_t>(connectivity.size()));
    }
  }
  return vtu_array(connectivity, "Name=\"connectivity\"") +
         vtu_array(offsets, "Name=\"offsets\"") +
         vtu_array(std::vector<std::uint8_t>(offsets.size(), vtk.type),
                   "Name=\"types\"");
}

}  // namespace

FieldOutput::FieldOutput(int dim, mesh::CellShape shape,
                         const InstantField& field,
                         const std::vector<ScalarField>& scalars,
                         const part::Pose& pose)
    : dim_(dim),
      shape_(shape),
      subdivisions_(field.subdivisions),
      cells_(static_cast<int>(field.points.size())),
      points_of_a_cell_(static_cast<int>(field.points.front().rows())),
      points_(array_of(
          field.points.size(), "NumberOfComponents=\"3\"",
          [&](std::size_t c) -> Eigen::MatrixXd {
            return (field.points[c] * pose.R_WL.transpose()).rowwise() +
                   pose.p_WL.transpose();
          })),
      values_(values_of(field, scalars, pose)) {}

void FieldOutput::write(
    CellOrder order, const std::function<void(std::string_view)>& sink) const {
  const VtkCells vtk = cells_of(dim_, shape_, subdivisions_, order);
  sink(
      fmt::format("<?xml version=\"1.0\"?>\n"
                  "<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" "
                  "compressor=\"vtkZLibDataCompressor\" "
                  "byte_order=\"LittleEndian\">\n<UnstructuredGrid>\n"
                  "<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n"
                  "<Points>\n",
                  cells_ * points_of_a_cell_,
                  cells_ * static_cast<int>(vtk.points.size())));
  sink(points_);
  sink("</Points>\n<Cells>\n");
  sink(topology(vtk, cells_, points_of_a_cell_));
  sink("</Cells>\n<PointData>\n");
  for (const std::string& array : values_) sink(array);
  sink("</PointData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n");
}

}  // namespace clevis::stress

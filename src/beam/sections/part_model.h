#pragma once

#include <array>
#include <functional>
#include <vector>

#include <Eigen/Core>

#include "mesh/cells/part_mesh.h"
#include "mesh/cells/section.h"

namespace clevis::beam {

/// A bit of the part's material.
struct Lump {
  double volume{};                                 ///< [m³]
  Eigen::Vector3d p_LQ = Eigen::Vector3d::Zero();  ///< [m]
};

/// Where a plane meets the part's surface.
using Outline = std::vector<std::array<Eigen::Vector3d, 2>>;

/// Shape of a part as beam theory needs it; points in L [m].
struct PartModel {
  std::function<mesh::Section(const Eigen::Vector3d& point,
                              const Eigen::Vector3d& normal)>
      section;
  std::function<Outline(const Eigen::Vector3d& point,
                        const Eigen::Vector3d& normal)>
      outline;
  std::vector<Lump> lumps;
};

/// The model of a mesh. Lumps and outline take the grid of each cell's
/// geometry points as straight; the sections are those of a
/// mesh::SectionCutter. The mesh must outlive the model.
PartModel part_model(const mesh::PartMesh<3>& mesh);

}  // namespace clevis::beam

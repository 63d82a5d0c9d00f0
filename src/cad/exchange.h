#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "cad/face.h"
#include "cad/plate.h"
#include "part/solid_source.h"

namespace clevis::cad {

/// How much finer a mesh is to be than the mesher makes it by itself.
struct Refinement {
  /// Cells within half a cell of a place are smaller still, growing away from
  /// it.
  struct Place {
    Eigen::Vector3d at;  ///< [m]
    double times{};      ///< smaller
  };
  double everywhere = 1.0;  ///< times smaller cells
  std::vector<Place> at;    ///< one that is named twice is refined twice
};

/// What clevis asks its mesher: to describe a solid, or to mesh it.
struct Request {
  std::filesystem::path file;  ///< absolute
  part::GeometryFormat format = part::GeometryFormat::kStep;
  double length_unit{};  ///< of a file without units [m]
  /// Whose distances from the faces are wanted [m].
  std::vector<Eigen::Vector3d> points;
  bool facets = false;         ///< wanted, of all faces
  std::filesystem::path mesh;  ///< .msh to write; empty: none
  std::map<std::string, std::vector<int>> groups;  ///< numbers of faces
  std::optional<double> mesh_size;                 ///< in the bulk [m]
  /// To be meshed in its plane, one layer of hexahedra above it; absent: in
  /// space.
  std::optional<Plate> plate;
  Refinement finer;
};

/// As JSON in one line.
std::string text_of(const Request& request);
Request read_request(const std::string& text);

/// What the mesher found, or the refusal that it met.
std::string answer(const Solid& solid);
std::string refusal(const std::string& code, const std::string& place,
                    const std::string& problem, const std::string& remedy);

/// @throws Error as the mesher refused; std::exception if the text is no
///   answer.
Solid read_answer(const std::string& text);

}  // namespace clevis::cad

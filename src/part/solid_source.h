#pragma once

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <Eigen/Core>

namespace clevis::part {

/// What a part's `geometry` is: a script of gmsh, or a solid from a CAD system.
enum class GeometryFormat { kScript, kStep, kIges, kBrep };

/// By the extension, in letters of either case; others are scripts.
inline GeometryFormat geometry_format(const std::filesystem::path& file) {
  constexpr std::array<std::pair<std::string_view, GeometryFormat>, 5>
      kExtensions{{{".step", GeometryFormat::kStep},
                   {".stp", GeometryFormat::kStep},
                   {".iges", GeometryFormat::kIges},
                   {".igs", GeometryFormat::kIges},
                   {".brep", GeometryFormat::kBrep}}};
  std::string extension = file.extension().string();
  std::ranges::transform(extension, extension.begin(), [](unsigned char c) {
    return static_cast<char>(std::tolower(c));
  });
  for (const auto& [name, format] : kExtensions) {
    if (extension == name) return format;
  }
  return GeometryFormat::kScript;
}

/// A solid of a CAD system rather than a script.
inline bool is_solid_file(const std::filesystem::path& file) {
  return geometry_format(file) != GeometryFormat::kScript;
}

/// Metres per unit of the meshes that are made of solids: they are written in
/// millimetres.
inline constexpr double kSolidMeshUnit = 1e-3;

/// Faces of one circular cylinder, told from others by what is given: all on
/// its axis, or with `near` those that follow one another there.
struct CylinderSelector {
  std::optional<double> diameter;       ///< [m]
  std::optional<Eigen::Vector3d> near;  ///< the nearest to this point [m]
  std::optional<Eigen::Vector3d> axis;  ///< unit vector, of either sense
};

/// Faces in one plane.
struct PlaneSelector {
  Eigen::Vector3d normal;                  ///< unit vector, out of the part
  std::optional<Eigen::Vector3d> through;  ///< [m]
};

/// The one face nearest to a point.
struct NearestSelector {
  Eigen::Vector3d point;  ///< [m]
};

/// The one face of this name in a STEP file.
struct LabelSelector {
  std::string label;
};

/// Which faces of a solid are meant, in the part's frame.
struct FaceSelector {
  std::variant<CylinderSelector, PlaneSelector, NearestSelector, LabelSelector,
               std::vector<FaceSelector>>
      what;           ///< a list stands for all of them together
  std::string place;  ///< file:line:column
};

/// A group of faces that the user names.
struct NamedFaces {
  std::string group;
  FaceSelector selector;
};

/// A group of faces that a joint finds: those of the cylinder on its axis.
struct JointFaces {
  std::string joint, group;
  Eigen::Vector3d p_LJ;    ///< the joint's point [m]
  Eigen::Vector3d axis_L;  ///< its axis, a unit vector
  std::string place;       ///< file:line:column
};

/// What a part says of the solid that it is: which faces its groups are and
/// how fine its mesh is to be.
struct SolidSource {
  std::vector<NamedFaces> faces;
  std::vector<JointFaces> joints;
  std::optional<double> mesh_size;  ///< of cells in the bulk [m]
  std::string mesh_size_place;      ///< file:line:column
  /// Whether a plate is meshed as one, in its plane, rather than in space.
  bool sweep = true;
  double length_unit{};  ///< of a file without units [m]; 0: its own
};

}  // namespace clevis::part

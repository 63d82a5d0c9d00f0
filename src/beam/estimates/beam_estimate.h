#pragma once

#include <optional>
#include <string>
#include <vector>

#include "beam/sections/part_model.h"
#include "loads/history/load_history.h"
#include "loads/parts/part_loads.h"
#include "mesh/cells/part_mesh.h"
#include "part/mass_properties.h"
#include "part/material.h"

namespace clevis::beam {

/// One formula evaluated at one place, the worst over the load history.
struct BeamStress {
  std::string formula;  ///< "axial + bending", "lug net section", …
  std::string where;    ///< "C-B at 30 mm", "bore_C"
  double stress{};      ///< equivalent stress [Pa], >= 0
  double instant{};     ///< [s]
  /// The nominal stress of a section; else a formula of shear, lugs or walls.
  bool is_section = false;
};

/// A compressed pair of pins as Euler's strut.
struct EulerBuckling {
  double load{};    ///< at which it buckles [N]
  double safety{};  ///< that load over the largest compression [1]
};

/// Stresses, deflection and buckling of a part by beam and lug theory
/// (docs/theory.md, "Beams and lugs").
struct BeamEstimate {
  std::vector<BeamStress> stresses;  ///< sorted, the governing one first
  double deflection{};               ///< relative to the first two pins [m]
  /// Of the pair with the least safety; absent: none is compressed.
  std::optional<EulerBuckling> buckling;
};

/// Beam theory from the same load history that the FE takes: axial + bending
/// + shear along the line between each pair of neighbouring pins with the
/// true section (mesh::cut), lug checks at every bore, Lamé's stress at
/// pressurized bores, Euler buckling.
///
/// All stresses are nominal: no stress concentration. A part whose loads are
/// not in balance by themselves (held by `fixed`) gets no section forces.
/// @param buckling_length  between the hinges of the column that the part
///   belongs to [m], e.g. the largest distance between the outer pins of a
///   cylinder and its rod; not given: the distance of the part's own pins.
/// Source: docs/theory.md, "Beams and lugs".
BeamEstimate estimate(const mesh::PartMesh<3>& mesh,
                      const part::Material& material,
                      const part::MassProperties& mass,
                      const std::vector<loads::GroupGeometry>& groups,
                      const loads::LoadHistory& history,
                      std::optional<double> buckling_length = std::nullopt);

/// The same for a part whose shape is given by other means than a mesh.
/// @param buckling_length  as above [m].
BeamEstimate estimate(const PartModel& model, const part::Material& material,
                      const part::MassProperties& mass,
                      const std::vector<loads::GroupGeometry>& groups,
                      const loads::LoadHistory& history,
                      std::optional<double> buckling_length = std::nullopt);

}  // namespace clevis::beam

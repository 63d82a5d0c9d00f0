#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "assessment/job/part_job.h"
#include "mechanism/definition/motion.h"

namespace clevis::app {

/// Motion of a part's body, to place its fields in the world.
struct MovingPart {
  const mechanism::Motion* motion{};
  mechanism::BodyIndex body{};
};

/// What of a part is written, besides its worst instant.
struct FieldFiles {
  std::optional<MovingPart> moving;  ///< its frames
  bool linear_cells = false;         ///< NAME_linear.vtu of hexahedra
};

/// Whether a part's governing load set begins with the instants of the motion;
/// cases of the same supports follow them, those of others are a set of their
/// own.
bool begins_with_motion(const assessment::PartFields& fields,
                        const mechanism::Motion& motion);

/// Writes NAME.vtu (Lagrange cells) at the worst instant in frame L, and of
/// hexahedra, where wanted, NAME_linear.vtu; for a moving part whose governing
/// load set has the motion also frames/NAME_####.vtu
/// in the world and NAME.pvd over them; NAME_buckling.vtu with the shape in
/// which it buckles.
/// @param yield_strength  of the material [Pa].
/// @throws Error I002.
void write_part_files(const assessment::PartAssessment& assessment,
                      const FieldFiles& files, double yield_strength,
                      const std::filesystem::path& folder);

/// Writes mechanism.pvd: the frames of all moving parts that have some, if any
/// has.
void write_mechanism_series(const std::vector<std::string>& parts,
                            const mechanism::Motion& motion,
                            const std::filesystem::path& folder);

}  // namespace clevis::app

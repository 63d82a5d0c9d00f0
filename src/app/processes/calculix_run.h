#pragma once

#include <optional>
#include <string>
#include <vector>

#include "assessment/job/part_job.h"
#include "calculix/model.h"
#include "study/run.h"

namespace clevis::app {

/// "CalculiX 2.20" if `ccx` is found and says its version.
std::optional<std::string> calculix_version();

/// Problem for CalculiX.
struct CalculixRequest {
  calculix::Hexahedron hexahedron{};
  int split = 1;  ///< cuts of each hexahedron's edges
  int instant{};  ///< the governing one, of the first load set
  bool every_instant = false;
};

/// Label of a run in CalculiX's series: "h", "h/2".
std::string calculix_setting(int split);

/// Number of degrees of freedom of the deck that a request makes, roughly [1].
double calculix_dofs(const mesh::PartMesh<3>& mesh, int split);

/// Writes the deck, runs ccx on one thread, reads its answer and compares the
/// displacements with clevis's own of the highest degree on the same cells.
///
/// Seconds are the process's, from the deck to the .frd; the peak is the
/// largest von Mises stress of the stresses at the nodes, as users read it.
/// @param job  of study::governed_job().
/// @throws Error I004 if ccx fails; as the modules below.
study::Run run_calculix(const assessment::PartJob& job,
                        const CalculixRequest& request);

}  // namespace clevis::app

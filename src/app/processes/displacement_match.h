#pragma once

#include <vector>

#include "assessment/job/part_job.h"
#include "calculix/frd.h"
#include "calculix/model.h"

namespace clevis::app {

/// Largest difference of CalculiX's displacements to clevis's own, of the
/// highest degree on the part's mesh, over the largest of these [1]; of a free
/// part without the rigid motion that fits each best.
/// @param job      of study::governed_job().
/// @param history  that the model's steps solve.
/// @param split    cuts of the model's hexahedra.
double displacement_difference(const assessment::PartJob& job,
                               const loads::LoadHistory& history,
                               const calculix::Model& model, int split,
                               const std::vector<calculix::StepResult>& steps);

}  // namespace clevis::app

#pragma once

#include <optional>

#include "assessment/part_check.h"

namespace clevis::assessment {

/// The mid-plane of a part that plane stress describes: a plate along z, not
/// thicker than 0.6 of its smallest bore (unless the job asks for it), all
/// loads and supports in its plane and on its sides. Nothing if it needs 3-D
/// or the job asks for it.
/// @throws Error F005 if the job asks for plane stress and it does not fit.
std::optional<mesh::PartMesh<2>> plane_model(const PartJob& job);

}  // namespace clevis::assessment

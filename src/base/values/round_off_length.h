#pragma once

namespace clevis {

/// Distances of two places below it are round-off: centroids of meshes miss
/// symmetric points by 1e-17 m, and the smallest parts have 1e-5 m [m].
inline constexpr double kRoundOffLength = 1e-9;

}  // namespace clevis

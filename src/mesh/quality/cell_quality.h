#pragma once

namespace clevis::mesh {

/// Jacobian of a cell's mapping over its quadrature points and its surface.
struct CellQuality {
  double min_jacobian{}, max_jacobian{};  ///< det ∂x/∂ξ [m³]
  /// Smallest det over the product of the column lengths [1]; 1 for a box.
  double scaled_jacobian{};
};

}  // namespace clevis::mesh

#pragma once

#include <Eigen/Core>

#include "mechanism/element_base/element_response.h"
#include "mechanism/neighbours/neighbours.h"

namespace clevis::mechanism {

/// Neighbours as they move by themselves, for springs that swing them in ways
/// which the body does not feel: z'' = f of their motions z, with the rows
///
///     heldᵀ y + followedᵀ z = 0
///
/// of motions y at the places. S Sᵀ is the stiffness of y and z, S = (sprung;
/// sprung_there).
struct SwingingNeighbours {
  Eigen::MatrixXd held;                ///< wrenches by place, × rows
  Eigen::MatrixXd followed;            ///< z × rows [1/√kg]
  Eigen::MatrixXd sprung{}, damped{};  ///< likewise
  Eigen::MatrixXd sprung_there{}, damped_there{};  ///< z × the same columns
};

/// An element's directions: wrenches on the body by place, and rows of the
/// neighbours' unknowns.
struct ElementDirections {
  Eigen::MatrixXd body, neighbours;
};

/// Neighbours with what springs swing, in motions of mass one.
class SwingingForm {
 public:
  /// @param wrenches  of the body's rows, by place.
  SwingingForm(const Neighbours& neighbours, const NeighbourRows& rows,
               const Eigen::MatrixXd& wrenches);

  /// A rotor that turns as its line does.
  /// @param inertia  [kg m²] or [kg].
  void add(double inertia, const ElementDirections& along);
  void add(const ElementSpring& spring, const ElementDirections& along);
  SwingingNeighbours take();

 private:
  /// @return its row.
  Eigen::Index add_motion();
  Eigen::MatrixXd there(const Eigen::MatrixXd& of_neighbours) const;
  void add_relaxing(const ElementSpring& spring,
                    const ElementDirections& along);

  Eigen::Index wrenches_;
  Eigen::MatrixXd motions_;  ///< of the neighbours' unknowns
  SwingingNeighbours found_;
};

}  // namespace clevis::mechanism

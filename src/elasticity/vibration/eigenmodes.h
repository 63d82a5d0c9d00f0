#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "elasticity/fe_space/discretization.h"
#include "elasticity/problem/displacement_basis.h"
#include "elasticity/problem/elastic_problem.h"
#include "elasticity/vibration/seat_shapes.h"
#include "elasticity/vibration/vibrating_part.h"

namespace clevis::elasticity {

/// Free vibrations of a part, lowest first; of a free part the rigid motions
/// before them, at 0 Hz.
template <int dim>
struct Eigenmodes {
  Discretization<dim> discretization;
  Eigen::VectorXd frequencies;  ///< [Hz]
  /// Columns with φᵀ M φ = 1, dofs × modes [1/√kg].
  Eigen::MatrixXd shapes;
  int rigid{};  ///< how many of them are rigid
  /// (φᵀ M e_d)² over the part's mass: share of it that vibrates with the mode
  /// under a shake along direction d; modes × dim [1].
  Eigen::MatrixXd participation;
  /// Of the equation, see dynamics::Modes [1].
  Eigen::VectorXd residual;
  double mass{};    ///< [kg]
  int equations{};  ///< unknowns
};

/// @param count  modes wanted, rigid ones counted in.
/// @throws Error F001, F002, F003 if a mode fails its check, F004, M005.
template <int dim>
Eigenmodes<dim> eigenmodes(const ElasticProblem<dim>& problem, int degree,
                           int count);

/// Periods of the lowest elastic vibration, of a part without supports as the
/// mechanism holds it at several times. Quick with degree 2: within a per cent
/// or so on meshes that suit stress. A small part's factor stays for the next.
template <int dim>
class FirstPeriods {
 public:
  /// @param problem  its mesh, material and loads outlive the object.
  FirstPeriods(ElasticProblem<dim> problem, int degree)
      : problem_(std::move(problem)), degree_(degree) {}

  /// @param hold_time  as of loads::LoadHistory [s]. @return [s].
  /// @throws Error F001, F002, F003, F004, M005.
  double at(double hold_time);
  /// Few shapes of a part without supports, for holds of these wrenches at
  /// seats; nothing where supports hold it.
  /// @param wrenches  6 n × columns, force [1] above moment [m].
  /// @param zones  of the seats, as of seat_means().
  /// @param has_fields  as of SeatShapes. @throws Error as at().
  std::optional<SeatShapes> seat_shapes(
      const Eigen::MatrixXd& wrenches, const std::vector<loads::Seat>& seats,
      const std::vector<loads::ContactZone>& zones,
      bool has_fields = false) requires(dim == 3);

 private:
  ElasticProblem<dim> problem_;
  int degree_;
  std::optional<VibratingPart<dim>> part_;  ///< as its supports hold it
};

/// Of a held part the period of that among the lowest sixteen vibrations in
/// which most of the mass moves along a direction [s]: bending for a blow
/// across a bar, stretching for one along it.
/// @param direction  unit, in L; only its square counts.
template <int dim>
double period_along(const ElasticProblem<dim>& problem, int degree,
                    const Eigen::Vector3d& direction);

}  // namespace clevis::elasticity

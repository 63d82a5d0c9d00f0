#pragma once

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <Eigen/Geometry>

#include "assessment/job/model_traits.h"
#include "assessment/job/part_result.h"
#include "elasticity/problem/dof_limit.h"
#include "elasticity/problem/engine.h"
#include "loads/history/load_history.h"
#include "loads/history/strike.h"
#include "loads/parts/part_loads.h"
#include "mesh/cells/part_mesh.h"
#include "part/mass_properties.h"
#include "part/part_definition.h"
#include "part/supports.h"
#include "stress/field/point_history.h"
#include "stress/field/stress_history.h"

namespace clevis::assessment {

/// Loads that share their supports, solved with one factorisation.
struct LoadSet {
  loads::LoadHistory history;
  part::Supports fixed;  ///< empty: free part
  part::Foundations foundations = {};
};

/// A blow on the part, resolved.
struct ImpactJob {
  loads::Strike strike;
  part::Supports fixed;
  std::string source;  ///< "given", "contact touch"
  int samples = 1200;  ///< instants at which it is judged
  double front =
      0.0;  ///< waves that take less are damped, but not by steps [s]
};

/// An impact somewhere in the mechanism, as it loads the part.
struct ImpactLoad {
  std::string name;
  double duration{};   ///< [s]
  double rise_time{};  ///< until its largest force [s]
  /// This one's and those of all impacts of the same contact or end of a stop
  /// that are at least a tenth as hard [s].
  std::vector<double> touches;
};

/// The loads of a set as its reactions may be shared otherwise, where
/// equilibrium leaves them open.
struct OpenSharing {
  std::size_t set{};           ///< of the load sets
  loads::LoadHistory checked;  ///< those of its instants that are shared
  std::vector<loads::LoadHistory> others;
  bool is_complete = true;  ///< between them lies every sharing
  std::string remedy;       ///< what makes it certain
};

/// All that the check of one part needs.
struct PartJob {
  part::PartDefinition part;
  mesh::PartMesh<3> mesh;
  std::optional<mesh::PartMesh<3>> unrefined;  ///< the mesh before `refine`
  part::MassProperties mass;
  std::vector<loads::GroupGeometry> groups;
  std::vector<LoadSet> load_sets;
  std::vector<OpenSharing> open_sharings;
  std::vector<ImpactJob> impacts;
  std::vector<ImpactLoad> impact_loads;
  double tolerance = 0.01;                ///< of the peak stress [1]
  std::optional<double> buckling_length;  ///< of a sliding pair [m]
  /// Asked for; nothing: the cheapest that meets the tolerance.
  std::optional<ModelKind> model = std::nullopt;
  elasticity::Engine engine = elasticity::Engine::kAuto;  ///< asked for
  /// Of the solutions that give stress and of buckling; asked for.
  elasticity::DofLimit max_dofs = std::nullopt;
  bool is_shared = false;  ///< all ranks of this MPI run solve it together
  /// Its mesh can be made finer where its peak stays open: that comes before
  /// degree 4 of tetrahedra, and before what is not about the peak.
  bool may_be_meshed_finer = false;
  /// Else the check ends at an open peak, and nothing is judged: a finer mesh
  /// comes.
  bool judges_open_peak = true;
  /// Then none comes, and an open peak is judged: of the check [s].
  std::optional<double> late_after = std::nullopt;
  std::vector<std::string> notes;  ///< of the mesh, for the result
  /// Of meshes finer than the first, 1, 2, …
  int mesh_round = 0;
  /// Hears what is being done, for a user who waits; empty: nobody.
  std::function<void(const std::string&)> listener = {};

  void tell(const std::string& what) const {
    if (!listener) return;
    listener(mesh_round > 0
                 ? "finer mesh " + std::to_string(mesh_round) + ", " + what
                 : what);
  }

  /// For what the part does as a whole, its periods and its buckling: fine
  /// cells round a peak make both dear and no better.
  const mesh::PartMesh<3>& overall_mesh() const {
    return unrefined ? *unrefined : mesh;
  }

  /// Of the box about the mesh, rising [m].
  Eigen::Vector3d sides() const {
    Eigen::AlignedBox3d box;
    for (const auto& vertex : mesh.vertices) box.extend(vertex);
    Eigen::Vector3d sides = box.sizes();
    std::ranges::sort(sides);
    return sides;
  }
};

/// Peak and strain energy of the part at one instant or in one case.
struct InstantRow {
  /// Index of the job's load set; absent: a blow.
  std::optional<std::size_t> load_set;
  std::string label;       ///< of the case, or "t = 1.25 s"
  double time{};           ///< [s]
  double peak{};           ///< largest von Mises [Pa]
  double strain_energy{};  ///< [J]
};

/// How the part buckles, at the instant that governs.
struct BucklingShape {
  mesh::CellShape shape{};
  stress::InstantField field;  ///< the largest displacement 1 mm
};

/// A place where finer cells would narrow the band of the peak.
struct OpenPlace {
  Eigen::Vector3d at;  ///< in L [m]
  double excess{};     ///< its error over what the tolerance admits [1]
};

/// Fields of the highest degree, for output.
struct PartFields {
  int dim = 3;
  mesh::CellShape shape{};
  stress::StressHistory worst;  ///< of the governing load set
  std::vector<double> times;    ///< of its instants [s]
  int peak_instant{};
  std::vector<InstantRow> history;  ///< of all load sets
  /// Singular zone of each lattice point, 0 outside; points × cells. Nothing
  /// if the part has none.
  std::optional<Eigen::MatrixXd> zones;
  std::optional<BucklingShape> buckling;
  /// Displacement and stress at an instant on a lattice.
  std::function<stress::InstantField(int instant, int subdivisions)> at;
  /// The same of points of the lattice, those of a cell together, at several
  /// instants.
  std::function<stress::PointHistory(
      const std::vector<stress::FieldPoint>& points, int subdivisions,
      const std::vector<int>& instants)>
      over;
};

struct PartAssessment {
  PartResult result;
  PartFields fields;
  std::vector<OpenPlace> open_places = {};  ///< of the judged peak
  bool is_judged = false;                   ///< else it ended at an open peak
};

}  // namespace clevis::assessment

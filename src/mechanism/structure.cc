#include "mechanism/structure.h"

#include <algorithm>

#include "mechanism/assembly.h"
#include "mechanism/assur.h"
#include "mechanism/closed_joints.h"
#include "mechanism/constraint_system.h"
#include "mechanism/mobility.h"

namespace clevis::mechanism {
namespace {

/// Constraints that the pairs take away, welds left out.
int pair_constraints(const MechanismDefinition& definition, Motions motions) {
  int constraints = 0;
  for (const JointDefinition& joint : definition.joints) {
    if (joint.type == JointType::kWeld) continue;
    constraints +=
        static_cast<int>(constrained_rows(joint.type, motions).size());
  }
  return constraints + static_cast<int>(definition.couplings.size());
}

/// Links with revolutes and slides only.
bool has_assur_groups(const MechanismDefinition& definition) {
  return definition.couplings.empty() &&
         std::ranges::all_of(definition.joints, [](const auto& joint) {
           return joint.type == JointType::kRevolute ||
                  joint.type == JointType::kPrismatic ||
                  joint.type == JointType::kWeld;
         });
}

std::vector<std::string> involved(const MechanismDefinition& definition,
                                  const ConstraintSystem& system,
                                  const std::vector<bool>& dependent_rows) {
  std::vector<std::string> names;
  for (int i = 0; i < system.joint_rows(); ++i) {
    if (!dependent_rows[static_cast<std::size_t>(i)]) continue;
    const auto& row = system.row_list()[static_cast<std::size_t>(i)];
    const std::string& name =
        row.coupling < 0
            ? definition.joints[static_cast<std::size_t>(row.joint)].name
            : definition.couplings[static_cast<std::size_t>(row.coupling)].name;
    if (std::ranges::find(names, name) == names.end()) names.push_back(name);
  }
  return names;
}

}  // namespace

Structure analyse_structure(const MechanismDefinition& definition) {
  const SolvingFrame frame(definition);
  const Configuration closed =
      closed_joints(definition, frame, 1e-8 * frame.length);
  const LinkGraph graph = link_graph(definition, {});
  Structure s;
  s.planar = frame.planar;
  s.moving_links = static_cast<int>(graph.links.size());
  s.pairs = static_cast<int>(graph.pairs.size());

  const Motions own = frame.planar ? Motions::kInPlane : Motions::kSpatial;
  const ConstraintSystem system(frame, definition.drives, own,
                                ConstraintSystem::Drives::kAll);
  const Mobility moves = mobility(frame, system, closed);
  s.mobility = moves.joints;
  s.redundant = moves.redundant;
  s.redundant_in = involved(definition, system, moves.dependent_rows);

  const ConstraintSystem spatial(frame, definition.drives, Motions::kSpatial,
                                 ConstraintSystem::Drives::kAll);
  const Mobility in_space = mobility(frame, spatial, closed);
  s.spatial_mobility = in_space.joints;
  s.spatial_redundant = in_space.redundant;
  s.spatial_redundant_in =
      involved(definition, spatial, in_space.dependent_rows);
  s.spatial_chebyshev =
      6 * s.moving_links - pair_constraints(definition, Motions::kSpatial);
  s.chebyshev = frame.planar
                    ? 3 * s.moving_links - pair_constraints(definition, own)
                    : s.spatial_chebyshev;
  if (!frame.planar || !has_assur_groups(definition)) return s;
  const AssurFormula corrected = corrected_formula(definition);
  const AssurFormula published = published_formula(definition);
  s.assur_corrected = corrected.text;
  s.assur_class_corrected = corrected.highest_class;
  s.assur_published = published.text;
  s.assur_class_published = published.highest_class;
  return s;
}

}  // namespace clevis::mechanism

#include "mechanism/structure/structure.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "mechanism/constraints/assembly.h"
#include "mechanism/constraints/closed_joints.h"
#include "mechanism/constraints/constraint_system.h"
#include "mechanism/constraints/mobility.h"
#include "mechanism/joints/joint_types.h"
#include "mechanism/structure/assur.h"
#include "mechanism/structure/assur_inputs.h"
#include "mechanism/structure/link_graph.h"

namespace clevis::mechanism {
namespace {

/// Constraints that the pairs take away, welds left out.
int pair_constraints(const MechanismDefinition& definition, Motions motions) {
  int constraints = 0;
  for (const JointDefinition& joint : definition.joints) {
    if (traits(joint.type).merges_links) continue;
    constraints +=
        static_cast<int>(constrained_rows(joint.type, motions).size());
  }
  return constraints + static_cast<int>(definition.couplings.size());
}

/// Joints and couplings that are no lower pairs of the plane.
std::vector<std::string> without_groups(const MechanismDefinition& definition) {
  std::vector<std::string> names;
  for (const JointDefinition& joint : definition.joints) {
    const JointTraits& type = traits(joint.type);
    if (!type.is_lower_pair && !type.merges_links) names.push_back(joint.name);
  }
  for (const CouplingDefinition& coupling : definition.couplings) {
    names.push_back(coupling.name);
  }
  return names;
}

/// Why the inputs cannot lead all that moves.
std::string not_led(const LinkGraph& graph) {
  std::vector<std::string> loose;
  for (int link = 0; link < static_cast<int>(graph.links.size()); ++link) {
    if (std::ranges::none_of(graph.pairs, [link](const auto& pair) {
          return pair.a == link || pair.b == link;
        })) {
      loose.push_back(graph.links[static_cast<std::size_t>(link)]);
    }
  }
  if (loose.empty()) return "no joints lead all that moves";
  return fmt::format("no joint leads {}", fmt::join(loose, ", "));
}

void add_groups(Structure& s, const MechanismDefinition& definition,
                const LinkGraph& graph) {
  if (const auto names = without_groups(definition); !names.empty()) {
    s.assur_none =
        fmt::format("{}: neither hinge nor slide", fmt::join(names, ", "));
    return;
  }
  if (s.redundant > 0) {
    s.assur_none = fmt::format("redundant constraints among {}",
                               fmt::join(s.redundant_in, ", "));
    return;
  }
  if (s.mobility == 0) {
    s.assur_none = "nothing moves";
    return;
  }
  const int count = s.mobility - static_cast<int>(definition.drives.size());
  const std::vector<int> taken = assumed_inputs(definition, count);
  if (static_cast<int>(taken.size()) < count) {
    s.assur_none = not_led(graph);
    return;
  }
  const AssurFormula corrected = corrected_formula(definition, taken);
  if (corrected.text.empty()) {
    s.assur_none = "what the drives leave does not split";
    return;
  }
  for (const int joint : taken) {
    s.assur_inputs.push_back(
        definition.joints[static_cast<std::size_t>(joint)].name);
  }
  s.assur_corrected = corrected.text;
  s.assur_class_corrected = corrected.highest_class;
  if (!taken.empty()) return;
  const AssurFormula published = published_formula(definition);
  s.assur_published = published.text;
  s.assur_class_published = published.highest_class;
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
  if (frame.planar) add_groups(s, definition, graph);
  return s;
}

}  // namespace clevis::mechanism

#pragma once

#include <memory>
#include <string>
#include <vector>

#include "mechanism/definition/motion.h"

namespace clevis::mechanism {

/// Factor to either side by which a compliance may differ from the one that
/// shares reactions [1]. Not given: from a pressed pin (0.01 nm/N) to a soft
/// bush (100 nm/N) about the default of 1 nm/N; beside links whose own
/// compliance is known: a plain or rolling bearing at most.
inline constexpr double kUnknownCompliance = 100.0;
inline constexpr double kBesideElasticLinks = 10.0;
inline constexpr double kGivenCompliance = 2.0;

/// Reactions below this part of the largest on the same body decide nothing;
/// nor does it matter that equilibrium leaves them open.
inline constexpr double kNegligibleReaction = 1e-6;

/// The same motion with its reactions as joints of other compliance share what
/// equilibrium leaves open.
///
/// Along one compliance, the others held, reactions move on a straight line
/// from one end to the other. What is convex in them, as von Mises stress, is
/// therefore largest at a corner of the box of all compliances.
/// Source: docs/theory.md, "Reactions".
class OtherSharings {
 public:
  /// @param motion  of the definition, without instants at change points; its
  ///   links may have counted as rigid.
  OtherSharings(const MechanismDefinition& definition, const Motion& motion);
  ~OtherSharings();
  OtherSharings(OtherSharings&&) noexcept;
  OtherSharings& operator=(OtherSharings&&) noexcept;

  /// Number of sharings; 0: equilibrium leaves nothing open that matters.
  std::size_t size() const;
  /// One of them.
  Motion motion(std::size_t index) const;
  /// Whether they are all corners of the box; else some of them.
  bool is_complete() const;
  /// The joints whose compliance matters but was not given.
  const std::vector<std::string>& unknown() const;
  /// Joints whose compliance was given and matters.
  const std::vector<std::string>& given() const;
  /// Whether pressure on further faces strains elastic links of these joints,
  /// which shares reactions too and is not known.
  bool leaves_forces_out() const;

 private:
  struct Solver;
  std::unique_ptr<Solver> solver_;
};

/// The same motion as the definition's own compliances share it, of links that
/// may have counted as rigid, with all that equilibrium leaves open marked.
/// Forces [N] and moments [N m]; components are along the solving frame's axes.
Motion shared_anew(const MechanismDefinition& definition, const Motion& motion);

/// Counts the reaction of a joint as unique where all that equilibrium leaves
/// open of it is negligible, over the whole motion: below kNegligibleReaction
/// of the reactions beside it, and so by how much it may change.
/// @param length  over which moments count as forces [m].
void forget_negligible(const std::vector<JointDefinition>& joints,
                       double length, Motion& motion);

}  // namespace clevis::mechanism

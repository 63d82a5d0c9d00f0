#pragma once

#include <optional>

#include "app/scenes/load_scene.h"
#include "assessment/job/part_job.h"
#include "mechanism/reactions/other_sharings.h"

namespace clevis::app {

/// How joints of other compliance share the reactions that equilibrium leaves
/// open. Where the compliance of a joint is given, or spin stretches links
/// between their joints, also as elastic links share them that count as rigid,
/// but for those that pressure on further faces strains.
class Sharings {
 public:
  /// @param motion  of the scene's mechanism, without instants at change
  ///   points.
  /// @throws Error of with_link_compliances().
  Sharings(const LoadedScene& loaded, const mechanism::Motion& motion);
  Sharings(const Sharings&) = delete;
  Sharings& operator=(const Sharings&) = delete;

  /// Loads on a part in these; nothing if its loads hardly depend on it.
  /// @param checked  its loads by the sharing that the motion has, load set 0.
  /// @throws Error as of part_loads().
  std::optional<assessment::OpenSharing> of_part(
      const LoadedPart& part, const loads::LoadHistory& checked) const;

 private:
  /// Of a mechanism whose links count as elastic.
  struct Elastic {
    Elastic(const LoadedScene& loaded, const mechanism::Motion& rigid);

    mechanism::MechanismDefinition definition;
    mechanism::Motion motion;  ///< as it shares
    mechanism::OtherSharings sharings;
  };
  const LoadedScene& loaded_;
  mechanism::OtherSharings as_given_;
  std::optional<Elastic> elastic_;
};

}  // namespace clevis::app

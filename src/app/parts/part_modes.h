#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "app/scenes/load_scene.h"
#include "elasticity/problem/dof_limit.h"
#include "part/supports.h"

namespace clevis::app {

/// Vibrations of a part that are asked for.
struct ModesRequest {
  std::string supports;  ///< "free", or the case or blow that holds the part
  int number{};          ///< of its set of supports, for names of files
  part::Supports fixed;
  int count{};         ///< of modes, rigid ones of a free part counted in
  double tolerance{};  ///< of the frequencies, for the climb of degrees [1]
  part::Foundations foundations = {};
  elasticity::DofLimit max_dofs = std::nullopt;  ///< asked for
};

/// Climbs degrees until the frequencies settle; writes NAME_mode_N.vtu (of the
/// second set of supports NAME_2_mode_N.vtu)
/// of every elastic mode. A plate whose supports hold nothing across its plane
/// vibrates in it, by plane stress.
/// @return the entry of modes.json.
/// @throws Error of elasticity::eigenmodes, F007 if the first degree has more
///   than `max_dofs`, I002.
nlohmann::ordered_json part_modes(const LoadedPart& part,
                                  const ModesRequest& request,
                                  const std::filesystem::path& folder);

/// Supports of a part whose modes can be asked for: free if a body of the
/// mechanism carries it or nothing holds it, and the supports of each case and
/// blow once.
/// @param tolerance  of the frequencies, relative [1].
std::vector<ModesRequest> modes_requests(const LoadedPart& part, bool moves,
                                         int count, double tolerance);

}  // namespace clevis::app

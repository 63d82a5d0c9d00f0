# Headers of others that most sources read, compiled once for all libraries and
# once for all tests: the first target that asks owns them. The preset `dev` does
# without, so that every source includes what it uses.
set(CLEVIS_COMMON_HEADERS
    <algorithm> <array> <cmath> <cstddef> <functional> <map> <memory> <numeric>
    <optional> <string> <string_view> <utility> <variant> <vector>
    <Eigen/Core> <Eigen/Geometry> <fmt/format.h>)

# precompile_headers(TARGET OWNER [HEADER...])
function(precompile_headers target owner)
  if(target STREQUAL owner)
    target_precompile_headers(${target} PRIVATE ${CLEVIS_COMMON_HEADERS} ${ARGN})
  else()
    target_precompile_headers(${target} REUSE_FROM ${owner})
  endif()
endfunction()

#include "base/system/instruction_set.h"

#include <algorithm>
#include <cstdlib>
#include <string_view>

namespace clevis {
namespace {

InstructionSet of_processor() {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
      __builtin_cpu_supports("avx512bw") &&
      __builtin_cpu_supports("avx512vl") &&
      __builtin_cpu_supports("avx512cd")) {
    return InstructionSet::kAvx512;
  }
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) {
    return InstructionSet::kAvx2;
  }
#endif
  return InstructionSet::kPlain;
}

InstructionSet admitted() {
  const char* variable = std::getenv("CLEVIS_INSTRUCTIONS");
  const std::string_view name = variable != nullptr ? variable : "";
  if (name == "plain") return InstructionSet::kPlain;
  return name == "avx2" ? InstructionSet::kAvx2 : InstructionSet::kAvx512;
}

}  // namespace

InstructionSet instruction_set() {
  static const InstructionSet set = std::min(of_processor(), admitted());
  return set;
}

}  // namespace clevis

#pragma once

namespace clevis {

/// What this processor computes in SIMD lanes with.
enum class InstructionSet { kPlain, kAvx2, kAvx512 };

/// The best that the processor has, or less where the environment variable
/// CLEVIS_INSTRUCTIONS says so (plain, avx2, avx512).
InstructionSet instruction_set();

}  // namespace clevis

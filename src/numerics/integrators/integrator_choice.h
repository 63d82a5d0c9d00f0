#pragma once

namespace clevis::numerics {

/// Method of an integrated motion: DOP853, Radau IIA, or each where it is the
/// better.
enum class IntegratorChoice { kAuto, kExplicit, kImplicit };

}  // namespace clevis::numerics

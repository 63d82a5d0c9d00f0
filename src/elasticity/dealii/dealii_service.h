#pragma once

namespace clevis::elasticity {

/// Ranks beside the first one solve what it solves: call this on them, and
/// dismiss_dealii() on the first one when it has done. @pre a RankTeam.
/// @throws what the system throws; the other ranks then wait for this one.
void serve_dealii();

/// Ends serve_dealii() on the other ranks.
void dismiss_dealii();

/// SIMD lanes of double precision in which the engine works on solids; 1 where
/// the processor's are not used.
int dealii_lanes();

/// The library's functions for these, and their names.
using DealiiServiceEntry = void();
inline constexpr const char* kDealiiServe = "clevis_dealii_serve";
inline constexpr const char* kDealiiDismiss = "clevis_dealii_dismiss";
using DealiiLanesEntry = int();
inline constexpr const char* kDealiiLanes = "clevis_dealii_lanes";

}  // namespace clevis::elasticity

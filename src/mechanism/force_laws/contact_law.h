#pragma once

namespace clevis::mechanism {

enum class ContactModel { kPenalty, kPublished, kHuntCrossley };

/// Normal force of a penetration d > 0 with rate d':
///   penalty    s(d/transition) (k d + b d'), not below 0, s = 3t² − 2t³
///   published  k d + b d', pulls before it lets go ([LandingGear] 4.3)
///   Hunt and Crossley  k d^exponent (1 + c d'), not below 0 ([HuntCrossley])
struct ContactLaw {
  ContactModel model = ContactModel::kPenalty;
  double stiffness{};   ///< [N/m], [N/m^n] or [N m/rad]
  double damping{};     ///< b [N s/m], or c [s/m]
  double transition{};  ///< [m]; 0: full at once
  double exponent = 1.5;
};

/// Effort of a penetration, without the bound at 0 [N] or [N m].
/// @param depth  > 0 [m] or [rad]; @param rate  of it [m/s] or [rad/s].
double contact_effort(const ContactLaw& law, double depth, double rate);

/// Sign of that effort, without the factors that vanish with the depth.
/// @param depth  >= 0 [m] or [rad]; @param rate  of it [m/s] or [rad/s].
double contact_sign(const ContactLaw& law, double depth, double rate);

/// Whether the law lets the bodies pull at one another until depth is 0.
inline bool may_pull(const ContactLaw& law) {
  return law.model == ContactModel::kPublished;
}

}  // namespace clevis::mechanism

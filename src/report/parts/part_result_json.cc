#include "report/parts/part_result_json.h"

#include <nlohmann/json.hpp>

#include "base/messages/errors.h"
#include "report/quantities/member_count.h"
#include "report/text/json_text.h"

namespace nlohmann {

template <>
struct adl_serializer<Eigen::Vector3d> {
  template <typename Json>
  static void to_json(Json& json, const Eigen::Vector3d& vector) {
    json = {vector.x(), vector.y(), vector.z()};
  }
  template <typename Json>
  static void from_json(const Json& json, Eigen::Vector3d& vector) {
    for (std::size_t i = 0; i < 3; ++i) {
      vector[static_cast<Eigen::Index>(i)] = json.at(i).template get<double>();
    }
  }
};

/// Null for what is not known.
template <typename T>
struct adl_serializer<std::optional<T>> {
  template <typename Json>
  static void to_json(Json& json, const std::optional<T>& value) {
    json = value ? Json(*value) : Json();
  }
  template <typename Json>
  static void from_json(const Json& json, std::optional<T>& value) {
    value.reset();
    if (!json.is_null()) value = json.template get<T>();
  }
};

}  // namespace nlohmann

// Carries all members of a type, or does not compile.
#define CLEVIS_PIPED(Type, ...)                         \
  NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Type, __VA_ARGS__) \
  static_assert(report::member_count<Type>() ==         \
                report::name_count(#__VA_ARGS__));

// nlohmann finds these by argument, so they stand in the namespace of the
// types; nothing outside this file sees them. Reading throws if a member is
// absent.
namespace clevis::assessment {

CLEVIS_PIPED(SequenceMember, degree, dofs, peak, strain_energy, label,
             field_peak, deflection)
CLEVIS_PIPED(ErrorShares, mesh, model, time, sharing, change_points)
CLEVIS_PIPED(PeakStress, value, band_low, band_high, discretization_error,
             model_error, shares, has_band, verdict, at, group, instant, label,
             sequence, degree_nearby, field_maximum, jump)
CLEVIS_PIPED(ZoneResult, name, exponent, exponent_measured, at, radius, governs,
             has_section, edge_of)
CLEVIS_PIPED(BucklingResult, factor, band_low, band_high, instant, label,
             of_motions, model, remark, euler, strut_is_longer, if_all_hold)
CLEVIS_PIPED(Swing, stress, deflection)
CLEVIS_PIPED(SecondOrderResult, is_stable, bears_growth, peak, stress, label,
             deflection, deflection_rise, least_peak, least_deflection, bound,
             deflection_bound, failure)
CLEVIS_PIPED(FiniteMotion, rotation, strain, label)
CLEVIS_PIPED(BeamComparison, peak_stress, governing, is_section, deflection,
             buckling_safety, ratio_fe_to_beam, reason)
CLEVIS_PIPED(SelfChecks, equilibrium, residual, energy, compression,
             reported_peak_is_field_maximum)
CLEVIS_PIPED(ProbeResult, name, quantity, value, band_low, band_high)
CLEVIS_PIPED(SupportStress, value, band_low, band_high, section, instant, label)
CLEVIS_PIPED(ImpactRow, model, scheme, degree, stress, nominal, face,
             deflection, error, seconds, ratio, remark)
CLEVIS_PIPED(WaveFrontRefinement, fronts, stress, deflection, below, above,
             root_below, root_above, settles, degree, competing_time,
             competing_stress)
CLEVIS_PIPED(ImpactResult, name, source, mass, speed, force, stiffness,
             exponent, is_ideal, part_mass, first_period, looked_for,
             later_stress, later_deflection, later_root, spread, is_cut,
             is_axial, free_vibration_stress, free_vibration_deflection,
             load_duration, rise_time, peak_force, beam_factor, dynamic_factor,
             stress, band_low, band_high, root, deflection, deflection_low,
             deflection_high, deflection_at, deflection_time, safety_factor,
             reason, refinement, rows)
CLEVIS_PIPED(DurationRatio, impact, duration, rise_time, first_period, ratio,
             amplification, treatment)
CLEVIS_PIPED(VibrationResult, ratio, governs, failure, not_followed, peak,
             band_low, band_high, still, still_error, degree_error, shape_error,
             sampling_error, path_error, at, group, time, from, to, deflection,
             model, shapes, lowest_frequency, highest_frequency, seconds)
CLEVIS_PIPED(PinReaction, label, group, force, moment, unique)
CLEVIS_PIPED(PartSeconds, mesh, choose, assemble, factor, solve, recover, write,
             total)
CLEVIS_PIPED(PartResult, name, verdict, why, model, engine, engine_why,
             stopped_because, notes, dofs, cells, load_columns, peak,
             singular_zones, peak_outside, held, safety_factor, deflection,
             deflection_low, deflection_high, deflection_at, deflection_instant,
             deflection_label, deflection_set, strain_energy,
             strain_energy_instant, mean_strain_energy, strain_energy_error,
             buckling, second_order, finite_motion, beam, self_checks, probes,
             seconds, mass, first_period, impacts, duration_ratios, vibration,
             swings, pin_reactions)

#undef CLEVIS_PIPED

}  // namespace clevis::assessment

namespace clevis::report {

std::string encode(const assessment::PartResult& result) {
  const nlohmann::json members = result;
  const nlohmann::ordered_json document = members;
  refuse_non_finite(document, "part " + result.name);
  return json_text(document);
}

assessment::PartResult decode_part_result(std::string_view text) {
  try {
    return nlohmann::json::parse(text).get<assessment::PartResult>();
  } catch (const nlohmann::json::exception& error) {
    throw Error("X001", "part result from a worker",
                std::string("cannot be read: ") + error.what(),
                "Run the check again with --jobs 1 and report the scene.");
  }
}

}  // namespace clevis::report

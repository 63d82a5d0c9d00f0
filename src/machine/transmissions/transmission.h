#pragma once

#include <optional>
#include <string>
#include <vector>

#include "machine/transmissions/chain_model.h"
#include "machine/transmissions/compliance.h"
#include "machine/transmissions/module_error.h"

namespace clevis::machine {

/// Parts of a drive train that move together, loaded in series.
struct TransmissionStage {
  std::string name;
  /// Motion of this stage per motion of the next one, which carries that many
  /// times its torque: [1] between rotations, [rad/m] into a
  /// translation. 1 of the last stage.
  double ratio = 1.0;
  bool angular = true;
  std::vector<CompliantElement> elements;
  /// Of what moves with its start, before its elements (the wheel that drives
  /// it), and with its end (its pinion); [kg m²] or [kg].
  double wheel_inertia{}, pinion_inertia{};
};

/// A drive train from the motor to the output, its last stage. With
/// `angular` of the last stage, quantities of the output are [rad], [N m],
/// [kg m²], else [m], [N], [kg].
struct TransmissionDefinition {
  std::string name;
  std::vector<TransmissionStage> stages;
  BallScrewUnit ball_screw_unit = BallScrewUnit::kCorrected;
  std::optional<double> motor_inertia;  ///< on the first stage [kg m²]
  std::optional<double> load_inertia;   ///< on the output
  double load{};                        ///< torque or force on the output
  std::optional<ErrorShares> errors;    ///< on the output
};

/// An element's part in the compliance of the output.
struct ElementCompliance {
  std::string stage, name, type, formula;
  bool angular{};
  double own{};      ///< [rad/(N m)] or [m/N]
  double ratio{};    ///< u of its stage to the output
  double reduced{};  ///< own / u²
};

/// Motor and load joined by the whole compliance; seen from the output.
struct TwoMassModel {
  double motor_inertia{}, load_inertia{};  ///< on the output
  double antiresonance{};  ///< [Hz]: the load with the motor held
  double resonance{};      ///< [Hz]: both free
};

struct TransmissionResult {
  std::string name;
  bool angular{};  ///< the output turns
  double ratio{};  ///< motor per output
  std::vector<ElementCompliance> elements;
  double compliance{};  ///< Σ e_i / u_in², of the output
  BallScrewUnit ball_screw_unit{};
  /// The same with the ball screws in the other unit; equal without any.
  double compliance_other_unit{};
  /// Last stage and the teeth that drive it, which [DriveLectures] (5.76) takes
  /// for the whole.
  double last_stage{};
  /// The same as printed: the teeth's compliance on the driving wheel is not
  /// reduced to the output.
  double last_stage_published{};
  std::optional<TwoMassModel> two_mass;
  /// With the inertia of the stages, where they have any: what the two-mass
  /// model leaves out.
  std::optional<ChainModel> chain;
  std::optional<ModuleError> error;
};

/// Compliance by element and in all, two-mass model and error of a drive
/// train.
/// @pre stages with elements, ratios > 0.
TransmissionResult analyse_transmission(
    const TransmissionDefinition& transmission);

/// @param compliance  between the masses [m/N] or [rad/(N m)]
TwoMassModel two_mass_model(double motor_inertia, double load_inertia,
                            double compliance);

}  // namespace clevis::machine

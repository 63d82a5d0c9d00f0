#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

namespace clevis::assessment {

enum class PartVerdict { kPass, kFail, kNotJudged };
enum class PeakVerdict { kConverged, kSingular, kNotConverged };

/// One member of the p-sequence.
struct SequenceMember {
  int degree{};
  int dofs{};
  double peak{};           ///< von Mises over all points and instants [Pa]
  double strain_energy{};  ///< at the worst instant [J]
  std::string label{};     ///< of that instant
  double field_peak{};     ///< peak between the points too; 0: not sought [Pa]
};

/// Peak von Mises over the surface and all instants.
struct PeakStress {
  double value{};                  ///< [Pa]
  double band_low{}, band_high{};  ///< both errors below included [Pa]
  double discretization_error{};   ///< of degree, mesh, sampling [Pa]
  double model_error{};            ///< against 3-D elasticity, as measured [Pa]
  PeakVerdict verdict{};
  Eigen::Vector3d at = Eigen::Vector3d::Zero();  ///< in L [m]
  std::string group;  ///< physical group nearest to it ("bore_C"), or "body"
  double instant{};   ///< [s]
  std::string label;  ///< "t = 1.25 s" or the case
  std::vector<SequenceMember> sequence;
};

/// A place where the model's stress has no bound.
struct ZoneResult {
  std::string name;   ///< "edge of root at (0, 10, 2) mm"
  double exponent{};  ///< λ of theory: stress ~ distance^(λ − 1) [1]
  double exponent_measured{};  ///< from the solved field; 0: not measured [1]
  Eigen::Vector3d at = Eigen::Vector3d::Zero();  ///< in L [m]
  double radius{};                               ///< left out around it [m]
  /// Whether its stress rises above the peak elsewhere.
  bool governs{};
};

/// What beam theory says of the same load history.
struct BeamComparison {
  double peak_stress{};  ///< governing of all beam and lug formulas [Pa]
  std::string
      governing;  ///< "axial + bending, C-B at 30 mm", "lug E net section"
  double deflection{};         ///< [m]
  double buckling_safety = 0;  ///< Euler load / axial force; 0: not in pressure
  double ratio_fe_to_beam{};   ///< peak stresses [1]
  std::string reason;          ///< why the ratio leaves 0.8–1.25, or empty
};

/// Every entry must be below its bound or the solve is refused (F003).
struct SelfChecks {
  double equilibrium{};  ///< |ΣF|, |ΣM|/size over the load scale [1]
  double residual{};     ///< ‖Ku−f‖/‖f‖ [1]
  double energy{};       ///< |½uᵀKu − ½fᵀu| / (½fᵀu) [1]
  double compression{};  ///< load basis against loads [1]
  bool reported_peak_is_field_maximum{};
};

struct ProbeResult {
  std::string name, quantity;
  double value{}, band_low{}, band_high{};  ///< SI
};

struct PartSeconds {
  double mesh{}, assemble{}, factor{}, solve{}, recover{}, write{}, total{};
};

struct PartResult;

/// The peak that limits and beam theory are compared with: away from the
/// singular zones where one governs.
const PeakStress& judged_peak(const PartResult& result);

/// All that is known of a part after the check.
struct PartResult {
  std::string name;
  PartVerdict verdict{};
  std::string why;    ///< one line: limit and value, or why not judged
  std::string model;  ///< "plane stress, p = 4"
  std::string stopped_because;  ///< why the ladder went no further
  int dofs{}, cells{}, load_columns{};
  PeakStress peak;
  std::vector<ZoneResult> singular_zones;
  /// Where a zone governs: the peak away from those that do; else with an
  /// empty sequence.
  PeakStress peak_outside;
  double safety_factor{};  ///< yield / peak
  double deflection{};     ///< relative to its pins [m]
  Eigen::Vector3d deflection_at = Eigen::Vector3d::Zero();
  double deflection_instant{};  ///< [s]
  double strain_energy{};       ///< largest over the instants [J]
  /// Over the strain energy at the worst instant, by its last three degrees;
  /// negative: too few at one instant [1].
  double strain_energy_error = -1.0;
  BeamComparison beam;
  SelfChecks self_checks;
  std::vector<ProbeResult> probes;
  PartSeconds seconds;
  double mass{};  ///< [kg]
};

}  // namespace clevis::assessment

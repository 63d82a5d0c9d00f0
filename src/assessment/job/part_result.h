#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "part/verdict.h"

namespace clevis::assessment {

enum class PeakVerdict { kConverged, kSingular, kNotConverged };

/// One member of the p-sequence.
struct SequenceMember {
  int degree{};
  int dofs{};
  double peak{};           ///< von Mises over all points and instants [Pa]
  double strain_energy{};  ///< at the worst instant [J]
  std::string label{};     ///< of that instant
  /// Peak between the points too; absent: not sought [Pa].
  std::optional<double> field_peak{};
  double deflection{};  ///< largest over the same instants [m]
};

/// Error of a peak to either side, by source [Pa].
struct ErrorShares {
  double mesh{};     ///< degree, cells, points between those looked at
  double model{};    ///< against 3-D elasticity
  double time{};     ///< instants between those looked at
  double sharing{};  ///< reactions that equilibrium leaves open
  /// What joints carry between instants, where the mechanism passes a change
  /// point.
  double change_points{};

  double total() const { return mesh + model + time + sharing + change_points; }
};

/// Peak von Mises over the surface and all instants.
struct PeakStress {
  double value{};                  ///< [Pa]
  double band_low{}, band_high{};  ///< both errors below included [Pa]
  double discretization_error{};   ///< of degree, mesh, sampling [Pa]
  double model_error{};            ///< against 3-D elasticity, as measured [Pa]
  ErrorShares shares;              ///< of what the band is wide
  /// Whether the band is an estimate though it may be wider than the tolerance:
  /// three degrees or more that do not grow like those of a singular peak.
  bool has_band = false;
  PeakVerdict verdict{};
  Eigen::Vector3d at = Eigen::Vector3d::Zero();  ///< in L [m]
  std::string group;  ///< physical group nearest to it ("bore_C"), or "body"
  double instant{};   ///< [s]
  std::string label;  ///< "t = 1.25 s" or the case
  std::vector<SequenceMember> sequence;
  /// Degree of the finer solution nearby that gives the value; absent: the last
  /// degree's own field gives it.
  std::optional<int> degree_nearby;
  /// Of the field as solved, cell by cell; absent: not sought [Pa].
  std::optional<double> field_maximum;
  double jump{};  ///< between the cells that meet at the peak, as solved [Pa]
};

/// A place where the model's stress has no bound.
struct ZoneResult {
  std::string name;   ///< "edge of root at (0, 10, 2) mm"
  double exponent{};  ///< λ of theory: stress ~ distance^(λ − 1) [1]
  /// From the solved field; absent: the mesh is not graded there [1].
  std::optional<double> exponent_measured;
  Eigen::Vector3d at = Eigen::Vector3d::Zero();  ///< in L [m]
  double radius{};                               ///< left out around it [m]
  /// Whether its stress rises above the peak elsewhere.
  bool governs{};
  /// Whether it is the edge of a plane held face, whose section is known.
  bool has_section{};
  std::string edge_of = {};  ///< the held group whose edge it is; empty: none
};

/// Linear buckling: by how much all loads of an instant may grow until the
/// part buckles, by finite elements, least over the instants.
struct BucklingResult {
  /// Absent: not computed, or nothing presses [1].
  std::optional<double> factor;
  double band_low{}, band_high{};  ///< [1]
  double instant{};                ///< [s]
  std::string label;               ///< "t = 1.25 s" or the case
  /// By load set of the job: of its motion alone, cases left out; not below
  /// `factor`. Far more than is wanted: it has none [1].
  std::vector<double> of_motions = {};
  std::string model;  ///< "plane stress, p = 4"
  /// Why there is none, or what it leaves out; one line, or empty.
  std::string remark;
  std::optional<double> euler;  ///< of the strut beside it, if it is one [1]
  /// It reaches through a slide into another body: it decides, too.
  bool strut_is_longer = false;
  /// If all that joints hold of the part counts, where that is more than
  /// balance needs and the band goes on to it [1].
  std::optional<double> if_all_hold = {};

  /// Whether anything is: a factor, or why there is none.
  bool is_known() const { return factor || !remark.empty(); }
  /// Whether no factor below it was found.
  bool is_lower_bound() const {
    return factor && *factor > 0.0 && band_low == band_high;
  }
  /// Whether Euler's strut falls short of the factor wanted [1] where it
  /// decides: without finite elements, or longer than the part.
  bool euler_fails(double wanted) const {
    return (!factor || strut_is_longer) && euler && *euler < wanted;
  }
};

/// How far the displacements are from small ones.
struct FiniteMotion {
  double rotation{};  ///< largest of a piece of the part [rad]
  double strain{};    ///< largest principal, by its amount [1]
  std::string label;  ///< when: "t = 1.25 s" or the case
};

/// Beam theory of the same load history.
struct BeamComparison {
  /// Governing of all beam and lug formulas; absent: none applies [Pa].
  std::optional<double> peak_stress;
  std::string
      governing;  ///< "axial + bending, C-B at 30 mm", "lug E net section"
  bool is_section = false;  ///< nominal stress of a section between pins
  double deflection{};      ///< [m]
  /// Euler load over axial force; absent: the part is not in pressure [1].
  std::optional<double> buckling_safety;
  std::optional<double> ratio_fe_to_beam;  ///< peak stresses [1]
  std::string reason;  ///< why the ratio leaves 0.8–1.25, or empty
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

/// Largest nominal stress of a plane face that holds the part, as the section
/// of a bar (stress::support_faces), over the instants.
struct SupportStress {
  double value{};                  ///< [Pa]
  double band_low{}, band_high{};  ///< [Pa]
  std::string section;             ///< "root", "left + right"
  double instant{};                ///< [s]
  std::string label;               ///< "t = 1.25 s" or the case
};

/// Models of a blow, in the order of a table.
enum class ImpactModel {
  kBeamPublished,
  kBeamCorrected,
  kBeamMovingAlong,    ///< corrected, with the bar's mass
  kStaticTimesFactor,  ///< elements at rest
  kElementsInTime
};

/// Result of one model of a blow; absent: the model has no such quantity.
struct ImpactRow {
  ImpactModel model{};
  std::string scheme{};             ///< of elements in time: "29 shapes"
  std::optional<int> degree{};      ///< of elements
  std::optional<double> stress{};   ///< where the part is judged [Pa]
  std::optional<double> nominal{};  ///< of the root section [Pa]
  double face{};  ///< way of the struck face, along the blow [m]
  std::optional<double> deflection{};  ///< largest of the part [m]
  std::optional<double> error{};       ///< estimated, of the stress [1]
  double seconds{};
  /// Nominal stress over that of the dynamic FE [1].
  std::optional<double> ratio{};
  std::string remark{};  ///< "unsafe by 12 %: …"
};

/// The model in words: "beam, corrected", "dynamic elements, 29 shapes, p = 3".
std::string model_name(const ImpactRow& row);

/// Stress of a blow by shorter and shorter wave fronts, the last as short as
/// the mesh resolves.
struct WaveFrontRefinement {
  std::vector<double> fronts;      ///< that waves are damped below [s]
  std::vector<double> stress;      ///< judged, by each [Pa]
  std::vector<double> deflection;  ///< largest of the part [m]
  double below{}, above{};         ///< error left of the last stress [1]
  /// Likewise of the nominal stress of the held faces [1].
  double root_below{}, root_above{};
  bool settles = true;  ///< the stress
  int degree{};         ///< of the elements
  /// Time of another sample whose stress may exceed the peak with shorter
  /// fronts [s], and its stress by each front [Pa]; empty: there is none.
  double competing_time{};
  std::vector<double> competing_stress;
};

/// A blow on a part by all models.
struct ImpactResult {
  std::string name;
  std::string source;                  ///< "given", "contact touch"
  double mass{}, speed{}, force{};     ///< of the striker [kg], [m/s], [N]
  double stiffness{}, exponent = 1.0;  ///< of the contact
  bool is_ideal = false;               ///< that spring stands for none
  double looked_for{};                 ///< later peaks, until then [s]
  /// Largest after the time that is judged over the largest in it, by few
  /// shapes; in the bands [1].
  double later_stress = 1.0, later_deflection = 1.0, later_root = 1.0;
  /// Relative scatter of a bouncing striker's peaks under the mass variation,
  /// largest over least less 1; in the bands; 0: insensitive [1].
  double spread{};
  /// Bound of the free vibration over the largest until `looked_for`; absent:
  /// the part has damping, or the striker presses on [1].
  std::optional<double> free_vibration_stress, free_vibration_deflection;
  bool is_cut = false;    ///< its given duration ends while the striker presses
  double part_mass{};     ///< [kg]
  double first_period{};  ///< of the part's vibration along the blow [s]
  bool is_axial = false;  ///< along a rod
  double load_duration{}, rise_time{};       ///< of the contact's force [s]
  double peak_force{};                       ///< of the contact [N]
  std::optional<double> beam_factor;         ///< of the corrected beam [1]
  double dynamic_factor{};                   ///< dynamic over static FE [1]
  double stress{}, band_low{}, band_high{};  ///< by the dynamic FE [Pa]
  std::optional<SupportStress>
      root;             ///< of the held faces, where they are plane
  double deflection{};  ///< largest of the part over all times [m]
  double deflection_low{}, deflection_high{};               ///< its band [m]
  Eigen::Vector3d deflection_at = Eigen::Vector3d::Zero();  ///< in L [m]
  double deflection_time{};                                 ///< [s]
  double safety_factor{};                                   ///< yield / stress
  std::string reason;              ///< of the route in time
  WaveFrontRefinement refinement;  ///< empty: the blow is soft
  std::vector<ImpactRow> rows;
};

/// Duration of an impact of the mechanism over the period of a part.
struct DurationRatio {
  std::string impact;      ///< "stop, upper at 0.31 s"
  double duration{};       ///< of its force [s]
  double rise_time{};      ///< [s]
  double first_period{};   ///< of the part [s]
  double ratio{};          ///< duration over the first period [1]
  double amplification{};  ///< of one mode by a half sine as long [1]
  std::string treatment;   ///< "quasi-static", …
};

/// Dynamic peak over the motion of a part's body.
struct VibrationResult {
  /// Dynamic over quasi-static peak; absent: not computed [1].
  std::optional<double> ratio;
  bool governs{};            ///< other loads of the part do not stress it more
  std::string failure;       ///< why it could not be, though it was wanted
  std::string not_followed;  ///< why it is known up to a time alone
  double peak{}, band_low{}, band_high{};  ///< that is judged [Pa]
  /// Largest stress of its loads at rest [Pa], and by how much the degree
  /// before has another [1].
  double still{}, still_error{};
  /// Of the ratio: the last degree's change, the last doubling of the shapes',
  /// between samples, between the instants of the loads [1].
  double degree_error{}, shape_error{}, sampling_error{}, path_error{};
  Eigen::Vector3d at = Eigen::Vector3d::Zero();  ///< in L [m]
  std::string group;
  double time{};        ///< of the dynamic peak [s]
  double from{}, to{};  ///< looked at closely [s]
  double deflection{};  ///< relative to the pins [m]
  std::string model;    ///< "plane stress, p = 4"
  int shapes{};
  double lowest_frequency{}, highest_frequency{};  ///< of them [Hz]
  double seconds{};

  /// Sum of the errors of the ratio [1].
  double error() const {
    return degree_error + shape_error + sampling_error + path_error;
  }
  /// Whether it is known over all the motion.
  bool is_whole() const { return failure.empty() && not_followed.empty(); }
};

/// How much farther than at rest a part goes as it vibrates under a load set.
struct Swing {
  double stress = 1.0, deflection = 1.0;  ///< at least 1 [1]

  /// Of both [1].
  double largest() const { return std::max(stress, deflection); }
};

/// Stress and displacement where the part's stresses and its spin act on what
/// they displace, with its vibration; of the loads that were solved for: of the
/// instant of each load set that may rise to most, and of all that may decide a
/// limit, with what lies between these and the next.
struct SecondOrderResult {
  bool is_stable = true;  ///< else it buckles, or whirls, under less
  /// Whether it bears as many times its loads, with the spin that they come
  /// from, as the limit of buckling wants; of parts whose spin counts.
  bool bears_growth = true;
  /// Largest [Pa]; 0: at no instant is it more than by linear theory.
  double peak{};
  double stress = 1.0;  ///< over linear theory's at that time [1]
  std::string label;    ///< of the peak
  /// Largest where it rises, as `peak` [m].
  double deflection{};
  double deflection_rise = 1.0;  ///< over linear theory's then [1]
  /// At least, of loads that do not vibrate [Pa], [m].
  double least_peak{}, least_deflection{};
  /// Of what was not solved for, though it may decide: at most [Pa], [m].
  double bound{}, deflection_bound{};
  std::string failure;  ///< why it is not known, though it may decide
};

/// Reaction on the part of a pin that holds it in a case.
struct PinReaction {
  std::string label;                                ///< of the case
  std::string group;                                ///< its bore
  Eigen::Vector3d force = Eigen::Vector3d::Zero();  ///< in L [N]
  /// About the middle of the bore [N m].
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
  bool unique = true;  ///< balance alone determines it
};

struct PartSeconds {
  double mesh{}, choose{}, assemble{}, factor{}, solve{}, recover{}, write{};
  double total{};
};

struct PartResult;

/// The peak that limits and beam theory are compared with: away from the
/// singular zones where one governs.
const PeakStress& judged_peak(const PartResult& result);

/// All that is known of a part after the check.
struct PartResult {
  std::string name;
  part::Verdict verdict{};
  std::string why;         ///< one line: limit and value, or why not judged
  std::string model;       ///< "plane stress, p = 4"
  std::string engine;      ///< who solved it: "own" or "dealii"
  std::string engine_why;  ///< one line; empty: there was no choice
  std::string stopped_because;  ///< why the ladder went no further
  /// Remarks for the user that decide nothing, a line each.
  std::vector<std::string> notes;
  int dofs{}, cells{}, load_columns{};
  PeakStress peak;
  std::vector<ZoneResult> singular_zones;
  /// Where a zone governs: the peak away from those that do.
  std::optional<PeakStress> peak_outside;
  std::optional<SupportStress> held;  ///< where a plane face holds the part
  double safety_factor{};             ///< yield / peak
  double deflection{};                ///< relative to its pins [m]
  double deflection_low{}, deflection_high{};  ///< its band [m]
  Eigen::Vector3d deflection_at = Eigen::Vector3d::Zero();
  double deflection_instant{};               ///< [s]
  std::string deflection_label;              ///< of that instant, or the case
  std::size_t deflection_set{};              ///< load set of it
  double strain_energy{};                    ///< largest over the instants [J]
  double strain_energy_instant{};            ///< when it is largest [s]
  std::optional<double> mean_strain_energy;  ///< over the motion's time [J]
  /// Over the strain energy at the worst instant, by its last three degrees;
  /// absent: fewer stand at one instant [1].
  std::optional<double> strain_energy_error;
  BucklingResult buckling;
  SecondOrderResult second_order;
  FiniteMotion finite_motion;
  BeamComparison beam;
  SelfChecks self_checks;
  std::vector<ProbeResult> probes;
  PartSeconds seconds;
  double mass{};  ///< [kg]
  /// Of the free or held part, whether loads excite it or not [s].
  std::optional<double> first_period;
  std::vector<ImpactResult> impacts;
  std::vector<DurationRatio> duration_ratios;
  VibrationResult vibration;
  std::vector<Swing> swings;  ///< by load set; empty: nothing vibrates
  std::vector<PinReaction> pin_reactions;
};

}  // namespace clevis::assessment

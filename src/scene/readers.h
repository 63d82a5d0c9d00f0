#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <vector>

#include "machine/bearing.h"
#include "machine/ejector.h"
#include "machine/transmission.h"
#include "mechanism/definition/definition.h"
#include "part/part_definition.h"
#include "part/supports.h"
#include "scene/name_index.h"
#include "scene/strict_table.h"

namespace clevis::scene {

/// Names of the entities that other tables refer to, as far as they are read.
struct Names {
  NameIndex materials{"material"};
  NameIndex parts{"part"};
  NameIndex bodies{"body"};
  NameIndex joints{"joint"};
  NameIndex couplings{"coupling"};
  NameIndex drives{"driven joint"};  ///< by the joint's name
  NameIndex forces{"force"};
  NameIndex markers{"marker"};
  NameIndex bearings{"bearing"};
  NameIndex transmissions{"transmission"};
  NameIndex ejectors{"ejector"};
};

// Each reads its array of tables from the root of the scene, in this order:
// a body may name a part, a joint its bodies, a drive its joint. All throw
// Error S002–S011; K006 for a body without mass.
std::vector<mechanism::BodyDefinition> read_bodies(StrictTable& root,
                                                   Names& names);
std::vector<mechanism::JointDefinition> read_joints(
    StrictTable& root, const std::vector<mechanism::BodyDefinition>& bodies,
    Names& names);
std::vector<mechanism::CouplingDefinition> read_couplings(
    StrictTable& root, const std::vector<mechanism::JointDefinition>& joints,
    Names& names);
std::vector<mechanism::DriveDefinition> read_drives(
    StrictTable& root, const std::vector<mechanism::JointDefinition>& joints,
    Names& names);
/// The law that a coordinate follows, of a drive or a servo: `law` and its
/// keys.
void read_drive_law(StrictTable& table, Dimension coordinate,
                    mechanism::DriveDefinition& drive);
/// Adds the [[force]] tables to a mechanism that has its joints.
void read_forces(StrictTable& root, Names& names,
                 mechanism::MechanismDefinition& mechanism);

enum class ElementType {
  kConstant,
  kSpring,
  kFriction,
  kStop,
  kTable,
  kContact,
  kImpedance,
  kGasCylinder,
  kMotor,
  kServo
};
/// A force that depends on the motion. @pre not kConstant.
mechanism::ForceElement read_element(
    ElementType type, const std::string& name, StrictTable& table,
    const std::vector<mechanism::JointDefinition>& joints, const Names& names);
std::vector<mechanism::MarkerDefinition> read_markers(StrictTable& root,
                                                      Names& names);
/// Adds the [[initial]] tables to a mechanism that has its joints.
void read_initial_states(StrictTable& root, Names& names,
                         mechanism::MechanismDefinition& mechanism);
/// The [[bearing]] tables; a joint that turns about one axis each.
std::vector<machine::BearingDefinition> read_bearings(
    StrictTable& root, const std::vector<mechanism::JointDefinition>& joints,
    Names& names);
/// The [[transmission]] tables, which need no mechanism.
std::vector<machine::TransmissionDefinition> read_transmissions(
    StrictTable& root, Names& names);
/// The [[ejector]] tables, which need no mechanism.
std::vector<machine::EjectorDefinition> read_ejectors(
    StrictTable& root, const std::vector<part::Material>& materials,
    Names& names);
/// An element of a stage. @throws Error S010 if it turns where the stage does
/// not, or the other way round.
machine::CompliantElement read_compliance(StrictTable& table, bool angular);
mechanism::SimulationSettings read_simulation(StrictTable table);

std::vector<part::Material> read_materials(StrictTable& root, Names& names);

/// A part without its seats, which need the mechanism.
/// @param file  the scene's, which the part's paths are relative to.
part::PartDefinition read_part(StrictTable& table, const Names& names,
                               const std::vector<part::Material>& materials,
                               const std::filesystem::path& file);

/// The part's `pins`, `drives` and `forces`, checked against the body that it
/// moves with: each of the body's joints and drives needs its seat.
void read_seats(StrictTable& table,
                const mechanism::MechanismDefinition& mechanism,
                const Names& names, part::PartDefinition& part);

/// The part's `forces`; those on its body without one are refused when the
/// part is checked.
void read_force_seats(StrictTable& table, mechanism::BodyIndex body,
                      const mechanism::MechanismDefinition& mechanism,
                      const Names& names, part::PartDefinition& part);

/// Refuses names by which two parts, or a part and the assembly, would write
/// files of the same name. @throws Error S008.
void require_own_files(std::vector<StrictTable>& tables,
                       const mechanism::MechanismDefinition& mechanism,
                       const std::vector<part::PartDefinition>& parts);

part::LoadCaseDefinition read_case(StrictTable table);
/// `fixed` of a case or an impact; empty without.
part::Supports read_fixed(StrictTable& table);

/// An [[impact]] that is read but for its contact's spring, which needs the
/// part.
struct ImpactOfPart {
  int part{};  ///< index
  StrictTable table;
  part::ImpactDefinition impact{};
};
std::vector<ImpactOfPart> read_impacts(
    StrictTable& root, const mechanism::MechanismDefinition& mechanism,
    Names& names);
/// Gives the part with this index its impacts.
void add_impacts(std::vector<ImpactOfPart>& impacts, int index,
                 part::PartDefinition& part);

/// The origins and axes of a joint apart, what its type needs besides: lead,
/// length, compliance.
void read_joint_properties(StrictTable& table,
                           const std::vector<mechanism::BodyDefinition>& bodies,
                           mechanism::JointDefinition& joint);

/// Index of the coordinate that `value` names. @throws Error S009.
int find_coordinate(const Value& value,
                    const mechanism::JointDefinition& joint);

/// Whether two equal times may follow one another, as a step between them.
enum class Steps { kRefused, kAllowed };

/// @param least  0 or 2. @throws Error S006 unless that many increase.
std::vector<double> increasing_times(const Value& times, std::size_t least,
                                     Steps steps = Steps::kRefused);
/// `ends` of a spline, or clamped.
numerics::SplineEnds read_spline_ends(StrictTable& table);

/// Index of a body, kGround for "ground". @throws Error S005, S007.
mechanism::BodyIndex find_body_or_ground(const Value& name, const Names& names);

}  // namespace clevis::scene

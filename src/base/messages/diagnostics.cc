#include "base/messages/diagnostics.h"

#include <algorithm>
#include <array>

namespace clevis {
namespace {

using enum ExitCode;

// Letters: B bearings and transmissions (remarks, no refusals), F elasticity, I
// files, K mechanism, L loads, M mesh, R regression, S scene, U command line, X
// internal. Keep sorted by code.
constexpr auto kCatalogue = std::to_array<Diagnostic>({
    {"B001", kLimitExceeded, "static load of a bearing above its rating",
     "The largest static equivalent load P0 of the motion is above the "
     "catalogue's C0: rolling bodies leave dents. The bearing fails if "
     "C0 / P0 is below static_safety_wanted (1). Take a larger bearing."},
    {"B002", kNotJudged, "axial load without its factors",
     "The joint carries a load along its axis, but the bearing has no factors "
     "X, Y, e (life) or X0, Y0 (static check): the load is left out and the "
     "bearing cannot pass. Give the catalogue's factors."},
    {"B003", kNotJudged, "bearing does not turn",
     "Its joint moves by no angle, so a life in revolutions means nothing; "
     "only the static check counts and the bearing may pass by it."},
    {"B004", kNotJudged, "bearing load beyond the range of the life formula",
     "ISO 281 leaves the life to the maker where P is above C0 or C/2, the "
     "lesser of both. The number is printed; where a life is wanted the "
     "bearing cannot pass by it."},
    {"B005", kNotJudged, "moment across the axis of a bearing",
     "The joint carries a moment that tilts the bearing: the load acts beside "
     "it by more than half its width (any offset, if no width is given). "
     "Equivalent loads know no such moment, so the bearing cannot pass. Put "
     "the joint's point into the middle of the bearing, or take a pair."},
    {"B006", kNotJudged, "bearing load is not unique",
     "Equilibrium leaves the force of the joint open (redundant constraints). "
     "The joints' compliance shares it; give the joints their own to make it "
     "physical."},
    {"B007", kNotJudged, "force of teeth not in the bearing's load",
     "A [[coupling]] acts on the angle of the bearing's joint. Couplings pass "
     "torques on, not the force between the teeth, which presses the shafts "
     "apart: the bearing carries more than is told and cannot pass."},
    {"B008", kNotJudged, "turning between instants is not followed",
     "The way that the joint turns is summed from its speed at the instants, "
     "and its angle says something else: it turns back, or whole turns on, "
     "between two. Life and way are not judged; give more `instants` in "
     "[simulation]."},
    {"B009", kNotJudged, "ratings of a bearing that do not fit one another",
     "Rolling bearings have a dynamic rating C of 0.3 to 3 times their static "
     "rating C0. Outside 0.1 to 10 one of the two has a wrong unit or digit: "
     "see the catalogue. The bearing cannot pass."},
    {"F001", kModelInvalid, "free rigid mode",
     "The supports of a case leave the part free to move as a rigid body, and "
     "a linear solver would return a meaningless displacement. Hold the named "
     "mode with `fixed`, or leave `fixed` out: a balanced part needs none."},
    {"F002", kSolverFailed, "factorisation failed",
     "The stiffness matrix is not positive definite or holds non-finite "
     "entries. Look at the mesh quality and at the material constants."},
    {"F003", kSolverFailed, "self-check failed",
     "A check that runs on every solve (residual, equilibrium, energy, finite "
     "values, reported peak = field maximum) was breached, so no verdict is "
     "given. Please report the scene: this should not happen."},
    {"F004", kResourceLimit, "memory forecast above the machine's",
     "The factorisation would need more memory than the machine has. Mesh the "
     "part coarser."},
    {"F005", kModelInvalid, "model or engine does not fit the part",
     "The model that --model or the engine that --engine asks for does not "
     "suit "
     "the part, its loads or its supports; the message says why, `clevis check "
     "--help` what each model suits. deal.II solves plane stress and 3-D of "
     "quadrangles and hexahedra. Beds (`foundation`) are known to 3-D only, "
     "and not to CalculiX. "
     "Leave the option out: clevis takes the cheapest that suits."},
    {"F006", kModelInvalid, "strike cannot be computed",
     "A striker needs a mass, a speed or a force towards the part, and a "
     "contact spring with a stiffness above zero. A Hertz contact (exponent "
     "1.5) cannot be bilateral."},
    {"F007", kResourceLimit, "more degrees of freedom than --max-dofs",
     "The first solution that the part needs has more degrees of freedom than "
     "--max-dofs allows. Higher degrees and finer meshes than it allows are "
     "left out and the result says so; without the first there is none. Give "
     "a larger number, leave the option out, or mesh the part coarser."},
    {"I001", kIo, "cannot read file",
     "The file does not exist, is a folder or device, or may not be read. "
     "Paths in a scene are "
     "relative to the scene file; meshes of a scene in geometry/NAME are "
     "looked for in meshes/NAME too."},
    {"I002", kIo, "cannot write file",
     "The output could not be written: check that the folder exists, that it "
     "may be written and that the disk is not full."},
    {"I003", kIo, "result file is damaged",
     "The file is not JSON, or a key that docs/result.schema.json requires is "
     "absent or has another type. Run `clevis check` again, or restore the "
     "baseline from version control."},
    {"I004", kIo, "CalculiX's answer cannot be read",
     "`clevis study` runs ccx on a deck that it writes; ccx failed, took too "
     "long or its .frd file is not whole. The study goes on without it. "
     "`clevis export` writes the deck for a run by hand."},
    {"I005", kIo, "folder is not empty",
     "`clevis init` writes into a new folder or an empty one, so that nothing "
     "of yours is overwritten."},
    {"I006", kIo, "folder in use",
     "Another clevis is writing its results into the same folder: their files "
     "would mix. Wait until it has ended, or give another --out; `check "
     "--watch` waits by itself, up to 10 minutes. The lock goes with its "
     "process, however that ends; the empty file .lock may stay."},
    {"I007", kIo, "no plan",
     "`clevis collect` reads the variants that are expected from plan.json, "
     "which `clevis plan` writes into the folder. Give that folder, or plan "
     "again."},
    {"I008", kIo, "folder is no result that can be shown",
     "The folder holds neither the result.json of a check nor the "
     "simulate.json of a simulation, or those of another version of clevis, "
     "or lacks files of its folder `view` that belong to them. Run the command "
     "again and report its folder as it stands. `clevis picture` draws checks: "
     "of a mechanism whose parts move, or with --part one part."},
    {"K001", kModelInvalid, "mechanism does not assemble",
     "No position of the bodies satisfies all joints and drives at the start: "
     "lengths break a loop, or the approximate placement is too far off. The "
     "message lists the joints that stay open and by how much; what is allowed "
     "is `tolerance` of [simulation], 1e-8, times the mechanism's size. Along "
     "pins the points in `at` around a loop must meet at one height."},
    {"K002", kModelInvalid, "under-driven mechanism",
     "The scene asks for a motion that the drives fix, but they leave degrees "
     "of freedom unprescribed. Add a drive on one of the named joints, or "
     "leave simulation.motion out: forces then decide the free coordinates."},
    {"K003", kModelInvalid, "over-driven mechanism",
     "More independent drives than degrees of freedom: they contradict each "
     "other. Remove one of the named drives."},
    {"K004", kModelInvalid, "motion cannot be continued",
     "During the motion the closure equations stopped having a solution near "
     "the last one: the drive runs past a dead centre or a link is too short. "
     "Reduce the range of the drive or change the lengths."},
    {"K005", kModelInvalid, "change point",
     "At the named instant the constraint Jacobian loses rank: the position "
     "branch is not determined and rigid reactions are unbounded. Keep away "
     "from the change point or choose at_singularity."},
    {"K006", kModelInvalid, "massless body must carry inertia",
     "The body has neither a part nor a mass. Give it mass, center_of_mass "
     "and inertia, or a part. Of a motion that is integrated no body may be "
     "lighter than 1e-12 of the heaviest: double precision cannot solve it."},
    {"K007", kModelInvalid, "initial velocities contradict the joints",
     "No velocity satisfies all joints, drives and the rates in [[initial]]. "
     "Give as many rates as the mechanism has free coordinates, or fewer."},
    {"K008", kSolverFailed, "motion cannot be integrated",
     "No step of the integration is short enough for the tolerance: a force "
     "grows without bound or jumps in every step. Look for stiffnesses, "
     "masses or lengths of a wrong order of size."},
    {"K009", kModelInvalid, "gas chamber without volume",
     "At the start of the motion the piston stands where the chamber's volume "
     "is zero or less: dead_volume at the coordinate origin, area times travel "
     "from there. Give the origin, or a larger dead volume."},
    {"K010", kModelInvalid, "start at a change point that no rate decides",
     "The motion starts where branches of positions meet, and the rates given "
     "fit several of them or none that leads on. Give [[initial]] rates that "
     "single one out, or start a thousandth of a radian beside the change "
     "point on the branch "
     "that is meant."},
    {"K011", kModelInvalid, "friction that follows the reaction has no answer",
     "Friction proportional to the reaction of its joint changes that reaction "
     "by as much as itself: the joint jams, and rigid bodies have no answer, "
     "or several. Or equilibrium leaves the reaction open, or teeth load the "
     "joint whose force the motion does not know. Reduce the "
     "coefficient or the pin radius, or remove redundant constraints."},
    {"K012", kSolverFailed, "energy does not balance",
     "Kinetic energy and the work of all forces of an integrated motion differ "
     "by more than a hundredth of the largest of them (or 100 times the "
     "tolerance). Its positions are wrong. Ask for a stricter tolerance, or "
     "correct lengths, masses and forces of a wrong order of size."},
    {"K013", kResourceLimit, "motion takes too long",
     "It has used more processor time than --max-time allows (60 s by "
     "default), "
     "or its integration would by a hundred times. Of an integrated motion the "
     "message names the body and the force that are fastest: a stiffness, mass "
     "or length of a wrong order of size there makes every step short. Where "
     "the forecast is below 20 times the limit it names a --max-time that "
     "should do. One that the drives fix takes as long as it has instants, and "
     "those that are added where loads are largest: ask for fewer, for a "
     "shorter motion, or for more --max-time."},
    {"L001", kModelInvalid, "unbalanced load on a free part",
     "Forces, moments and inertia of a part that nothing holds do not cancel. "
     "A linear static solve would hide the residual in arbitrary supports. "
     "Give the missing load, or hold the part with `fixed`."},
    {"L002", kModelInvalid, "pin force cannot be carried by its bore",
     "The load on the group has a component that its surface cannot take. Of a "
     "bore with a keyway or a slot the wall that is there carries the pin, as "
     "long as that presses no more than twice as hard as on a whole wall; a "
     "wall that is open where the pin pulls carries nothing."},
    {"L003", kModelInvalid, "bore and joint do not coincide",
     "A pin's bore in the part's mesh lies elsewhere than the joint in the "
     "mechanism: the lengths in the scene and in the geometry disagree by more "
     "than a thousandth of the bore's diameter. The message tells by how much, "
     "and the numbers that would fit."},
    {"L004", kModelInvalid, "load without a seat on the part",
     "A joint, drive or force acts on the body of a part, but no group of its "
     "mesh takes it, or a seat names one that is not on the body. The part "
     "would be checked with other loads than the mechanism has. Add pins, "
     "drives or forces = { NAME = { face = \"GROUP\" } } to the part."},
    {"L005", kModelInvalid, "probe outside the part",
     "A probe's point lies in no cell of the part's mesh. Points are given in "
     "the part's frame, the mesh's own."},
    {"L006", kModelInvalid, "impact that does not happen",
     "An [[impact]] takes its striker from a contact of the mechanism that is "
     "never touched in the motion, or whose bodies are held by drives so that "
     "they weigh nothing that could be said. Give mass and speed instead."},
    {"L007", kModelInvalid, "contact that slides or rolls is not known",
     "A joint that slides presses only where the counterpart is: spread over "
     "the whole wall its load would be too kind. Give the length of what "
     "touches, pins = { JOINT = { group = \"GROUP\", length = \"20 mm\" } }, "
     "or a part on the other body whose own pin names the joint. Or the "
     "counterpart leaves the wall, or presses where the part has none. A "
     "force that travels over its face, as a wheel's on a rail, has no such "
     "length: let a body that slides on the part take it."},
    {"M001", kMeshInvalid, "not a gmsh mesh",
     "The file does not start with $MeshFormat, so it is not read. gmsh would "
     "run unknown text as a script; clevis never does. Give a .msh of version "
     "2.2 or 4.1."},
    {"M002", kMeshInvalid, "mesh file is damaged",
     "The file ends early or holds something other than its header promises. "
     "Export it again."},
    {"M003", kMeshInvalid, "physical group not found",
     "A group that the scene names is not in the mesh. The message lists the "
     "groups there are. Names are the $PhysicalNames of the .msh."},
    {"M004", kMeshInvalid, "non-finite coordinate",
     "A node has NaN or Inf as a coordinate."},
    {"M005", kMeshInvalid, "inverted or degenerate cell",
     "The Jacobian determinant of the mapped cell is not positive at every "
     "quadrature point: the cell is turned inside out or folded. Or the cell "
     "is a needle: flat to 1e-5, or 5000 times as long as across."},
    {"M006", kMeshInvalid, "mesh is not one connected body",
     "The cells fall into several pieces that share no face. Delete the loose "
     "piece or merge coincident nodes."},
    {"M007", kMeshInvalid, "implausible size",
     "The part is smaller than 10 µm or larger than 100 m, or thinner than "
     "1 µm or a millionth of its size: check length_unit and thickness."},
    {"M008", kMeshInvalid, "unsupported cells",
     "clevis takes hexahedra (orders 1-4) or tetrahedra (orders 1-2), and for "
     "a plate with `thickness` quadrangles (orders 1-4) or triangles (orders "
     "1-2); no mix, no shells, pyramids or prisms."},
    {"M009", kMeshInvalid, "bore is not a cylinder",
     "Groups named bore_* and round_* are exact circular cylinders by "
     "definition, but the nodes of the group do not lie on one. Name the "
     "group differently if it is not round."},
    {"M010", kMeshInvalid, "mesher failed",
     "gmsh or OpenCASCADE could not read or mesh the geometry, or took too "
     "much "
     "time (gmsh and the mesher of CAD files get 120 s by the clock) or "
     "memory; the message says which."},
    {"M011", kMeshInvalid, "mesh is out of date",
     "The mesh was made from another version of the geometry, or with other "
     "parameters. Run `clevis mesh SCENE`, with the same --set, or `clevis "
     "check` with --mesh."},
    {"M012", kMeshInvalid, "surface in two groups",
     "A face belongs to two named physical groups, so that a load on one "
     "would be a load on the other too. Let every surface be in one named "
     "group at most."},
    {"M013", kMeshInvalid, "thickness does not fit the mesh",
     "A part with `thickness` is a plate whose mesh holds its mid-plane: "
     "triangles or quadrangles in a plane z = const, and it is no thicker than "
     "it is wide. A mesh with volume cells has its thickness in itself."},
    {"M014", kMeshInvalid, "cell twice",
     "Two elements have the same nodes, in one physical group or in another "
     "order: the part would be twice as stiff and heavy there. The same "
     "element in several groups is one. Mesh every volume once."},
    {"M015", kMeshInvalid, "no CAD file",
     "A part's `geometry` that ends in .step, .stp, .iges, .igs or .brep must "
     "begin as such a file does; a script under such a name is not run, and "
     "nothing above 256 MiB is read. Export it again, or name it .geo."},
    {"M016", kMeshInvalid, "not one sound solid",
     "A part is one solid whose closed surface does not cut itself: no "
     "assembly, no open shell, no loose surface. The message says what is "
     "found where, in millimetres of the file's frame."},
    {"M017", kMeshInvalid, "faces not found, or several that might be meant",
     "No face of the solid, or faces of more than one cylinder or plane, fit "
     "what a joint or a selector asks for, or `clevis init --geometry` finds "
     "nothing to hold and pull a part by. `clevis faces FILE` lists all faces. "
     "Give a diameter, a point nearby (`near`) or another selector."},
    {"R001", kRegression, "regression against the baseline",
     "At least one quantity moved by more than its tolerance."},
    {"R002", kUsage, "result and baseline do not match",
     "The two files are not results of the same scene, or the schema "
     "differs."},
    {"R003", kNotJudged, "variant without a result",
     "The plan has a variant whose folder holds no result, an unfinished one, "
     "one of other inputs or a damaged file. Run its command of the plan: what "
     "is finished is skipped."},
    {"S001", kSceneInvalid, "scene is not valid TOML",
     "The text could not be parsed at the given place, or is no scene but the "
     "file of another program. Texts, and numbers with a unit, stand in double "
     "quotes; other numbers have a decimal point."},
    {"S002", kSceneInvalid, "unknown key",
     "The key is not part of the scene format. A silent typo would change "
     "the model, so it is refused; the nearest known name is given."},
    {"S003", kSceneInvalid, "missing key",
     "A required key is absent: clevis has no silent default for a physical "
     "quantity."},
    {"S004", kSceneInvalid, "missing or wrong unit",
     "Every dimensional value is a string with its unit, e.g. \"140 mm\"; the "
     "unit must have the dimension that the key needs."},
    {"S005", kSceneInvalid, "wrong type",
     "The value has another type than the key needs."},
    {"S006", kSceneInvalid, "value out of range",
     "The number is not finite or outside the range that makes sense for "
     "this key."},
    {"S007", kSceneInvalid, "unknown name",
     "A body, joint, part, material or drive is referred to that the scene "
     "does not define; the nearest defined name is given."},
    {"S008", kSceneInvalid, "duplicate name",
     "Two entities of the same kind have the same name, or two parts would "
     "write files of the same name."},
    {"S009", kSceneInvalid, "unknown choice",
     "The value is none of the choices of this key."},
    {"S010", kSceneInvalid, "keys contradict each other",
     "Two keys of the same table cannot be given together."},
    {"S011", kSceneInvalid, "implausible value",
     "The value has the right dimension but a size that no real part has, "
     "e.g. a Young's modulus outside 0.01-1200 GPa: the unit is likely "
     "wrong."},
    {"S012", kSceneInvalid, "table of variants or loads is not valid",
     "The CSV of `clevis plan --vary` has a header of paths and a row for each "
     "variant, every row with as many fields as the header and none empty "
     "(RFC 4180: commas between columns, fields with commas or quotes in "
     "double "
     "quotes). The file of a [[part.history]] likewise: a header of titles "
     "with units, and a row "
     "for each time."},
    {"S013", kSceneInvalid, "no SDF or URDF file",
     "`clevis import` reads XML whose root is <sdf> or <robot>, up to 16 MiB. "
     "A script under such a name is not run; a xacro file must be expanded "
     "first."},
    {"S014", kSceneInvalid, "model refused by its reader",
     "The XML is damaged, or libsdformat or liburdfdom refuses what it says, "
     "or reading took too much time or memory; the message says which. What "
     "<include> names is never opened: write it into the file."},
    {"S015", kSceneInvalid, "model that no scene can hold",
     "A link that moves by itself has no mass or no possible inertia, a number "
     "is not finite, nothing in the model moves, or it has more than 4000 "
     "links, joints, frames and models."},
    {"U001", kUsage, "wrong command line", "See clevis --help."},
    {"U002", kUsage, "unknown diagnostic code",
     "The catalogue has no such code; `clevis explain` lists all."},
    {"X001", kInternal, "internal error",
     "clevis itself is at fault. Please report it with the scene."},
    {"X002", kResourceLimit, "the system's memory or processes ran out",
     "The system, a container or a limit of the shell (ulimit) gave no more "
     "memory, processes or processor time, or it ended a process for them. "
     "Free "
     "some, raise the limit, or solve fewer parts at once (--jobs 1)."},
});

}  // namespace

std::span<const Diagnostic> diagnostics() {
  return kCatalogue;
}

const Diagnostic& find_diagnostic(std::string_view code) {
  const auto found = std::ranges::find(kCatalogue, code, &Diagnostic::code);
  return found != kCatalogue.end() ? *found : find_diagnostic("X001");
}

}  // namespace clevis

"""Modules and rooms: who may include whom, and which headers are public.
docs/architecture.md says the same in words."""

LAYERS = {  # module: (modules it may include, outside libraries it may include)
    "base": ("", "Eigen fmt udunits2"),
    "numerics": ("base", "Eigen"),
    "part": ("base", "Eigen fmt"),
    "cad": ("base part", "Eigen fmt nlohmann"),
    "mesher": ("base part cad", "Eigen fmt gmsh"),
    "multibody": ("base", "Eigen fmt nlohmann"),
    "importer": ("base multibody", "Eigen fmt"),
    "mechanism": ("base numerics part", "Eigen fmt"),
    "machine": ("base part mechanism", "Eigen fmt"),
    "scene": ("base numerics part mechanism machine", "Eigen fmt toml"),
    "mesh": ("base part", "Eigen fmt"),
    "loads": ("base part mechanism", "Eigen fmt"),
    "dynamics": ("base loads", "Eigen fmt"),
    "beam": ("base part machine mesh loads", "Eigen fmt"),
    "elasticity": ("base part mesh loads dynamics", "deal.II petsc Eigen fmt"),
    "calculix": ("base part mesh loads elasticity", "Eigen fmt"),
    "stress": ("base part mesh loads dynamics elasticity", "zlib Eigen fmt"),
    "assessment": ("base part mesh loads dynamics beam elasticity stress", "Eigen fmt"),
    "report": ("base part mechanism machine beam assessment", "Eigen fmt nlohmann"),
    "study": ("base part mesh loads elasticity stress assessment report",
              "Eigen fmt nlohmann"),
    "app": ("base part cad multibody mechanism machine scene mesh loads dynamics beam elasticity calculix"
            " stress assessment study report", "Eigen fmt nlohmann CLI"),
}

# Rooms of a module, bottom to top: each may include those above it in the list.
# Files beside the rooms are the module's door: they may include all.
ROOMS = {
    "base": {
        "messages": "what is wrong, where, what to do: errors, their catalogue, exit codes",
        "values": "quantities with units, indices, seconds",
        "algebra": "singular vectors of small dense matrices, and the spaces they span",
        "bytes": "base64, deflate, fingerprints",
        "system": "the process and its machine: signals, processors, memory, other programs",
    },
    "numerics": {
        "factors": "small LU, rank-revealing QR, Cholesky of normal equations",
        "curves": "splines, tables, roots in an interval",
        "integrators": "DOP853, Radau IIA, and the choice between them",
    },
    "mechanism": {
        "joints": "joint types: what each holds and leaves free, in numbers and in space",
        "drives": "prescribed coordinates over time",
        "force_laws": "scalar laws: contact, friction, gas",
        "element_base": "what force elements share: lines, modes, response to a state, ends that press",
        "line_elements": "force elements along a line, one file pair each, and their registry",
        "force_elements": "all force elements: those beside lines, and the registry",
        "definition": "a mechanism as the user wrote it, its settings, and its motion",
        "constraints": "equations of the joints: Jacobian, assembly, continuation, mobility",
        "forces": "all forces of a mechanism in a state: wrenches on bodies, states, events",
        "compliance": "joints and links that give way, and how they share reactions",
        "reactions": "inverse dynamics: reactions, friction that depends on them, power balance",
        "change_points": "positions at which the Jacobian loses rank, and the branches there",
        "structure": "links and pairs, Assur groups, structural formula",
        "sampling": "which instants are wanted; loads as lists of numbers",
        "driven_motion": "motions that drives fix, from instant to instant",
        "driven_trajectory": "such a motion at any time, and what may change there",
        "driven_loads": "its loads between instants: how smooth, and which times stand for them",
        "driven_search": "when the loads of such a motion are largest or jump",
        "mass_matrix": "masses of bodies, and the mass matrix with constraints, factored",
        "neighbours": "what a body's neighbours hold, weigh and push at its joints",
        "dynamic_state": "states that forces decide: layout, turns, drives, sizes",
        "equations_of_motion": "accelerations from forces, projection, tangents",
        "joint_space": "the same in joint coordinates (articulated bodies)",
        "events": "zeros, stick and slip, impacts and load peaks along an integration",
        "integration": "start, steps, breaks and energy of such a motion",
        "dynamic_motion": "motions that forces decide: one run from start to end",
    },
    "machine": {
        "bearings": "rolling bearings by their catalogues: load over a motion, life",
        "transmissions": "drive trains: compliance, frequencies, error",
        "devices": "machines of one kind: ejectors, the slide lever in closed form",
    },
    "scene": {
        "text": "the scene as text: values with places, tables with known keys, names",
        "motion": "bodies, joints, couplings, drives, initial states, settings",
        "element_base": "what readers of forces share: units of lines, plausible values",
        "line_elements": "forces along a line: one reader each",
        "force_elements": "the other forces, and the list of all readers",
        "machine": "bearings, transmissions, ejectors",
        "csv": "RFC 4180 tables: fields with places, columns with units",
        "cases": "what loads and holds a part: load cases, histories in files",
        "solids": "parts that are CAD solids: selectors, and what joints ask of them",
        "parts": "parts, materials, seats, impacts",
        "variants": "values in place of the scene's, and which variants are wanted",
    },
    "mesh": {
        "basis": "Lagrange bases and quadrature of cells",
        "cells": "PartMesh, its topology, sections",
        "gmsh": "the .msh format",
        "quality": "what a mesh must satisfy; mass properties",
        "rounds": "cylinders behind faces, and cells that follow them",
        "reading": "from the file to a PartMesh with exact geometry",
        "derived": "meshes made of meshes: mid-planes, meridians, graded, parts of them",
    },
    "loads": {
        "history": "loads of a part over time, the inertia in balance with them, blows",
        "pressure": "tractions of seats on walls, in balance on their quadrature points",
        "seats": "seats: where joints and forces of the scene press on a part",
        "holds": "what the rest of the mechanism holds of a part at its seats, and where its slides do",
        "parts": "loads of a part: over the motion, in its cases and histories, on pins that hold it",
    },
    "dynamics": {
        "systems": "K and M as operators, their Krylov spaces, free vibrations",
        "load_vibration": "vibration about the quasi-static answer to loads over time",
        "struck_body": "the body under a strike: contact, shapes, one step in time",
        "strike": "a strike: its duration, its steps, both sides in motion",
    },
    "beam": {
        "theory": "closed forms: struts, bars under a blow",
        "sections": "a part as a beam: sections, pins, lugs and the mass beside them",
        "estimates": "stress, deflection and blow of a part or an ejector by these",
    },
    "elasticity": {
        "engine_library": "the library of deal.II, PETSc and MPI, loaded when one of them is asked for; the ranks of a run",
        "algebra": "dense and sparse matrices",
        "fe_space": "shape functions, numbering, discretisation, traces on groups",
        "assembly": "stiffness, mass, beds, supports, equations",
        "nodal_loads": "tractions and loads as vectors of the equations",
        "lanes": "kernels over several cells at once (SIMD), threads",
        "direct": "multifrontal Cholesky: dissection, fronts, memory",
        "problem": "an elastic problem, its solution, the checks of that",
        "mirror_symmetry": "symmetric parts, solved on one side of their mirrors",
        "multigrid": "large parts without a matrix",
        "dealii_space": "a rank's share of a part's cells as deal.II has them, functions on it",
        "dealii_levels": "the levels of deal.II's multigrid: stiffness without a matrix, PETSc below",
        "dealii": "the other engine, alone or on the ranks of MPI, and its door",
        "solid": "plane stress and 3-D: solve, neighbourhoods, compliance of seats",
        "plate": "terms through the thickness of a plate",
        "revolution": "Fourier terms about an axis",
        "vibration": "modes, answer to a strike and to a load history",
        "holds": "how pins hold a free part as a whole: mean motions of surfaces, and conditions on them",
        "buckling": "lowest buckling factor",
    },
    "stress": {
        "field": "stress in cells, over time, at probes, on surfaces",
        "displacement": "relative to what holds the part: its largest, and how far it is from small",
        "many_instants": "thousands of instants of a field: by few columns, at few points",
        "sections": "mean stress in plane sections, and of what a held face carries",
        "corners": "edges and corners of a part: angle, support beside them, exponent, and which are facets",
        "zones": "places where linear elasticity has no finite stress, and how far they reach",
        "peaks": "the largest stress, its band, and what shows that cells are too coarse",
        "surface": "what faces of cells make of curved surfaces",
        "output": "fields as files for ParaView",
    },
    "assessment": {
        "job": "what the check of a part needs, and what it gives",
        "judge": "bands and doubt",
        "verdict": "a part against its limits",
        "notes": "what a user should know beside the verdict; beam theory",
        "models": "the list of models: what suits a part, how each solves it, its error against the next",
        "places": "where the peak may stand, and finer solutions there",
        "ladder": "one model with rising degrees until its band is narrow enough",
        "impact": "blows in time, by beam theory and finite elements",
        "pace": "how fast loads change beside a part's first period, and how fast it turns",
        "stretches": "stretches of a motion through which a part is held alike, and their times",
        "vibration": "what loads over time excite",
        "sharing": "reactions that equilibrium leaves open, shared otherwise",
        "buckling": "at which loads a part and what holds it give way",
        "second_order": "stress and deflection of loads that act on what they displace",
        "joined": "what parts that are joined yield together",
    },
    "report": {
        "text": "files, tables, JSON and terminals",
        "quantities": "the table of a result's scalars, in JSON, CSV and with tolerances",
        "machine": "bearings, transmissions, ejectors",
        "notes": "what in a mechanism's numbers and its motion tells of a slip",
        "summary": "what is said of a motion: extremes, jumps, impacts, and which instants show it",
        "forces": "force elements and couplings over a motion",
        "motion": "the motion as JSON, CSV and table",
        "parts": "a part's result",
        "check": "a check's result: table, JSON, CSV, JUnit",
        "compare": "a result against a baseline",
        "figures": "plots as scripts of gnuplot",
        "variants": "many variants of a scene: plan, results, table, plot",
        "view": "what pictures need of a result: surfaces, fields, the motion",
        "stored": "the view of a part as it was stored, and packed for a page",
        "page": "a result as one HTML page, or as glTF",
        "picture": "parts and mechanisms as pictures, without a browser",
        "solid_picture": "a solid with its faces' numbers, from all sides",
    },
    "app": {
        "processes": "other programs, workers, temporary folders, errors across processes",
        "figures": "plots drawn by gnuplot",
        "request": "what the command line asks for, where results go, how refusals are told",
        "companions": "clevis' own programs that read files of others: question, answer, limits",
        "solids": "meshes of CAD solids, by clevis-mesher",
        "scenes": "a scene with its meshes; gmsh, and which mesh a geometry belongs to",
        "parts": "from a scene's motion to the jobs of its parts",
        "ranks": "the parts of a check on the ranks of an MPI run",
        "variants": "many variants: plan, collect, and which results are finished",
        "joined": "parts of one mechanism: what each makes of the others' verdicts",
        "solving": "the commands that solve, as the library that is loaded on demand",
        "results": "commands that read results: compare, report, glTF",
        "watch": "a check that runs again when its files change",
        "plugin": "the door to that library, and the commands that ask it",
        "commands": "the other commands",
        "start": "a way in: scenes to start from, what is installed, completion in shells",
    },
}

# Headers that other modules may include, of modules with rooms.
PUBLIC = {
    "base": "algebra/append_columns algebra/singular_vectors algebra/unit_columns messages/diagnostics messages/errors messages/exit_code"
            " values/index values/quantity values/round_off_length values/stopwatch"
            " bytes/base64 bytes/compression bytes/fingerprint"
            " system/allowed_program system/companion system/huge_pages"
            " system/instruction_set system/interrupts system/mpi_run"
            " system/processor_share system/system_failure",
    "numerics": "factors/jacobian_factor factors/normal_cholesky curves/brent"
                " curves/cubic_spline curves/dip curves/linear_table"
                " integrators/integrator_choice integrators/ode_system"
                " integrators/switching_integrator",
    "mechanism": "definition/definition definition/drive_names definition/meshing_wheels definition/motion definition/pitch_radii"
                 " force_elements/breakaway force_elements/force_element joints/joint_types"
                 " neighbours/elements_at_rest neighbours/load_gains neighbours/neighbour_inertia neighbours/neighbours reactions/largest_reaction"
                 " reactions/other_sharings simulate structure/joined_bodies structure/structure structure/tooth_paths",
    "machine": "bearings/bearing bearings/bearing_history bearings/bearing_life"
               " devices/ejector devices/slide_lever_closed_form"
               " transmissions/transmission",
    "scene": "scene text/name_index text/suggestion variants/design"
             " variants/setting variants/variant_list",
    "mesh": "basis/cell_parts basis/simplex_basis basis/simplex_quadrature basis/tensor_basis cells/cell_orientation cells/part_mesh cells/section"
            " cells/topology derived/graded_mesh derived/plate derived/quadrangles"
            " derived/revolution derived/split_cells derived/sub_mesh"
            " gmsh/gmsh_element quality/mass_properties reading/mesh_reader",
    "loads": "history/balance history/load_history history/motion_instants history/strike history/turning_loads"
             " parts/case_loads parts/held_pins parts/part_loads parts/partial_walls parts/series_loads"
             " pressure/discrete_balance pressure/face_pressure pressure/load_scale pressure/pin_pressure pressure/seat_traction pressure/surface_shear"
             " pressure/wall_pressure holds/holding_groups seats/force_seats seats/part_seats holds/seat_hold seats/seat_spans holds/slide_places holds/spread_seats",
    "dynamics": "load_vibration/load_answer load_vibration/load_path"
                " load_vibration/moving_constraints load_vibration/pulsed_oscillator load_vibration/response_spectrum"
                " load_vibration/load_shapes strike/strike strike/strike_steps"
                " systems/attached_system systems/block_krylov systems/eigenmodes systems/held_system systems/linear_system systems/sprung_system systems/weighed_system",
    "beam": "estimates/beam_estimate estimates/ejector estimates/struck_part",
    "elasticity": "algebra/blas_space algebra/dense_product algebra/even_runs algebra/principal_columns engine_library/rank_team assembly/foundation assembly/stiffness assembly/supports"
                  " buckling/buckling buckling/buckling_problem buckling/second_order_solver holds/pin_hold"
                  " buckling/stressed_part dealii/dealii_service direct/dissection fe_space/discretization fe_space/group_trace"
                  " fe_space/tabulation nodal_loads/load_vectors plate/layered_solve"
                  " plate/plate_layer problem/displacement_basis problem/dof_limit"
                  " problem/elastic_problem problem/engine problem/nodal_field revolution/revolution_solve"
                  " solid/neighbourhood solid/open_reactions solid/plane_loads"
                  " solid/seat_compliance solid/solid_solve vibration/eigenmodes"
                  " vibration/load_vibration vibration/seat_shapes vibration/strike_response",
    "stress": "displacement/deflection displacement/finite_motion"
              " displacement/held_reference displacement/touched_reference"
              " many_instants/field_reduction many_instants/point_stress field/point_history field/probe field/stress_history field/surface_mesh peaks/energy_error peaks/local_peak peaks/lattice_maximum peaks/meeting_points"
              " peaks/peak_band peaks/peak_zoom peaks/slow_sequence surface/surface_deviation surface/surface_kink"
              " sections/support_face corners/facet corners/round_depth zones/end_of_shear zones/singular_zone zones/zone_mask zones/zone_strength output/field_output",
    "assessment": "impact/impact_check job/model_traits job/part_job"
                  " job/part_result joined/joined_parts models/level models/model_list part_check",
    "report": "check/check_inputs check/check_table check/result_files check/result_json"
              " compare/comparison compare/comparison_output"
              " compare/result_reader figures/plot machine/ejector_output"
              " machine/transmission_output motion/motion_csv motion/motion_files"
              " motion/motion_json motion/motion_table page/glb_scene"
              " page/report_page page/result_folder page/watch_mark parts/part_result_json"
              " picture/mechanism_picture picture/part_picture"
              " solid_picture/face_picture"
              " summary/line_refinement summary/motion_report text/atomic_file"
              " text/csv_field"
              " text/json_text text/progress text/terminal text/text_table"
              " variants/collection_csv variants/collection_figure"
              " variants/collection_table variants/plan_file variants/variant_reader"
              " view/motion_view view/part_view view/view_files",
}

MOST_FILES_OF_A_ROOM = 16

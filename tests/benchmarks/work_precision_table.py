#!/usr/bin/env python3
"""Turns the output of work_precision, simbody_precision, mujoco_precision and
sundials_precision into Markdown. Of rows that stand there several times the least time counts.

    work_precision_table.py CSV... > work_precision.md
"""
import csv
import sys

TITLES = {
    "pendulum": "Simple pendulum, 10 s: elliptic functions; reaction: tension",
    "two_window_four_bar": "Two-window four-bar, 10 s, ten change points: converged reference; "
                           "reaction: closed form of the first pin; branch: largest angle between the upright bars [rad]",
    "spatial_slider_crank": "Spatial slider-crank, 5 s: converged reference, nine digits",
    "governor": "Flyball governor (8e5 N/m, 4e4 N s/m), 10 s: equations of its own in three coordinates",
    "bricard": "Bricard's mechanism, 10 s, one redundant constraint: equations of its own on its closed form; "
               "branch: residual of the closed form [1]",
    "andrews": "Andrews' squeezing mechanism, 0.03 s: Test Set for IVP Solvers; position: direction of the crank [rad]; "
               "reaction: at E on K3",
    "light_cart_pole": "Light cart-pole (1 mg under 1 kg), 10 s: converged reference; position: direction of the pole [rad] and cart [m]",
    "crank_rocker": "Crank-rocker, 10 s: equations of its own in the crank's angle; position: direction of the crank [rad]",
    "stick_slip": "Coulomb stick-slip, 25 s: times of the first three events [s]",
    "lugre": "The same on LuGre's bristles (1e5 N/m): converged reference, nine digits",
    "wall_1e8": "Elastic wall of 1e8 N/m, 3 s: times of the first eighteen events [s]",
    "landing_gear_stroke": "Landing gear's stroke by inverse dynamics: time of one instant",
}
ERRORS = {"position_or_time_error": "position m", "energy_error_J": "energy J", "gap_m": "gap m",
          "reaction_error_N": "reaction N", "branch_error": "branch"}
PROGRAMS = ("clevis", "Simbody", "MuJoCo", "SUNDIALS")
# problem, what is small enough, by which error, milliseconds
TARGETS = (
    ("two_window_four_bar", "two-window four-bar to 1e-6 J", "energy_error_J", 1e-6, 5.0),
    ("bricard", "Bricard's mechanism to 1e-6 J", "energy_error_J", 1e-6, 6.0),
    ("governor", "governor to 1e-6 m", "position_or_time_error", 1e-6, 8.0),
    ("landing_gear_stroke", "landing gear, one instant", "gap_m", 1e-9, 0.010),
)
INTRODUCTION = """\
# Work against precision of integrated motions

`results/studies/make work_precision` makes this anew: clevis, and beside it in the same run Simbody 3.7, MuJoCo 2.2.2 and SUNDIALS 6.4 where
they are installed (`apt-get install libsimbody-dev libmujoco-dev libsundials-dev`). SUNDIALS is given equations: of planar mechanisms in the bodies'
coordinates, of governor and Bricard's mechanism in those of their closed forms.

- `cpu` is the least processor time of several runs in three rounds on one thread, from a busy machine: 30 % more or less, short
  runs by where a process lies in memory more (MuJoCo's pendulum of 1000 steps: 1.6 or 2.6 ms). clevis: the whole `simulate()` with
  assembly, reactions and output; the others: the motion alone, without building the system, but with reactions at each output;
  both are as Debian builds them.
- `setting`: what a scene asks for as `tolerance`; Simbody's accuracy (but for `defaults` with constraints to a thousandth of it,
  projected every step); MuJoCo's step. `evaluations` are of accelerations; Simbody counts realizations.
- MuJoCo closes loops by *soft* constraints, springs and dampers: `2h` is as stiff as it allows (`solref = "2h 1"`, `solimp`
  0.9999), so that they stiffen with the step; `defaults` as they come, which is another mechanism. Pendulum and governor have no loops.
  Solver: Newton at its own tolerance (with 1e-14 the errors are the same).
- Errors are the largest over the outputs, against closed forms or converged references, the same for all programs. Energy:
  clevis prints kinetic energy less all work over every step; of the others it is the change of their own energy at the outputs,
  where it is conserved. Gap: largest error of a loop's constraints. Reactions are not known for the slider-crank and the governor,
  and not unique in Bricard's mechanism.
- Simbody's runs through change points hang on round-off: another processor or BLAS gives other steps and errors.
- A method's list ends where a run takes more than 3 s (clevis), 10 s (Simbody) or some hundred thousand evaluations (MuJoCo).
  Friction and the wall have no equal in the other two.
"""


def read(names):
    """Rows by problem, least time of equal ones."""
    rows = {}
    for name in names:
        with open(name, newline="") as file:
            for row in csv.DictReader(file):
                key = row["problem"], row["method"], row["setting"]
                if row["problem"] not in TITLES:
                    continue
                if key in rows:
                    both = [r for r in (rows[key], row) if r["steps"] is not None]
                    row = min(both, key=lambda r: float(r["cpu_ms"]), default=row)
                rows[key] = row
    return {problem: [r for (p, _, _), r in rows.items() if p == problem] for problem in TITLES}


def least(rows, program, column, allowed):
    """Row of least time within the allowed error, or None."""
    fit = [r for r in rows if r["method"].startswith(program) and r["steps"] is not None
           and r[column] and float(r[column]) <= allowed]
    return min(fit, key=lambda r: float(r["cpu_ms"]), default=None)


def milliseconds(row):
    value = float(row["cpu_ms"])
    return f"{value:.0f}" if value >= 1000 else f"{value:.3g}"


def time_of(row):
    if row is None:
        return "not reached"
    method = row["method"].split(" ", 1)[-1].replace("3.7 ", "").replace("2.2.2 ", "").replace("6.4 ", "")
    return f"{milliseconds(row)} ({method.replace('clevis', 'auto')}, {row['setting']})"


def print_targets(rows):
    print("## Targets\n")
    print("| 10 s of motion | target ms | clevis ms | | Simbody ms | MuJoCo ms | SUNDIALS ms |")
    print("|---|---|---|---|---|---|---|")
    for problem, title, column, allowed, target in TARGETS:
        best = {p: least(rows[problem], p, column, allowed) for p in PROGRAMS}
        time = float(best["clevis"]["cpu_ms"]) if best["clevis"] else float("inf")
        verdict = "met" if time <= target else f"**missed: {time / target:.1f} times**"
        others = ["", "", ""] if problem == "landing_gear_stroke" else [time_of(best[p]) for p in PROGRAMS[1:]]
        print(f"| {title} | {target:g} | {time_of(best['clevis'])} | {verdict} | {' | '.join(others)} |")
    print()


def print_growth(rows):
    """Where clevis gets worse at the tightest tolerances."""
    for problem, all_rows in rows.items():
        for column, label in ERRORS.items():
            if column in ("gap_m", "branch_error"):
                continue
            errors = [(float(r[column]), r["setting"]) for r in all_rows
                      if r["method"] == "clevis" and r["steps"] is not None and r[column]]
            if not errors:
                continue
            best, last = min(errors), errors[-1]
            if last[0] > 30 * best[0] and last[0] > 1e-9:
                print(f"**Grows at the tightest tolerances:** {problem}, {label}: {last[0]:.1e} at {last[1]}, "
                      f"{best[0]:.1e} at {best[1]}.\n")


def print_comparison(rows):
    print("## Least time to an error of position\n")
    print("*Not reached*: by no run of the lists below.\n")
    print("| problem | m | clevis ms | Simbody ms | MuJoCo ms | SUNDIALS ms |")
    print("|---|---|---|---|---|---|")
    for problem in ("pendulum", "two_window_four_bar", "crank_rocker", "spatial_slider_crank", "governor",
                    "bricard", "andrews", "light_cart_pole"):
        for allowed in (1e-3, 1e-6, 1e-8):
            cells = [time_of(least(rows[problem], p, "position_or_time_error", allowed)) for p in PROGRAMS]
            print(f"| {problem} | {allowed:.0e} | {' | '.join(cells)} |")
    print()


def print_rows(title, rows):
    print(f"## {title}\n")
    columns = ["method", "setting", "cpu_ms", "steps", "implicit_steps", "evaluations", *ERRORS]
    print("| method | setting | cpu ms | steps | implicit | evaluations | " + " | ".join(ERRORS.values()) + " |")
    print("|---" * len(columns) + "|")
    for r in rows:
        if r["steps"] is not None:
            r = {**r, "cpu_ms": milliseconds(r)}
        print("| " + " | ".join(r[c] or "" for c in columns) + " |")
    print()


def main():
    rows = read(sys.argv[1:])
    print(INTRODUCTION)
    print_targets(rows)
    print_growth(rows)
    print_comparison(rows)
    for problem, title in TITLES.items():
        if rows[problem]:
            print_rows(title, rows[problem])


main()

#!/usr/bin/env python3
"""Turns the output of work_precision and simbody_four_bar into Markdown.

    work_precision_table.py CSV... > work_precision.md
"""
import csv
import sys

TITLES = {
    "pendulum": "Simple pendulum, 10 s: elliptic functions",
    "two_window_four_bar": "Two-window four-bar, 10 s, ten change points: converged reference",
    "spatial_slider_crank": "Spatial slider-crank, 5 s: converged reference, nine digits",
    "governor": "Flyball governor (8e5 N/m, 4e4 N s/m), 10 s: equations of its own in three coordinates",
    "bricard": "Bricard's mechanism, 10 s, one redundant constraint: residual of its closed form under branch",
    "stick_slip": "Coulomb stick-slip, 25 s: times of the first three events [s]",
    "lugre": "The same on LuGre's bristles (1e5 N/m): converged reference, nine digits",
    "wall_1e8": "Elastic wall of 1e8 N/m, 3 s: times of twenty events [s]",
}


def main():
    rows = []
    for name in sys.argv[1:]:
        with open(name, newline="") as file:
            rows += [r for r in csv.DictReader(file) if r["problem"] in TITLES]
    print("# Work against precision of integrated motions\n")
    print("`results/studies/make work_precision` makes this anew. `cpu` is the least processor time of several runs of the "
          "whole simulation\non one thread, with assembly, reactions and output; `tolerance` is what a scene asks for. "
          "Errors are against closed forms or\nconverged references; energy is kinetic energy less work, but Simbody's "
          "own energy for Simbody.\nTimes from a busy machine: 30 % more or less.\n")
    for problem, title in TITLES.items():
        here = [r for r in rows if r["problem"] == problem]
        if not here:
            continue
        print(f"## {title}\n")
        print("| method | tolerance | cpu ms | steps | implicit | evaluations | "
              "error | energy J | reaction N | branch rad |")
        print("|---|---|---|---|---|---|---|---|---|---|")
        for r in here:
            if r["steps"] is None:
                print(f"| {r['method']} | {r['tolerance']} | {r['cpu_ms']} | | | | | | | |")
                continue
            print("| " + " | ".join(
                r[k] for k in ("method", "tolerance", "cpu_ms", "steps", "implicit_steps",
                               "evaluations", "position_or_time_error", "energy_error_J",
                               "reaction_error_N", "branch_error_rad")) + " |")
        print()


main()

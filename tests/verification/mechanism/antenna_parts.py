#!/usr/bin/env python3
"""Runs `clevis check` on a crank and a rod of the antenna: from the motion of a
spatial mechanism to stresses and verdicts.

    antenna_parts.py CLEVIS GEOMETRY
"""
import csv
import json
import math
import subprocess
import sys
import tempfile
from pathlib import Path

G = 9.81  # m/s^2
BORE, THICKNESS = 6.0, 5.0  # mm
faults = []


def expect(what, found, expected, tolerance):
    if not abs(found - expected) <= tolerance:
        faults.append(f"{what}: {found} instead of {expected} +- {tolerance}")


def ball_forces(folder):
    """(t, force on the rod in the world [N]) at the elevation lever's ball."""
    with open(Path(folder) / "reactions.csv", newline="") as file:
        for row in csv.DictReader(file):
            if row["joint"] == "ball_elevation":
                yield float(row["t_s"]), [
                    float(row[f"force_on_b_world_{axis}_N"]) for axis in "xyz"]


def main():
    clevis, geometry = str(Path(sys.argv[1]).resolve()), Path(sys.argv[2])
    with tempfile.TemporaryDirectory() as folder:
        run = subprocess.run(
            [clevis, "check", geometry / "antenna/swinging.toml", "--part",
             "crank_elevation", "--part", "rod_elevation", "--json", "--out",
             folder], capture_output=True, text=True)
        expect("exit code", run.returncode, 0, 0)
        forces = list(ball_forces(folder))
    parts = {part["name"]: part for part in json.loads(run.stdout)["parts"]}
    for part in parts.values():
        peak = part["peak_von_mises"]
        expect(f"{part['name']}: settled", peak["verdict"] == "converged", 1, 0)
        print(part["name"], part["verdict"], peak["band_MPa"])
    rod = parts["rod_elevation"]
    # the reflector is balanced and at t = 0 nothing is accelerated along the
    # rod, which the ball alone bears
    first = forces[0][1]
    expect("ball at rest: weight of the rod [N]", first[2],
           G * rod["mass_kg"], 1e-6)
    # governing closed form: the mean bearing pressure of its largest force
    largest = max(math.hypot(*force) for _, force in forces)
    expect("rod: F / (d t) [MPa]", rod["beam"]["peak_stress_MPa"],
           largest / (BORE * THICKNESS), 1e-6)
    for fault in faults:
        print(fault)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())

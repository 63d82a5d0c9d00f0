#!/usr/bin/env python3
"""Runs `clevis check` on the tribometer's crank and rod: from an integrated motion
with stick and slip to verdicts, at the instant where the pins carry most.

    tribometer_parts.py CLEVIS GEOMETRY
"""
import csv
import json
import math
import subprocess
import sys
import tempfile
from pathlib import Path

from stick_slip import Tribometer, cranked

R, ROD, W, G = 0.010, 0.060, 2 * math.pi, 9.81
LOWER = 1.0  # kg
BORE, EYE, THICKNESS = 4.0, 8.0, 5.0  # of the rod [mm]
faults = []


def expect(what, found, expected, tolerance):
    if not abs(found - expected) <= tolerance:
        faults.append(f"{what}: {found} instead of {expected} +- {tolerance}")


def ends(t):
    """Crank pin P and slide pin S from the shaft [m]."""
    return (R * math.cos(W * t), R * math.sin(W * t)), (
        R + ROD + cranked(t)[0], 0.0)


def middle_acceleration(t, h=1e-4):
    """Of the rod's middle [m/s^2], by differences."""
    middle = [[0.5 * (p + s) for p, s in zip(*ends(t + i * h))]
              for i in (-1, 0, 1)]
    return [(a - 2 * b + c) / h**2 for a, b, c in zip(*middle)]


def pin_force(t, friction, mass):
    """On the rod at the crank pin [N]: the lower platform and half the rod are
    accelerated, `friction` drags the upper one; moments about the slide pin. The
    rod's own turning, 1e-4 of it, is left out."""
    p, s = ends(t)
    d = [p[0] - s[0], p[1] - s[1]]
    a = middle_acceleration(t)
    fx = mass * a[0] + LOWER * cranked(t)[2] + friction
    inertia = 0.5 * mass * (d[0] * (a[1] + G) - d[1] * a[0])
    return math.hypot(fx, (inertia + d[1] * fx) / d[0])


def main():
    clevis, geometry = str(Path(sys.argv[1]).resolve()), Path(sys.argv[2])
    with tempfile.TemporaryDirectory() as folder:
        run = subprocess.run(
            [clevis, "check", geometry / "tribometer/crank_check.toml",
             "--tolerance", "20%", "--json", "--out", folder], capture_output=True, text=True)
        expect("exit code", run.returncode, 0, 0)
        with open(Path(folder) / "reactions.csv", newline="") as file:
            forces = {float(row["t_s"]): math.hypot(
                float(row["force_on_b_world_x_N"]),
                float(row["force_on_b_world_y_N"]))
                for row in csv.DictReader(file) if row["joint"] == "crank_pin"}
    parts = {part["name"]: part for part in json.loads(run.stdout)["parts"]}
    for name in ("crank", "rod"):
        print(name, parts[name]["verdict"],
              parts[name]["peak_von_mises"]["band_MPa"])
        expect(f"{name}: passes", parts[name]["verdict"] == "pass", 1, 0)
    # it is largest where the first stick breaks, between two regular instants
    tribometer = Tribometer(cranked)
    slip = tribometer.pieces(1.0)[0][1]
    largest = max(forces, key=forces.get)
    expect("largest force [s]", largest, slip, 1e-8)
    rod = parts["rod"]
    force = pin_force(slip, tribometer.dragging(slip, 0.0), rod["mass_kg"])
    expect("largest force [N]", forces[largest], force, 1e-3)
    expect("rod: governing instant [s]", rod["peak_von_mises"]["instant_s"],
           slip, 1e-8)
    # governing closed form of the rod: its eye shears out
    expect("rod: closed form [MPa]", rod["beam"]["peak_stress_MPa"],
           math.sqrt(3) * force / (THICKNESS * (EYE - BORE)), 2e-3)
    for fault in faults:
        print(fault)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())

#!/usr/bin/env python3
"""Runs `clevis check` on Bennett's linkage: an overconstrained mechanism whose
links are parts, from the motion to a verdict for each.

    bennett_parts.py CLEVIS GEOMETRY
"""
import csv
import json
import math
import re
import subprocess
import sys
import tempfile
from pathlib import Path

G, DENSITY = 9.81, 7850e-9  # m/s^2, kg/mm^3
WIDTH, THICKNESS, BORE = 12.0, 8.0, 5.0  # mm
faults = []


def expect(what, found, expected, tolerance):
    if not abs(found - expected) <= tolerance:
        faults.append(f"{what}: {found} instead of {expected} +- {tolerance}")


def reactions(folder):
    """{joint: rows of floats}"""
    rows = {}
    with open(Path(folder) / "reactions.csv", newline="") as file:
        for row in csv.DictReader(file):
            rows.setdefault(row["joint"], []).append(
                {key: float(value) for key, value in row.items()
                 if value and value not in ("yes", "no")
                 and key not in ("joint", "body_a", "body_b")})
    return rows


def mass(length):
    """Two square eyes and a twisted bar, whose sections are all alike."""
    eyes = 2 * (WIDTH**2 - math.pi / 4 * BORE**2) * THICKNESS
    return DENSITY * (eyes + WIDTH * THICKNESS * (length - WIDTH))


def beam_stress(row, lever):
    """Axial force, bending about both axes and torsion of a rectangle, `lever`
    before the hinge; what the material beyond weighs is left out. Frame of the
    hinge: x along the link, z across the wide side. [MPa]"""
    force = [row[f"force_on_b_joint_frame_{a}_N"] for a in "xyz"]
    moment = [1e3 * row[f"moment_on_b_joint_frame_{a}_N_m"] for a in "xyz"]
    moment[1] -= lever * force[2]
    moment[2] += lever * force[1]
    normal = (abs(force[0]) / (WIDTH * THICKNESS)
              + abs(moment[1]) / (WIDTH * THICKNESS**2 / 6)
              + abs(moment[2]) / (THICKNESS * WIDTH**2 / 6))
    shear = abs(moment[0]) / (0.231 * WIDTH * THICKNESS**2)  # Timoshenko
    return math.sqrt(normal**2 + 3 * shear**2)


def main():
    clevis, geometry = str(Path(sys.argv[1]).resolve()), Path(sys.argv[2])
    with tempfile.TemporaryDirectory() as folder:
        run = subprocess.run(
            [clevis, "check", geometry / "bennett/links.toml", "--json", "--out",
             folder], capture_output=True, text=True)
        expect("exit code", run.returncode, 0, 0)
        joints = reactions(folder)
    result = json.loads(run.stdout)
    expect("mobility", result["mechanism"]["mobility"], 1, 0)
    expect("redundant", result["mechanism"]["redundant_constraints"], 3, 0)
    parts = {part["name"]: part for part in result["parts"]}
    expect("parts", len(parts), 3, 0)
    for name, part in parts.items():
        expect(f"{name}: passes", part["verdict"] == "pass", 1, 0)
        # gmsh's splines lie within the twisted edges
        expect(f"{name}: mass", part["mass_kg"],
               mass(200 if name == "BC" else 100), 5e-4 * part["mass_kg"])
    # at rest at first: A and D hold the weight, however they share it
    upward = sum(joints[name][0]["force_on_b_world_z_N"] for name in "AD")
    expect("weight on A and D", upward,
           G * sum(part["mass_kg"] for part in parts.values()), 1e-9)
    # the governing closed form of BC and DC, from the reactions at C
    for name, length in (("BC", 200), ("DC", 100)):
        beam = parts[name]["beam"]
        station = re.fullmatch(r"axial \+ bending, .* at ([\d.]+) mm",
                               beam["governing"])
        lever = length - float(station[1])
        largest = max(beam_stress(row, lever) for row in joints["C"])
        print(name, parts[name]["verdict"], beam["peak_stress_MPa"], largest)
        expect(f"{name}: beam [MPa]", beam["peak_stress_MPa"], largest,
               0.02 * largest)
    for fault in faults:
        print(fault)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())

#!/usr/bin/env python3
"""Runs `clevis check` on the landing gear through a change point, one instant
just there: it is reported, and the parts' loads leave it out.

    change_point_parts.py CLEVIS GEOMETRY
"""
import csv
import json
import math
import re
import subprocess
import sys
import tempfile
from pathlib import Path

faults = []


def expect(what, found, expected, tolerance):
    if not abs(found - expected) <= tolerance:
        faults.append(f"{what}: {found} instead of {expected} +- {tolerance}")


def main():
    clevis, geometry = str(Path(sys.argv[1]).resolve()), Path(sys.argv[2])
    command = [clevis, "check", geometry / "landing_gear/change_point.toml",
               "--part", "AB", "--part", "BC", "--part", "FE1", "--out"]
    with tempfile.TemporaryDirectory() as folder:
        run = subprocess.run(command + [folder], capture_output=True, text=True)
        expect("exit code", run.returncode, 0, 0)
        result = json.loads((Path(folder) / "result.json").read_text())
        with open(Path(folder) / "reactions.csv", newline="") as file:
            forces = {float(row["t_s"]): math.hypot(
                float(row["force_on_b_world_x_N"]),
                float(row["force_on_b_world_y_N"]))
                for row in csv.DictReader(file) if row["joint"] == "B"}
        shown = [float(t) for t in re.findall(
            'timestep="([^"]*)"', (Path(folder) / "AB.pvd").read_text())]
    mechanism = result["mechanism"]
    expect("instants", mechanism["instants"], len(forces), 0)
    expect("uniform and more", mechanism["instants"] > 21, True, 0)
    expect("left out", mechanism["instants_left_out"], 1, 0)
    expect("change points", len(mechanism["change_points"]), 1, 0)
    # half-way of the cylinder's stroke, by the closed form of the links
    expect("change point [s]", mechanism["change_points"][0]["at_s"], 1, 1e-5)
    for word in ("change point at", "left out of the parts' loads: 1 instant"):
        expect(f"table: {word}", word in run.stdout, True, 0)
    expect("reactions at the point are told", 1.0 in forces, True, 0)
    expect("frames", 10 <= len(shown) < len(forces), True, 0)
    expect("frame at the point", 1.0 in shown, False, 0)
    # AB shears out at B, where the largest force of the other instants presses;
    # clevis takes the eye's outline from the chords of its cells
    largest = max(force for t, force in forces.items() if t != 1.0)
    parts = {part["name"]: part for part in result["parts"]}
    expect("AB: sqrt(3) F / (2 t (R - r)) [MPa]",
           parts["AB"]["beam"]["peak_stress_MPa"],
           math.sqrt(3) * largest / (2 * 5 * (12 - 7.5)), 4e-5)
    # the tube swings: points of one cell have their worst instants far apart;
    # 0.70485 on cells of half the size to 0.5 % (part.FE1.refine = 2)
    peak = parts["FE1"]["peak_von_mises"]
    expect("FE1 [MPa]", peak["value_MPa"], 0.70485, 0.01)
    low, high = peak["band_MPa"]
    expect("FE1: band holds that", low <= 0.70485 <= high, True, 0)
    expect("FE1: converged", peak["verdict"] == "converged", True, 0)
    for part in parts.values():
        print(part["name"], part["verdict"], part["peak_von_mises"]["band_MPa"])
        expect(f"{part['name']}: passes", part["verdict"] == "pass", 1, 0)
    for fault in faults:
        print(fault)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())

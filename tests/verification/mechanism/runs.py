"""Runs of `clevis simulate` and what it wrote."""
import csv
import math
import re
from pathlib import Path

import source_systems
from source_systems import expect, faults


def simulate(clevis, scene, folder):
    """(simulate.json, rows of motion.csv, [(t, force, event)])"""
    result, rows = source_systems.simulate(clevis, scene, folder)
    with open(Path(folder) / "events.csv", newline="") as file:
        events = [(float(row["t_s"]), row["force"], row["event"])
                  for row in csv.DictReader(file)]
    return result, rows, events


def forces(folder):
    with open(Path(folder) / "forces.csv", newline="") as file:
        return [{key: float(value) for key, value in row.items()}
                for row in csv.DictReader(file)]


def changed(scene, folder, *replacements):
    """A copy of the scene with some of its text replaced."""
    text = scene.read_text()
    for old, new in replacements:
        if old not in text:
            raise ValueError(f"{scene} lacks {old}")
        text = text.replace(old, new)
    if 'geometry = "' in text:  # the meshes beside the geometry tree
        meshes = scene.resolve().parents[2] / "meshes" / scene.parent.name
        text = re.sub(r'geometry = "(.*)\.geo"', rf'mesh = "{meshes}/\1.msh"',
                      text)
    copy = Path(folder) / f"changed_{scene.name}"
    copy.write_text(text)
    return copy


def worst_time(name, events, exact):
    """Largest difference of the times [s]; events must match one by one."""
    found = [event for _, _, event in events]
    expected = [event for _, event, *_ in exact]
    if found != expected:
        faults.append(f"{name}: {found} instead of {expected}")
        return math.inf
    return max(abs(a[0] - b[0]) for a, b in zip(events, exact))


def check_energy(name, result, tolerance=1e-8):
    expect(f"{name}: energy [1]",
           result["motion"]["integration"]["relative_energy_error"], 0,
           tolerance)


def reactions(folder, t):
    """{joint: force [N]} at an instant."""
    with open(Path(folder) / "reactions.csv", newline="") as file:
        return {row["joint"]: math.hypot(*(
            float(row[f"force_on_b_world_{axis}_N"]) for axis in "xyz"))
            for row in csv.DictReader(file) if float(row["t_s"]) == t}

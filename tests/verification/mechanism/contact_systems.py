#!/usr/bin/env python3
"""Runs `clevis simulate` on the scenes with contact, friction and impedance
and compares with their closed forms.

    contact_systems.py CLEVIS GEOMETRY
"""
import csv
import math
import sys
import tempfile
from pathlib import Path

import source_systems
from pieces import Wall, restitution
from source_systems import expect, faults

WALLS = {"scene": Wall(), "published": Wall(pulls=True),
         "friction": Wall(breakaway=1.4715, kinetic=0.981, viscous=0.5)}


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


def check_energy(name, result):
    expect(f"{name}: energy [1]",
           result["motion"]["integration"]["relative_energy_error"], 0, 1e-8)


def impact(clevis, geometry, folder, *replacements):
    """(part of the speed that comes back, duration of the contact [s])"""
    scene = changed(geometry / "wall/impact.toml", folder, *replacements)
    _, rows, events = simulate(clevis, scene, folder)
    (press, _, _), (release, _, _) = events
    return rows[-1]["mass.velocity_x_m_per_s"], release - press


def check_wall(clevis, geometry, folder):
    """Every event of the mass on its spring, and one impact alone."""
    for name, wall in WALLS.items():
        result, _, events = simulate(clevis, geometry / f"wall/{name}.toml",
                                     folder)
        exact = wall.events(0.1, 0.0, 3.0)
        worst = worst_time(f"wall {name}", events, exact)
        expect(f"wall {name}: times [s]", worst, 0, 1e-9)
        check_energy(f"wall {name}", result)
        print(f"wall {name}: {len(events)} events, {worst:.1e} s off")
    for model, known in (("penalty", 0.90720), ("published", 0.90538)):
        e, t = impact(clevis, geometry, folder, ("penalty", model))
        exact_e, exact_t = restitution(1e5, 1.0, 20.0, model == "published")
        expect(f"wall {model}: restitution", e, exact_e, 1e-9)
        expect(f"wall {model}: restitution, source", e, known, 5e-6)
        expect(f"wall {model}: contact time [s]", t, exact_t, 1e-11)
        if model == "penalty":
            expect("wall: contact time, source [ms]", 1e3 * t, 9.7394, 5e-5)
        print(f"wall {model}: restitution {e:.6f}, {1e3 * t:.5f} ms, "
              f"{abs(e - exact_e):.1e} and {abs(t - exact_t):.1e} s off")


def main():
    clevis, geometry = str(Path(sys.argv[1]).resolve()), Path(sys.argv[2])
    with tempfile.TemporaryDirectory() as folder:
        for check in (check_wall,):
            check(clevis, geometry, folder)
    for fault in faults:
        print(fault)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())

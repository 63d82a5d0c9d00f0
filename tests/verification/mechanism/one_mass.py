#!/usr/bin/env python3
"""Runs `clevis simulate` on one block of 1 kg on a rail, with forces whose values
are extreme, and compares with closed forms.

    one_mass.py CLEVIS
"""
import math
import sys
import tempfile
from pathlib import Path

import runs
from source_systems import expect, faults


def scene(*tables, gravity=0.0, duration=1.0, instants=5, tolerance=1e-8):
    """x is the rail's distance; gravity pulls towards −x."""
    return f"""schema = 1
name = "one mass"
[world]
gravity = ["{-gravity!r} m/s^2", "0 m/s^2", "0 m/s^2"]
[[body]]
name = "block"
mass = "1 kg"
center_of_mass = ["0 m", "0 m", "0 m"]
inertia = ["1 kg m^2", "1 kg m^2", "1 kg m^2"]
[[joint]]
name = "rail"
type = "prismatic"
between = ["ground", "block"]
point = ["0 m", "0 m", "0 m"]
axis = [1, 0, 0]
{"".join(tables)}
[simulation]
duration = "{duration!r} s"
instants = {instants}
tolerance = {tolerance!r}
"""


def force(kind, **keys):
    lines = [f'{key} = "{value}"' for key, value in keys.items()]
    return "\n".join(["[[force]]", f'type = "{kind}"', 'joint = "rail"',
                      *lines, ""])


def start(position, rate):
    return (f'[[initial]]\njoint = "rail"\nposition = "{position!r} m"\n'
            f'rate = "{rate!r} m/s"\n')


def simulate(clevis, text, folder):
    """(simulate.json, rows of motion.csv, events)"""
    path = Path(folder) / "scene.toml"
    path.write_text(text)
    return runs.simulate(clevis, path, Path(folder) / "out")


def at_end(rows):
    return 1e-3 * rows[-1]["block.position_x_mm"]


def check_preload_alone(clevis, folder):
    """A spring of zero stiffness pulls with its preload, whatever `free`."""
    for name, keys in (("no free length", {}), ("free", {"free": "0.1 m"})):
        spring = force("spring", stiffness="0 N/m", preload="3 N", **keys)
        _, rows, _ = simulate(clevis, scene(spring), folder)
        expect(f"preload alone, {name} [m]", at_end(rows), -1.5, 1e-8)
    _, rows, _ = simulate(clevis, scene(
        force("spring", damping="2 N s/m", preload="3 N")), folder)
    expect("preload and damper [m]", at_end(rows),
           -1.5 * (1 - 0.5 * (1 - math.exp(-2))), 1e-8)


def main():
    clevis = sys.argv[1]
    with tempfile.TemporaryDirectory() as folder:
        check_preload_alone(clevis, folder)
    for fault in faults:
        print("FAULT", fault)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())

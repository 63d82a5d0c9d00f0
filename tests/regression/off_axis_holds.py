#!/usr/bin/env python3
"""A bar whose roll, or whose bending, is held by a rod off its axis, by one of several
joints, or in one direction only: buckling and deflection are those of what is held, in
any order of the joints.

    off_axis_holds.py CLEVIS
"""
import math
import sys
import tempfile
from pathlib import Path

import hex_mesh
import scene_text
import support

LENGTH, SIDE, MODULUS, POISSON = 0.3, 0.01, 210e9, 0.3
BENDING = MODULUS * SIDE**4 / 12  # N m²
TORSION = MODULUS / (2 + 2 * POISSON) * 0.1406 * SIDE**4
RINGS = {"near": 0.025, "mid": 0.15}  # groups round the bar, 10 mm and 20 mm wide


def write_mesh(folder):
    """Faces of its sides about each ring are the ring's group."""
    nodes, cells, sides = hex_mesh.block(
        (30, 1, 1), lambda x, y, z: (1e3 * LENGTH * x, 1e3 * SIDE * (y - 0.5),
                                     1e3 * SIDE * (z - 0.5)))
    groups = {"root": sides["x0"], "tip": sides["x1"]}
    for side in ("y0", "y1", "z0", "z1"):
        for face in sides[side]:
            middle = sum(nodes[v][0] for v in face) / 4
            for name, width in (("near", 6), ("mid", 11)):
                if abs(middle - 1e3 * RINGS[name]) < width:
                    groups.setdefault(name, []).append(face)
    hex_mesh.write(folder / "bar.msh", (nodes, cells, groups))


def rod(name, x, along, off=(0, 0)):
    """From the ground to the bar at x, `along` y or z, its ends off the axis [mm]."""
    y, z = off
    far = (x, y + 100, z) if along == "y" else (x, y, z - 100)
    return f"""[[joint]]
name = "{name}"
type = "distance"
between = ["ground", "bar"]
at = {{ ground = {scene_text.lengths(far)}, bar = {scene_text.lengths((x, y, z))} }}
"""


def mast(x, height, force):
    """A load on a mast over x [mm]."""
    return (scene_text.body("load", "0.1 kg", "1e-4 kg m^2", center=(x, 0, height)) +
            scene_text.joint("mast", "weld", "bar", "load", (x, 0, 0)) +
            push("load", (x, 0, height), force))


def fork(behind):
    """Welded to the bar's root, hinged in the plane of y so far behind it [mm]."""
    return (scene_text.body("fork", "0.1 kg", "1e-4 kg m^2", center=(-10, 0, 0)) +
            scene_text.joint("weld", "weld", "fork", "bar") +
            scene_text.joint("R", "revolute", "ground", "fork", (-behind, 0, 0),
                             (0, 0, 1)))


def bent_on_fork(force, behind, held):
    """Deflection of the bar's tip [m] under a force across; held: place of its rod."""
    rod_force = force * (LENGTH + behind) / (held + behind)
    hinge = rod_force - force

    def elastic(x):
        bent = hinge * (behind * x**2 / 2 + x**3 / 6)
        return (bent - rod_force * max(0.0, x - held)**3 / 6) / BENDING

    turn = -elastic(held) / (behind + held)
    return abs(turn * (behind + LENGTH) + elastic(LENGTH))


def push(body, point, force, along="z"):
    across = ["0 N", f"{force} N"] if along == "z" else [f"{force} N", "0 N"]
    return f"""[[force]]
type = "constant"
name = "push"
body = "{body}"
point = {scene_text.lengths(point)}
force = ["0 N", "{across[0]}", "{across[1]}"]
"""


def check(clevis, mechanism, pins, more=""):
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        write_mesh(folder)
        file = folder / "scene.toml"
        file.write_text(
            scene_text.head("bar") + scene_text.part_body("bar") + mechanism + f"""\
[simulation]
duration = "1 s"
instants = 2
{scene_text.BAR}pins = {{ {pins} }}
limits = {{ safety_factor = 1, singular_zones = "exclude", deflection = "0.5 mm" }}
{more}""")
        return support.check(clevis, file).part


def main():
    clevis = Path(sys.argv[1]).resolve()
    checks = support.Checks()

    def expect(what, value, exact):
        checks.near(what, value, exact, 0.015)

    # Roll bends the bar at its middle by what the rod there is off the axis.
    ball = scene_text.joint("A", "spherical", "ground", "bar")
    for off in (10, 25):
        stiffness = 1 / (LENGTH**3 / (48 * BENDING * (1e-3 * off)**2) +
                         LENGTH / (2 * TORSION))
        part = check(clevis, ball + rod("ty", 300, "y") + rod("tz", 300, "z") +
                     rod("roll", 150, "y", (0, off)) + mast(300, 100, -1000),
                     'A = "root", ty = "tip", tz = "tip", roll = "mid", mast = "tip"')
        expect(f"roll held {off} mm off the axis", part["buckling"]["factor"],
               stiffness / 100)

    # The universal joint at the tip holds the roll, whatever comes first.
    rods = rod("ty", 0, "y") + rod("tz", 0, "z")
    cross = scene_text.joint("U", "universal", "ground", "bar", (300, 0, 0),
                             (0, 0, 1)) + "normal = [0, 1, 0]\n"
    exact = TORSION / (LENGTH - RINGS["near"]) / 375
    for name, joints in (("rods", rods + cross), ("universal", cross + rods)):
        part = check(clevis, joints + mast(25, 1500, -250),
                     'ty = "root", tz = "root", U = "tip", mast = "near"')
        expect(f"roll held at the tip, {name} first", part["buckling"]["factor"], exact)
        checks.expect(part["verdict"] == "fail", f"{name} first: {part['verdict']}")

    # A rod along y holds nothing along z.
    part = check(clevis, fork(0) + rod("d", 150, "y") + push("bar", (300, 0, 0), 20),
                 'weld = "root", d = "mid"', '[part.forces]\npush = { face = "tip" }\n')
    expect("deflection of a cantilever beside a rod, mm", part["deflection_mm"],
           1e3 * 20 * LENGTH**3 / (3 * BENDING))
    checks.expect(part["verdict"] == "fail", f"beside a rod: {part['verdict']}")

    # Hinged behind its root: displacement and turn there are one condition.
    part = check(clevis, fork(60) + rod("d", 150, "y") + push("bar", (300, 0, 0), 20, "y"),
                 'weld = "root", d = "mid"', '[part.forces]\npush = { face = "tip" }\n')
    expect("deflection of a bar on a fork, mm", part["deflection_mm"],
           1e3 * bent_on_fork(20, 0.06, 0.15))
    return checks.exit_code()


if __name__ == "__main__":
    sys.exit(main())

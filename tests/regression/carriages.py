#!/usr/bin/env python3
"""Parts with slides that share a wall or stand off its middle.

    carriages.py CLEVIS

What a guide touches holds a bar that slides in it and carries a carriage on the same
wall, in every model and whichever pin is named first; a carriage's load acts where it
stands, and a guide on a pin holds by what it touches (beam theory).
"""
import math
import sys
from functools import partial
from pathlib import Path

import scene_text
import support
from round_bar import DIAMETER, INERTIA, MODULUS, check_of, round_bar
from rods_and_rotors import in_a_guide

SHEAR = MODULUS / 2 / 1.3


def scene(folder, text, pins, seats="", simulation='duration = "1 s"\ninstants = 2'):
    """pins: by joint; the bar's mesh is there."""
    file = folder / "scene.toml"
    named = ", ".join(f"{joint} = {seat}" for joint, seat in pins.items())
    file.write_text(f"""{scene_text.head("carriage")}{text}
[simulation]
{simulation}
{scene_text.BAR}pins = {{ {named} }}
{seats}
limits = {{ safety_factor = 1.5, singular_zones = "exclude" }}
[accuracy]
peak_stress = "10 %"
""")
    return file


def stands(joint, at):
    return f'[[drive]]\njoint = "{joint}"\nlaw = "constant"\nfrom = "{at} mm"\n'


def slide(name, first, second):
    """Along x, its points at both origins."""
    return scene_text.joint(name, "prismatic", first, second, axis=(1, 0, 0)).replace(
        'point = ["0 mm", "0 mm", "0 mm"]',
        f'at = {{ {first} = ["0 mm", "0 mm", "0 mm"], '
        f'{second} = ["0 mm", "0 mm", "0 mm"] }}')


def push(body, point, force):
    return f"""[[force]]
type = "constant"
name = "load"
body = "{body}"
point = {scene_text.lengths(point)}
force = ["0 N", "{force} N", "0 N"]
"""


def on_a_bar(folder, first):
    """A bar of 400 x 10 x 10 mm in a guide of 20 mm at x = 350 of it carries 100 N at
    20. first: of the two slides, in `pins`."""
    scene_text.write_bar(folder, (0.4, 0.01, 0.01), (40, 1, 1))
    body = f'{scene_text.part_body("bar")}placement = {{ origin = ["-350 mm", "0 mm", "0 mm"] }}\n'
    wall = '{ groups = ["y1", "y0"], length = "20 mm" }'
    return scene(folder, body
                 + scene_text.body("car", "1e-3 kg", "1e-7 kg m^2", origin=(-330, 0, 0))
                 + slide("S", "ground", "bar") + slide("C", "bar", "car")
                 + stands("S", -350) + stands("C", 20) + push("car", (0, 0, 0), -100),
                 dict.fromkeys((first, "S", "C"), wall),
                 'drives = { S = { face = "x0" }, C = { face = "x0" } }')


def on_a_strip(folder, at, height):
    """A strip of 300 x 20 x 2 mm, clamped at x = 0, carries 20 N on a carriage, so high
    over its axis."""
    scene_text.write_bar(folder, (0.3, 0.02, 0.002), (40, 2, 1))
    return scene(folder, scene_text.part_body("bar")
                 + scene_text.body("car", "1e-3 kg", "1e-6 kg m^2", origin=(at, 0, 0))
                 + scene_text.joint("W", "weld", "ground", "bar")
                 + scene_text.joint("C", "prismatic", "bar", "car", (at, 0, 0), (1, 0, 0))
                 + stands("C", 0) + push("car", (0, height, 0), -20),
                 {"W": '"x0"', "C": '{ groups = ["z0", "z1"], length = "20 mm" }'},
                 'drives = { C = { face = "x0" } }')


def strip_falls_over(at, height):
    """Load [N], [TimoshenkoGere] 6.3."""
    across = MODULUS * 20 * 2**3 / 12
    twist = SHEAR * 20 * 2**3 / 3 * (1 - 0.63 * 2 / 20)
    return (4.013 * math.sqrt(across * twist) / at**2
            * (1 - height / at * math.sqrt(across / twist)))


def in_a_pivoting_guide(folder, at, far, bodies=("guide", "bar")):
    """A bar of 500 mm on a ball at its left end; a guide of 10 mm on a pin so many mm
    behind it pushes it off with 20 kN. bodies: of the guide's joint."""
    round_bar(folder, [(500, 34, "round_m")])
    end = at + far
    pivot = scene_text.joint("P", "universal", "guide", "ground", (end, 0, 0),
                             (0, 1, 0)).replace("axis =", "normal = [0, 0, 1]\naxis =")
    return scene(folder, scene_text.part_body("bar")
                 + scene_text.body("guide", "1e-2 kg", "1e-6 kg m^2", origin=(end, 0, 0))
                 + scene_text.joint("A", "spherical", "ground", "bar", (0, 0, 0), (1, 0, 0))
                 + scene_text.joint("S", "prismatic", *bodies, (at, 0, 0), (1, 0, 0))
                 + pivot + f"""[[force]]
type = "spring"
name = "push"
joint = "S"
stiffness = "0 N/m"
preload = "{20 if bodies[1] == "bar" else -20} kN"
free = "0 mm"
""", {"A": '"left"', "S": '{ group = "round_m", length = "10 mm" }'},
                 'forces = { push = { face = "right" } }')


def through_two_balls(folder):
    """A bar of 500 mm is drawn through two balls 200 mm apart until 270 mm of it, with
    200 N at their end, stick out. Both drives of it are at one joint."""
    round_bar(folder, [(500, 40, "round_m")])

    def ball(name, at):
        return f"""[[joint]]
name = "{name}"
type = "point_on_line"
between = ["bar", "ground"]
at = {{ bar = ["0 mm", "0 mm", "0 mm"], ground = ["{at} mm", "0 mm", "0 mm"] }}
axis = [1, 0, 0]
"""
    body = f'{scene_text.part_body("bar")}placement = {{ origin = ["-50 mm", "0 mm", "0 mm"] }}\n'
    seat = '{ group = "round_m", length = "10 mm" }'
    return scene(folder, body + ball("A", 20) + ball("B", 220)
                 + """[[drive]]
joint = "A"
coordinate = "angle_1"
law = "constant"
from = "0 deg"
[[drive]]
joint = "A"
coordinate = "distance"
law = "quintic"
from = "70 mm"
to = "30 mm"
duration = "1 s"
""" + push("bar", (500, 0, 0), -200), {"A": seat, "B": seat},
                 'drives = { A = { face = "left" } }\n'
                 'forces = { load = { face = "right" } }',
                 'duration = "1 s"\ninstants = 5')


def tube(folder):
    """bar.msh: 600 x 20 x 10 mm in closed rings, group round_m outside."""
    lines = ["Point(1) = {0, 0, 0};"]
    for k, (y, z) in enumerate(((1, 0), (0, 1), (-1, 0), (0, -1))):
        lines.append(f"Point({2 + k}) = {{0, {5 * y}, {5 * z}}};"
                     f" Point({6 + k}) = {{0, {10 * y}, {10 * z}}};")
    for k in range(4):
        n = (k + 1) % 4
        lines.append(f"Circle({1 + k}) = {{{2 + k}, 1, {2 + n}}};"
                     f" Circle({5 + k}) = {{{6 + k}, 1, {6 + n}}};"
                     f" Line({9 + k}) = {{{2 + k}, {6 + k}}};")
    lines.append("Transfinite Curve {1:8} = 3; Transfinite Curve {9:12} = 2; ends[] = {};"
                 " outside[] = {}; volumes[] = {};")
    for k in range(4):
        n = (k + 1) % 4
        lines.append(f"Curve Loop({1 + k}) = {{{9 + k}, {5 + k}, {-9 - n}, {-1 - k}}};"
                     f" Plane Surface({1 + k}) = {{{1 + k}}};")
    lines.append("""Transfinite Surface {1:4}; Recombine Surface {1:4};
For q In {1:4}
  e[] = Extrude {600, 0, 0} { Surface{q}; Layers{40}; Recombine; };
  ends[] += e[0]; volumes[] += e[1]; outside[] += e[3];
EndFor
Physical Surface("left") = {1:4};
Physical Surface("right") = {ends[]};
Physical Surface("round_m") = {outside[]};
Physical Volume("body") = {volumes[]};
Mesh.ElementOrder = 2;
""")
    support.gmsh(folder, "\n".join(lines), name="bar")


def tube_out_of_a_guide(folder):
    """520 mm out of a guide of 40 mm, 20 N at its end."""
    tube(folder)
    body = f'{scene_text.part_body("bar")}placement = {{ origin = ["-60 mm", "0 mm", "0 mm"] }}\n'
    return scene(folder, body + slide("S", "ground", "bar") + stands("S", -60)
                 + push("bar", (600, 0, 0), -20),
                 {"S": '{ group = "round_m", length = "40 mm" }'},
                 'drives = { S = { face = "left" } }\n'
                 'forces = { load = { face = "right" } }')


def main():
    clevis = Path(sys.argv[1]).resolve()
    checks = support.Checks()

    check = partial(check_of, clevis)

    # Clamped in the guide's middle, and at its end.
    most, least = (100 * d**2 * (3 * (d + 20) - d) / 6 / (MODULUS * 1e4 / 12)
                   for d in (330, 320))
    for first in ("S", "C"):
        part = check(on_a_bar, first).part
        checks.expect(part["model"].startswith("plane stress"),
                      f"carriage on a bar: by {part['model']}")
        checks.expect(least < part["deflection_mm"] < most,
                      f"carriage on a bar, {first} first: bends by "
                      f"{part['deflection_mm']:.3f} mm, clamped {least:.3f} to {most:.3f} mm")
        # As a narrow strip, of a square section.
        theory = 4.013 * math.sqrt(1e4 / 12 * MODULUS * 0.1406e4 * SHEAR) / 330**2 / 100
        checks.near(f"carriage on a bar, {first} first: buckles at",
                    part["buckling"]["factor"], theory, 0.06)

    for at, height in ((285, 0), (285, 20), (150, 0)):
        factor = check(on_a_strip, at, height).part["buckling"]["factor"]
        checks.near(f"carriage at {at} mm of a strip, {height} mm over it: falls over at",
                    factor, strip_falls_over(at, height) / 20, 0.02)

    for at, far in ((400, 100), (495, 200)):
        factor = check(in_a_pivoting_guide, at, far).part["buckling"]["factor"]
        checks.near(f"guide on a pin {far} mm behind it: strut buckles at", factor,
                    in_a_guide(at - 5, far + 5) / 20e3, 0.02)
    # 200 mm stick out behind the guide, and are pushed along its line.
    tail = math.pi**2 * MODULUS * INERTIA / 4 / 200**2
    for far in (100, -100, -50):  # the last in the middle of the bar's wall
        for bodies in (("guide", "bar"), ("bar", "guide")):
            factor = check(in_a_pivoting_guide, 300, far, bodies).part["buckling"]["factor"]
            checks.near(f"{bodies[1]} on {bodies[0]}, pin {far} mm behind it: what sticks out "
                        "buckles at", factor, tail / 20e3, 0.02)

    part = check(through_two_balls).part
    checks.near("bar through two balls: bends by", part["deflection_mm"],
                200 * 270**2 * 470 / 3 / MODULUS / INERTIA, 0.02)

    part = check(tube_out_of_a_guide).part
    checks.expect(part["model"].startswith("axisymmetric"), f"tube: by {part['model']}")
    bends = 20 * 520**3 / 3 / MODULUS / (math.pi / 64 * (DIAMETER**4 - 10**4))
    checks.expect(bends < part["deflection_mm"] < 1.15 * bends,
                  f"tube out of a guide: bends by {part['deflection_mm']:.3f} mm, "
                  f"clamped at its end {bends:.3f} mm")
    return checks.exit_code()


if __name__ == "__main__":
    sys.exit(main())

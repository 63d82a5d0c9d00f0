#!/usr/bin/env python3
"""Compliance of real parts by finite elements beside the formulas of the
transmission's elements, and what the landing gear's wheel gives under its load.

    compliance.py CLEVIS [--parts]

--parts: the single parts that a formula holds for, nothing written.

Two equal and opposite unit loads at the ends of a part do the work of its
strain energy U: e = 2 U / F². A mechanism whose drives hold gives at its wheel,
along the load W,  δ = (U(loads + v) − U(loads) − U(v)) / v  for a small force v
beside them (virtual work; the parts are linear), summed over all parts. Writes
results/studies/compliance.md; exit code 1 if a formula misses by more than it
may.
"""
import csv
import math
import re
import sys
import tempfile
from pathlib import Path

import support

ROOT = Path(__file__).resolve().parents[2]
GPA = 210e9
CLEVIS = str(Path(sys.argv[1]).resolve())


def check(scene, out, *more):
    return support.check(CLEVIS, scene, *more, out=out,
                         exits=support.JUDGED).result


def energies(folder, part):
    """Strain energy of every instant or case [J]."""
    with open(Path(folder) / f"{part}_history.csv", encoding="utf-8") as file:
        return [1e-3 * float(row["strain_energy_mJ"]) for row in csv.DictReader(file)]


HEAD = f"""schema = 1
name = "compliance"
{support.STEEL}
[[part]]
name = "part"
length_unit = "mm"
material = "steel"
"""


def mesh_of(geometry):
    return ROOT / "meshes" / geometry.parent.name / (geometry.stem + ".msh")


def part_compliance(folder, geometry, case):
    """2 U of a part under one case [J]."""
    scene = folder / "scene.toml"
    is_own = geometry.is_relative_to(folder)
    source = f'geometry = "{geometry.name}"' if is_own else f'mesh = "{mesh_of(geometry)}"'
    scene.write_text(HEAD + source + f'\n[[part.case]]\nname = "unit"\n{case}\n'
                     '[accuracy]\npeak_stress = "1 %"\n')
    if is_own:
        support.make_meshes(CLEVIS, scene)
    check(scene, folder / "out")
    return 2.0 * energies(folder / "out", "part")[0]


BAR = """Point(1) = {0, 0, 0}; Point(2) = {200, 0, 0}; Point(3) = {200, 10, 0}; Point(4) = {0, 10, 0};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4}; Plane Surface(1) = {1};
Transfinite Curve {1, 3} = 9; Transfinite Curve {2, 4} = 3;
Transfinite Surface {1}; Recombine Surface {1};
e[] = Extrude {0, 0, 10} { Surface{1}; Layers{2}; Recombine; };
Physical Volume("body") = {e[1]};
Physical Surface("left") = {e[5]}; Physical Surface("right") = {e[3]};
"""


def pull(a, b):
    return f'pins = {{ {a} = ["-1000 N", "0 N", "0 N"], {b} = ["1000 N", "0 N", "0 N"] }}'


def single_parts(folder, with_links):
    """(what, finite elements, formula, remark) [m/N]."""
    rows = []
    bar = folder / "bar.geo"
    bar.write_text(BAR)
    area = 1e-4
    fe = part_compliance(folder, bar, 'traction = { left = ["-10 MPa", "0 MPa", "0 MPa"], '
                         'right = ["10 MPa", "0 MPa", "0 MPa"] }') / (10e6 * area) ** 2
    rows.append(("bar 200 x 10 x 10", fe, 0.2 / (GPA * area), "l/EA"))
    ring = lambda outer: math.pi * (outer**2 - 6e-3**2)
    force = 27.5e6 * ring(20e-3)
    # Area under the fillet of radius 4 from x = 96 to 100: integrated.
    steps = 20000
    fillet = 0.0
    for i in range(steps):
        x = 4e-3 * (i + 0.5) / steps
        outer = 24e-3 - math.sqrt(16e-6 - x * x)
        fillet += 4e-3 / steps / (GPA * ring(outer))
    formula = 96e-3 / (GPA * ring(20e-3)) + fillet + 100e-3 / (GPA * ring(30e-3))
    check(ROOT / "geometry/stepped_shaft/tension.toml", folder / "shaft", "--tolerance", "5 %")
    fe = 2.0 * energies(folder / "shaft", "shaft")[0] / force**2
    rows.append(("stepped shaft 40/60, bore 12, in tension", fe, formula, "Σ l/EA; the stress spreads into the collar over a length"))
    if not with_links:
        return rows
    link = ROOT / "geometry/reference_link/link.geo"
    fe = part_compliance(folder, link, pull("bore_A", "bore_B")) / 1e6
    rows.append(("reference link, pin to pin", fe, 140e-3 / (GPA * 12e-3 * 8e-3), "l/EA of the web alone: the eyes give most"))
    for name, length, width, thick in (("link_ab", 140e-3, 18e-3, 5e-3), ("link_bc", 60e-3, 18e-3, 5e-3)):
        bores = ("bore_A", "bore_B") if name == "link_ab" else ("bore_C", "bore_B")
        fe = part_compliance(folder, ROOT / f"geometry/landing_gear/{name}.geo", pull(*bores)) / 1e6
        rows.append((f"landing gear, {name}", fe, length / (GPA * width * thick), "l/EA of the web alone"))
    return rows


TORSION = HEAD.replace('[[part]]', '''[world]
gravity = ["0 m/s^2", "0 m/s^2", "0 m/s^2"]
[[body]]
name = "shaft"
part = "part"
[[body]]
name = "disc"  # at the far end, what the torque accelerates
mass = "100 kg"
center_of_mass = ["0 mm", "0 mm", "0 mm"]
inertia = ["10 kg m^2", "10 kg m^2", "10 kg m^2"]
placement = { origin = ["0 mm", "0 mm", "0 mm"] }
[[joint]]
name = "shaft"
type = "revolute"
between = ["ground", "shaft"]
point = ["100 mm", "0 mm", "0 mm"]
axis = [1, 0, 0]
[[joint]]
name = "flange"
type = "weld"
between = ["shaft", "disc"]
point = ["0 mm", "0 mm", "0 mm"]
[[drive]]
joint = "shaft"
law = "sine"
from = "0 deg"
amplitude = "0.001 deg"
frequency = "25 Hz"
[simulation]
duration = "10 ms"
instants = 2
[[part]]''')


# A hollow shaft along x, 40 outside, bore 12, 200 long.
SHAFT = """bore[] = {}; outer[] = {}; left[] = {}; right[] = {}; solid[] = {};
Point(1) = {0, 0, 0};
For i In {0 : 3}
  Point(10 + i) = {0, 6 * Cos(i * Pi / 2), 6 * Sin(i * Pi / 2)};
  Point(20 + i) = {0, 20 * Cos(i * Pi / 2), 20 * Sin(i * Pi / 2)};
  Line(30 + i) = {10 + i, 20 + i};
  Transfinite Curve {30 + i} = 3;
EndFor
For i In {0 : 3}
  j = (i + 1) % 4;
  Circle(40 + i) = {10 + i, 1, 10 + j}; Circle(50 + i) = {20 + i, 1, 20 + j};
  Transfinite Curve {40 + i, 50 + i} = 3;
  Curve Loop(60 + i) = {30 + i, 50 + i, -(30 + j), -(40 + i)};
  Plane Surface(70 + i) = {60 + i};
  Transfinite Surface {70 + i}; Recombine Surface {70 + i};
EndFor
For i In {0 : 3}
  e[] = Extrude {200, 0, 0} { Surface{70 + i}; Layers{4}; Recombine; };
  left[] += 70 + i; right[] += e[0]; solid[] += e[1]; outer[] += e[3]; bore[] += e[5];
EndFor
Physical Volume("body") = {solid[]};
Physical Surface("bore_axis") = {bore[]}; Physical Surface("round_outer") = {outer[]};
Physical Surface("left") = {left[]}; Physical Surface("right") = {right[]};
"""


def polar_compliance(outers, inner):
    """∫ dx/(G Jp) of (length, outer radius(x)) pieces."""
    modulus, steps, total = GPA / 2.6, 20000, 0.0
    for length, outer in outers:
        for i in range(steps):
            radius = outer(length * (i + 0.5) / steps)
            total += length / steps / (0.5 * math.pi * modulus * (radius**4 - inner**4))
    return total


def torsion_of(folder, source):
    """Finite elements [rad/(N m)]: at the top of a sine the drive's torque runs
    from one face through the shaft to a disc at the other."""
    scene = folder / "torsion.toml"
    scene.write_text(TORSION + source + '\n'
                     'pins = { shaft = "bore_axis", flange = "left" }\n'
                     'drives = { shaft = { face = "right" } }\n'
                     '[accuracy]\npeak_stress = "5 %"\n')
    if "geometry" in source:
        support.make_meshes(CLEVIS, scene)
    out = folder / "torsion"
    result = check(scene, out, "--tolerance", "5 %")
    torque = result["mechanism"]["drives"][0]["peak_effort_Nm"]
    return 2.0 * energies(out, "part")[-1] / torque**2


def torsion(folder):
    """(what, finite elements, formula, remark) [rad/(N m)]"""
    (folder / "shaft.geo").write_text(SHAFT)
    fe = torsion_of(folder, 'geometry = "shaft.geo"')
    yield ("shaft 40, bore 12, 200 long, in torsion", fe,
           polar_compliance(((200e-3, lambda x: 20e-3),), 6e-3), "l/(G Jp), rad/(N m)")
    text = (ROOT / "geometry/stepped_shaft/shaft.geo").read_text()
    for fine, coarse in (("around = 5;", "around = 3;"), ("outwards = 3;", "outwards = 1;"),
                         ("= 2 + 1;", "= 1 + 1;"), ("= 3 + 1;", "= 1 + 1;"),
                         ("= 5 + 1 ", "= 3 + 1 ")):
        assert fine in text
        text = text.replace(fine, coarse)  # energies need no fine cells
    (folder / "stepped.geo").write_text(text)
    fe = torsion_of(folder, 'geometry = "stepped.geo"')
    neck, collar = lambda x: 20e-3, lambda x: 30e-3
    fillet = lambda x: 24e-3 - math.sqrt(16e-6 - x * x)
    formula = polar_compliance(((96e-3, neck), (4e-3, fillet), (100e-3, collar)), 6e-3)
    yield ("stepped shaft 40/60, bore 12, in torsion", fe, formula,
           "Σ l/(G Jp), rad/(N m); the shoulder takes a length to fill")


def wheel(folder, dx, dy, without_load=False):
    """Per part the strain energies of all instants, with a force (dx, dy) N at
    the wheel's contact point beside the scene's own."""
    text = (ROOT / "geometry/landing_gear/loaded.toml").read_text()
    fx, fy = (0.0, 0.0) if without_load else (500.0, 1000.0)
    text = text.replace('force = ["500 N", "1000 N", "0 N"]',
                        f'force = ["{fx + dx} N", "{fy + dy} N", "0 N"]')
    assert text.count(f"{fx + dx} N") >= 1
    text = re.sub(r"instants = \d+", "instants = 21", text)
    text = re.sub(r'geometry = "(\w+\.geo)"',
                  lambda m: f'mesh = "{ROOT}/meshes/landing_gear/{m[1][:-4]}.msh"', text)
    if without_load:
        text = text.replace('"-9.81 m/s^2"', '"0 m/s^2"').replace('density = "7850 kg/m^3"', 'density = "11 kg/m^3"')
    scene = folder / "gear.toml"
    scene.write_text(text)
    out = folder / "gear"
    result = check(scene, out)
    parts = [part["name"] for part in result["parts"]]
    assert len(parts) == 5, result
    return {part: energies(out, part) for part in parts}, result


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        rows = single_parts(folder, "--parts" not in sys.argv)
        rows += torsion(folder)
        good = (abs(rows[0][1] / rows[0][2] - 1.0) < 1e-6
                and 1.0 < rows[1][1] / rows[1][2] < 1.05
                and abs(rows[-2][1] / rows[-2][2] - 1.0) < 1e-3
                and 1.0 < rows[-1][1] / rows[-1][2] < 1.05)
        if "--parts" in sys.argv:
            for what, fe, formula, _ in rows:
                unit = "rad/(N m)" if "torsion" in what else "m/N"
                print(f"{what}: {fe:.6e} {unit}, formula {formula:.6e}")
            return 0 if good else 1
        v = 1000.0
        loads, _ = wheel(folder, 0, 0)
        both, _ = wheel(folder, 0, v)
        alone, _ = wheel(folder, 0, v, without_load=True)
    lines = ["# Compliance of parts and of the landing gear", "",
             "Written by `python3 tests/regression/compliance.py build/release/bin/clevis`.", "",
             "| part | finite elements, m/N | formula, m/N | ratio | |", "|---|---|---|---|---|"]
    for what, fe, formula, remark in rows:
        lines.append(f"| {what} | {fe:.4e} | {formula:.4e} | {fe / formula:.3f} | {remark} |")
    lines += ["", "Vertical deflection of the wheel's contact point under (500, 1000) N by virtual work with the "
              "strain energies of all parts, drives held, over the stroke; shares of the parts in per cent.", "",
              "| instant | deflection, mm | " + " | ".join(loads) + " |",
              "|---|---|" + "---|" * len(loads)]
    for i in range(0, 21, 4):
        share = {p: (both[p][i] - loads[p][i] - alone[p][i]) / v for p in loads}
        total = sum(share.values())
        lines.append(f"| {i + 1} of 21 | {1e3 * total:.4f} | "
                     + " | ".join(f"{100 * share[p] / total:.1f}" for p in loads) + " |")
    (ROOT / "results/studies/compliance.md").write_text("\n".join(lines) + "\n")
    print("\n".join(lines))
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())

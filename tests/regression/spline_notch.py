#!/usr/bin/env python3
"""A bar whose upper face is one spline that dips by a notch of 0.63 mm radius, a hundredth
of its length wide, between the places that a coarse look would take: its stress against
the same outline meshed by hand, and its area and volume against the outline's.

    spline_notch.py CLEVIS
"""
import json
import math
import subprocess
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path

import support

CLEVIS = sys.argv[1]
WIDTH, DEPTH = 0.45, 0.16


@dataclass
class Bar:
    length: float
    height: float
    thickness: float
    place: float  # of the notch

    def area(self):
        return self.length * self.height - DEPTH * WIDTH * math.sqrt(math.pi)


SHORT, LONG = Bar(50.0, 12.0, 6.0, 28.6), Bar(300.0, 20.0, 15.0, 171.1)


def outline(bar):
    """Points of the upper face, right to left: close together in the notch."""
    xs, reach, step = {bar.place}, 0.0, WIDTH / 8
    while reach < bar.length:
        reach += step
        if reach > 4 * WIDTH:
            step *= 1.4
        xs |= {bar.place + reach, bar.place - reach}
    inner = [x for x in xs if 3 < x < bar.length - 3]
    return [(x, bar.height - DEPTH * math.exp(-((x - bar.place) / WIDTH) ** 2))
            for x in sorted([0.0, bar.length, *inner], reverse=True)]


def profile(bar):
    points = outline(bar)
    count = len(points)
    text = 'SetFactory("OpenCASCADE");\n'
    for k, (x, y) in enumerate([*points, (0, 0), (bar.length, 0)], 1):
        text += f"Point({k}) = {{{x}, {y}, 0}};\n"
    return text + f"""Spline(1) = {{1:{count}}};
Line(2) = {{{count}, {count + 1}}}; Line(3) = {{{count + 1}, {count + 2}}};
Line(4) = {{{count + 2}, 1}};
Curve Loop(1) = {{1, 2, 3, 4}}; Plane Surface(1) = {{1}};
"""


def scene(folder, name, source, faces, tolerance):
    file = folder / f"{name}.toml"
    file.write_text(f"""schema = 1
name = "{name}"
{support.steel(strength=355.0)}
[accuracy]
peak_stress = "{tolerance}"
[[part]]
name = "{name}"
{source}
material = "steel"
limits = {{ safety_factor = 1.3 }}
{faces}
[[part.case]]
name = "pull"
traction = {{ e1 = ["-200 MPa", "0 MPa", "0 MPa"], e2 = ["200 MPa", "0 MPa", "0 MPa"] }}
""")
    return file


def write_step(folder, bar, name):
    (folder / f"{name}.geo").write_text(
        profile(bar) + f"Extrude {{0, 0, {bar.thickness}}} {{ Surface{{1}}; }}\n"
        f'Save "{name}.step";\n')
    subprocess.run(["gmsh", "-", f"{name}.geo"], cwd=folder, check=True,
                   stdout=subprocess.DEVNULL)
    faces = """[part.faces]
e1 = { plane = { normal = [-1, 0, 0] } }
e2 = { plane = { normal = [1, 0, 0] } }
"""
    return scene(folder, name, f'geometry = "{name}.step"', faces, "20 %")


def meshed_by_hand(folder, bar):
    (folder / "hand.geo").write_text(profile(bar) + f"""
Physical Curve("e1") = {{2}}; Physical Curve("e2") = {{4}}; Physical Surface("body") = {{1}};
Field[1] = Ball; Field[1].XCenter = {bar.place}; Field[1].YCenter = {bar.height};
Field[1].Radius = {2 * WIDTH}; Field[1].Thickness = 12;
Field[1].VIn = 0.12; Field[1].VOut = 3;
Background Field = 1;
Mesh.MeshSizeExtendFromBoundary = 0; Mesh.MeshSizeFromPoints = 0;
Mesh.RecombineAll = 1; Mesh.ElementOrder = 2;
""")
    file = scene(folder, "hand", 'geometry = "hand.geo"\nlength_unit = "mm"\n'
                 f'thickness = "{bar.thickness} mm"', "", "2 %")
    return support.check(CLEVIS, file, "--mesh", exits=support.JUDGED)


def expect_integrals(file, bar):
    told = json.loads(subprocess.run([CLEVIS, "faces", file, "--json"], check=True,
                                     capture_output=True, text=True).stdout)["solids"][0]
    volume, area = 1e9 * told["volume_m3"], bar.area()
    print(f"volume {volume:.7g} mm^3, {area * bar.thickness:.7g} by the outline")
    if abs(volume / (area * bar.thickness) - 1) > 1e-5:
        sys.exit("volume")
    plane = [1e6 * face["area_m2"] for face in told["faces"]]
    plane = [one for one in plane if abs(one / area - 1) < 0.02]
    if len(plane) != 2 or any(abs(one / area - 1) > 1e-5 for one in plane):
        sys.exit(f"areas {plane}")


def expect_stress(folder):
    found = support.check(CLEVIS, write_step(folder, SHORT, "short"), "--mesh-rounds",
                          "0", exits=support.JUDGED)
    truth = meshed_by_hand(folder, SHORT)
    print(f"notch {found}; by hand {truth}")
    if truth.code != 1 or found.code == 0:
        sys.exit("a notch that is stressed beyond its limit passes")
    if not (found.band[0] <= truth.band[1] and truth.band[0] <= found.band[1]):
        sys.exit("bands do not meet")


def expect_cells_in_notch(folder):
    """Along a long bar cells are larger than the notch is wide."""
    file = write_step(folder, LONG, "long")
    subprocess.run([CLEVIS, "mesh", file], check=True, stdout=subprocess.DEVNULL)
    lines = (folder / "long.msh").read_text().splitlines()
    nodes = [[float(word) for word in line.split()]
             for line in lines[lines.index("$Nodes"):lines.index("$EndNodes")]
             if line.count(" ") == 2 and "." in line]
    inside = sum(abs(x - LONG.place) < WIDTH and abs(z) < 1e-9 and
                 y > LONG.height - 2 * DEPTH for x, y, z in nodes)
    print(f"{inside} nodes along the edge of the long bar's notch")
    if inside < 5:
        sys.exit("cells step over the notch")


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        expect_stress(folder)
        expect_integrals(folder / "short.step", SHORT)
        expect_cells_in_notch(folder)


if __name__ == "__main__":
    main()

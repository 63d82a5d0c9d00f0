#!/usr/bin/env python3
"""One mechanism written in other ways has the same numbers: mirrored, turned, with the
frames of its bodies turned, or its tables in another order.

    same_scene.py CLEVIS

A four-bar with a coupler of plate in which nothing is even, with a mass welded to it
beside its middle. Mirrored are points, directions, meshes and inertias; of axes and
moments what a mirror leaves of them.
"""
import math
import re
import sys
import tempfile
from pathlib import Path

import scene_text
import support

TOLERANCE = 2e-5  # round-off of factors and iterations to 1e-6
ONE = [[1, 0, 0], [0, 1, 0], [0, 0, 1]]
LEFT = [[-1, 0, 0], [0, 1, 0], [0, 0, 1]]
# Nodes of curves and quadrangles of order 2 in gmsh's order, once mirrored.
MIRRORED = {8: [1, 0, 2], 10: [0, 3, 2, 1, 7, 6, 5, 4, 8]}


def apply(matrix, vector):
    return [sum(a * b for a, b in zip(row, vector)) for row in matrix]


def product(a, b):
    columns = [apply(a, [row[k] for row in b]) for k in range(3)]
    return [[columns[k][i] for k in range(3)] for i in range(3)]


def transposed(matrix):
    return [list(row) for row in zip(*matrix)]


def turned(axis, degrees):
    """Rodrigues' formula."""
    size = math.hypot(*axis)
    x, y, z = (a / size for a in axis)
    s, c = math.sin(math.radians(degrees)), math.cos(math.radians(degrees))
    cross = [[0, -z, y], [z, 0, -x], [-y, x, 0]]
    square = product(cross, cross)
    return [[ONE[i][j] + s * cross[i][j] + (1 - c) * square[i][j] for j in range(3)]
            for i in range(3)]


def listed(values, unit=""):
    """Round-off is not printed."""
    return "[" + ", ".join(
        f'"{value + 0.0:.14f} {unit}"' if unit else f"{value + 0.0:.14f}"
        for value in values) + "]"


class Way:
    """world, body: matrices of the world's and of all bodies' frames, of one sign."""

    def __init__(self, world=ONE, body=ONE, shift=(0, 0, 0), order=1):
        self.world, self.body, self.shift, self.order = world, body, shift, order
        first, second, third = world
        self.sign = round(sum(a * b for a, b in zip(
            third, (first[1] * second[2] - first[2] * second[1],
                    first[2] * second[0] - first[0] * second[2],
                    first[0] * second[1] - first[1] * second[0]))))

    def frame(self, where):
        return self.world if where == "ground" else self.body

    def point(self, where, p):
        shift = self.shift if where == "ground" else (0, 0, 0)
        return listed([a + b for a, b in zip(apply(self.frame(where), p), shift)], "mm")

    def vector(self, where, v, unit=""):
        return listed(apply(self.frame(where), v), unit)

    def axis(self, where, v, unit=""):
        return self.vector(where, [self.sign * a for a in v], unit)

    def placement(self, origin, degrees):
        axes = transposed(product(product(self.world, turned((0, 0, 1), degrees)),
                                  transposed(self.body)))
        return (f"placement = {{ origin = {self.point('ground', origin)}, "
                f"x_axis = {listed(axes[0])}, y_axis = {listed(axes[1])} }}\n")

    def tables(self, texts):
        return "".join(list(texts)[::self.order])


def link_script(length, holes, width):
    """A flat link in quadrangles; holes: (name, x, y, radius)."""
    discs = "".join(f"Disk({20 + k}) = {{{x}, {y}, 0, {r}}};\n"
                    for k, (_, x, y, r) in enumerate(holes))
    groups = "".join(
        f"b{k}[] = Curve In BoundingBox{{{x - r - 1e-3}, {y - r - 1e-3}, -1, "
        f"{x + r + 1e-3}, {y + r + 1e-3}, 1}};\n"
        f'Physical Curve("{name}") = {{b{k}[]}};\n'
        for k, (name, x, y, r) in enumerate(holes))
    numbers = ", ".join(str(20 + k) for k in range(len(holes)))
    return f"""SetFactory("OpenCASCADE");
Disk(1) = {{0, 0, 0, 17}}; Disk(2) = {{{length}, 0, 0, 17}};
Rectangle(3) = {{0, {-width / 2}, 0, {length}, {width}}};
BooleanUnion(10) = {{Surface{{1}}; Delete;}}{{Surface{{2, 3}}; Delete;}};
{discs}BooleanDifference(30) = {{Surface{{10}}; Delete;}}{{Surface{{{numbers}}}; Delete;}};
Mesh.CharacteristicLengthMax = 16; Mesh.CharacteristicLengthMin = 4;
Mesh.CharacteristicLengthFromCurvature = 1; Mesh.MinimumCirclePoints = 8;
Mesh.RecombineAll = 1; Mesh.Algorithm = 6;
Mesh.RecombinationAlgorithm = 1; Mesh.SubdivisionAlgorithm = 1;
Physical Surface("body") = {{30}};
{groups}Mesh.ElementOrder = 2; Mesh.MshFileVersion = 2.2;
"""


HOLES = (("bore_A", 0, 0, 6), ("bore_B", 120, 0, 6), ("bore_C", 60, 9, 4))


def write_mesh(source, target, way):
    lines, out = source.read_text().splitlines(), []
    nodes = elements = 0
    for at, line in enumerate(lines):
        if lines[at - 1] == "$Nodes":
            nodes = int(line)
        elif lines[at - 1] == "$Elements":
            elements = int(line)
        elif nodes:
            nodes -= 1
            number, *place = line.split()
            place = apply(way.body, [float(x) for x in place])
            line = f"{number} " + " ".join(f"{x:.17g}" for x in place)
        elif elements:
            elements -= 1
            words = line.split()
            start = 3 + int(words[2])
            if way.sign < 0:
                line = " ".join(words[:start] + [words[start + k]
                                                 for k in MIRRORED[int(words[1])]])
        out.append(line)
    target.write_text("\n".join(out) + "\n")


def hinge(way, name, first, second, p, q):
    ends = ((first, p), (second, q))
    return f"""[[joint]]
name = "{name}"
type = "revolute"
between = ["{first}", "{second}"]
at = {{ {", ".join(f"{w} = {way.point(w, x)}" for w, x in ends)} }}
axis = {{ {", ".join(f"{w} = {way.axis(w, (0, 0, 1))}" for w, _ in ends)} }}
normal = {{ {", ".join(f"{w} = {way.vector(w, (1, 0, 0))}" for w, _ in ends)} }}
"""


def four_bar(folder, meshes, way):
    write_mesh(meshes / "coupler.msh", folder / "coupler.msh", way)
    # The loop closes with the crank at 60 degrees.
    x, y = 40 * math.cos(math.pi / 3), 40 * math.sin(math.pi / 3)
    away = math.hypot(120 - x, y)
    half = (120**2 - 80**2 + away**2) / (2 * away)
    rise = math.sqrt(120**2 - half**2)
    ux, uy = (120 - x) / away, -y / away
    top = (x + half * ux - rise * uy, y + half * uy + rise * ux)
    lean = math.degrees(math.atan2(top[1] - y, top[0] - x))
    place = [a + b for a, b in zip((x, y, 0), apply(turned((0, 0, 1), lean), (60, 9, 0)))]
    bodies = [scene_text.part_body("coupler") + way.placement((x, y, 0), lean)]
    for name, mass, centre, inertia, origin, angle in (
            ("crank", 0.1, (20, 0, 0), (1e-5, 3e-5, 3.5e-5), (0, 0, 0), 60),
            ("rocker", 0.15, (40, 0, 0), (1e-5, 1e-4, 1e-4), (120, 0, 0),
             math.degrees(math.atan2(top[1], top[0] - 120))),
            ("weight", 2, (5, 12, 0), (1e-3, 2e-3, 2.5e-3), place, 0)):
        own = product(product(way.body, [[inertia[i] if i == j else 0 for j in range(3)]
                                         for i in range(3)]), transposed(way.body))
        bodies.append(f"""[[body]]
name = "{name}"
mass = "{mass} kg"
center_of_mass = {way.point(name, centre)}
inertia = [{", ".join(listed(row, "kg m^2") for row in own)}]
{way.placement(origin, angle)}""")
    joints = [hinge(way, "A", "ground", "crank", (0, 0, 0), (0, 0, 0)),
              hinge(way, "B", "crank", "coupler", (40, 0, 0), (0, 0, 0)),
              hinge(way, "C", "coupler", "rocker", (120, 0, 0), (80, 0, 0)),
              hinge(way, "D", "ground", "rocker", (120, 0, 0), (0, 0, 0)),
              f"""[[joint]]
name = "W"
type = "weld"
between = ["coupler", "weight"]
point = {way.point("ground", place)}
"""]
    world = f"[world]\ngravity = {way.vector('ground', (1, -9.5, 0), 'm/s^2')}\n"
    file = folder / "scene.toml"
    file.write_text(f"""{scene_text.head("four-bar", world=world)}{way.tables(bodies)}\
{way.tables(joints)}[[drive]]
joint = "A"
law = "speed"
from = "60 deg"
speed = "600 rpm"
[[force]]
type = "constant"
name = "work"
body = "rocker"
point = {way.point("rocker", (80, 0, 0))}
force = {way.vector("ground", (200, -300, 0), "N")}
moment = {way.axis("ground", (0, 0, -5), "N m")}
[[part]]
name = "coupler"
mesh = "coupler.msh"
length_unit = "mm"
thickness = "8 mm"
material = "steel"
pins = {{ {", ".join(['B = "bore_A"', 'C = "bore_B"', 'W = "bore_C"'][::way.order])} }}
limits = {{ safety_factor = 1.5, deflection = "0.5 mm", singular_zones = "exclude" }}
[simulation]
duration = "0.1 s"
instants = 21
[accuracy]
peak_stress = "20 %"
""")
    return file


def numbers(part):
    """Of one part, those that no frame is in."""
    second = part.get("second_order") or {}
    vibration = part.get("vibration") or {}
    found = {"peak": part["peak_von_mises"]["value_MPa"],
             "low": part["peak_von_mises"]["band_MPa"][0],
             "high": part["peak_von_mises"]["band_MPa"][1],
             "deflection": part["deflection_mm"], "mass": part["mass_kg"],
             "beam": part["beam"].get("peak_MPa"),
             "second order": second.get("stress_factor"),
             "vibration": vibration.get("peak_MPa")}
    for name in ("factor", "euler"):
        found[f"buckling {name}"] = (part.get("buckling") or {}).get(name)
    return {name: value for name, value in found.items() if value is not None}


def main():
    clevis = Path(sys.argv[1]).resolve()
    checks = support.Checks()
    oblique = turned((0, 0, 1), 77)
    ways = {"as it is": Way(), "mirrored": Way(LEFT, LEFT),
            "turned with its bodies' frames, mirrored, reversed":
                Way(product(oblique, LEFT), product(turned((0, 0, 1), 140), LEFT),
                    (300, -200, 0), -1)}
    with tempfile.TemporaryDirectory() as name:
        meshes = Path(name)
        support.gmsh(meshes, link_script(120, HOLES, 34), "coupler", 2)
        known = {}
        for words, way in ways.items():
            folder = meshes / re.sub(r"\W", "_", words)
            folder.mkdir()
            answer = support.check(clevis, four_bar(folder, meshes, way),
                                   exits=support.JUDGED)
            for one in answer.parts:
                here = numbers(one)
                first = known.setdefault(one["name"], (here, one["verdict"]))
                off = {key: abs(value / first[0][key] - 1) if first[0].get(key) else math.inf
                       for key, value in here.items()}
                worst = max(off, key=off.get)
                checks.expect(
                    off[worst] < TOLERANCE and here.keys() == first[0].keys() and
                    one["verdict"] == first[1],
                    f"{words}, {one['name']}: {here['peak']:.6g} MPa, {one['verdict']}; "
                    f"{worst} {here[worst]:.7g} for {first[0].get(worst)}")
    return checks.exit_code()


if __name__ == "__main__":
    sys.exit(main())

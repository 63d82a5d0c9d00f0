#!/usr/bin/env python3
"""Linear buckling of whole runs.

    buckling.py CLEVIS ROOT

- Two links, clamped at one bore and under a dead traction on the other, against
  CalculiX's *BUCKLE on the exported deck, its cells cut finer (skipped without ccx).
- A link between two pins: their forces go through their axes, whatever the bores
  turn by. As dead loads on the walls they would hold the eyes: 5 % more.
- The ears of a fork tilt each by itself, be they one group or two.
- A clamped column under three times its Euler load must fail, by its buckling;
  under a third of it, it passes.
- A strip that linear theory bends by half of its length does not pass.
- A bar that is pushed along its guide buckles beyond the guide's own length, whoever
  takes the push: a drive, a spring, or a drive beside a weak spring across the tip.
- The shape and the numbers stand in the files.
"""
import math
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

import hex_mesh
import support

CALCULIX = 0.005

MATERIAL = f"""schema = 1
name = "buckling"
{support.STEEL}"""

PRESSED = MATERIAL + """
[[part]]
name = "link"
mesh = "{mesh}"
length_unit = "mm"
material = "steel"

[[part.case]]
name = "press"
"""

LINK = PRESSED + """
fixed = {{ {held} = ["x", "y", "z"] }}
traction = {{ {pressed} = ["{x} MPa", "{y} MPa", "0 MPa"] }}
"""

EYES = """length = 300; end_radius = 8; bore_radius = 3;
Point(1) = {0, 0, 0};
Point(2) = {length, 0, 0};
For i In {0 : 1}
  x = i * length; s = 1 - 2 * i; p = 10 * (i + 1);
  Point(p + 1) = {x, -s * end_radius, 0};
  Point(p + 2) = {x - s * end_radius, 0, 0};
  Point(p + 3) = {x, s * end_radius, 0};
  Circle(p + 1) = {p + 1, i + 1, p + 2};
  Circle(p + 2) = {p + 2, i + 1, p + 3};
  Point(p + 4) = {x + bore_radius, 0, 0};
  Point(p + 5) = {x - bore_radius, 0, 0};
  Circle(p + 4) = {p + 4, i + 1, p + 5};
  Circle(p + 5) = {p + 5, i + 1, p + 4};
  Curve Loop(i + 2) = {p + 4, p + 5};
EndFor
Line(1) = {13, 21};
Line(2) = {23, 11};
Curve Loop(1) = {11, 12, 1, 21, 22, 2};
Plane Surface(1) = {1, 2, 3};
Physical Curve("bore_A") = {14, 15};
Physical Curve("bore_B") = {24, 25};
Physical Surface("body") = {1};
MeshSize {:} = 6;
Transfinite Curve {14, 15, 24, 25} = 9;
Mesh.ElementOrder = 2;
"""

PINNED = MATERIAL + """
[[part]]
name = "link"
geometry = "../eyes.geo"
length_unit = "mm"
thickness = "30 mm"
material = "steel"

[[part.case]]
name = "press"
pins = {{ bore_A = ["{force} N", "0 N", "0 N"], bore_B = ["-{force} N", "0 N", "0 N"] }}
"""

BAR = MATERIAL + """
[[part]]
name = "bar"
mesh = "bar.msh"
length_unit = "mm"
material = "steel"
limits = {{ singular_zones = "exclude", safety_factor = 1.5 }}

[[part.case]]
name = "{case}"
fixed = {{ root = ["x", "y", "z"] }}
traction = {{ tip = ["{x} MPa", "{y} MPa", "0 MPa"] }}
"""


GUIDED = """schema = 1
name = "guided"
""" + support.STEEL + """
[world]
gravity = ["0 m/s^2", "0 m/s^2", "0 m/s^2"]

[[body]]
name = "bar"
part = "bar"

[[joint]]
name = "slide"
type = "prismatic"
between = ["ground", "bar"]
at = {{ ground = ["0 mm", "0 mm", "0 mm"], bar = ["350 mm", "10 mm", "10 mm"] }}
axis = [1, 0, 0]

[[force]]
type = "constant"
name = "push"
body = "bar"
point = ["0 mm", "10 mm", "10 mm"]
force = ["45 kN", "0 N", "0 N"]
{held}
[[part]]
name = "bar"
mesh = "bar.msh"
length_unit = "mm"
material = "steel"
limits = {{ safety_factor = 1.5 }}
pins = {{ slide = {{ groups = ["low", "high"], length = "60 mm" }} }}
{faces}
"""

DRIVEN = """
[[drive]]
joint = "slide"
law = "quintic"
from = "0 mm"
to = "1e-6 mm"
duration = "1 s"

[simulation]
duration = "1 s"
"""
ON_DRIVE = 'drives = { slide = { face = "root" } }\n'

# Who holds the slide, and where these act.
HOLDERS = {
    "a drive": (DRIVEN, ON_DRIVE + 'forces = { push = { face = "tip" } }'),
    "a spring": ("""
[[initial]]
joint = "slide"
position = "0 mm"
rate = "0 m/s"

[[force]]
type = "spring"
name = "stop"
joint = "slide"
free = "-0.45 mm"
stiffness = "1e8 N/m"

[simulation]
duration = "10 ms"
""", 'forces = { push = { face = "tip" }, stop = { face = "root" } }'),
    "a drive beside a weak spring": (DRIVEN + """
[[force]]
type = "spring"
name = "across"
between = ["ground", "bar"]
from = ["-350 mm", "0 mm", "0 mm"]
to = ["0 mm", "10 mm", "10 mm"]
axis = [0, 1, 0]
stiffness = "100 N/m"
free = "0 mm"
""", ON_DRIVE + 'forces = { push = { face = "tip" }, across = { face = "tip" } }'),
}


def bar_mesh(path, length, width, height, cells):
    """A box of hexahedra along x, root at x = 0, tip at x = length."""
    ends = dict.fromkeys(hex_mesh.SIDES) | {"x0": "root", "x1": "tip"}
    hex_mesh.write(path, hex_mesh.block(
        (cells, 1, 1), lambda x, y, z: (length * x, width * y, height * z),
        ends))


def check(clevis, folder, text, name):
    """Each with files of its own."""
    (folder / name).mkdir()
    scene = folder / name / "scene.toml"
    scene.write_text(text.replace('"bar.msh"', '"../bar.msh"'))
    return support.check(clevis, scene, exits=support.JUDGED)


def calculix_factor(clevis, scene, folder):
    subprocess.run([clevis, "export", scene, "--out", folder, "--split", "2",
                    "--elements", "C3D20"], check=True, capture_output=True)
    deck = (folder / "link.inp").read_text()
    step = deck.index("*STATIC")
    (folder / "buckle.inp").write_text(
        deck[:step] + "*BUCKLE\n1\n" + deck[step + len("*STATIC\n"):])
    subprocess.run(["ccx", "buckle"], cwd=folder, check=True,
                   capture_output=True)
    rows = re.findall(r"^ +1 +(\S+) *$", (folder / "buckle.dat").read_text(),
                      re.M)
    return float(rows[0])


def link_faults(clevis, root, folder):
    links = [("ab", "meshes/landing_gear/link_ab.msh", "bore_A", "bore_B"),
             ("reference", "meshes/reference_link/link.msh", "bore_B",
              "bore_A")]
    for name, mesh, held, pressed in links:
        direction = PRESS[name]
        text = LINK.format(mesh=root / mesh, held=held, pressed=pressed,
                           x=direction[0], y=direction[1])
        found = check(clevis, folder, text, name)
        part = found.part
        factor = part["buckling"]["factor"]
        low, high = part["buckling"]["band"]
        if not (found.out / "link_buckling.vtu").is_file():
            yield f"{name}: link_buckling.vtu is missing"
        if "buckling" not in found.text:
            yield f"{name}: the table does not tell its buckling"
        if shutil.which("ccx") is None:
            continue
        reference = calculix_factor(clevis, folder / name / "scene.toml",
                                    folder / f"{name}_ccx")
        print(f"{name}: {factor:.4f} [{low:.4f}, {high:.4f}], CalculiX "
              f"{reference:.4f}")
        if abs(factor / reference - 1) > CALCULIX:
            yield f"{name}: {factor / reference} of CalculiX's factor"


def pin_faults(clevis, folder):
    """Euler's load, less by the compliance in shear."""
    (folder / "eyes.geo").write_text(EYES)
    length, height, thickness, force = 300.0, 16.0, 30.0, 20e3
    euler = math.pi ** 2 * 210e3 * thickness * height ** 3 / 12 / length ** 2
    in_shear = 5 / 6 * 210e3 / 2.6 * thickness * height
    truth = euler / (1 + euler / in_shear) / force
    (folder / "pinned").mkdir()
    scene = folder / "pinned" / "scene.toml"
    scene.write_text(PINNED.format(force=force))
    subprocess.run([clevis, "mesh", scene], check=True, capture_output=True)
    factor = support.check(clevis, scene, exits=support.JUDGED).part["buckling"]["factor"]
    print(f"between pins: {factor:.4f}, by beam theory {truth:.4f}")
    if abs(factor / truth - 1) > 0.01:
        yield f"between pins: {factor} for {truth}"


FORK = """SetFactory("OpenCASCADE");
Box(1) = {-10, -12, -22, 10, 24, 44};
For i In {0 : 1}
  z = -22 + 40 * i;
  Box(10 + i) = {0, -12, z, 40, 24, 4};
  Cylinder(20 + i) = {40, 0, z, 0, 0, 4, 12};
  Cylinder(30 + i) = {40, 0, z - 1, 0, 0, 6, 6};
EndFor
BooleanUnion(50) = { Volume{1}; Delete; }{ Volume{10, 11, 20, 21}; Delete; };
BooleanDifference(60) = { Volume{50}; Delete; }{ Volume{30, 31}; Delete; };
Physical Volume("body") = {60};
end() = Surface In BoundingBox {-10.1, -13, -23, -9.9, 13, 23};
Physical Surface("end") = {end()};
low() = Surface In BoundingBox {33.9, -6.1, -22.1, 46.1, 6.1, -17.9};
high() = Surface In BoundingBox {33.9, -6.1, 17.9, 46.1, 6.1, 22.1};
GROUPS
Mesh.MeshSizeMax = 9; Mesh.MeshSizeMin = 5; Mesh.ElementOrder = 2; Mesh.HighOrderOptimize = 2;
"""
EARS = PRESSED + """
fixed = {{ end = ["x", "y", "z"] }}
pins = {{ {pins} }}
"""


def fork_faults(clevis, folder):
    """Two ears of 24 x 4 mm pressed along by a pin, which holds neither upright."""
    factors = []
    for name, groups, pins in (
            ("one", 'Physical Surface("bore_pin") = {low(), high()};',
             'bore_pin = ["-2000 N", "0 N", "0 N"]'),
            ("two", 'Physical Surface("bore_low") = {low()};'
                    'Physical Surface("bore_high") = {high()};',
             'bore_low = ["-1000 N", "0 N", "0 N"], bore_high = ["-1000 N", "0 N", "0 N"]')):
        place = folder / f"fork_{name}"
        place.mkdir()
        support.gmsh(place, FORK.replace("GROUPS", groups), "fork")
        (place / "scene.toml").write_text(EARS.format(mesh="fork.msh", pins=pins))
        answer = support.check(clevis, place / "scene.toml", "--tolerance", "20%",
                               "--max-dofs", "20000", exits=support.JUDGED)
        factors.append(answer.part["buckling"]["factor"])
    print(f"fork: {factors[0]:.4f} as one group, {factors[1]:.4f} as two")
    if abs(factors[0] / factors[1] - 1) > 2e-3:
        yield f"fork: {factors[0]} as one group, {factors[1]} as two"


def column_faults(clevis, folder):
    length, side = 1000.0, 10.0
    bar_mesh(folder / "bar.msh", length, side, side, 20)
    euler = math.pi ** 2 * 210e3 * side ** 4 / 12 / (2 * length) ** 2
    for share, verdict in ((3.0, "fail"), (1 / 3, "pass")):
        text = BAR.format(case="press", x=-share * euler / side ** 2, y=0)
        part = check(clevis, folder, text, f"column_{share:.1f}").part
        factor = part["buckling"]["factor"]
        print(f"column, {share:.3f} times Euler's load: {part['verdict']}, "
              f"factor {factor:.4f}; {part['why']}")
        if part["verdict"] != verdict:
            yield f"column at {share}: {part['verdict']}: {part['why']}"
        if abs(factor * share - 1) > 0.01:
            yield f"column at {share}: factor {factor}"


def bed_faults(clevis, folder):
    """A column whose foot rests on an elastic bed: u tan u = k I l / (E I), by
    beam theory."""
    length, width, height, bed, press = 200.0, 20.0, 10.0, 1000.0, 200.0
    bar_mesh(folder / "bar.msh", length, width, height, 20)
    low, high = 0.0, math.pi / 2
    for _ in range(100):
        u = 0.5 * (low + high)
        low, high = (u, high) if u * math.tan(u) < bed * length / 210e3 else (low, u)
    truth = (u / length) ** 2 * 210e3 * height ** 2 / 12 / press
    text = BAR.format(case="press", x=-press, y=0).replace(
        'fixed = { root = ["x", "y", "z"] }', f'foundation = {{ root = "{bed} N/mm^3" }}')
    part = check(clevis, folder, text, "bed").part
    factor = part["buckling"]["factor"]
    print(f"column on a bed: {part['verdict']}, {factor:.4f}, by beam theory {truth:.4f}")
    if part["verdict"] != "fail" or abs(factor / truth - 1) > 0.01:
        yield f"column on a bed: {part['verdict']}, {factor} for {truth}"


def guide_faults(clevis, folder):
    """Above its guide the bar is a column on a guide that holds it in the mean, and
    its turn; by beam theory 1.292 times the push, as a column clamped where the
    guide begins 1.495 times."""
    sides = dict.fromkeys(hex_mesh.SIDES) | {"x0": "tip", "x1": "root", "y0": "low", "y1": "high"}
    hex_mesh.write(folder / "bar.msh", hex_mesh.block(
        (20, 1, 1), lambda x, y, z: (400 * x, 20 * y, 20 * z), sides))
    for who, (held, faces) in HOLDERS.items():
        text = GUIDED.format(held=held, faces=faces)
        part = check(clevis, folder, text, "guided by " + who).part
        factor = part["buckling"]["factor"]
        print(f"a bar in a guide, held along it by {who}: {part['verdict']}, {factor:.4f}")
        if part["verdict"] != "fail" or abs(factor / 1.292 - 1) > 0.01:
            yield f"a bar in a guide on {who}: {part['verdict']}, {factor}"


def strip_faults(clevis, folder):
    bar_mesh(folder / "bar.msh", 1000.0, 10.0, 1.0, 40)
    text = BAR.replace('"0 MPa"]', '"{z} MPa"]').format(
        case="bend", x=0, y=0, z=0.03)
    part = check(clevis, folder, text, "strip").part
    print(f"strip: {part['deflection_mm']:.0f} mm, {part['why']}")
    if part["deflection_mm"] < 500:
        yield f"strip: deflection {part['deflection_mm']}"
    if part["verdict"] != "not judged" or "small displ" not in part["why"]:
        yield f"strip: {part['verdict']}: {part['why']}"


# MPa on the wall of the bore, towards the held one.
PRESS = {"ab": (-5.0, 0.0), "reference": (40.0, 0.0)}


def main():
    clevis, root = sys.argv[1:3]
    clevis, root = str(Path(clevis).resolve()), Path(root).resolve()
    found = []
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for fault in (*column_faults(clevis, folder),
                      *bed_faults(clevis, folder),
                      *guide_faults(clevis, folder),
                      *strip_faults(clevis, folder),
                      *pin_faults(clevis, folder),
                      *fork_faults(clevis, folder),
                      *link_faults(clevis, root, folder)):
            found.append(fault)
    for fault in found:
        print(fault, file=sys.stderr)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())

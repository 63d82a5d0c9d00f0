#!/usr/bin/env python3
"""Where shear on a surface ends, and at the edge of a stiff bed, the stress has no
bound that a mesh could find: two meshes that agree do not say otherwise.

    shear_ends.py CLEVIS

A plate glued between straps, shear on four pads of its sides: on a smooth side the
stress at a pad's end rises like the logarithm of the cells' size, by 117 MPa a
decade for 80 MPa. It passed with a band of some percent, each finer mesh with
another. Pulled at its ends by pressure alone nothing is left out. A bar on a bed
that gives way by less than its own wall has the edge of a support, one on a soft
bed has none.
"""
import sys
import tempfile
from pathlib import Path

import support

PLATE = """
a = 25; m = 50; h = 20;
x[] = {{0, a, a + m, 2 * a + m}};
For i In {{0:3}}
 Point(10 + i) = {{x[i], -h, 0}}; Point(20 + i) = {{x[i], h, 0}};
 Line(100 + i) = {{10 + i, 20 + i}};
EndFor
For i In {{0:2}}
 Line(200 + i) = {{10 + i, 11 + i}}; Line(300 + i) = {{20 + i, 21 + i}};
 Curve Loop(i + 1) = {{200 + i, 101 + i, -(300 + i), -(100 + i)}};
 Plane Surface(i + 1) = {{i + 1}};
EndFor
Transfinite Curve{{100:103}} = 4 * {n} + 1;
Transfinite Curve{{200, 202, 300, 302}} = 3 * {n} + 1;
Transfinite Curve{{201, 301}} = 5 * {n} + 1;
Transfinite Surface{{1:3}}; Recombine Surface{{1:3}};
o1[] = Extrude{{0, 0, 4}}{{ Surface{{1}}; Layers{{1}}; Recombine; }};
o2[] = Extrude{{0, 0, 4}}{{ Surface{{2}}; Layers{{1}}; Recombine; }};
o3[] = Extrude{{0, 0, 4}}{{ Surface{{3}}; Layers{{1}}; Recombine; }};
Physical Volume("part") = {{o1[1], o2[1], o3[1]}};
Physical Surface("pad_left") = {{o1[2], o1[4]}};
Physical Surface("pad_right") = {{o3[2], o3[4]}};
Physical Surface("end_left") = {{o1[5]}};
Physical Surface("end_right") = {{o3[3]}};
"""

BAR = """
L = 100; b = 6; h = 20;
Point(1) = {0, -h/2, -b/2}; Point(2) = {0, h/2, -b/2};
Point(3) = {0, h/2, b/2}; Point(4) = {0, -h/2, b/2};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4}; Plane Surface(1) = {1};
Transfinite Curve{1, 3} = 3; Transfinite Curve{2, 4} = 2;
Transfinite Surface{1}; Recombine Surface{1};
o[] = Extrude{L, 0, 0}{ Surface{1}; Layers{12}; Recombine; };
Physical Volume("part") = {o[1]};
Physical Surface("root") = {1}; Physical Surface("tip") = {o[0]};
"""


def part_of(clevis, script, case, *arguments):
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        support.gmsh(folder, script)
        scene = folder / "scene.toml"
        scene.write_text(f"""schema = 1
name = "bench"
{support.STEEL}[[part]]
name = "part"
mesh = "part.msh"
length_unit = "mm"
material = "steel"
limits = {{ safety_factor = 1.0 }}
[[part.case]]
name = "load"
{case}
""")
        return support.check(clevis, scene, "--model", "3d", *arguments).part


def zones(part):
    return [zone["name"].split(" at ")[0] for zone in part["singular_zones"]
            if zone["governs"]]


def main():
    faults = support.Checks()
    clevis = sys.argv[1]
    shear = ('traction = { pad_left = ["-80 MPa", "0 MPa", "0 MPa"], '
             'pad_right = ["80 MPa", "0 MPa", "0 MPa"] }')
    for n in (1, 2):
        part = part_of(clevis, PLATE.format(n=n), shear)
        ends = set(zones(part))
        faults.expect(ends == {"end of the shear on pad_left",
                               "end of the shear on pad_right"},
                      f"shear, mesh {n}: ends of the pads govern: {ends}")
        faults.expect(part["verdict"] == "not judged",
                      f"shear, mesh {n}: {part['verdict']}")
        away = part["peak_outside_singular_zones"]["value_MPa"]
        # 100 MPa in the mean of the section between the pads
        faults.expect(95.0 < away < 300.0,
                      f"shear, mesh {n}: {away:.1f} MPa away from the ends")
    part = part_of(clevis, PLATE.format(n=1),
                   'pressure = { end_left = "-100 MPa", end_right = "-100 MPa" }')
    faults.expect(part["verdict"] == "pass" and not part["singular_zones"],
                  f"pressure: {part['verdict']}, zones {part['singular_zones']}")
    for bed, wanted in (("1e5", ["edge of root"]), ("1e4", [])):
        part = part_of(clevis, BAR, f"""foundation = {{ root = "{bed} N/mm^3" }}
traction = {{ tip = ["0 MPa", "4 MPa", "0 MPa"] }}""")
        faults.expect(zones(part) == wanted, f"bed of {bed} N/mm^3: {zones(part)}")
    return faults.exit_code()


if __name__ == "__main__":
    sys.exit(main())

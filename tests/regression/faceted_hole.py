#!/usr/bin/env python3
"""A hole of flat facets that no group calls round, against the same as a bore.

    faceted_hole.py CLEVIS

A quarter of a plate with a hole, pulled, with 4, 8 and 32 facets to the quarter
(16, 32 and 128 round): the hole is taken for the cylinder that it is and that
is said; its peak is that of the group named bore_, and its band holds that of
CalculiX 2.20 (330.7 MPa, C3D20, 25 965 nodes of three layers, on the deck of
`clevis export`). A hole in the shape of an
ellipse stays in facets: its band holds the peak of the same ellipse in cells
of order 2. A kink of 10 degrees in the side of a bar, all alone, is no curve
and does not pass.
"""
import sys
import tempfile
from pathlib import Path

import support

GEO = """R = 10; A = {a}; W = 40; H = 60; T = 8;
Point(1) = {{A, 0, 0}}; Point(2) = {{W, 0, 0}}; Point(3) = {{W, H, 0}};
Point(4) = {{0, H, 0}}; Point(5) = {{0, R, 0}}; Point(6) = {{0, 0, 0}};
{arc}
Line(2) = {{1, 2}}; Line(3) = {{2, 3}}; Line(4) = {{3, 4}}; Line(5) = {{4, 5}};
Curve Loop(1) = {{2, 3, 4, 5, -1}}; Plane Surface(1) = {{1}};
Transfinite Curve {{1}} = {facets} + 1;
Mesh.MeshSizeMin = 0.5; Mesh.MeshSizeMax = 6;
Mesh.RecombineAll = 1; Mesh.RecombinationAlgorithm = 2; Mesh.Algorithm = 6; Mesh.ElementOrder = {order};
Mesh.MshFileVersion = 2.2;
out[] = Extrude {{0, 0, T}} {{ Surface{{1}}; Layers{{1}}; Recombine; }};
Physical Volume("body") = {{out[1]}};
Physical Surface("bottom_cut") = {{out[2]}};
Physical Surface("end") = {{out[4]}};
Physical Surface("middle_cut") = {{out[5]}};
Physical Surface("{hole}") = {{out[6]}};
"""
TRUTH, SCATTER = 330.7, 0.002  # MPa, by CalculiX
ROUND = "Circle(1) = {1, 6, 5};"
ELLIPSE = "Ellipse(1) = {1, 6, 1, 5};"

SCENE = f"""schema = 1
name = "faceted hole"
{support.STEEL}""" + """
[[part]]
name = "plate"
mesh = "plate.msh"
length_unit = "mm"
material = "steel"
limits = {{ safety_factor = 1.5, singular_zones = "{zones}" }}

[[part.case]]
name = "pull"
fixed = {{ {fixed} }}
traction = {{ end = ["0 MPa", "100 MPa", "0 MPa"] }}
"""
CUTS = 'bottom_cut = ["y"], middle_cut = ["x"]'


def check(clevis, folder, text):
    (folder / "scene.toml").write_text(text)
    found = support.check(clevis, folder / "scene.toml", exits=support.JUDGED)
    return found.part, found.text


def plate(clevis, folder, facets, hole="hole", arc=ROUND, a=10, order=1,
          zones="exclude"):
    support.gmsh(folder, GEO.format(a=a, arc=arc, facets=facets, hole=hole,
                                    order=order), "plate")
    return check(clevis, folder, SCENE.format(zones=zones, fixed=CUTS))


def round_faults(clevis, folder):
    for facets in (4, 8, 32):
        bore, _ = plate(clevis, folder, facets, hole="bore_hole")
        part, out = plate(clevis, folder, facets)
        peak, band = (part["peak_von_mises"][k] for k in ("value_MPa",
                                                          "band_MPa"))
        exact = bore["peak_von_mises"]["value_MPa"]
        print(f"{4 * facets} facets: {peak:.2f} {band}, as bore_ {exact:.2f}, "
              f"{part['verdict']}")
        if abs(peak / exact - 1) > 1e-6:
            yield f"{4 * facets} facets: {peak} MPa for {exact}"
        if not (band[0] <= TRUTH * (1 + SCATTER)
                and TRUTH * (1 - SCATTER) <= band[1]):
            yield f"{4 * facets} facets: {band} MPa without {TRUTH}"
        if part["verdict"] != bore["verdict"]:
            yield f"{4 * facets} facets: {part['verdict']}"
        if "taken for it" not in out:
            yield f"{4 * facets} facets: not said: {out}"


def ellipse_faults(clevis, folder):
    truth, _ = plate(clevis, folder, 24, arc=ELLIPSE, a=14, order=2)
    exact = truth["peak_von_mises"]["value_MPa"]
    for facets in (12, 24):
        part, out = plate(clevis, folder, facets, arc=ELLIPSE, a=14)
        low, high = part["peak_von_mises"]["band_MPa"]
        print(f"ellipse in {4 * facets} facets: [{low:.1f}, {high:.1f}] MPa, "
              f"in cells of order 2 {exact:.1f}")
        if not low <= exact <= high:
            yield f"ellipse in {facets}: [{low}, {high}] MPa without {exact}"
        if "kink by" not in out:
            yield f"ellipse in {facets}: facets not told"


def kink_faults(clevis, folder):
    support.gmsh(folder, """
W = 40; H = 10; D = W * Tan(10 * Pi / 180);
Point(1) = {-W, 0, 0}; Point(2) = {0, 0, 0}; Point(3) = {W, -D, 0};
Point(4) = {W, -D - H, 0}; Point(5) = {0, -H, 0}; Point(6) = {-W, -H, 0};
Line(1) = {1, 6}; Line(2) = {6, 5}; Line(3) = {5, 2}; Line(4) = {2, 1};
Line(5) = {5, 4}; Line(6) = {4, 3}; Line(7) = {3, 2};
Curve Loop(1) = {1, 2, 3, 4}; Plane Surface(1) = {1};
Curve Loop(2) = {-3, 5, 6, 7}; Plane Surface(2) = {2};
Transfinite Curve {2, 4, 5, 7} = 13; Transfinite Curve {1, 3, 6} = 5;
Transfinite Surface {1}; Transfinite Surface {2}; Recombine Surface {1, 2};
Mesh.MshFileVersion = 2.2;
a[] = Extrude {0, 0, 8} { Surface{1, 2}; Layers{1}; Recombine; };
Physical Volume("body") = {a[1], a[7]};
Physical Surface("middle_cut") = {a[2]};
Physical Surface("end") = {a[10]};
""", "plate")
    scene = SCENE.replace('"0 MPa", "100 MPa"', '"0 MPa", "-2 MPa"').format(
        zones="count", fixed='middle_cut = ["x", "y", "z"]')
    part, _ = check(clevis, folder, scene)
    names = [zone["name"] for zone in part["singular_zones"]]
    print(f"kink of 10 degrees: {part['verdict']}, zones {names}")
    if not any(name.startswith("notch at (0.0, -10.0") for name in names):
        yield f"no zone at the kink: {names}"


def main():
    clevis = str(Path(sys.argv[1]).resolve())
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        found = [*round_faults(clevis, folder), *ellipse_faults(clevis, folder),
                 *kink_faults(clevis, folder)]
    for fault in found:
        print(fault, file=sys.stderr)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())

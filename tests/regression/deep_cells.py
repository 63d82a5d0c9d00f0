#!/usr/bin/env python3
"""Cells that reach many radii of a hole into a part: no degree shows what stress falls
by within the first radius, and degrees agree on too little of it. The band holds the
truth all the same, nothing deep is called converged, and a note tells it.

    deep_cells.py CLEVIS

A disc with a bore under pressure, as a plate, against Lamé. A quarter of a block with a
hole, pulled, in plane strain: Kirsch's stress times sqrt(1 - nu + nu^2), as Howland
corrects it for the width, and that of a mesh graded towards the hole.
"""
import math
import re
import sys
import tempfile
from pathlib import Path

import hex_mesh
import scene_text
import support

RADIUS = 3.0  # mm
PRESSURE, PULL, RATIO = 50.0, 100.0, 0.3  # MPa
PER_RADIUS, DEEP = 0.05, 2.0  # docs/theory, "Holes in deep cells"


def quarter(divisions, half, height, names, side=lambda c, s: 1.0, grade=1.0):
    """Of what reaches from the hole to half times side(cosine, sine); grade: 1 is even."""
    def at(x, y, z):
        angle = 0.5 * math.pi * y
        c, s = math.cos(angle), math.sin(angle)
        radius = RADIUS + (half * side(c, s) - RADIUS) * x**grade
        return radius * c, radius * s, height * z
    return hex_mesh.block((*divisions, 1), at, names)


class Found:
    def __init__(self, clevis, mesh, case, *arguments):
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            hex_mesh.write(folder / "part.msh", mesh)
            (folder / "scene.toml").write_text(
                scene_text.head("hole", support.steel(RATIO), world="") + f"""[[part]]
name = "part"
mesh = "part.msh"
length_unit = "mm"
material = "steel"
limits = {{ safety_factor = 1 }}
[[part.case]]
name = "load"
{case}
""")
            answer = support.check(clevis, folder / "scene.toml", *arguments,
                                   exits=support.JUDGED)
        self.peak, self.band = answer.peak, answer.band
        self.converged = answer.part["peak_von_mises"]["verdict"] == "converged"
        told = re.search(r"reach (\S+) radii of the hollow face", " ".join(answer.part["notes"]))
        self.told = float(told[1]) if told else 0.0
        # what the degrees alone say
        wide = PER_RADIUS * max(self.told - DEEP, 0.0) * self.peak
        self.bare = (self.band[0] + wide, self.band[1] - wide)

    def expect(self, checks, what, depth, truth):
        checks.holds(self.band, truth, f"{what}, {depth:g} radii deep", slack=0.002)
        checks.expect(not self.converged or depth <= DEEP, "  not called converged")
        checks.expect(self.told > 0 or depth <= DEEP, "  a note tells it")


def check_disc(clevis, checks):
    half = 27.0
    hoop = PRESSURE * (half**2 + RADIUS**2) / (half**2 - RADIUS**2)
    truth = math.sqrt(hoop**2 + PRESSURE**2 + hoop * PRESSURE)
    for radial, missed in ((8, 0.001), (4, 0.003), (2, 0.021), (1, 0.077)):
        found = Found(clevis, quarter((radial, 16), half, 2.0, {"x0": "bore"}),
                      f"""fixed = {{ y0 = ["y"], y1 = ["x"], z0 = ["z"] }}
pressure = {{ bore = "{PRESSURE} MPa" }}""")
        found.expect(checks, "disc", (half - RADIUS) / radial / RADIUS, truth)
        miss = 1 - found.peak / truth
        checks.expect(abs(miss - missed) < 0.002,
                      f"  {found.peak:.2f} MPa, {miss:.1%} below, degrees alone "
                      f"[{found.bare[0]:.1f}, {found.bare[1]:.1f}]")


def block(clevis, depth, layers, around=2, grade=1.0):
    half = RADIUS + depth
    nodes, cells, groups = quarter(
        (layers, around), half, 10.0, {"x0": "bore_hole", "x1": "side"},
        lambda c, s: 1 / max(c, s), grade)
    groups["end"] = [face for face in groups.pop("side")
                     if all(abs(nodes[v][0] - half) < 1e-9 for v in face)]
    return Found(clevis, (nodes, cells, groups),
                 f"""fixed = {{ y0 = ["y"], y1 = ["x"], z0 = ["z"], z1 = ["z"] }}
traction = {{ end = ["{PULL} MPa", "0 MPa", "0 MPa"] }}""", "--model", "3d")


def check_block(clevis, checks):
    """missed: by the band of the degrees alone."""
    graded = block(clevis, 96, 14, around=6, grade=3.0)
    share = RADIUS / (RADIUS + 96)
    howland = (2 + (1 - share)**3) / (1 - share)  # by Heywood's formula
    truth = PULL * howland * math.sqrt(1 - RATIO + RATIO**2)
    checks.expect(abs(graded.peak / truth - 1) < 0.005 and graded.told == 0.0,
                  f"block, graded mesh: {graded.peak:.2f} MPa, Howland {truth:.2f}")
    for depth, layers, missed in ((108, 18, 0.004), (108, 9, 0.027), (96, 4, 0.097),
                                  (108, 4, 0.115)):
        found = block(clevis, depth, layers)
        found.expect(checks, "block", depth / layers / RADIUS, graded.peak)
        miss = 1 - found.bare[1] / graded.peak
        checks.expect(abs(miss - missed) < 0.003,
                      f"  degrees alone [{found.bare[0]:.1f}, {found.bare[1]:.1f}], {miss:.1%} "
                      f"below")


def main():
    clevis = Path(sys.argv[1]).resolve()
    checks = support.Checks()
    check_disc(clevis, checks)
    check_block(clevis, checks)
    return checks.exit_code()


if __name__ == "__main__":
    sys.exit(main())

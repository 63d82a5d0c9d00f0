#!/usr/bin/env python3
"""Cells that reach many radii of a hole into a part: all degrees agree on too low a
stress. Their band holds the truth all the same, and a note says how deep they are.

    deep_cells.py CLEVIS

A quarter of a block with a hole of 3 mm radius, in plane strain, pulled: Kirsch's
stress times sqrt(1 - nu + nu^2), as Howland corrects it for the width, and that of a mesh
graded towards the hole. The bore of a disc under pressure: Lame.
"""
import math
import re
import sys
import tempfile
from pathlib import Path

import hex_mesh
import scene_text
import support

PULL, PRESSURE, RATIO, THICKNESS = 100.0, 40.0, 0.3, 10.0  # MPa, mm
RADIUS = 3.0                                               # of the block's hole
PER_RADIUS, RESOLVED = 0.05, 2.0  # docs/theory, "Holes in deep cells"


def quarter(radius, depth, layers, around, grade, is_round):
    """Block or disc, `depth` from the hole to its side; grade: 1 is even."""
    half = radius + depth

    def place(x, y, z):
        angle = math.pi / 2 * y
        c, s = math.cos(angle), math.sin(angle)
        r = radius + ((half if is_round else half / max(c, s)) - radius) * x**grade
        return r * c, r * s, THICKNESS * z

    nodes, cells, groups = hex_mesh.block(
        (layers, around, 1), place,
        {"x0": "bore_hole", "x1": "round_side" if is_round else "side",
         "y0": "cut_y", "y1": "cut_x"})
    if not is_round:
        groups["end"] = [face for face in groups.pop("side")
                         if all(abs(nodes[v][0] - half) < 1e-9 for v in face)]
    return nodes, cells, groups


class Row:
    def __init__(self, clevis, radius, depth, layers, around=2, grade=1.0, is_round=False):
        load = (f'pressure = {{ bore_hole = "{PRESSURE} MPa" }}' if is_round else
                f'traction = {{ end = ["{PULL} MPa", "0 MPa", "0 MPa"] }}')
        across = 'z0 = ["z"]' if is_round else 'z0 = ["z"], z1 = ["z"]'
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            hex_mesh.write(folder / "part.msh", quarter(radius, depth, layers, around, grade,
                                                        is_round))
            (folder / "scene.toml").write_text(
                scene_text.head("hole", support.steel(RATIO), world="") + f"""[[part]]
name = "part"
mesh = "part.msh"
length_unit = "mm"
material = "steel"
[[part.case]]
name = "load"
fixed = {{ cut_x = ["x"], cut_y = ["y"], {across} }}
{load}
""")
            found = support.check(clevis, folder / "scene.toml", "--model", "3d",
                                  exits=support.JUDGED)
        self.peak, self.band = found.peak, found.band
        told = re.search(r"cells at the peak reach (\S+) radii", found.text)
        self.told = float(told[1]) if told else 0.0
        # what the degrees alone say
        wide = PER_RADIUS * max(self.told - RESOLVED, 0.0) * self.peak
        self.bare = (self.band[0] + wide, self.band[1] - wide)


def howland(half):
    """Largest stress over the pull far from a hole in a strip, by Heywood's formula."""
    share = RADIUS / half
    return (2 + (1 - share)**3) / (1 - share)


def main():
    clevis = Path(sys.argv[1]).resolve()
    checks = support.Checks()
    graded = Row(clevis, RADIUS, 96, 14, around=6, grade=3.0)
    truth = PULL * math.sqrt(1 - RATIO + RATIO**2) * howland(RADIUS + 96)
    checks.expect(abs(graded.peak / truth - 1) < 0.005 and graded.told == 0.0,
                  f"graded mesh: {graded.peak:.2f} MPa, Howland {truth:.2f}")
    truth = graded.peak
    # depth, layers, what the degrees alone miss the truth by
    for depth, layers, missed in ((108, 18, 0.004), (108, 9, 0.03), (96, 4, 0.097),
                                  (108, 4, 0.115)):
        row = Row(clevis, RADIUS, depth, layers)
        what = f"{depth / layers / RADIUS:g} radii deep"
        checks.holds(row.band, truth, f"{what}: band")
        miss = 1 - row.bare[1] / truth
        checks.expect(row.told > RESOLVED and abs(miss - missed) < 0.004,
                      f"{what}, corners {row.told:g}: degrees alone [{row.bare[0]:.1f}, "
                      f"{row.bare[1]:.1f}], {miss:.1%} below, {missed:.1%} expected")
    radius, depth = 5.0, 95.0
    side = radius + depth
    hoop = PRESSURE * (side**2 + radius**2) / (side**2 - radius**2)
    truth = math.sqrt(hoop**2 + hoop * PRESSURE + PRESSURE**2)
    row = Row(clevis, radius, depth, 1, is_round=True)
    checks.holds(row.band, truth, "disc: band")
    checks.expect(row.bare[1] < 0.85 * truth,
                  f"disc: degrees alone {row.peak:.1f} [{row.bare[0]:.1f}, {row.bare[1]:.1f}]")
    return checks.exit_code()


if __name__ == "__main__":
    sys.exit(main())

#!/usr/bin/env python3
"""Cells that reach many radii of a bore into a part: no degree shows what stress falls
by within the first radius, and degrees agree on too little of it. A disc with a bore
under pressure, 3-D and as a plate, against Lamé: wherever the band is called converged
it holds the truth, and what is deep says so.

    deep_cells.py CLEVIS
"""
import math
import sys
import tempfile
from pathlib import Path

import hex_mesh
import support

INNER, OUTER, HEIGHT = 3.0, 27.0, 2.0  # mm
PRESSURE = 50.0  # MPa
DEEP = 2.0  # radii, from which on a note tells it


def lame():
    """Von Mises stress at the bore, no stress along the axis [MPa]."""
    hoop = PRESSURE * (OUTER**2 + INNER**2) / (OUTER**2 - INNER**2)
    return math.sqrt(hoop**2 + PRESSURE**2 + hoop * PRESSURE)


def check(clevis, folder, radial, around):
    def at(x, y, z):
        radius, angle = INNER + (OUTER - INNER) * x, 0.5 * math.pi * y
        return radius * math.cos(angle), radius * math.sin(angle), HEIGHT * z
    hex_mesh.write(folder / "disc.msh", hex_mesh.block(
        (radial, around, 1), at, {"x0": "bore"}))
    (folder / "scene.toml").write_text(f"""schema = 1
name = "disc"
{support.STEEL}
[[part]]
name = "disc"
mesh = "disc.msh"
length_unit = "mm"
material = "steel"
limits = {{ safety_factor = 1 }}
[[part.case]]
name = "press"
fixed = {{ y0 = ["y"], y1 = ["x"], z0 = ["z"] }}
pressure = {{ bore = "{PRESSURE} MPa" }}
""")
    return support.check(clevis, folder / "scene.toml", exits=support.JUDGED)


def main():
    clevis = Path(sys.argv[1]).resolve()
    checks = support.Checks()
    truth = lame()
    print(f"Lamé: {truth:.2f} MPa\n| radii deep | MPa | band | off |\n|---|---|---|---|")
    for radial in (8, 4, 2, 1):
        with tempfile.TemporaryDirectory() as name:
            answer = check(clevis, Path(name), radial, 16)
        depth = (OUTER - INNER) / radial / INNER
        low, high = answer.band
        print(f"| {depth:g} | {answer.peak:.2f} | {low:.2f} … {high:.2f} | "
              f"{100 * (answer.peak / truth - 1):+.1f} % |")
        converged = answer.part["peak_von_mises"]["verdict"] == "converged"
        checks.expect(low <= truth * 1.002 and high >= truth * 0.998,
                      f"{depth:g} radii deep: [{low:.2f}, {high:.2f}] holds {truth:.2f}")
        checks.expect(not converged or depth <= DEEP,
                      f"{depth:g} radii deep: not called converged")
        told = any("radii of the hollow face" in note for note in answer.part["notes"])
        checks.expect(told or depth <= DEEP, f"{depth:g} radii deep: a note tells it")
    return checks.exit_code()


if __name__ == "__main__":
    sys.exit(main())

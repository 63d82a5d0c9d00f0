#!/usr/bin/env python3
"""A clamped strut under a sine of 0.3 of its Euler load along it. Near twice its frequency
any small swing grows (Mathieu: by share ω/4 a second, tenfold in a quarter of a second), far below
what buckles it: that is not judged. Beside it and in steel that damps it stands.

    pulsing_strut.py CLEVIS
"""
import math
import sys
import tempfile
from pathlib import Path

import scene_text
import support
from gliding_bar import sine

LENGTH, HEIGHT, WIDTH, MODULUS, DENSITY = 0.4, 0.004, 0.02, 210e9, 7850.0
BENDING = MODULUS * WIDTH * HEIGHT**3 / 12
EULER = math.pi**2 * BENDING / (2 * LENGTH)**2
FIRST = 1.8751**2 / (2 * math.pi * LENGTH**2) * math.sqrt(
    BENDING / (DENSITY * WIDTH * HEIGHT))


def strut(folder, frequency, damping):
    """frequency in those of its first."""
    file = folder / "scene.toml"
    file.write_text(f"""{scene_text.head("strut")}
{scene_text.part_body("bar")}
{scene_text.joint("W", "weld", "ground", "bar")}
[[force]]
type = "table"
name = "push"
between = ["ground", "bar"]
from = ["0 mm", "0 mm", "0 mm"]
to = ["400 mm", "0 mm", "0 mm"]
axis = [1, 0, 0]
{sine(0.3 * EULER, frequency * FIRST, 1.0)}

[simulation]
duration = "1 s"

{scene_text.BAR}
damping = {damping}
limits = {{ safety_factor = 1.5, singular_zones = "exclude" }}
pins = {{ W = "x0" }}
forces = {{ push = {{ face = "x1" }} }}
""")
    return file


def main():
    clevis = Path(sys.argv[1]).resolve()
    checks = support.Checks()
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        scene_text.write_bar(folder, (LENGTH, HEIGHT, WIDTH), (40, 2, 2))
        for frequency, damping, verdict in ((2.0, 0.0, "not judged"), (2.1, 0.005, "not judged"),
                                            (2.0, 0.15, "pass"), (1.4, 0.0, "pass")):
            part = support.check(clevis, strut(folder, frequency, damping),
                                 exits=support.JUDGED).part
            checks.expect(part["verdict"] == verdict and
                          ("parametric resonance" in part["why"]) == (verdict != "pass"),
                          f"{frequency:g} of its frequency, damping {damping:g}: "
                          f"{part['verdict']} {part['why']}")
    return checks.exit_code()


if __name__ == "__main__":
    sys.exit(main())

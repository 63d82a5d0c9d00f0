#!/usr/bin/env python3
"""Slides that pass a resonance: a bar that glides out of its guide while a sine shakes its
leading end, and a rail over which a shaken carriage glides.

    gliding_bar.py CLEVIS

By two beams of twelve shapes of a free bar in a guide that travels (Newmark's rule, no
damping) 2 N stress the bar with 64 MPa, where the guide is two stiff points, and
73.5 MPa, where it holds the mean and the turn of 60 mm. By a clamped beam of ten shapes
with a mass that travels on it the rail has 8.19 MPa.
"""
import json
import math
import sys
import tempfile
from pathlib import Path

import scene_text
import support

BEAMS = (64.0, 73.5)  # MPa of 2 N
RAIL = 8.19           # MPa


def sine(force, frequency, duration):
    """As times and efforts of a table, N, Hz, s."""
    count = round(24 * duration * frequency)
    turns = [k / 24 for k in range(count + 1)]
    return (f"times = {json.dumps([f'{turn / frequency:.9f} s' for turn in turns])}\n"
            f"efforts = {json.dumps([f'{force * math.sin(2 * math.pi * turn):.9f} N' for turn in turns])}")


def glide(start, end):
    """Of the slide, in 1 s; places in mm."""
    return f"""[[drive]]
joint = "slide"
law = "quintic"
from = "{start} mm"
to = "{end} mm"
duration = "1 s"

[simulation]
duration = "1 s"

"""


def rail(folder):
    """A carriage of 0.3 kg glides by 300 mm in 1 s, shaken at 42 Hz, where the rail swings
    with it in its middle."""
    scene_text.write_bar(folder, (0.4, 0.01, 0.02), (40, 2, 1))
    file = folder / "rail.toml"
    file.write_text(f"""{scene_text.head("rail")}
{scene_text.part_body("bar")}
{scene_text.body("carriage", "0.3 kg", "1e-5 kg m^2", origin=(200, 0, 0))}
{scene_text.joint("root", "weld", "ground", "bar")}
[[joint]]
name = "slide"
type = "prismatic"
between = ["bar", "carriage"]
at = {{ bar = ["200 mm", "0 mm", "0 mm"], carriage = ["0 mm", "0 mm", "0 mm"] }}
axis = [1, 0, 0]

{glide(-150, 150)}[[force]]
type = "table"
name = "shake"
between = ["ground", "carriage"]
from = ["0 mm", "0 mm", "0 mm"]
to = ["0 mm", "0 mm", "0 mm"]
axis = [0, 1, 0]
{sine(0.5, 42.0, 1.0)}

{scene_text.BAR}
limits = {{ safety_factor = 1.5, singular_zones = "exclude" }}
pins = {{ root = "x0", slide = {{ groups = ["y0", "y1"], length = "40 mm" }} }}
drives = {{ slide = {{ face = "x1" }} }}
""")
    return file


def bar(folder, force):
    """Driven by 300 mm in 1 s; the force acts for 0.5 s."""
    scene_text.write_bar(folder, (0.4, 0.005, 0.02), (40, 2, 2))
    file = folder / "scene.toml"
    file.write_text(f"""{scene_text.head("bar")}
{scene_text.part_body("bar")}
[[joint]]
name = "slide"
type = "prismatic"
between = ["ground", "bar"]
at = {{ ground = ["0 mm", "0 mm", "0 mm"], bar = ["350 mm", "0 mm", "0 mm"] }}
axis = [1, 0, 0]

{glide(0, 300)}[[force]]
type = "table"
name = "shake"
between = ["ground", "bar"]
from = ["0 mm", "0 mm", "0 mm"]
to = ["400 mm", "0 mm", "0 mm"]
axis = [0, 1, 0]
{sine(force, 160.0, 0.5)}

{scene_text.BAR}
limits = {{ safety_factor = 1.5 }}
pins = {{ slide = {{ groups = ["y0", "y1"], length = "60 mm" }} }}
drives = {{ slide = {{ face = "x0" }} }}
forces = {{ shake = {{ face = "x1" }} }}
""")
    return file


def main():
    clevis = Path(sys.argv[1]).resolve()
    checks = support.Checks()
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for force, verdict in ((2.0, "pass"), (12.0, "not judged")):
            part = support.check(clevis, bar(folder, force), exits=support.JUDGED).part
            low, high = part["vibration"]["band_MPa"]
            least, most = (0.5 * force * beam for beam in BEAMS)
            checks.expect(low < least and most < high < 2.5 * most,
                          f"{force:g} N: {low:.1f} to {high:.1f} MPa, by beams {least:.0f} and {most:.0f}")
            checks.expect(part["verdict"] == verdict, f"{force:g} N: {part['verdict']}: {part['why']}")
        part = support.check(clevis, rail(folder), exits=support.JUDGED).part
        low, high = part["vibration"]["band_MPa"]
        checks.expect(low < RAIL < high < 5.0 * RAIL,
                      f"rail: {low:.2f} to {high:.2f} MPa, by a beam {RAIL:.2f}")
    return checks.exit_code()


if __name__ == "__main__":
    sys.exit(main())

#!/usr/bin/env python3
"""A bar that glides out of its guide while a sine shakes its leading end: its free length
passes that at which it is in resonance.

    gliding_bar.py CLEVIS

By two beams of twelve shapes of a free bar in a guide that travels (Newmark's rule, no
damping) 2 N stress it with 64 MPa, where the guide is two stiff points, and 73.5 MPa,
where it holds the mean and the turn of 60 mm.
"""
import json
import math
import sys
import tempfile
from pathlib import Path

import scene_text
import support

BEAMS = (64.0, 73.5)  # MPa of 2 N
FREQUENCY = 160.0     # Hz


def scene(folder, force):
    """Driven by 300 mm in 1 s; the force acts for 0.5 s."""
    scene_text.write_bar(folder, (0.4, 0.005, 0.02), (40, 2, 2))
    times = [k / FREQUENCY / 16 for k in range(int(0.5 * FREQUENCY * 16) + 1)]
    efforts = [force * math.sin(2 * math.pi * FREQUENCY * time) for time in times]
    file = folder / "scene.toml"
    file.write_text(f"""{scene_text.head("bar")}
{scene_text.part_body("bar")}
[[joint]]
name = "slide"
type = "prismatic"
between = ["ground", "bar"]
at = {{ ground = ["0 mm", "0 mm", "0 mm"], bar = ["350 mm", "0 mm", "0 mm"] }}
axis = [1, 0, 0]

[[drive]]
joint = "slide"
law = "quintic"
from = "0 mm"
to = "300 mm"
duration = "1 s"

[[force]]
type = "table"
name = "shake"
between = ["ground", "bar"]
from = ["0 mm", "0 mm", "0 mm"]
to = ["400 mm", "0 mm", "0 mm"]
axis = [0, 1, 0]
times = {json.dumps([f"{time:.9f} s" for time in times])}
efforts = {json.dumps([f"{effort:.9f} N" for effort in efforts])}

[simulation]
duration = "1 s"

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
            part = support.check(clevis, scene(folder, force), exits=support.JUDGED).part
            low, high = part["vibration"]["band_MPa"]
            least, most = (0.5 * force * beam for beam in BEAMS)
            checks.expect(low < least and most < high < 2.5 * most,
                          f"{force:g} N: {low:.1f} to {high:.1f} MPa, by beams {least:.0f} and {most:.0f}")
            checks.expect(part["verdict"] == verdict, f"{force:g} N: {part['verdict']}: {part['why']}")
    return checks.exit_code()


if __name__ == "__main__":
    sys.exit(main())

#!/usr/bin/env python3
"""Parts whose hold changes as they swing: a bar that glides out of its guide while a sine
shakes its leading end, one that is plucked and drawn in, a rail over which a shaken
carriage glides, an arm whose forearm folds.

    gliding_bar.py CLEVIS

By a beam of twelve shapes of a free bar (Newmark's rule, no damping), of which a guide that
travels holds the mean and the turn of 60 mm, the first bar has 441 MPa and the second
262: the energy of its swing goes as its frequency. By a clamped beam of ten shapes with a
mass that travels on it the rail has 8.19 MPa. By beams with a forearm that turns, Coriolis
forces included, the arm has 277 to 300 MPa.
"""
import json
import math
import sys
import tempfile
from pathlib import Path

import scene_text
import support

BAR = 441.0  # MPa
DRAWN_IN = 262.0
RAIL = 8.19
ARM = (277.0, 300.0)


def sine(force, frequency, duration):
    """As times and efforts of a table, N, Hz, s."""
    count = round(24 * duration * frequency)
    turns = [k / 24 for k in range(count + 1)]
    return (f"times = {json.dumps([f'{turn / frequency:.9f} s' for turn in turns])}\n"
            f"efforts = {json.dumps([f'{force * math.sin(2 * math.pi * turn):.9f} N' for turn in turns])}")


def glide(start, end, at=0.0, takes=1.0, until=1.0):
    """Of the slide; places in mm, times in s."""
    return f"""[[drive]]
joint = "slide"
law = "quintic"
from = "{start} mm"
to = "{end} mm"
start = "{at} s"
duration = "{takes} s"

[simulation]
duration = "{until} s"

"""


def pluck(force, until):
    """As times and efforts of a table, N, s."""
    return (f'times = ["0 s", "{until} s", "{until + 1e-4} s"]\n'
            f'efforts = ["{force} N", "{force} N", "0 N"]')


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


def arm(folder):
    """A forearm of 1 kg folds by 170° in 1 s."""
    scene_text.write_bar(folder, (0.4, 0.01, 0.02), (40, 2, 1))
    file = folder / "arm.toml"
    file.write_text(f"""{scene_text.head("arm")}
{scene_text.part_body("bar")}
{scene_text.body("hub", "0.01 kg", "1e-7 kg m^2", origin=(400, 0, 0))}
{scene_text.body("fore", "1 kg", "1e-4 kg m^2", center=(250, 0, 0), origin=(400, 0, 0))}
{scene_text.joint("root", "weld", "ground", "bar")}
{scene_text.joint("wrist", "weld", "bar", "hub", (400, 0, 0))}
{scene_text.joint("elbow", "revolute", "hub", "fore", (400, 0, 0), (0, 0, 1))}
normal = {{ hub = [1, 0, 0], fore = [1, 0, 0] }}

[[drive]]
joint = "elbow"
law = "quintic"
from = "0 deg"
to = "170 deg"
start = "0.2 s"
duration = "1 s"

[simulation]
duration = "1.5 s"

[[force]]
type = "table"
name = "pluck"
between = ["ground", "hub"]
from = ["400 mm", "-500 mm", "0 mm"]
to = ["0 mm", "0 mm", "0 mm"]
axis = [0, 1, 0]
{pluck(100, 0.1)}

{scene_text.BAR}
limits = {{ safety_factor = 1.5, singular_zones = "exclude" }}
pins = {{ root = "x0", wrist = "x1" }}
""")
    return file


def bar(folder, motion, efforts):
    """In a guide of 60 mm; a force acts on the end that stands out."""
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

{motion}[[force]]
type = "table"
name = "shake"
between = ["ground", "bar"]
from = ["0 mm", "0 mm", "0 mm"]
to = ["400 mm", "0 mm", "0 mm"]
axis = [0, 1, 0]
{efforts}

{scene_text.BAR}
limits = {{ safety_factor = 1.5, singular_zones = "exclude" }}
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
        def compare(name, file, beam, widest, verdict):
            """beam: from, to in MPa."""
            part = support.check(clevis, file, exits=support.JUDGED).part
            low, high = part["vibration"]["band_MPa"]
            checks.expect(low < beam[0] and beam[1] < high and high - low < widest * beam[1],
                          f"{name}: {low:.2f} to {high:.2f} MPa, by a beam {beam[0]:.4g} to {beam[1]:.4g}")
            checks.expect(part["verdict"] == verdict,
                          f"{name}: {part['verdict']}: {part['why']}")

        compare("driven out", bar(folder, glide(0, 300), sine(12.0, 160.0, 0.5)), (BAR, BAR),
                0.2, "fail")
        drawn_in = bar(folder, glide(300, 100, 0.1, 0.5, 0.7), pluck(30, 0.05))
        compare("drawn in", drawn_in, (DRAWN_IN, DRAWN_IN), 0.15, "fail")
        compare("rail", rail(folder), (RAIL, RAIL), 0.2, "pass")
        compare("arm", arm(folder), ARM, 0.5, "not judged")
    return checks.exit_code()


if __name__ == "__main__":
    sys.exit(main())

#!/usr/bin/env python3
"""A bar 24 mm high and 8 mm thick whose mechanism holds it otherwise in the course of its
motion, in its plane alone, where its first vibration of all, across it, does not change:
spring or brake at first, a sine at the frequency without them later, against twins whose
same forces are tables over time; a stop that it comes to, against a spring; that it
leaves, against a shorter motion; friction between points, against a spring.

    changed_holds.py CLEVIS
"""
import math
import sys
import tempfile
from pathlib import Path

import scene_text
import support

GEOMETRY = """L = 300; R = 12; r = 5;
Point(1) = {0, 0, 0}; Point(2) = {L, 0, 0};
For i In {0 : 1}
  x = i * L; s = 1 - 2 * i; p = 10 * (i + 1);
  Point(p + 1) = {x, -s * R, 0}; Point(p + 2) = {x - s * R, 0, 0};
  Point(p + 3) = {x, s * R, 0};
  Circle(p + 1) = {p + 1, i + 1, p + 2}; Circle(p + 2) = {p + 2, i + 1, p + 3};
  Point(p + 4) = {x + r, 0, 0}; Point(p + 5) = {x - r, 0, 0};
  Circle(p + 4) = {p + 4, i + 1, p + 5}; Circle(p + 5) = {p + 5, i + 1, p + 4};
  Curve Loop(i + 2) = {p + 4, p + 5};
EndFor
Line(1) = {13, 21}; Line(2) = {23, 11};
Curve Loop(1) = {11, 12, 1, 21, 22, 2};
Plane Surface(1) = {1, 2, 3};
Physical Curve("bore_A") = {14, 15}; Physical Curve("bore_B") = {24, 25};
Physical Surface("body") = {1};
MeshSize {:} = 8;
Transfinite Curve {14, 15, 24, 25} = 9;
Mesh.RecombineAll = 1;
Mesh.ElementOrder = 2;
"""

AT_TIP = """between = ["ground", "bar"]
from = ["300 mm", "-200 mm", "0 mm"]
to = ["300 mm", "0 mm", "0 mm"]
axis = [0, 1, 0]
"""


def rows(unit, values):
    return "[" + ", ".join(f'"{value:.10g} {unit}"' for value in values) + "]"


def table(name, times, efforts, line, unit):
    return (f'[[force]]\nname = "{name}"\ntype = "table"\n{line}'
            f"times = {rows('s', times)}\nefforts = {rows(unit, efforts)}\n")


def sine(name, amplitude, frequency, start, end, mean=0.0, before=()):
    """A tip load [N]: rows before it, then a sine about a mean."""
    step = 1.0 / frequency / 24
    count = int((end - start) / step)
    times = [t for t, _ in before] + [start + k * step for k in range(count)]
    loads = [f for _, f in before] + [
        mean + amplitude * math.sin(2.0 * math.pi * k / 24) for k in range(count)]
    return table(name, times, loads, AT_TIP, "N")


def scene(folder, forces, part, duration, instants):
    (folder / "bar.geo").write_text(GEOMETRY)
    file = folder / "scene.toml"
    file.write_text(scene_text.head("bar") + scene_text.part_body("bar") +
                    scene_text.joint("A", "revolute", "ground", "bar", axis=(0, 0, 1)) +
                    forces + f"""
[simulation]
duration = "{duration} s"
instants = {instants}
[accuracy]
peak_stress = "5 %"
[[part]]
name = "bar"
geometry = "bar.geo"
length_unit = "mm"
thickness = "8 mm"
material = "steel"
pins = {{ A = "bore_A" }}
{part}
limits = {{ safety_factor = 1.3 }}
""")
    return file


def bumped(folder, bump):
    """Its tip leaves a spring of 1 kN/mm as it turns, and is shaken then."""
    drive = """[[drive]]
joint = "A"
law = "quintic"
from = "0 deg"
to = "4 deg"
start = "0.02 s"
duration = "0.04 s"
"""
    return scene(folder, drive + sine("sine", 30.0, 200.3, 0.07, 0.11) + bump,
                 """drives = { A = { face = "bore_A" } }
forces = { sine = { face = "bore_B" }, bump = { face = "bore_B" } }
damping = 0.01""", 0.12, 121)


def braked(folder, brake):
    """It sticks to its pin, breaks away at 40.5 ms and is shaken as it slips."""
    load = sine("load", 100.0, 918.7, 0.05, 0.07, mean=12.0,
                before=((0.0, 115.0), (0.04, 115.0), (0.041, 125.0)))
    return scene(folder, load + brake,
                 """forces = { load = { face = "bore_B" }, brake = { face = "bore_A" } }
damping = 0.005""", 0.07, 71)


def stopped(folder, stop, duration=0.06):
    """It comes to a stop and is pressed on it harder than it swings, then leaves it."""
    push = """[[initial]]
joint = "A"
position = "-1e-6 rad"
rate = "0 rad/s"
""" + table("push", [0.0, 0.01, 0.057, 0.059, 1.0], [5.0, 400.0, 400.0, -0.5, -0.5],
            'joint = "A"\n', "N m")
    return scene(folder, push + sine("sine", 36.0, 198.0, 0.03, 0.055) + stop,
                 """forces = { sine = { face = "bore_B" }, push = { face = "bore_A" }, \
stop = { face = "bore_A" } }
damping = 0.01""", duration, round(1e3 * duration) + 1)


def pinched(folder, pinch):
    """Its tip is held across it, a torque shakes its pin."""
    step = 1.0 / 635.0 / 24
    times = [0.0] + [0.005 + k * step for k in range(289)]
    torque = [0.0] + [15.0 * math.sin(2.0 * math.pi * k / 24) for k in range(289)]
    return scene(folder, table("torque", times, torque, 'joint = "A"\n', "N m") + pinch,
                 """forces = { torque = { face = "bore_A" }, pinch = { face = "bore_B" } }
damping = 0.005""", 0.03, 31)


def checked(write, force):
    with tempfile.TemporaryDirectory() as name:
        found = support.check(sys.argv[1], write(Path(name), force), "--mesh",
                              exits=support.JUDGED)
    return found.code, found.part


def compare(what, one, twin, least):
    """@param least  times as much as at rest, by its own resonance."""
    peaks = [part["vibration"]["peak_MPa"] for _, part in (one, twin)]
    print(f"{what}: {peaks[0]:.4g} and {peaks[1]:.4g} MPa with vibration")
    if [one[0], twin[0]] != [1, 1]:
        sys.exit(f"{what}: a part that swings at its resonance passed")
    if abs(peaks[0] / peaks[1] - 1.0) > 0.02:
        sys.exit(f"{what}: not as its twin")
    for _, part in (one, twin):
        if part["vibration"]["ratio"] < least:
            sys.exit(f"{what}: not at its resonance")


STOP = """[[force]]
name = "stop"
type = "stop"
joint = "A"
upper = "0 rad"
stiffness = "1e6 N m/rad"
damping = "100 N m s/rad"
"""


def main():
    # 1 kN/mm over 0.2 mm, left as the tip rises: that height over time.
    at = [0.02 + 0.04 * k / 400 for k in range(401)]

    def height(t):
        s = (t - 0.02) / 0.04
        return 300e-3 * math.sin(math.radians(4.0) * s**3 * (10 - 15 * s + 6 * s * s))

    pressed = [max(0.0, 200.0 - 1e6 * height(t)) for t in at]
    compare("spring that it leaves",
            checked(bumped, f'[[force]]\nname = "bump"\ntype = "table"\n{AT_TIP}'
                            'positions = ["190 mm", "200.2 mm"]\n'
                            'efforts = ["10200 N", "0 N"]\n'),
            checked(bumped, table("bump", at, pressed, AT_TIP, "N")), 3.0)
    compare("brake that slips",
            checked(braked, '[[force]]\nname = "brake"\ntype = "friction"\njoint = "A"\n'
                            'breakaway = "36 N m"\nkinetic = "3 N m"\n'),
            checked(braked, table("brake", [0.0, 0.04, 0.0405, 0.0405, 0.1],
                                  [-34.5, -34.5, -36.0, -3.0, -3.0], 'joint = "A"\n',
                                  "N m")), 3.0)
    on_stop = checked(stopped, STOP)
    compare("stop that it comes to", on_stop,
            checked(stopped, STOP.replace('"stop"\njoint', '"spring"\njoint')
                    .replace("upper", "free")), 3.0)
    compare("stop that it leaves at a third of its motion", on_stop,
            checked(lambda folder, stop: stopped(folder, stop, 0.18), STOP), 3.0)
    compare("friction between points",
            checked(pinched, f'[[force]]\nname = "pinch"\ntype = "friction"\n{AT_TIP}'
                             'breakaway = "20 kN"\nkinetic = "20 kN"\n'),
            checked(pinched, f'[[force]]\nname = "pinch"\ntype = "spring"\n{AT_TIP}'
                             'free = "200 mm"\nstiffness = "1e9 N/m"\n'), 3.0)


if __name__ == "__main__":
    main()

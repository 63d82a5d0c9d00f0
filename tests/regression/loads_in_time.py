#!/usr/bin/env python3
"""Loads that act for moments between the instants of a driven motion are in the
part's verdict: a pulse of 1 ms, a sine sampled at its zeros, a contact met for
1 ms, a cam of two millimetres.

    loads_in_time.py CLEVIS SOURCE_DIR

The arm is the reference link on a driven shaft. Truth, independent of the time:
CalculiX 2.20 on the decks that `clevis export --split N --elements C3D20R`
writes of the largest load at rest, largest von Mises stress of a node:

    load                        N  nodes   MPa
    800 N across at bore B      3  41 560  758.9
                                4  91 806  760.5
    9996 N along, pin to pin    3  20 780  323.4

and for the sine the force that gives the shaft the torque of the closed form
(m L^2 + J) A (2 pi f)^2.
"""
import math
import sys
import tempfile
from pathlib import Path

import support

CLEVIS = str(Path(sys.argv[1]).resolve())
MESH = Path(sys.argv[2]).resolve() / "meshes/reference_link/link.msh"
CHECKS = support.Checks()
ACROSS, ALONG = 760.5 / 800, 323.4 / 9996  # MPa/N, by CalculiX
SCATTER = 0.005      # of CalculiX's nodes between two meshes
REACH = 140.0        # mm, from bore A to bore B

HEAD = f"""schema = 1
name = "arm under loads in time"
{support.STEEL}
[[body]]
name = "arm"
part = "arm"
[[joint]]
name = "shaft"
type = "revolute"
between = ["ground", "arm"]
point = ["0 mm", "0 mm", "0 mm"]
axis = [0, 0, 1]
"""
PART = f"""
[[part]]
name = "arm"
mesh = "{MESH}"
length_unit = "mm"
material = "steel"
drives = {{ shaft = {{ face = "bore_A" }} }}
limits = {{ safety_factor = 1.5 }}
"""
PUSHED = ('pins = { shaft = "bore_A" }\n'
          'forces = { push = { face = "bore_B" } }\n')
TIPPED = 'pins = { shaft = "bore_A", seat = "bore_B" }\n'
REST = '[[drive]]\njoint = "shaft"\nlaw = "constant"\nfrom = "0 deg"\n'
TURN = ('[[drive]]\njoint = "shaft"\nlaw = "speed"\nfrom = "{} deg"\n'
        'speed = "60 rpm"\n')


def check(folder, blocks, instants, seats=PUSHED, gravity=-9.81):
    scene = folder / "scene.toml"
    scene.write_text(
        f'{HEAD}{blocks}{PART}{seats}\n[world]\n'
        f'gravity = ["0 m/s^2", "{gravity} m/s^2", "0 m/s^2"]\n'
        f'[simulation]\nduration = "1 s"\ninstants = {instants}\n')
    return support.check(CLEVIS, scene, exits=support.JUDGED)


def look(name, instants, truth, found):
    """The band holds the truth, and what breaks fails."""
    said = f"{name}, {instants} instants"
    CHECKS.holds(found.band, truth, said, SCATTER)
    CHECKS.expect(found.part["verdict"] == "fail", f"{said}: {found}")


def quantities(values, unit):
    return "[" + ", ".join(f'"{value:.12g} {unit}"' for value in values) + "]"


def table(over, values, newtons):
    """Across the arm that lies along x; over: "times" or "positions" of its
    tip along y."""
    tip = 'between = ["ground", "arm"]\nto = ["140 mm", "0 mm", "0 mm"]\n'
    start = ["140 mm", "0 mm", "0 mm"] if over == "times" else ["0 mm"] * 3
    unit = "s" if over == "times" else "mm"
    return ('[[force]]\nname = "push"\ntype = "table"\n' + tip
            + f"from = {start}\naxis = [0, 1, 0]\n".replace("'", '"')
            + f"{over} = {quantities(values, unit)}\n"
            f"efforts = {quantities(newtons, 'N')}\n")


def pulse(folder):
    def at(middle, half):
        return REST + table("times", [middle - half, middle, middle + half],
                            [0, 800, 0])
    for instants in (201, 5001):
        look("pulse of 1 ms and 800 N", instants, 800 * ACROSS,
             check(folder, at(0.5025, 0.0005), instants))
    look("the same without gravity", 201, 800 * ACROSS,
         check(folder, at(0.5025, 0.0005), 201, gravity=0))


def sine(folder):
    """A kilogram at the arm's end; the zeros of the sine are the instants."""
    swing, rate, tip = 1.1, 20 * math.pi, 1.0  # rad, rad/s, kg
    blocks = f"""[[body]]
name = "tip"
mass = "{tip} kg"
center_of_mass = ["0 mm", "0 mm", "0 mm"]
inertia = ["1e-7 kg m^2", "1e-7 kg m^2", "1e-7 kg m^2"]
placement = {{ origin = ["{REACH} mm", "0 mm", "0 mm"] }}
[[joint]]
name = "seat"
type = "weld"
between = ["arm", "tip"]
at = {{ arm = ["{REACH} mm", "0 mm", "0 mm"], tip = ["0 mm", "0 mm", "0 mm"] }}
[[drive]]
joint = "shaft"
law = "sine"
from = "0 deg"
amplitude = "{swing} rad"
frequency = "10 Hz"
"""
    eye = math.pi * (12.5**2 - 7.5**2)
    spin = math.pi / 2 * (12.5**4 - 7.5**4)
    web = 12 * ((REACH - 12.5)**3 - 12.5**3) / 3  # without its fillets, 0.2 %
    arm = 7.85e-6 * 8 * (2 * spin + eye * REACH**2 + web)  # kg mm^2
    force = (1e-3 * (tip * REACH**2 + arm) / REACH) * swing * rate**2
    look("sine of 10 Hz", 11, force * ACROSS,
         check(folder, blocks, 11, TIPPED, gravity=0))


def contact(folder):
    """The tip passes a plate while the arm turns by 0.36 degrees, between two
    of 201 instants; 9996 N where it stands upright."""
    half = 0.0005 * 2 * math.pi
    deep = REACH * (1 - math.cos(half))  # mm, at upright
    plate = f"""[[force]]
name = "push"
type = "contact"
body = "arm"
center = ["{REACH} mm", "0 mm", "0 mm"]
radius = "1 mm"
plane_point = ["0 mm", "{REACH + 1 - deep:.12g} mm", "0 mm"]
normal = [0, -1, 0]
stiffness = "{1e3 * 9996 / deep:.12g} N/m"
damping = "0 N s/m"
"""
    # upright at 0.2475 s, 0.2450 and 0.2500 s are printed
    look("contact for 1 ms", 201, 9996 * ALONG,
         check(folder, TURN.format(0.9) + plate, 201))


def cam(folder):
    """800 N at one height of the tip, passed within 1 ms: a table over
    positions."""
    middle = REACH * math.sin(math.radians(0.9))  # at 2.5 ms
    table_of_cam = table("positions", [middle - 0.44, middle, middle + 0.44],
                         [0, 800, 0])
    look("cam for 1 ms", 201, 800 * ACROSS,
         check(folder, TURN.format(0) + table_of_cam, 201))


def main():
    with tempfile.TemporaryDirectory() as name:
        for case in (pulse, sine, contact, cam):
            case(Path(name))
    return CHECKS.exit_code()


if __name__ == "__main__":
    sys.exit(main())

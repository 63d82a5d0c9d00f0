#!/usr/bin/env python3
"""Round bars that a guide holds, or that turn: what is not computed may not pass.

    rods_and_rotors.py CLEVIS

A column's load goes on through the far end of a strut or a rope.
A shaft with a disc near its critical speed, one that is shaken at its frequency while
it turns, and a parallelogram that passes its change point between two instants are not
judged; a weight that stands in space sags a shaft at any speed. A wheel that rolls over
a rail is refused.
"""
import math
import subprocess
import sys
import tempfile
from functools import partial
from pathlib import Path

import scene_text
import support
from round_bar import DENSITY, DIAMETER, INERTIA, MODULUS, check_of, round_bar

FIRST = 168.6  # Hz, of the shaft between its bearings, π/2 √(EI/ρA)/l²


def shaft(folder, speed, disc="", shake="", gravity=0.0):
    """Between bearings 490 mm apart; gravity along -y [m/s²]."""
    round_bar(folder, [(10, 1, "bore_A"), (230, 8, "round_a"), (20, 2, "round_mid"),
                       (230, 8, "round_b"), (10, 1, "bore_B")])
    ground = "carrier" if shake else "ground"
    hub = ""
    if disc:
        hub = disc + scene_text.joint("hub", "weld", "bar", "disc", (250, 0, 0))
    file = folder / "scene.toml"
    world = f'[world]\ngravity = ["0 m/s^2", "{-gravity} m/s^2", "0 m/s^2"]\n'
    file.write_text(f"""{scene_text.head("shaft", world=world)}{scene_text.part_body("bar")}{shake}{hub}
{scene_text.joint("A", "spherical", ground, "bar", (5, 0, 0), (1, 0, 0))}
{scene_text.joint("B", "point_on_line", ground, "bar", (495, 0, 0), (1, 0, 0))}
[[drive]]
joint = "A"
coordinate = "angle_1"
law = "speed"
from = "0 deg"
speed = "{speed} rpm"
[simulation]
duration = "0.2 s"
instants = 101
{scene_text.BAR}pins = {{ A = "bore_A", B = {{ group = "bore_B", length = "10 mm" }}{
    ', hub = "round_mid"' if disc else ""} }}
drives = {{ A = {{ face = "bore_A" }} }}
limits = {{ safety_factor = 2.5, singular_zones = "exclude" }}
[accuracy]
peak_stress = "5 %"
""")
    return file


DISC = scene_text.body("disc", "20 kg", "0.01 kg m^2", center=(0, 1, 0), origin=(250, 0, 0))
EVEN = scene_text.body("disc", "20 kg", "0.01 kg m^2", origin=(250, 0, 0))
SHAKE = scene_text.body("carrier", "5 kg", "0.01 kg m^2") + scene_text.joint(
    "shake", "prismatic", "ground", "carrier", axis=(0, 1, 0)) + f"""[[drive]]
joint = "shake"
law = "sine"
from = "0 mm"
amplitude = "0.01 mm"
frequency = "{FIRST} Hz"
"""


def rail(folder):
    """A wheel of 20 mm that 1000 N press rolls along a rail."""
    round_bar(folder, [(10, 1, "bore_A"), (480, 16, "round_m"), (10, 1, "bore_B")])
    file = folder / "scene.toml"
    file.write_text(f"""{scene_text.head("rail")}{scene_text.part_body("bar")}
{scene_text.body("carriage", "1 kg", "1e-3 kg m^2", origin=(100, 50, 0))}
{scene_text.body("wheel", "1 kg", "1e-3 kg m^2", origin=(100, 29, 0))}
{scene_text.joint("A", "spherical", "ground", "bar", (5, 0, 0), (1, 0, 0))}
{scene_text.joint("B", "point_on_line", "ground", "bar", (495, 0, 0), (1, 0, 0))}
{scene_text.joint("S", "prismatic", "ground", "carriage", (100, 50, 0), (1, 0, 0))}
{scene_text.joint("V", "prismatic", "carriage", "wheel", (100, 29, 0), (0, 1, 0))}
[[drive]]
joint = "A"
coordinate = "angle_1"
law = "constant"
from = "0 deg"
[[drive]]
joint = "S"
law = "quintic"
from = "0 mm"
to = "300 mm"
duration = "1 s"
[[force]]
type = "constant"
name = "push"
body = "wheel"
point = ["0 mm", "0 mm", "0 mm"]
force = ["0 N", "-1000 N", "0 N"]
[[force]]
type = "contact"
name = "roll"
body = "wheel"
center = ["0 mm", "0 mm", "0 mm"]
radius = "20 mm"
plane = "bar"
plane_point = ["0 mm", "10 mm", "0 mm"]
normal = [0, 1, 0]
stiffness = "1e6 N/m"
damping = "1000 N s/m"
[simulation]
duration = "1 s"
instants = 21
{scene_text.BAR}pins = {{ A = "bore_A", B = {{ group = "bore_B", length = "10 mm" }} }}
drives = {{ A = {{ face = "bore_A" }} }}
forces = {{ roll = {{ face = "round_m" }} }}
limits = {{ safety_factor = 3, singular_zones = "exclude" }}
""")
    return file


def column(folder, strut, kind):
    """Welded at its foot, pressed by 4.5 kN at 495 mm through a strut of so many mm,
    which ends in a slide along it: a rod of given length, or a link between two pins.
    Or by a cylinder of two bodies, or by a weight that high on a mast; or pulled down by a
    rope to its foot, a spring."""
    round_bar(folder, [(10, 1, "round_a"), (480, 16, "round_m"), (10, 1, "bore_B")])
    end = 495 + strut
    ram = scene_text.body("ram", "1 kg", "1e-3 kg m^2", origin=(end, 0, 0)) + scene_text.joint(
        "S", "prismatic", "ground", "ram", (end, 0, 0), (1, 0, 0)) + """[[force]]
type = "constant"
name = "push"
body = "ram"
point = ["0 mm", "0 mm", "0 mm"]
force = ["-4.5 kN", "0 N", "0 N"]
"""
    rod = scene_text.joint("B", "distance", "bar", "ram").replace(
        'point = ["0 mm", "0 mm", "0 mm"]',
        'at = { bar = ["495 mm", "0 mm", "0 mm"], ram = ["0 mm", "0 mm", "0 mm"] }')
    link = scene_text.body("strut", "1e-3 kg", "1e-6 kg m^2",
                           origin=((495 + end) / 2, 0, 0)) + scene_text.joint(
        "B", "spherical", "bar", "strut", (495, 0, 0), (1, 0, 0)) + scene_text.joint(
        "C", "universal", "strut", "ram", (end, 0, 0), (0, 1, 0)).replace(
        "axis =", "normal = [0, 0, 1]\naxis =")
    rope = """[[force]]
type = "spring"
name = "rope"
between = ["ground", "bar"]
from = ["0 mm", "0 mm", "0 mm"]
to = ["495 mm", "0 mm", "0 mm"]
stiffness = "1e6 N/m"
free = "490.5 mm"
"""
    cylinder = "".join(scene_text.body(name, "1e-2 kg", "1e-6 kg m^2", origin=(x, 0, 0))
                       for name, x in (("rod", 495 + strut / 4), ("tube", 495 + strut / 2)))
    cylinder += scene_text.joint("B", "spherical", "bar", "rod", (495, 0, 0), (1, 0, 0))
    cylinder += scene_text.joint("S", "prismatic", "tube", "rod", (495 + strut / 2, 0, 0),
                                 (1, 0, 0))
    cylinder += scene_text.joint("C", "universal", "tube", "ground", (end, 0, 0),
                                 (0, 1, 0)).replace("axis =", "normal = [0, 0, 1]\naxis =")
    cylinder += """[[force]]
type = "spring"
name = "push"
joint = "S"
stiffness = "0 N/m"
preload = "4.5 kN"
free = "0 mm"
"""
    mast = scene_text.body("mast", "1e-2 kg", "1e-6 kg m^2", origin=(495, 0, 0))
    mast += scene_text.joint("B", "weld", "bar", "mast", (495, 0, 0)) + f"""[[force]]
type = "constant"
name = "push"
body = "mast"
point = ["{strut} mm", "0 mm", "0 mm"]
force = ["-4.5 kN", "0 N", "0 N"]
"""
    above = {"rod": ram + rod, "link": ram + link, "cylinder": cylinder, "mast": mast,
             "rope": rope}[kind]
    seats = ('pins = { A = "left" }\nforces = { rope = { face = "bore_B" } }'
             if kind == "rope" else 'pins = { A = "left", B = "bore_B" }')
    file = folder / "scene.toml"
    file.write_text(f"""{scene_text.head("column")}{scene_text.part_body("bar")}{above}
{scene_text.joint("A", "weld", "ground", "bar")}
[simulation]
duration = "1 s"
instants = 2
{scene_text.BAR}{seats}
limits = {{ safety_factor = 1.5, singular_zones = "exclude" }}
[accuracy]
peak_stress = "50 %"
""")
    return file


def least_load(length, low, high, is_below):
    """k² EI [N] of the least k for which is_below(k) ends; low, high: of kl, in it."""
    low, high = low / length * (1 + 1e-12) + 1e-9, high / length * (1 - 1e-12)
    for _ in range(200):
        k = (low + high) / 2
        low, high = (k, high) if is_below(k) else (low, k)
    return low**2 * MODULUS * INERTIA


def through_a_point(length, strut):
    """Load of a column that is clamped at its foot, through a point a strut's length
    behind its end: P = k² EI with tan kl = k (l + strut) [N]."""
    return least_load(length, 0, math.pi / 2,
                      lambda k: math.tan(k * length) < k * (length + strut))


def on_a_mast(length, height):
    """The same under a weight on a mast: kl tan kl = l/height [N]."""
    return least_load(length, 0, math.pi / 2,
                      lambda k: k * height * math.tan(k * length) < 1)


def swinging(folder, far):
    """A bar on a ball at its left end; its right end slides in a guide on a pin so many mm
    behind it, from which it is pushed off."""
    round_bar(folder, [(10, 1, "round_a"), (480, 16, "round_m"), (10, 1, "bore_B")])
    end = 495 + far
    pivot = scene_text.joint("C", "universal", "guide", "ground", (end, 0, 0),
                             (0, 1, 0)).replace("axis =", "normal = [0, 0, 1]\naxis =")
    file = folder / "scene.toml"
    file.write_text(f"""{scene_text.head("strut")}{scene_text.part_body("bar")}
{scene_text.body("guide", "1e-2 kg", "1e-6 kg m^2", origin=(end, 0, 0))}
{scene_text.joint("A", "spherical", "ground", "bar", (0, 0, 0), (1, 0, 0))}
{scene_text.joint("S", "prismatic", "guide", "bar", (495, 0, 0), (1, 0, 0))}
{pivot}
[[force]]
type = "spring"
name = "push"
joint = "S"
stiffness = "0 N/m"
preload = "20 kN"
free = "0 mm"
[simulation]
duration = "1 s"
instants = 2
{scene_text.BAR}pins = {{ A = "left", S = {{ group = "bore_B", length = "10 mm" }} }}
forces = {{ push = {{ face = "right" }} }}
limits = {{ safety_factor = 1.5, singular_zones = "exclude" }}
[accuracy]
peak_stress = "50 %"
""")
    return file


def in_a_guide(length, far):
    """Load of a strut between a ball and a stiff guide on a pin: tan kl = -k far [N]."""
    return least_load(length, math.pi / 2, math.pi,
                      lambda k: math.tan(k * length) < -k * far)


def parallelogram(clevis, folder, moment):
    """A moment [N m] on the rocker; 15 instants, none near the change points. Beside
    them 10 N m make some 7 kN (166 MPa), 142 MPa are allowed."""
    subprocess.run([clevis, "init", "four_bar", "--template", "four-bar"], cwd=folder,
                   check=True, capture_output=True)
    joints = "".join(
        f"""[[joint]]
name = "{name}"
type = "revolute"
between = ["{first}", "{second}"]
at = {{ {first} = ["{x} mm", "0 mm", "0 mm"], {second} = ["{u} mm", "0 mm", "0 mm"] }}
axis = [0, 0, 1]
""" for name, first, second, x, u in (
            ("A", "ground", "crank", 0, 0), ("B", "crank", "coupler", 60, 0),
            ("C", "coupler", "rocker", 180, 60), ("D", "ground", "rocker", 180, 0)))
    turned = 'angle = "60 deg" }'
    bodies = (scene_text.body("crank", "0.4 kg", "2e-4 kg m^2", (30, 0, 0), (0, 0, 0))
              + scene_text.body("rocker", "0.8 kg", "2e-3 kg m^2", (60, 0, 0), (180, 0, 0)))
    bodies = bodies.replace('] }\n', f'], {turned}\n')
    file = folder / "four_bar" / "scene.toml"
    file.write_text(f"""{scene_text.head("parallelogram")}{bodies}
{scene_text.part_body("coupler")}placement = {{ origin = ["30 mm", "52 mm", "0 mm"] }}
{joints}[[drive]]
joint = "A"
law = "speed"
from = "0 deg"
speed = "120 rpm"
[[force]]
type = "constant"
name = "work"
body = "rocker"
point = ["0 mm", "0 mm", "0 mm"]
force = ["0 N", "0 N", "0 N"]
moment = ["0 N m", "0 N m", "-{moment} N m"]
[simulation]
duration = "0.5 s"
instants = 15
[[part]]
name = "coupler"
geometry = "coupler.geo"
length_unit = "mm"
thickness = "8 mm"
material = "steel"
pins = {{ B = "bore_B", C = "bore_C" }}
limits = {{ safety_factor = 2.5 }}
""")
    support.make_meshes(clevis, file)
    return file


def main():
    clevis = Path(sys.argv[1]).resolve()
    checks = support.Checks()

    check = partial(check_of, clevis)

    for strut, kind in ((100, "rod"), (100, "link"), (100, "cylinder"), (300, "mast"),
                        (2000, "rod"), (-495, "rope")):
        part = check(column, strut, kind).part
        # Through its foot as between two pins.
        theory = (math.pi**2 * MODULUS * INERTIA / 495**2 if kind == "rope"
                  else on_a_mast(495, strut) if kind == "mast"
                  else through_a_point(495, strut)) / 4500
        factor = part["buckling"]["factor"]
        checks.expect(abs(factor / theory - 1) < 0.02,
                      f"column, {kind}: {factor:.4f}, {theory:.4f} by theory")
        checks.expect((part["verdict"] == "pass") == (theory > 1.5),
                      f"column, {kind}: {part['verdict']}")

    part = check(swinging, 400).part
    theory = in_a_guide(490, 405) / 20e3
    factor = part["buckling"]["factor"]
    checks.expect(abs(factor / theory - 1) < 0.03,
                  f"strut in a guide on a pin: {factor:.4f}, {theory:.4f} by theory")

    # Critical with the disc, 17/35 of the shaft's mass beside it: ω² = 48 EI/(l³ m).
    mass = 0.020 + 17 / 35 * DENSITY * math.pi / 4 * DIAMETER**2 * 490
    critical = math.sqrt(48 * MODULUS * INERTIA / 490**3 / mass) * 30 / math.pi
    speed = 0.8 * critical
    part = check(shaft, speed, DISC).part
    checks.expect(part["verdict"] != "pass",
                  f"disc at 0.8 of {critical:.0f} rpm, 2.8 of linear theory's: no pass")
    part = check(shaft, 0.1 * critical, DISC).part
    checks.expect(part["verdict"] == "pass", "disc at a tenth of it: pass")
    # Its weight stands still in space, and sags it whatever the speed.
    part = check(shaft, 0.7 * critical, EVEN, "", 9.81).part
    weight = 9.81 * 20 * 490 / 4 * DIAMETER / 2 / INERTIA
    checks.expect(part["verdict"] == "pass" and
                  abs(part["peak_von_mises"]["value_MPa"] / weight - 1) < 0.1,
                  f"even disc at 0.7 of it: {part['peak_von_mises']['value_MPa']:.1f} MPa, "
                  f"{weight:.1f} by its weight")
    part = check(shaft, 600, "", SHAKE).part
    checks.expect("spins about its length" in part["why"],
                  "shaken at its frequency, 600 rpm: not judged for its spin")
    part = check(shaft, 0, "", SHAKE).part
    checks.expect(part["verdict"] == "pass", "shaken at its frequency at rest: pass")

    with tempfile.TemporaryDirectory() as name:
        answer = support.check(clevis, rail(Path(name)))
        checks.expect("L007" in answer.codes, f"rail: refused, {answer.codes}")
    for moment, verdicts, why in ((10, ("not judged", "fail"), "change points"),
                                  (1, ("pass",), "")):
        with tempfile.TemporaryDirectory() as name:
            answer = support.check(clevis, parallelogram(clevis, Path(name), moment),
                                   exits=support.JUDGED)
        part = answer.part
        checks.expect(part["verdict"] in verdicts and why in part["why"],
                      f"parallelogram, {moment} N m: {part['verdict']}, {part['why']}")
    return checks.exit_code()


if __name__ == "__main__":
    sys.exit(main())

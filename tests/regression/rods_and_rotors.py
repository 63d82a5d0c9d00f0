#!/usr/bin/env python3
"""Round bars that a guide holds, or that turn: what is not computed may not pass.

    rods_and_rotors.py CLEVIS

A rod that slides out of a guide buckles and bends as what the guide touches holds it
(Euler, a cantilever from the guide's end: a little softer, for the guide gives way), and
vibrates at its place. A column's load goes on through the far end of a strut or a rope.
A shaft with a disc near its critical speed, one that is shaken at its frequency while
it turns, and a parallelogram that passes its change point between two instants are not
judged; a weight that stands in space sags a shaft at any speed. A wheel that rolls over
a rail is refused.
"""
import json
import math
import subprocess
import sys
import tempfile
from pathlib import Path

import scene_text
import support

DIAMETER, MODULUS, DENSITY = 20.0, 210e3, 7.85e-9  # mm, MPa, t/mm³
INERTIA = math.pi * DIAMETER**4 / 64
FIRST = 168.6  # Hz, of the shaft between its bearings, π/2 √(EI/ρA)/l²


def round_bar(folder, pieces):
    """bar.msh along x from 0; pieces: (length, layers, group of its wall). Groups left
    and right at the ends."""
    inner, outer = DIAMETER / 2 * 0.55 / math.sqrt(2), DIAMETER / 2 / math.sqrt(2)
    lines = ["Point(1) = {0, 0, 0};"]
    for k, (y, z) in enumerate(((1, 1), (-1, 1), (-1, -1), (1, -1))):
        lines.append(f"Point({2 + k}) = {{0, {inner * y}, {inner * z}}};"
                     f" Point({6 + k}) = {{0, {outer * y}, {outer * z}}};")
    for k in range(4):
        n = (k + 1) % 4
        lines.append(f"Line({1 + k}) = {{{2 + k}, {2 + n}}};"
                     f" Circle({5 + k}) = {{{6 + k}, 1, {6 + n}}};"
                     f" Line({9 + k}) = {{{2 + k}, {6 + k}}};")
    lines.append("Transfinite Curve {1:8} = 3; Transfinite Curve {9:12} = 2;"
                 " Curve Loop(1) = {1, 2, 3, 4}; Plane Surface(1) = {1};")
    for k in range(4):
        lines.append(f"Curve Loop({2 + k}) = {{{9 + k}, {5 + k}, {-9 - (k + 1) % 4}, "
                     f"{-1 - k}}}; Plane Surface({2 + k}) = {{{2 + k}}};")
    lines.append("Transfinite Surface {1:5}; Recombine Surface {1:5};"
                 " now[] = {1, 2, 3, 4, 5}; volumes[] = {};"
                 ' Physical Surface("left") = {1:5};')
    for number, (length, layers, group) in enumerate(pieces):
        wall = f"wall{number}"
        lines.append(f"""next[] = {{}}; {wall}[] = {{}};
For q In {{0:4}}
  e[] = Extrude {{{length}, 0, 0}} {{ Surface{{now[q]}}; Layers{{{layers}}}; Recombine; }};
  next[] += e[0]; volumes[] += e[1];
  If(q > 0)
    {wall}[] += e[3];
  EndIf
EndFor
now[] = next[];
Physical Surface("{group}") = {{{wall}[]}};""")
    lines.append('Physical Surface("right") = {now[]}; Physical Volume("body") ='
                 " {volumes[]}; Mesh.ElementOrder = 2;")
    support.gmsh(folder, "\n".join(lines) + "\n", name="bar")


def guided(folder, drive, loads, simulation):
    """600 mm in a guide of 40 mm about the ground's origin; loads of its free end."""
    round_bar(folder, [(600, 40, "round_m")])
    seats = ", ".join(f'{name} = {{ face = "right" }}' for name in loads)
    forces = "".join(f'[[force]]\nname = "{name}"\n{text}\n' for name, text in loads.items())
    file = folder / "scene.toml"
    file.write_text(f"""{scene_text.head("rod")}
[[body]]
name = "bar"
part = "bar"
placement = {{ origin = ["-60 mm", "0 mm", "0 mm"] }}
{scene_text.joint("S", "prismatic", "ground", "bar", axis=(1, 0, 0)).replace(
    'point = ["0 mm", "0 mm", "0 mm"]',
    'at = { ground = ["0 mm", "0 mm", "0 mm"], bar = ["0 mm", "0 mm", "0 mm"] }')}
[[drive]]
joint = "S"
{drive}
{forces}
[simulation]
{simulation}
{scene_text.BAR}pins = {{ S = {{ group = "round_m", length = "40 mm" }} }}
drives = {{ S = {{ face = "left" }} }}
forces = {{ {seats} }}
limits = {{ safety_factor = 1.5, deflection = "4 mm", singular_zones = "exclude" }}
[accuracy]
peak_stress = "5 %"
""")
    return file


def rod(folder, force):
    """520 mm out of its guide."""
    load = f"""type = "constant"
body = "bar"
point = ["600 mm", "0 mm", "0 mm"]
force = {force}"""
    return guided(folder, 'law = "constant"\nfrom = "-60 mm"', {"load": load},
                  'duration = "1 s"\ninstants = 11')


def table(rows):
    """Across the rod's end; rows: (s, N)."""
    return f"""type = "table"
between = ["ground", "bar"]
from = ["540 mm", "0 mm", "0 mm"]
to = ["600 mm", "0 mm", "0 mm"]
axis = [0, 1, 0]
times = {json.dumps([f"{time:.9f} s" for time, _ in rows])}
efforts = {json.dumps([f"{force:.6f} N" for _, force in rows])}"""


def sweep(start, last, low, high, force, points):
    """A sine from one frequency to another, Hz."""
    rows = [(0.0, 0.0), (start, 0.0)]
    for k in range(1, points + 1):
        at = k / points * (last - start)
        turns = low * at + (high - low) * at**2 / 2 / (last - start)
        rows.append((start + at, force * math.sin(2 * math.pi * turns)))
    return rows


def crossing_rod(folder, moves):
    """It bears 90 N at 480 mm out of its guide, is drawn half into it, where 20 N sweep
    over its first frequency, and out on the other side as far. moves: else it stands
    half-way from the start."""
    start, last = 0.6, 1.1
    clamped = frequency(280)
    heavy = [(0.0, -90.0), (0.1, -90.0), (0.2, 0.0)]
    there = sweep(start, last, 0.84 * clamped, 1.16 * clamped, 20.0, 2000)
    places = [(0.0, -100), (0.2, -100), (0.5, -300), (0.55, -300), (0.6, -300), (1.1, -300),
              (1.15, -300), (1.2, -300), (1.5, -500), (1.7, -500)]
    crosses = f"""law = "table"
times = {json.dumps([f"{time} s" for time, _ in places])}
positions = {json.dumps([f"{place} mm" for _, place in places])}"""
    return guided(folder, crosses if moves else 'law = "constant"\nfrom = "-300 mm"',
                  {"heavy": table(heavy), "sweep": table(there)},
                  'duration = "1.7 s"\ninstants = 18')


def frequency(length):
    """Of a cantilever of the round bar, Hz."""
    return 3.516 * math.sqrt(MODULUS * INERTIA / DENSITY / (
        math.pi / 4 * DIAMETER**2)) / length**2 / 2 / math.pi


def sliding_rod(folder, shake):
    """250 mm out of its guide it bears 90 N, then it slides out to 520 mm, where a force
    of 12 N sweeps over its first frequency there. shake: whether it does."""
    last = 1.0
    heavy = [(0.0, -90.0), (0.1, -90.0), (0.3, 0.0)]
    there = sweep(0.5, last, 42.0, 58.0, 12.0 * shake, 600)
    return guided(folder, """law = "quintic"
from = "-330 mm"
to = "-60 mm"
start = "0.1 s"
duration = "0.3 s\"""", {"heavy": table(heavy), "sweep": table(there)},
                  f'duration = "{last} s"\ninstants = 11')


def shaft(folder, speed, disc="", shake="", gravity=0.0):
    """Between bearings 490 mm apart; gravity along -y [m/s²]."""
    round_bar(folder, [(10, 1, "bore_A"), (230, 16, "round_a"), (20, 2, "round_mid"),
                       (230, 16, "round_b"), (10, 1, "bore_B")])
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
    round_bar(folder, [(10, 1, "bore_A"), (480, 32, "round_m"), (10, 1, "bore_B")])
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
    round_bar(folder, [(10, 1, "round_a"), (480, 32, "round_m"), (10, 1, "bore_B")])
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
peak_stress = "5 %"
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
    round_bar(folder, [(10, 1, "round_a"), (480, 32, "round_m"), (10, 1, "bore_B")])
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
peak_stress = "5 %"
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

    def check(make, *arguments):
        with tempfile.TemporaryDirectory() as name:
            answer = support.check(clevis, make(Path(name), *arguments),
                                   exits=support.JUDGED)
        print(f"{make.__name__} {arguments[:1]}: {answer.part['verdict']}, "
              f"{answer.part['why']}", flush=True)
        return answer

    out = 520.0
    part = check(rod, '["-18 kN", "-1 N", "0 N"]').part
    euler = math.pi**2 * MODULUS * INERTIA / 4 / out**2 / 18e3
    factor = part["buckling"]["factor"]
    checks.expect(0.9 * euler < factor < euler,
                  f"rod: buckles at {factor:.3f}, clamped at its guide's end {euler:.3f}")
    checks.expect(part["verdict"] == "fail", "rod: fails")
    part = check(rod, '["0 N", "-20 N", "0 N"]').part
    bends = 20 * out**3 / 3 / MODULUS / INERTIA
    deflection = part["deflection_mm"]
    checks.expect(bends < deflection < 1.15 * bends,
                  f"rod: bends by {deflection:.3f} mm, clamped there {bends:.3f} mm")

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

    part = check(sliding_rod, True).part
    clamped = frequency(520)
    checks.expect(part["verdict"] == "fail", "rod slid out, shaken there: fails")
    first = part["vibration"]["lowest_frequency_hz"]
    checks.expect(0.9 * clamped < first < clamped,
                  f"rod slid out: {first:.2f} Hz, clamped there {clamped:.2f} Hz")
    part = check(sliding_rod, False).part
    checks.expect(part["verdict"] == "pass", "rod slid out, at rest there: pass")
    part = check(crossing_rod, True).part
    there = check(crossing_rod, False).part["vibration"]["peak_MPa"]
    peak = part["vibration"]["peak_MPa"]
    # What swings on as it leaves counts as held there: a little more.
    checks.expect(part["verdict"] == "fail" and 0.98 * there < peak < 1.2 * there,
                  f"rod half-way through its guide, shaken there: {peak:.1f} MPa, "
                  f"{there:.1f} where it stands there")
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

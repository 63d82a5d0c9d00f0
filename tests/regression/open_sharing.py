#!/usr/bin/env python3
"""A link on two hinges to the ground, pulled along itself: equilibrium leaves
open how they share the pull, so its band must hold for every sharing. Each is
checked alone with compliances given that make it all but certain. A beam on seven feet:
the band holds that the outer two carry it alone.

    open_sharing.py CLEVIS SOURCE_DIR
"""
import sys
import tempfile
from pathlib import Path

import scene_text
import support

CLEVIS = str(Path(sys.argv[1]).resolve())
MESH = Path(sys.argv[2]).resolve() / "meshes/reference_link/link.msh"
PULL = 4000.0  # N
# MPa/N of the link pressed pin to pin: CalculiX, see loads_in_time.py
PRESSED, SCATTER = 323.4 / 9996, 0.005

SCENE = """{head}
[[body]]
name = "link"
part = "link"
placement = {{ origin = ["0 mm", "0 mm", "0 mm"] }}
{joints}
[[force]]
name = "pull"
type = "constant"
body = "link"
point = ["70 mm", "0 mm", "0 mm"]
force = ["{pull} N", "0 N", "0 N"]
[simulation]
duration = "1 s"
instants = 2
[[part]]
name = "link"
mesh = "{mesh}"
length_unit = "mm"
material = "steel"
pins = {{ A = "bore_A", B = "bore_B" }}
forces = {{ pull = {{ face = "{face}" }} }}
limits = {{ safety_factor = 1 }}
"""


def joint(name, x, compliance):
    at = f'["{x} mm", "0 mm", "0 mm"]'
    text = f"""
[[joint]]
name = "{name}"
type = "revolute"
between = ["ground", "link"]
at = {{ ground = {at}, link = {at} }}
axis = [0, 0, 1]
"""
    if compliance is None:
        return text
    force, turn = f'"{compliance} m/N"', '"1e-6 rad/(N m)"'
    return text + f"""compliance = {{ force = [{force}, {force}, {force}], moment = [{turn}, {turn}, {turn}] }}
"""


def check(folder, a, b, strength=1e4, pull=PULL):
    joints = joint("A", 0, a) + joint("B", 140, b)
    (folder / "scene.toml").write_text(SCENE.format(
        joints=joints, head=scene_text.head("two hinges", support.steel(strength=strength)), pull=pull,
        mesh=MESH, face="bore_A"))
    found = support.check(CLEVIS, folder / "scene.toml", exits=support.JUDGED)
    print(f"A {a}, B {b}: {found}")
    return found.peak, found.band, found.part["verdict"], found.text


FEET, APART, HEIGHT, THICK, PRESS = 7, 40, 20, 10, 3000.0  # mm, N


def beam_geometry():
    """With a bore for each foot, pressed on 8 mm of its upper side."""
    last, top = (FEET - 1) * APART, HEIGHT / 2
    feet = [(f"c{i}", APART * i) for i in range(FEET)]
    return f"""SetFactory("OpenCASCADE");
Rectangle(1) = {{-15, {-top}, 0, {last + 30}, {HEIGHT}}};
Point(901) = {{{last / 2 - 4}, {top}, 0}}; Point(902) = {{{last / 2 + 4}, {top}, 0}};
Line(903) = {{901, 902}};
BooleanFragments{{ Surface{{1}}; Delete; }}{{ Curve{{903}}; Delete; }}
""" + "".join(f"Disk({10 + i}) = {{{x}, 0, 0, 2}};\n" for i, (_, x) in enumerate(feet)) + f"""\
BooleanDifference(5) = {{ Surface{{1}}; Delete; }}{{ Surface{{10:{9 + FEET}}}; Delete; }};
Physical Surface("body") = {{5}};
t() = Curve In BoundingBox {{{last / 2 - 5}, {top - 1}, -1, {last / 2 + 5}, {top + 1}, 1}};
Physical Curve("top") = {{t()}};
MeshSize{{:}} = 8;
""" + "".join(f"""{c}() = Curve In BoundingBox {{{x - 3}, -3, -1, {x + 3}, 3, 1}};
Physical Curve("bore_{c}") = {{{c}()}}; Transfinite Curve{{{c}()}} = 9;
""" for c, x in feet) + "Mesh.RecombineAll = 1; Mesh.ElementOrder = 2;\n"


def check_feet(folder, checks):
    """A beam on more feet than all corners of their compliances can be tried for: the
    outer two alone may carry it, with F l/4."""
    support.gmsh(folder, beam_geometry(), "bar", 2)
    feet = "".join(f"""[[joint]]
name = "F{i}"
type = "revolute"
between = ["ground", "bar"]
at = {{ ground = {place}, bar = {place} }}
axis = [0, 0, 1]
""" for i, place in enumerate(scene_text.lengths((APART * i, 0, 0)) for i in range(FEET)))
    pins = ", ".join(f'F{i} = "bore_c{i}"' for i in range(FEET))
    last = (FEET - 1) * APART
    outer = PRESS * last / 4 * 6 / (THICK * HEIGHT**2)
    strength = 0.98 * outer
    scene = folder / "feet.toml"
    scene.write_text(scene_text.head("feet", support.steel(strength=strength)) +
                     scene_text.part_body("bar") + feet + f"""[[force]]
name = "press"
type = "constant"
body = "bar"
point = ["{last / 2} mm", "0 mm", "0 mm"]
force = ["0 N", "{-PRESS} N", "0 N"]
[simulation]
duration = "1 s"
instants = 2
{scene_text.BAR}thickness = "{THICK} mm"
pins = {{ {pins} }}
forces = {{ press = {{ face = "top" }} }}
limits = {{ safety_factor = 1 }}
""")
    found = support.check(CLEVIS, scene, exits=support.JUDGED)
    checks.holds(found.band, outer, f"{FEET} feet: the outer two alone")
    checks.expect(found.part["verdict"] == "not judged",
                  f"{FEET} feet, a strength of {strength:.0f} MPa: {found}")


def main():
    checks = support.Checks()
    with tempfile.TemporaryDirectory() as name:
        check_feet(Path(name), checks)
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        # one carries next to all: 1e-12 against 1e-7 m/N
        a_alone, _, _, _ = check(folder, 1e-12, 1e-7)
        b_alone, b_band, _, _ = check(folder, 1e-7, 1e-12)
        checks.holds(b_band, PULL * PRESSED, "B alone, beside CalculiX", SCATTER)
        worst = max(a_alone, b_alone)
        even, open_band, _, _ = check(folder, None, None)
        checks.expect(even < 0.95 * worst,
                      "an even sharing stresses less than the worst")
        checks.expect(open_band[0] <= 1.001 * min(a_alone, b_alone) and
                      open_band[1] >= 0.995 * worst, "the band holds every sharing")
        checks.expect(open_band[1] <= 1.05 * worst,
                      "the band is no wider than all sharings")

        # a strength between: not judged, though the printed peak is below it
        _, _, verdict, _ = check(folder, None, None, strength=0.5 * (even + worst))
        checks.expect(verdict == "not judged", "a default does not decide: " + verdict)

        # given: half and twice of each, and no more
        known, band, _, _ = check(folder, 1e-9, 1e-9)
        soft, _, _, _ = check(folder, 2e-9, 0.5e-9)
        stiff, _, _, _ = check(folder, 0.5e-9, 2e-9)
        checks.expect(abs(known - even) < 1e-6 * even, "the default is 1 nm/N")
        checks.expect(band[1] >= 0.995 * max(soft, stiff),
                      "the band holds half and twice")
        checks.expect(band[1] - band[0] < open_band[1] - open_band[0],
                      "given is better than not")
        _, _, verdict, _ = check(folder, 1e-9, 1e-9, strength=1.02 * band[1])
        checks.expect(verdict == "pass", "given compliances can pass: " + verdict)
    return checks.exit_code()


if __name__ == "__main__":
    sys.exit(main())

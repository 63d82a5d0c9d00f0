#!/usr/bin/env python3
"""A link on two hinges to the ground, pulled along itself: equilibrium leaves
open how they share the pull, so its band must hold for every sharing. Each is
checked alone with compliances given that make it all but certain. Beams on feet: the
band holds that the outer two of seven carry one alone, and the least that three can do.

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


COMPLIANCE = """compliance = {{ force = [{force}, {force}, {force}], \
moment = [{turn}, {turn}, {turn}] }}
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
    return text + COMPLIANCE.format(force=f'"{compliance} m/N"', turn='"1e-6 rad/(N m)"')


def check(folder, a, b, strength=1e4, pull=PULL):
    joints = joint("A", 0, a) + joint("B", 140, b)
    (folder / "scene.toml").write_text(SCENE.format(
        joints=joints, head=scene_text.head("two hinges", support.steel(strength=strength)), pull=pull,
        mesh=MESH, face="bore_A"))
    found = support.check(CLEVIS, folder / "scene.toml", exits=support.JUDGED)
    print(f"A {a}, B {b}: {found}")
    return found.peak, found.band, found.part["verdict"], found.text


HEIGHT, THICK, PRESS = 20, 10, 3000.0  # mm, N


def beam_geometry(feet, presses):
    """With a bore for each foot, pressed on 8 mm of its upper side; places in mm."""
    last, top = feet[-1], HEIGHT / 2
    lines = "".join(f"Point({901 + 3 * k}) = {{{x - 4}, {top}, 0}}; Point({902 + 3 * k}) = "
                    f"{{{x + 4}, {top}, 0}}; Line({903 + 3 * k}) = "
                    f"{{{901 + 3 * k}, {902 + 3 * k}}};\n" for k, x in enumerate(presses))
    curves = ", ".join(str(903 + 3 * k) for k in range(len(presses)))
    return f"""SetFactory("OpenCASCADE");
Rectangle(1) = {{-15, {-top}, 0, {last + 30}, {HEIGHT}}};
{lines}BooleanFragments{{ Surface{{1}}; Delete; }}{{ Curve{{{curves}}}; Delete; }}
""" + "".join(f"Disk({10 + i}) = {{{x}, 0, 0, 2}};\n" for i, x in enumerate(feet)) + f"""\
BooleanDifference(5) = {{ Surface{{1}}; Delete; }}{{ Surface{{10:{9 + len(feet)}}}; Delete; }};
Physical Surface("body") = {{5}};
""" + "".join(f"""t() = Curve In BoundingBox {{{x - 5}, {top - 1}, -1, {x + 5}, {top + 1}, 1}};
Physical Curve("top{k}") = {{t()}};
""" for k, x in enumerate(presses)) + "MeshSize{:} = 8;\n" + "".join(
        f"""c{i}() = Curve In BoundingBox {{{x - 3}, -3, -1, {x + 3}, 3, 1}};
Physical Curve("bore_c{i}") = {{c{i}()}}; Transfinite Curve{{c{i}()}} = 9;
""" for i, x in enumerate(feet)) + "Mesh.RecombineAll = 1; Mesh.ElementOrder = 2;\n"


def beam_on_feet(folder, feet, presses, strength, given=None, links="rigid", compliance=None):
    """Each foot a hinge to the ground, PRESS at each of the presses. given: what the
    feet carry [N], typed by hand. compliance: of each foot's forces."""
    support.gmsh(folder, beam_geometry(feet, presses), "bar", 2)
    given_compliance = "" if compliance is None else COMPLIANCE.format(
        force=f'"{compliance}"', turn='"1e-6 rad/(N m)"')
    hinges = "".join(f"""[[joint]]
name = "F{i}"
type = "revolute"
between = ["ground", "bar"]
at = {{ ground = {place}, bar = {place} }}
axis = [0, 0, 1]
{given_compliance}""" for i, place in enumerate(scene_text.lengths((x, 0, 0)) for x in feet))
    pins = ", ".join(f'F{i} = "bore_c{i}"' for i in range(len(feet)))
    seats = ", ".join(f'press{k} = {{ face = "top{k}" }}' for k in range(len(presses)))
    loads = "".join(f"""[[force]]
name = "press{k}"
type = "constant"
body = "bar"
point = ["{x} mm", "0 mm", "0 mm"]
force = ["0 N", "{-PRESS} N", "0 N"]
""" for k, x in enumerate(presses))
    head = scene_text.head("feet", support.steel(strength=strength))
    mechanism = scene_text.part_body("bar") + hinges + loads + f"""[simulation]
duration = "1 s"
instants = 2
links = "{links}"
"""
    seated = f"pins = {{ {pins} }}\nforces = {{ {seats} }}\n"
    if given:
        head = scene_text.head("feet", support.steel(strength=strength), "")
        mechanism, seated = "", ""
    scene = folder / "feet.toml"
    scene.write_text(head + mechanism + f"""{scene_text.BAR}thickness = "{THICK} mm"
{seated}limits = {{ safety_factor = 1 }}
""" + (carried(given, len(presses)) if given else ""))
    return support.check(CLEVIS, scene, exits=support.JUDGED)


def carried(feet, presses):
    """A case: forces of the feet [N] and, as an even traction, of the presses."""
    pins = ", ".join(f'bore_c{i} = ["0 N", "{force} N", "0 N"]'
                     for i, force in enumerate(feet))
    tractions = ", ".join(f'top{k} = ["0 MPa", "{-PRESS / (8 * THICK)} MPa", "0 MPa"]'
                          for k in range(presses))
    return f"""[[part.case]]
name = "carried"
pins = {{ {pins} }}
traction = {{ {tractions} }}
"""


def check_feet(folder, checks):
    """A beam on more feet than all corners of their compliances can be tried for: the
    outer two alone may carry it, with F l/4."""
    feet = [40 * i for i in range(7)]
    outer = PRESS * feet[-1] / 4 * 6 / (THICK * HEIGHT**2)
    strength = 0.98 * outer
    found = beam_on_feet(folder, feet, [feet[-1] / 2], strength)
    checks.holds(found.band, outer, "seven feet: the outer two alone")
    checks.expect(found.part["verdict"] == "not judged",
                  f"seven feet, a strength of {strength:.0f} MPa: {found}")


def check_spans(folder, checks):
    """Two spans pressed in their middles: of feet that do not give way the middle one
    carries 11/8 of a press, which stresses the beam less than any corner of the feet's
    compliances does, and than rigid beams on equal feet do."""
    places = [0, 160, 320], [80, 240]
    stiff = beam_on_feet(folder, *places, strength=1e4,
                         given=[5 / 16 * PRESS, 11 / 8 * PRESS, 5 / 16 * PRESS])
    strength = 1.2 * stiff.peak
    found = beam_on_feet(folder, *places, strength=strength)
    checks.holds(found.band, stiff.peak, "two spans on stiff feet")
    checks.expect(found.peak > strength, "two spans: equal feet make more")
    checks.expect(found.part["verdict"] == "not judged",
                  f"two spans, a strength of {strength:.0f} MPa: {found}")


def timoshenko_feet(foot, press, length):
    """What three rigid feet at 0, foot and length [mm] carry of a press of 1 by beam
    theory, with shear."""
    stiffness = 210e3 * THICK * HEIGHT**3 / 12  # N mm²
    shear = 5 / 6 * 210e3 / 2.6 * THICK * HEIGHT  # N
    beyond = length - press
    by_foot = (foot**2 * (length - foot)**2 / (3 * stiffness * length)
               + foot * (length - foot) / length / shear)
    by_press = (beyond * foot * (length**2 - beyond**2 - foot**2) / (6 * stiffness * length)
                + beyond * foot / length / shear)
    middle = by_press / by_foot
    return [beyond / length - middle * (length - foot) / length, middle,
            press / length - middle * foot / length]


def check_elastic_beam(folder, checks):
    """Two spans, one pressed near its end: what the press bends between the feet counts
    in how elastic links share. Of rigid links the band holds that where the feet are
    given next to no compliance."""
    foot, press, length = 208.0, 272.0, 320.0  # mm
    places = [0, foot, length], [press]
    feet = [share * PRESS for share in timoshenko_feet(foot, press, length)]
    stiff = beam_on_feet(folder, *places, strength=1e4, given=feet)
    elastic = beam_on_feet(folder, *places, strength=1e4, links="elastic")
    checks.holds(elastic.band, stiff.peak, "two spans of an elastic link on stiff feet", 0.01)
    checks.expect(elastic.band[1] < 1.2 * stiff.peak, f"its band: {elastic}")
    rigid = beam_on_feet(folder, *places, strength=1e4, compliance="1e-11 m/N")
    checks.holds(rigid.band, elastic.peak, "the same as a rigid link", 0.005)
    checks.expect("on rigid links and on elastic ones" in rigid.text, f"told: {rigid.text}")
    low, high = sorted([rigid.peak, elastic.peak])
    checks.expect(high > 1.05 * low, "how a rigid link shares is another")
    between = beam_on_feet(folder, *places, strength=0.5 * (low + high),
                           compliance="1e-11 m/N")
    checks.expect(between.part["verdict"] == "not judged", f"a strength between: {between}")


def main():
    checks = support.Checks()
    with tempfile.TemporaryDirectory() as name:
        check_elastic_beam(Path(name), checks)
    with tempfile.TemporaryDirectory() as name:
        check_feet(Path(name), checks)
    with tempfile.TemporaryDirectory() as name:
        check_spans(Path(name), checks)
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
        checks.expect("on rigid links and on elastic ones" in check(folder, 1e-8, 1e-8)[3],
                      "given compliances: what the band is of")
        _, _, verdict, _ = check(folder, 1e-9, 1e-9, strength=1.02 * band[1])
        checks.expect(verdict == "pass", "given compliances can pass: " + verdict)
    return checks.exit_code()


if __name__ == "__main__":
    sys.exit(main())

#!/usr/bin/env python3
"""What rotors, currents and dampers make of a part's vibration: each in two ways.

A link that is welded to the ground bears a disc on a hinge at its end, which a
pulse pushes across. What acts between link and disc drags the disc along as the
link bends: a motor's rotor or the same inertia as a body behind a gear; a motor's
current or a spring with a damper behind it; a damper alone or beside a soft spring.

    dragged_neighbours.py CLEVIS SOURCE_DIR
"""
import sys
import tempfile
from pathlib import Path

import scene_text
import support

MESH = Path(sys.argv[2]).resolve() / "meshes/reference_link/link.msh"


def body(name, mass, inertia, y=0):
    return scene_text.body(name, f"{mass} kg", f"{inertia} kg m^2", origin=(140, y, 0))


def joint(name, kind, first, second, x=140, y=0):
    axis = "" if kind == "weld" else "axis = [0, 0, 1]\n"
    return f"""
[[joint]]
name = "{name}"
type = "{kind}"
between = ["{first}", "{second}"]
point = ["{x} mm", "{y} mm", "0 mm"]
{axis}"""


def spring(on, stiffness, damping):
    return f"""
[[force]]
type = "spring"
name = "spring {on}"
joint = "{on}"
stiffness = "{stiffness} N m/rad"
damping = "{damping} N m s/rad"
free = "0 deg"
"""


def motor(ratio, rotor, henry, weber):
    return f"""
[[force]]
type = "motor"
name = "motor"
joint = "B"
ratio = {ratio}
pole_pairs = 4
resistance = "0.5 ohm"
inductance = "{henry} H"
flux = "{weber} Wb"
voltage = "0 V"
rotor_inertia = "{rotor} kg m^2"
"""


HINGE = joint("B", "revolute", "link", "disc")
RING = body("ring", 1e-3, 1e-6) + joint("R", "revolute", "link", "ring")
ROTOR = (body("box", 1e-3, 1e-7) + body("rotor", 1e-3, 1e-4, 50) +
         joint("W", "weld", "link", "box") + joint("G", "revolute", "box", "rotor", y=50) +
         joint("B", "revolute", "box", "disc") + """
[[coupling]]
name = "gear"
type = "gear"
joints = ["G", "B"]
ratio = -100
pressure_angle = "0 deg"
""")
VOLTS = 20 * 4 * 0.1  # per rate of the hinge


def peak(clevis, folder, between, pins):
    """With vibration [MPa]."""
    scene = folder / "scene.toml"
    scene.write_text(f"""{scene_text.head("dragged")}
{scene_text.part_body("link")}{body("disc", 0.5, 2e-2)}{joint("A", "weld", "ground", "link", 0)}{between}
[[force]]
type = "table"
name = "push"
between = ["ground", "disc"]
from = ["140 mm", "-1000 mm", "0 mm"]
to = ["0 mm", "0 mm", "0 mm"]
axis = [0, 1, 0]
times = ["0 s", "20 ms", "20.5 ms", "26 ms", "26.5 ms", "60 ms"]
efforts = ["0 N", "0 N", "100 N", "100 N", "0 N", "0 N"]
[simulation]
duration = "0.06 s"
instants = 61
[[part]]
name = "link"
mesh = "{MESH}"
length_unit = "mm"
material = "steel"
limits = {{ safety_factor = 1.5 }}
{pins}
[accuracy]
peak_stress = "2 %"
""")
    found = support.check(clevis, scene, exits=support.JUDGED)
    return found.part["vibration"]["peak_MPa"]


def main():
    checks = support.Checks()
    with tempfile.TemporaryDirectory() as name:
        def found(between, joint_of_pin="B", forces=""):
            pins = (f'pins = {{ A = "bore_A", {joint_of_pin} = "bore_B" }}\n' +
                    (f'forces = {{ {forces} = {{ face = "bore_B" }} }}\n' if forces else ""))
            return peak(sys.argv[1], Path(name), between, pins)

        alone = found(HINGE)
        rotor = found(HINGE + motor(100, 1e-4, 1e-3, 1e-4), forces="motor")
        geared = found(ROTOR, "W")
        checks.near("a motor's rotor, and a rotor behind a gear", rotor, geared, 0.01)
        current = found(HINGE + motor(20, 0, 5e-3, 0.1), forces="motor")
        relaxing = found(RING + joint("B", "revolute", "ring", "disc") +
                         spring("R", 1.5 * VOLTS**2 / 5e-3, 0) +
                         spring("B", 0, 1.5 * VOLTS**2 / 0.5), "R", '"spring R"')
        checks.near("a motor's current, and a spring and damper", current, relaxing, 0.02)
        damper = found(HINGE + spring("B", 0, 100), forces='"spring B"')
        soft = found(HINGE + spring("B", 5, 100), forces='"spring B"')
        checks.near("a damper, and one beside a soft spring", damper, soft, 0.01)
        for what, stress in (("rotor", rotor), ("current", current), ("damper", damper)):
            checks.expect(abs(stress / alone - 1) > 0.1,
                          f"the {what} counts: {stress:.4g} MPa for {alone:.4g} without")
    return checks.exit_code()


if __name__ == "__main__":
    sys.exit(main())

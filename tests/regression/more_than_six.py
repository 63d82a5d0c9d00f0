#!/usr/bin/env python3
"""A column that joints hold by more than six conditions: welded at its foot, at its tip
to a block that a rail guides. Six of them make it a column between two pins, all of them
one that is clamped at both ends. The band reaches over both, joints = "ideal" counts all.

    more_than_six.py CLEVIS
"""
import math
import sys
import tempfile
from pathlib import Path

import scene_text
import support

LENGTH, WIDTH, THICKNESS, MODULUS, DENSITY = 0.3, 0.02, 0.006, 210e9, 7850.0
SECOND_MOMENT = WIDTH * THICKNESS**3 / 12
PINNED = math.pi**2 * MODULUS * SECOND_MOMENT / LENGTH**2


def write_scene(folder, tip, push, limit, joints="", gravity=0.0):
    """tip: joint between the bar and the block on the rail; push [N] along the bar."""
    scene_text.write_bar(folder, (LENGTH, WIDTH, THICKNESS), (20, 2, 1))
    world = scene_text.WEIGHTLESS.replace('"0 m/s^2"]', f'"{-gravity} m/s^2"]')
    file = folder / "scene.toml"
    file.write_text(
        scene_text.head("bar", world=world) + scene_text.part_body("bar") +
        scene_text.body("block", "1 g", "1e-6 kg m^2", origin=(300, 0, 0)) +
        scene_text.joint("foot", "weld", "ground", "bar") +
        scene_text.joint("tip", tip, "bar", "block", (300, 0, 0)) +
        scene_text.joint("rail", "prismatic", "ground", "block", (300, 0, 0),
                         (1, 0, 0)) + f"""\
[[force]]
type = "constant"
name = "push"
body = "block"
point = ["0 mm", "0 mm", "0 mm"]
force = ["-{push} N", "0 N", "0 N"]
[simulation]
duration = "0.01 s"
instants = 3
{scene_text.BAR}pins = {{ foot = "x0", tip = "x1" }}
limits = {{ safety_factor = 1, buckling = {limit}, singular_zones = "exclude" }}
{joints}""")
    return file


def bent(push, load, first):
    """Largest deflection [m] under a load [N/m] across, in second order.

    first: by linear theory [m], between both ends' slopes and moments as rigid links
    share the reactions. What the push adds is held at both ends in full."""
    rigidity = MODULUS * SECOND_MOMENT
    moment = (5 * load * LENGTH**4 / (384 * rigidity) - first) * 8 * rigidity / LENGTH**2
    slope = load * LENGTH**3 / (24 * rigidity) - moment * LENGTH / (2 * rigidity)
    k = math.sqrt(push / rigidity)
    swing = (load * LENGTH / (2 * push) + slope) / (k * math.sin(k * LENGTH / 2))
    return swing * (1 - math.cos(k * LENGTH / 2)) - load * LENGTH**2 / (8 * push)


def main():
    clevis = Path(sys.argv[1]).resolve()
    checks = support.Checks()

    def check(*args, **more):
        with tempfile.TemporaryDirectory() as name:
            return support.check(clevis, write_scene(Path(name), *args, **more)).part

    push = 0.4 * PINNED
    ideal = 'joints = "ideal"\n'
    for tip, exact in (("weld", 4.0), ("spherical", 2.0457)):
        exact *= PINNED / push
        whole = check(tip, push, 1.5, joints=ideal)["buckling"]
        checks.near(f"{tip}, all hold: factor", whole["factor"], exact, 0.01)
        part = check(tip, push, 0.8 * exact)
        least = part["buckling"]
        checks.near(f"{tip}, six hold: end of the band", least["band"][1], exact, 0.01)
        checks.expect(least["band"][0] <= 1.01 * PINNED / push,
                      f"{tip}, six hold: {least['band']}")
        checks.expect(part["verdict"] == "not judged" and "joints hold it" in part["why"],
                      f"{tip}, limit between: {part['verdict']}, {part['why']}")
        checks.expect(check(tip, push, 1.2 * exact)["verdict"] == "fail",
                      f"{tip}, limit beyond all that hold: fails")

    gravity = 300.0
    load = DENSITY * WIDTH * THICKNESS * gravity
    push = 1.5 * PINNED
    part = check("weld", push, 1.5, joints=ideal, gravity=gravity)
    first = part["deflection_mm"]
    checks.near("bent, second order: mm", part["second_order"]["deflection_mm"],
                1e3 * bent(push, load, 1e-3 * first), 0.005)
    return checks.exit_code()


if __name__ == "__main__":
    sys.exit(main())

#!/usr/bin/env python3
"""Parts that yield together: no pass of one of them may lie beneath what theory says of
all.

    joined_parts.py CLEVIS

A column of two welded bars buckles where one of its whole length does, π²EI/4L², though
each alone bears more; so does one whose bars a ball and a stiff bushing join. A cantilever
of two welded bars is shaken at the first frequency of its whole length, where it swings to
E h/2 φ''(0) Γ A/2ζ at its root; φ''(0) = 2 β², βL = 1.8751, Γ = 0.7830. With half of the load, or slowly shaken, both pass.
"""
import math
import sys
import tempfile
from pathlib import Path

import scene_text
import support

LENGTH, SIDE, MODULUS, DENSITY = 500.0, 20.0, 210e3, 7.85e-9  # mm, MPa, t/mm³
AREA, INERTIA = SIDE**2, SIDE**4 / 12
EULER = math.pi**2 * MODULUS * INERTIA / (4 * LENGTH**2)  # N
BETA = 1.8751 / LENGTH
FIRST = BETA**2 * math.sqrt(MODULUS * INERTIA / DENSITY / AREA) / 2 / math.pi  # Hz
SHAKE, DAMPING, DURATION = 0.1, 0.01, 0.5  # mm, 1, s


def write_halves(folder):
    for name in ("lower", "upper"):
        scene_text.write_bar(folder, (LENGTH / 2e3, SIDE / 1e3, SIDE / 1e3), (8, 2, 2))
        (folder / "bar.msh").rename(folder / f"{name}.msh")


def halves(foot, limits, force=""):
    """Bodies, welds and parts; foot: the body that the lower one stands on."""
    middle = (LENGTH / 2, 0, 0)
    pins = {"lower": 'F = "x0", W = "x1"', "upper": 'W = "x0"'}
    parts = "".join(f"""[[part]]
name = "{name}"
mesh = "{name}.msh"
length_unit = "mm"
material = "steel"
damping = {DAMPING}
pins = {{ {pins[name]} }}
{force if name == "upper" else ""}limits = {{ singular_zones = "exclude", {limits} }}
""" for name in pins)
    return (scene_text.part_body("lower") + scene_text.part_body("upper") +
            f"placement = {{ origin = {scene_text.lengths(middle)} }}\n" +
            scene_text.joint("F", "weld", foot, "lower") +
            scene_text.joint("W", "weld", "lower", "upper", middle) + parts)


TAIL = """[accuracy]
peak_stress = "5 %"
"""


BUSHING = f"""[[force]]
type = "bushing"
name = "bush"
between = ["lower", "upper"]
from = {scene_text.lengths((LENGTH / 2, 0, 0))}
to = ["0 mm", "0 mm", "0 mm"]
angular_stiffness = ["1e7 N m/rad", "1e7 N m/rad", "1e7 N m/rad"]
"""


def on_ball(text):
    """The halves on a ball and a bushing that is far stiffer than they are."""
    weld = scene_text.joint("W", "weld", "lower", "upper", (LENGTH / 2, 0, 0))
    assert weld in text
    return text.replace(weld, weld.replace('"weld"', '"spherical"') + BUSHING).replace(
        'forces = { press', 'forces = { bush = { face = "x0" }, press').replace(
        'pins = { F = "x0", W = "x1" }',
        'pins = { F = "x0", W = "x1" }\nforces = { bush = { face = "x1" } }')


def column(folder, factor, joined=str):
    """Pressed by Euler's load over a factor; joined: puts another joint."""
    write_halves(folder)
    file = folder / "scene.toml"
    file.write_text(joined(scene_text.head("column") +
                    scene_text.body("crank", "1 kg", "0.01 kg m^2", origin=(0, 500, 0)) +
                    scene_text.joint("C", "revolute", "ground", "crank", (0, 500, 0),
                                     (0, 0, 1)) +
                    halves("ground", "safety_factor = 1.5, buckling = 1.5",
                           'forces = { press = { face = "x1" } }\n') + f"""[[drive]]
joint = "C"
law = "constant"
from = "0 deg"
[[force]]
type = "constant"
name = "press"
body = "upper"
point = {scene_text.lengths((LENGTH / 2, 0, 0))}
force = ["-{EULER / factor:.9g} N", "0 N", "0 N"]
[simulation]
duration = "1 s"
instants = 3
{TAIL}"""))
    return file


def cantilever(folder, share, allowed):
    """Shaken at a share of the first frequency; stress allowed in MPa."""
    write_halves(folder)
    file = folder / "scene.toml"
    file.write_text(scene_text.head("cantilever") +
                    scene_text.body("base", "20 kg", "1 kg m^2") +
                    scene_text.joint("S", "prismatic", "ground", "base", axis=(0, 1, 0)) +
                    halves("base", f"safety_factor = {355 / allowed:.9g}") + f"""[[drive]]
joint = "S"
law = "sine"
from = "0 mm"
amplitude = "{SHAKE} mm"
frequency = "{share * FIRST:.9g} Hz"
[simulation]
duration = "{DURATION} s"
instants = 101
{TAIL}""")
    return file


def stress(share):
    """At the root, as far as it has swung on [MPa]."""
    near = share**2 / math.hypot(1 - share**2, 2 * DAMPING * share)
    grown = 1 - math.exp(-2 * math.pi * FIRST * DAMPING * DURATION) if share == 1 else 1
    return MODULUS * SIDE / 2 * 2 * BETA**2 * 0.783 * SHAKE * near * grown


def main():
    clevis = Path(sys.argv[1]).resolve()
    checks = support.Checks()

    def parts_of(scene, *arguments):
        with tempfile.TemporaryDirectory() as name:
            answer = support.check(clevis, scene(Path(name), *arguments),
                                   exits=support.JUDGED)
            texts = [(answer.out / f"{part['name']}.svg").read_text()
                     for part in answer.parts]
        for part, text in zip(answer.parts, texts):
            title = f"{part['name']}: {part['verdict']}"
            checks.expect(title in text, f"the picture says \"{title}\"")
        return answer.parts

    for factor, joined in ((1.3, str), (3.0, str), (1.3, on_ball)):
        for part in parts_of(column, factor, joined):
            buckling = part["buckling"]
            checks.holds(buckling["band"], factor,
                         f"{part['name']} of the column, alone {buckling['factor']:.4g}")
            checks.expect(buckling["band"][0] > 0.9 * factor,
                          "the sum is no more than a tenth below it")
            checks.expect((part["verdict"] == "pass") == (factor > 1.5),
                          f"{part['name']}: {part['verdict']}, 1.5 wanted")
    allowed = 120.0
    for share in (1.0, 0.2):
        truth = stress(share)
        verdicts = {part["name"]: part["verdict"]
                    for part in parts_of(cantilever, share, allowed)}
        checks.expect((verdicts["lower"] == "pass") == (truth < allowed),
                      f"shaken at {share} of its first frequency, {truth:.4g} MPa by "
                      f"theory, {allowed} allowed: {verdicts}")
        if share < 1.0:
            checks.expect(verdicts["upper"] == "pass", "the upper one, too")
    return checks.exit_code()


if __name__ == "__main__":
    sys.exit(main())

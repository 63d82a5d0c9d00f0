#!/usr/bin/env python3
"""A clamped bar pulled at its tip by two springs: a large load that fades at once, and
one of a twenty-fifth of it at the bar's own frequency that goes on. Against the modes of
beam theory. Beside the large load the small one changes little, and yet it decides.

    small_load.py CLEVIS
"""
import math
import sys
import tempfile
from pathlib import Path

import scene_text
import support
from cantilever import AREA, DENSITY, HEIGHT, LENGTH, MODES, MODULUS, write_mesh

LARGE, SMALL, FREQUENCY, DAMPING = 50.0, 2.0, 208.7, 0.005
STIFFNESS, DAMPER = 1e4, 200.0  # of the large one, with 1 kg: it creeps back
LIGHT = 0.01                    # [kg] on the other
DURATION = 0.6


def slider(name, mass, stiffness, damper, force):
    tip = (200, 0, 0)
    return scene_text.body(name, f"{mass} kg", "1e-2 kg m^2", center=tip) + scene_text.joint(
        f"slide_{name}", "prismatic", "ground", name, tip, (0, 1, 0)) + f"""[[initial]]
joint = "slide_{name}"
position = "{1e3 * force / stiffness} mm"
[[force]]
type = "spring"
name = "to_{name}"
between = ["bar", "{name}"]
axis = [0, 1, 0]
from = ["200 mm", "0 mm", "0 mm"]
to = ["200 mm", "0 mm", "0 mm"]
stiffness = "{stiffness} N/m"
damping = "{damper} N s/m"
free = "0 mm"
"""


def scene(folder, duration=DURATION, damping=DAMPING):
    write_mesh(folder)
    file = folder / "scene.toml"
    file.write_text(scene_text.head(
        "a small load behind a large one", support.steel(ratio=0.0, strength=3550.0)) +
        scene_text.part_body("bar") + scene_text.joint("W", "weld", "ground", "bar") + f"""\
{slider("heavy", 1, STIFFNESS, DAMPER, LARGE)}
{slider("light", LIGHT, LIGHT * (2 * math.pi * FREQUENCY)**2, 0, SMALL)}
[simulation]
motion = "dynamic"
duration = "{duration} s"
instants = 11
{scene_text.BAR}pins = {{ W = "x0" }}
forces = {{ to_heavy = {{ face = "x1" }}, to_light = {{ face = "x1" }} }}
damping = {damping}
limits = {{ safety_factor = 2 }}
""")
    return file


def pull(t):
    """At the tip [N]: the large load creeps back, critically damped."""
    rate = math.sqrt(STIFFNESS)
    large = LARGE * math.exp(-rate * t) * (1 - rate * t)  # spring and damper
    return large + SMALL * math.cos(2 * math.pi * FREQUENCY * t)


def largest_stress(steps=20000):
    """At the root [MPa]; at first the bar rests under its loads. Vibration about
    the static answer, mode by mode, in time by the method of Newmark."""
    h = DURATION / steps
    loads = [pull(i * h) for i in range(steps + 1)]
    static = LENGTH / (MODULUS * AREA * HEIGHT**2 / 12)  # curvature by 1 N
    curvature = [static * load for load in loads]
    for mode in MODES:
        cells = 400
        modal_mass = DENSITY * AREA * LENGTH / cells * sum(
            mode.shape((i + 0.5) * LENGTH / cells)**2 for i in range(cells))
        share = mode.shape(LENGTH) / modal_mass
        stiff, loss = mode.omega**2, 2 * DAMPING * mode.omega
        q, v = share * loads[0] / stiff, 0.0
        a = 0.0
        for i in range(1, steps + 1):
            q_next, v_next = q + h * v + h * h / 4 * a, v + h / 2 * a
            a = ((share * loads[i] - stiff * q_next - loss * v_next) /
                 (1 + h / 2 * loss + h * h / 4 * stiff))
            q, v = q_next + h * h / 4 * a, v_next + h / 2 * a
            curvature[i] += mode.root_curvature * (q - share * loads[i] / stiff)
    return 1e-6 * MODULUS * HEIGHT / 2 * max(map(abs, curvature))


def main():
    clevis = Path(sys.argv[1]).resolve()
    faults = []
    exact = largest_stress()
    with tempfile.TemporaryDirectory() as name:
        part = support.check(clevis, scene(Path(name))).part
    vibration = part["vibration"]
    if not vibration:
        sys.exit("nothing of vibration")
    low, high = vibration["band_MPa"]
    at_rest = part["peak_von_mises"]["value_MPa"]
    print(f"{vibration['peak_MPa']:.2f} [{low:.2f}, {high:.2f}] MPa, {exact:.2f} by the "
          f"modes of beam theory, {at_rest:.2f} at rest")
    # Near resonance shear's and the root's part in the frequency counts.
    if abs(vibration["peak_MPa"] / exact - 1.0) > 0.03:
        faults.append(f"{vibration['peak_MPa']:.2f} instead of {exact:.2f}")
    if not 1.5 * at_rest < exact:
        faults.append(f"at rest the bar has {at_rest:.2f} already")
    # What cannot be followed to its end is not judged.
    with tempfile.TemporaryDirectory() as name:
        part = support.check(clevis, scene(Path(name), duration=20)).part
    print(f"20 s: {part['verdict']}, {part['why']}")
    if part["verdict"] != "not judged" or "loads are followed up to" not in part["why"]:
        faults.append(f"20 s: {part['verdict']}, {part['why']}")
    sys.exit("\n".join(faults) or None)


if __name__ == "__main__":
    main()

#!/usr/bin/env python3
"""A clamped bar pulled at its tip: by a large load that fades at once, and through a soft
spring by one of a twenty-fifth of it at the bar's own frequency that goes on. Against the
modes of beam theory. Beside the large load the small one changes little, and yet it
decides.

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
RATE = 100.0      # [1/s] the large one creeps back
STIFFNESS = 20.0  # [N/m] of the small one's spring, a thousandth of the bar's
DURATION = 0.6
TIMES = [0.002 * i for i in range(100)]


def large(t):
    """At the tip [N]."""
    return LARGE * math.exp(-RATE * t) * (1 - RATE * t)


TIP = scene_text.lengths((200, 0, 0))
LOADS = f"""[[force]]
type = "table"
name = "large"
between = ["ground", "bar"]
axis = [0, 1, 0]
from = {TIP}
to = {TIP}
times = [{", ".join(f'"{t:.3f} s"' for t in TIMES)}]
efforts = [{", ".join(f'"{large(t):.9g} N"' for t in TIMES)}]
{scene_text.body("shaker", "1 kg", "1e-2 kg m^2", center=(200, 0, 0))}
{scene_text.joint("S", "prismatic", "ground", "shaker", (200, 0, 0), (0, 1, 0))}
[[drive]]
joint = "S"
law = "sine"
from = "0 mm"
amplitude = "{1e3 * SMALL / STIFFNESS} mm"
frequency = "{FREQUENCY} Hz"
[[force]]
type = "spring"
name = "small"
between = ["bar", "shaker"]
axis = [0, 1, 0]
from = {TIP}
to = {TIP}
stiffness = "{STIFFNESS} N/m"
free = "0 mm"
"""


def scene(folder, loads, names, duration=DURATION, more=""):
    """names: of the forces."""
    write_mesh(folder)
    file = folder / "scene.toml"
    faces = ", ".join(f'{name} = {{ face = "x1" }}' for name in names)
    file.write_text(scene_text.head(
        "a small load behind a large one", support.steel(ratio=0.0, strength=3550.0)) +
        scene_text.part_body("bar") + scene_text.joint("W", "weld", "ground", "bar") + f"""\
{loads}
[simulation]
{more}duration = "{duration} s"
instants = 11
{scene_text.BAR}pins = {{ W = "x0" }}
forces = {{ {faces} }}
damping = {DAMPING}
limits = {{ safety_factor = 2 }}
""")
    return file


# It swings on, and on.
SLIDER = scene_text.body("light", "0.01 kg", "1e-2 kg m^2", center=(200, 0, 0)) + f"""\
{scene_text.joint("L", "prismatic", "ground", "light", (200, 0, 0), (0, 1, 0))}
[[initial]]
joint = "L"
position = "1 mm"
[[force]]
type = "spring"
name = "to_light"
between = ["bar", "light"]
axis = [0, 1, 0]
from = {TIP}
to = {TIP}
stiffness = "{0.01 * (2 * math.pi * FREQUENCY)**2} N/m"
free = "0 mm"
"""


def pull(t):
    """At the tip [N]; the table is linear between its points."""
    last = min(int(t / TIMES[1]), len(TIMES) - 1)
    after = min(last + 1, len(TIMES) - 1)
    share = min(t / TIMES[1] - last, 1.0)
    faded = large(TIMES[last]) + share * (large(TIMES[after]) - large(TIMES[last]))
    return faded + SMALL * math.sin(2 * math.pi * FREQUENCY * t)


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
        part = support.check(clevis, scene(Path(name), LOADS, ("large", "small"))).part
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
        part = support.check(clevis, scene(
            Path(name), SLIDER, ("to_light",), 20, 'motion = "dynamic"\n')).part
    print(f"20 s: {part['verdict']}, {part['why']}")
    if part["verdict"] != "not judged" or "loads are followed up to" not in part["why"]:
        faults.append(f"20 s: {part['verdict']}, {part['why']}")
    sys.exit("\n".join(faults) or None)


if __name__ == "__main__":
    main()

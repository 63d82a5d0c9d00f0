#!/usr/bin/env python3
"""A cantilever on a carrier that a sine shakes near its first frequency, against the
modes of beam theory: however long the motion goes on, for the loads of its later
cycles repeat those of the first, and whatever stands beside them, as a force of
thousands of newtons on the welded face does.

    shaken_bar.py CLEVIS
"""
import math
import sys
import tempfile
from pathlib import Path

import scene_text
import support
from cantilever import HEIGHT, LENGTH, MODES, MODULUS, write_mesh

AMPLITUDE, FREQUENCY, DAMPING = 0.02e-3, 206.0, 0.01


CASE = """[[part.case]]
name = "pull"
traction = { x0 = ["-1 MPa", "0 MPa", "0 MPa"], x1 = ["1 MPa", "0 MPa", "0 MPa"] }
"""


def scene(folder, duration, force, damping=DAMPING, more=""):
    write_mesh(folder)
    file = folder / "scene.toml"
    file.write_text(scene_text.head(
        "shaken bar", support.steel(ratio=0.0, strength=3550.0)) + scene_text.part_body("bar") +
        scene_text.body("carrier", "1 kg", "0.01 kg m^2") +
        scene_text.joint("Y", "prismatic", "ground", "carrier", axis=(0, 1, 0)) +
        scene_text.joint("W", "weld", "carrier", "bar") + f"""[[drive]]
joint = "Y"
law = "sine"
from = "0 mm"
amplitude = "{1e3 * AMPLITUDE} mm"
frequency = "{FREQUENCY} Hz"
[[force]]
type = "constant"
name = "press"
body = "bar"
point = ["0 mm", "0 mm", "0 mm"]
force = ["{force} N", "0 N", "0 N"]
[simulation]
duration = "{duration} s"
{scene_text.BAR}pins = {{ W = "x0" }}
forces = {{ press = {{ face = "x0" }} }}
damping = {damping}
limits = {{ safety_factor = 2 }}
{more}""")
    return file


def largest_stress(duration, steps=400):
    """At the root [MPa]; the bar rests on its carrier before."""
    omega = 2 * math.pi * FREQUENCY
    answers = []
    for mode in MODES:
        h = LENGTH / steps
        shape = [mode.shape((i + 0.5) * h) for i in range(steps)]
        share = sum(shape) / sum(value**2 for value in shape)
        answers.append((mode.root_curvature, share, mode.omega))
    largest = 0.0
    times = int(duration * 40 * FREQUENCY)
    curvature = [0.0] * (times + 1)
    for bend, share, own in answers:
        # q'' + 2 z w q' + w^2 q = share A W^2 sin W t from rest
        force = share * AMPLITUDE * omega**2
        gap = own**2 - omega**2
        loss = 2 * DAMPING * own * omega
        size = gap**2 + loss**2
        sine, cosine = force * gap / size, -force * loss / size
        swing = own * math.sqrt(1 - DAMPING**2)
        c = -cosine
        s = (DAMPING * own * c - omega * sine) / swing
        for i in range(times + 1):
            t = i * duration / times
            q = (sine * math.sin(omega * t) + cosine * math.cos(omega * t) +
                 math.exp(-DAMPING * own * t) *
                 (c * math.cos(swing * t) + s * math.sin(swing * t)))
            curvature[i] += bend * q
    largest = max(map(abs, curvature))
    return 1e-6 * MODULUS * HEIGHT / 2 * largest


def main():
    clevis = Path(sys.argv[1]).resolve()
    faults = []
    for duration, force, more in ((0.2, 0, ""), (0.2, 9000, ""), (3.0, 0, CASE)):
        exact = largest_stress(duration)
        with tempfile.TemporaryDirectory() as name:
            part = support.check(clevis, scene(Path(name), duration, force,
                                               more=more)).part
        vibration = part["vibration"]
        what = f"{duration} s, {force} N{', a case beside' if more else ''}"
        if not vibration:
            faults.append(f"{what}: nothing of vibration")
            continue
        low, high = vibration["band_MPa"]
        print(f"{what}: {vibration['peak_MPa']:.2f} [{low:.2f}, {high:.2f}] MPa, "
              f"{exact:.2f} by the modes of beam theory")
        # Shear and the root's own width: a percent or two beside beam theory,
        # near resonance several times as much.
        if abs(vibration["peak_MPa"] / exact - 1.0) > 0.1:
            faults.append(f"{what}: {vibration['peak_MPa']:.2f} instead of {exact:.2f}")
        if high - low > 0.2 * exact:
            faults.append(f"{what}: band {low:.2f} to {high:.2f}")
    # What is not followed to its end is not judged: with little damping it grows on.
    with tempfile.TemporaryDirectory() as name:
        part = support.check(clevis, scene(Path(name), 20.0, 0, damping=1e-4)).part
    print(f"20 s: {part['verdict']}, {part['why']}")
    if part["verdict"] != "not judged" or "loads are followed up to" not in part["why"]:
        faults.append(f"20 s: {part['verdict']}, {part['why']}")
    sys.exit("\n".join(faults) or None)


if __name__ == "__main__":
    main()

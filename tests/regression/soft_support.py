#!/usr/bin/env python3
"""A block on a flexure, pushed by a sine of its own frequency, which is far below that
of a bar of its size: it swings, against two degrees of freedom, a rigid mass on the
flexibility of its sections. In the static answer of the same loads nothing shows that.

    soft_support.py CLEVIS
"""
import math
import sys
import tempfile
from pathlib import Path

import hex_mesh
import scene_text
import support

LENGTH, WIDTH, BLOCK, FLEXURE = 0.06, 0.01, 0.02, 0.00022  # height of both
MODULUS, DENSITY = 210e9, 7850.0
FORCE, CYCLES = 0.003, 6  # [N] at the block's end
ROWS = 40                # of a cycle in the file of loads
SAFETY = 10


def height(share):
    """Of the section at share times the length: half flexure, half block."""
    return FLEXURE + (BLOCK - FLEXURE) / (1 + math.exp(-(share - 0.5) / 0.02))


class RigidBlock:
    """Displacement and rotation of the centre of mass."""

    def __init__(self, sections=4000):
        step = LENGTH / sections
        rows = [((i + 0.5) * step, height((i + 0.5) / sections)) for i in range(sections)]
        masses = [DENSITY * WIDTH * h * step for _, h in rows]
        self.mass = sum(masses)
        self.center = sum(m * x for m, (x, _) in zip(masses, rows)) / self.mass
        self.inertia = sum(m * ((x - self.center)**2 + h * h / 12)
                           for m, (x, h) in zip(masses, rows))
        give = [step / (MODULUS * WIDTH * h**3 / 12) for _, h in rows]
        arms = [self.center - x for x, _ in rows]
        a, b, c = (sum(g * arm**power for g, arm in zip(give, arms)) for power in (2, 1, 0))
        det = a * c - b * b
        self.stiffness = (c / det, -b / det, a / det)
        first, cross, second = self.stiffness
        half = 0.5 * (first / self.mass + second / self.inertia)
        product = (first * second - cross**2) / (self.mass * self.inertia)
        self.frequency = math.sqrt(half - math.sqrt(half**2 - product)) / (2 * math.pi)

    def largest_stress(self, steps=400):
        """At the root [MPa], through the sine and a cycle after it (Runge, Kutta)."""
        first, cross, second = self.stiffness
        rate = 2 * math.pi * self.frequency

        def slope(t, s):
            push = FORCE * math.sin(rate * t) if t < CYCLES / self.frequency else 0.0
            return (s[2], s[3], (push - first * s[0] - cross * s[1]) / self.mass,
                    (push * (LENGTH - self.center) - cross * s[0] - second * s[1]) /
                    self.inertia)

        def ahead(s, k, h):
            return [value + h * change for value, change in zip(s, k)]

        h = 1 / self.frequency / steps
        state, largest = [0.0] * 4, 0.0
        for i in range((CYCLES + 1) * steps):
            t = i * h
            k1 = slope(t, state)
            k2 = slope(t + h / 2, ahead(state, k1, h / 2))
            k3 = slope(t + h / 2, ahead(state, k2, h / 2))
            k4 = slope(t + h, ahead(state, k3, h))
            state = ahead(state, [(a + 2 * b + 2 * c + d) / 6
                                  for a, b, c, d in zip(k1, k2, k3, k4)], h)
            force = first * state[0] + cross * state[1]
            largest = max(largest, abs(force * self.center + cross * state[0] +
                                       second * state[1]))
        return 1e-6 * largest * 6 / (WIDTH * FLEXURE**2)


def scene(folder, frequency):
    hex_mesh.write(folder / "bar.msh", hex_mesh.block(
        (24, 2, 1), lambda x, y, z: (1e3 * LENGTH * x, 1e3 * height(x) * (y - 0.5),
                                     1e3 * WIDTH * (z - 0.5))))
    rows = [(i / ROWS / frequency, FORCE * math.sin(2 * math.pi * i / ROWS))
            for i in range(CYCLES * ROWS + 1)] + [((CYCLES + 1) / frequency, 0.0)]
    (folder / "sine.csv").write_text("time [s],tip.force_y [N]\n" + "".join(
        f"{time:.9g},{force:.9g}\n" for time, force in rows))
    file = folder / "scene.toml"
    file.write_text(scene_text.head("block on a flexure", support.steel(ratio=0.0), world="") +
                    scene_text.BAR + f"""\
limits = {{ safety_factor = {SAFETY}, singular_zones = "exclude" }}
[[part.history]]
name = "sine"
file = "sine.csv"
faces = {{ tip = "x1" }}
fixed = {{ x0 = ["x", "y", "z"] }}
interpolation = "linear"
""")
    return file


def main():
    clevis = Path(sys.argv[1]).resolve()
    checks = support.Checks()
    block = RigidBlock()
    bar = (1.8751040687**2 / (2 * math.pi * LENGTH**2) *
           math.sqrt(MODULUS * (BLOCK / 2)**2 / 12 / DENSITY))
    print(f"{block.frequency:.2f} Hz, a bar of its length and mean height {bar:.0f} Hz")
    with tempfile.TemporaryDirectory() as name:
        found = support.check(clevis, scene(Path(name), block.frequency), exits=support.JUDGED)
    part, vibration = found.part, found.part["vibration"]
    if not vibration:
        sys.exit(f"nothing of vibration: {found}")
    at_rest = 1e-6 * FORCE * LENGTH * 6 / (WIDTH * FLEXURE**2)
    exact = block.largest_stress()
    checks.expect(abs(found.peak / at_rest - 1) < 0.005,
                  f"at rest {found.peak:.3f} MPa, beam {at_rest:.3f}")
    checks.expect(abs(vibration["peak_MPa"] / exact - 1) < 0.01,
                  f"with vibration {vibration['peak_MPa']:.2f} MPa, two degrees of freedom "
                  f"{exact:.2f}")
    checks.holds(vibration["band_MPa"], exact, "its band", slack=0.005)
    checks.expect(abs(vibration["lowest_frequency_hz"] / block.frequency - 1) < 0.01,
                  f"frequency {vibration['lowest_frequency_hz']:.2f} Hz")
    limit = 355 / SAFETY
    checks.expect(at_rest < limit < exact and part["verdict"] == "fail",
                  f"{part['verdict']} for a limit of {limit} MPa: {part['why']}")
    return checks.exit_code()


if __name__ == "__main__":
    sys.exit(main())

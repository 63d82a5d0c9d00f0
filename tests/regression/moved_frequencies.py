#!/usr/bin/env python3
"""Frequencies that are not those at rest: no pass may lie beneath what theory says.

    moved_frequencies.py CLEVIS

An arm turns about a hub under its own weight. Its inertia stiffens it, and the weight,
which turns once a turn in its frame, meets another frequency than at rest: a cantilever
in its turning frame, by Ritz with x², x³, …, of
E I w⁗ − (N w')' + ρA w'' − ρA Ω² w = ρA g cos Ωt, N the pull of what is outside. Slow
arms keep their pass.

A bar between two pins is shaken across where a press of 0.6 of Euler's load leaves its
frequency, √(1 − 0.6) of that at rest, and where a pull of half of it raises it to,
√1.5.
"""
import math
import sys
import tempfile
from functools import partial
from pathlib import Path

import scene_text
import round_bar
import support
from held_ends import solve
from round_bar import check_of

LENGTH, SIDE, MODULUS, DENSITY, GRAVITY = 0.3, 0.01, 210e9, 7850.0, 9.81
DAMPING, DURATION, STRENGTH = 0.01, 1.0, 355.0
AREA, INERTIA = SIDE**2, SIDE**4 / 12
FIRST = 1.8751**2 / LENGTH**2 * math.sqrt(MODULUS * INERTIA / DENSITY / AREA)  # rad/s


def arm(folder, speed, factor):
    """speed: rad/s about the world's z, weight along −y."""
    scene_text.write_bar(folder, (LENGTH, SIDE, SIDE), (12, 2, 2))
    file = folder / "scene.toml"
    world = f'[world]\ngravity = ["0 m/s^2", "-{GRAVITY} m/s^2", "0 m/s^2"]\n'
    file.write_text(scene_text.head("arm", world=world) + scene_text.part_body("bar") +
                    scene_text.body("hub", "1 kg", "1e-3 kg m^2") +
                    scene_text.joint("H", "revolute", "ground", "hub", (0, 0, 0), (0, 0, 1)) +
                    scene_text.joint("A", "weld", "hub", "bar") + f"""[[drive]]
joint = "H"
law = "speed"
from = "0 deg"
speed = "{speed:.9g} rad/s"
[simulation]
duration = "{DURATION} s"
instants = 201
{scene_text.BAR}pins = {{ A = "x0" }}
damping = {DAMPING}
limits = {{ safety_factor = {factor:.6g}, singular_zones = "exclude" }}
[accuracy]
peak_stress = "2 %"
""")
    return file


def first_shape(speed, powers=range(2, 8), steps=300):
    """Of the turning cantilever: frequency [rad/s], its moment at the root over its
    modal coordinate [N m], and the modal force of a unit of ρA g [m], with unit mass."""
    def integral(f):
        h = LENGTH / steps
        return sum(f((i + 0.5) * h) for i in range(steps)) * h
    mass = DENSITY * AREA

    def basis(p, x, order=0):
        factor = math.prod(range(p, p - order, -1))
        return factor * x**(p - order) / LENGTH**p

    def pull(x):
        return mass * speed**2 * (LENGTH**2 - x**2) / 2
    weigh = [[integral(lambda x: mass * basis(a, x) * basis(b, x)) for b in powers]
             for a in powers]
    stiff = [[integral(lambda x: MODULUS * INERTIA * basis(a, x, 2) * basis(b, x, 2)
                       + pull(x) * basis(a, x, 1) * basis(b, x, 1))
              - speed**2 * weigh[i][j] for j, b in enumerate(powers)]
             for i, a in enumerate(powers)]
    # Inverse iteration with Gauss's elimination.
    shape = [1.0] * len(stiff)
    for _ in range(60):
        load = [sum(m * v for m, v in zip(row, shape)) for row in weigh]
        shape = solve(stiff, load)
        norm = math.sqrt(sum(v * w * u for v, row in zip(shape, weigh)
                             for w, u in zip(row, shape)))
        shape = [v / norm for v in shape]
    square = sum(v * k * u for v, row in zip(shape, stiff) for k, u in zip(row, shape))
    root = MODULUS * INERTIA * sum(v * basis(p, 0.0, 2) for v, p in zip(shape, powers))
    force = integral(lambda x: sum(v * basis(p, x) for v, p in zip(shape, powers)))
    return math.sqrt(square), root, force


def steady_stress(speed):
    """Largest at the root once it swings on, and the pull alone [MPa]."""
    own, root, force = first_shape(speed)
    load = DENSITY * AREA * GRAVITY * force
    swing = load / math.hypot(own**2 - speed**2, 2 * DAMPING * own * speed)
    pull = DENSITY * (speed * LENGTH)**2 / 2
    return (root * swing * SIDE / 2 / INERTIA + pull) / 1e6, pull / 1e6


PINNED, SHAKE = 495.0, 0.03  # mm between the pins, amplitude
EULER = math.pi**2 * round_bar.MODULUS * round_bar.INERTIA / PINNED**2  # N
SECTION = math.pi * round_bar.DIAMETER**2 / 4  # mm²


def bent_first(press):
    """First frequency of the bar between its pins [rad/s]."""
    rest = (math.pi / PINNED)**2 * math.sqrt(
        round_bar.MODULUS * round_bar.INERTIA / round_bar.DENSITY / SECTION)
    return rest * math.sqrt(1 - press)


def shaken(folder, press, share):
    """Pressed by so much of Euler's load, shaken at a share of the first frequency that
    this leaves it."""
    round_bar.round_bar(folder, [(10, 1, "round_a"), (480, 12, "round_m"), (10, 1, "bore_B")])
    file = folder / "scene.toml"
    file.write_text(scene_text.head("shaken") + scene_text.part_body("bar") +
                    scene_text.body("carrier", "5 kg", "0.01 kg m^2") +
                    scene_text.joint("S", "prismatic", "ground", "carrier", axis=(0, 1, 0)) +
                    scene_text.joint("A", "spherical", "carrier", "bar", (0, 0, 0), (1, 0, 0)) +
                    scene_text.joint("B", "point_on_line", "carrier", "bar", (495, 0, 0),
                                     (1, 0, 0)) + f"""[[drive]]
joint = "A"
coordinate = "angle_1"
law = "constant"
from = "0 deg"
[[drive]]
joint = "S"
law = "sine"
from = "0 mm"
amplitude = "{SHAKE} mm"
frequency = "{share * bent_first(press) / 2 / math.pi:.9g} Hz"
[[force]]
type = "constant"
name = "press"
body = "bar"
point = ["500 mm", "0 mm", "0 mm"]
force = ["{-press * EULER:.9g} N", "0 N", "0 N"]
[simulation]
duration = "0.4 s"
instants = 101
{scene_text.BAR}pins = {{ A = "left", B = {{ group = "bore_B", length = "10 mm" }} }}
drives = {{ A = {{ face = "left" }} }}
forces = {{ press = {{ face = "right" }} }}
damping = {DAMPING}
limits = {{ safety_factor = {STRENGTH / 200}, buckling = 1.2, singular_zones = "exclude" }}
[accuracy]
peak_stress = "5 %"
""")
    return file


def shaken_stress(press, share):
    """Once it swings on, 0.93 of it after 0.4 s: the first sine of an even load, and the
    press [MPa]."""
    own = bent_first(press)
    shaking = SHAKE * (share * own)**2
    swing = 4 / math.pi * shaking / math.hypot(own**2 - (share * own)**2,
                                               2 * DAMPING * share * own * bent_first(0))
    return (round_bar.MODULUS * (math.pi / PINNED)**2 * swing * round_bar.DIAMETER / 2 +
            abs(press) * EULER / SECTION)


def main():
    clevis = Path(sys.argv[1]).resolve()
    checks = support.Checks()
    check = partial(check_of, clevis)
    for share in (0.3, 1.11):
        speed = share * FIRST
        truth, pull = steady_stress(speed)
        allowed = pull + 0.7 * (truth - pull)  # MPa
        part = check(arm, speed, STRENGTH / allowed).part
        checks.expect(part["verdict"] != "pass",
                      f"at {share} of its first frequency, {allowed:.4g} MPa allowed, "
                      f"{truth:.4g} by theory: {part['verdict']}")
        if share < 0.5:
            part = check(arm, speed, STRENGTH / (1.3 * truth)).part
            checks.expect(part["verdict"] == "pass",
                          f"at {share} of it, {1.3 * truth:.4g} MPa allowed: "
                          f"{part['verdict']}")
    for press, share in ((0.6, 1.0), (0.6, 0.2), (-0.5, 1.0), (-0.5, 0.2)):
        part = check(shaken, press, share).part
        truth = shaken_stress(press, share)
        checks.expect((part["verdict"] == "pass") == (truth < 200),
                      f"pressed by {press} of Euler's load, shaken at {share} of its "
                      f"frequency, {truth:.4g} MPa by "
                      f"theory, 200 allowed: {part['verdict']}")
    return checks.exit_code()


if __name__ == "__main__":
    sys.exit(main())

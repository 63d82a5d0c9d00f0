#!/usr/bin/env python3
"""Bodies that an arm carries move its frequencies: by their spin, and as they stand.

    carried_bodies.py CLEVIS

An arm is welded to the ground. An unbalanced disc spins on its end about its length.
Its gyroscopic moment parts the arm's two equal frequencies; theory is Euler's beam by
its end's way and turn, consistent mass (two unknowns a plane, y + i z), with the spin's
momentum: (K - w² M + w Ip spin on turns) u = 0, and once it swings on Id - Ip for Id.

On the same arm a forearm unfolds, which weighs more on it as it stretches, and then its
spindle runs at the stretched arm's first frequency. Theory is that beam beside the
stretched forearm.
"""
import math
import sys
from functools import partial
from pathlib import Path

import scene_text
import support
from round_bar import check_of

LENGTH, HEIGHT, MODULUS, DENSITY, GRAVITY = 0.3, 0.03, 210e9, 7850.0, 9.81
DAMPING, STRENGTH, HOLDER = 0.02, 355.0, 0.1
ALLOWED = STRENGTH / 1.5
WORLD = f'[world]\ngravity = ["0 m/s^2", "-{GRAVITY} m/s^2", "0 m/s^2"]\n'


def beam(width):
    """Stiffness and mass of the arm by its end's way and turn, in bending along its
    height; its second moment [m⁴]."""
    inertia = width * HEIGHT**3 / 12
    stiff = MODULUS * inertia / LENGTH**3
    mass = DENSITY * width * HEIGHT * LENGTH / 420
    return ([[12 * stiff, -6 * LENGTH * stiff], [-6 * LENGTH * stiff, 4 * LENGTH**2 * stiff]],
            [[156 * mass, -22 * LENGTH * mass], [-22 * LENGTH * mass, 4 * LENGTH**2 * mass]],
            inertia)


def added(matrix, more):
    return [[a + b for a, b in zip(row, other)] for row, other in zip(matrix, more)]


def determinant(m):
    return m[0][0] * m[1][1] - m[0][1] * m[1][0]


def frequencies(width, carried, momentum=0.0):
    """Below 400 Hz, those against the spin negative, by what is carried at the end as a
    mass matrix and its momentum along the arm [kg m²/s]."""
    stiff, mass, _ = beam(width)
    mass = added(mass, carried)

    def dynamic(hertz):
        w = 2 * math.pi * hertz
        return determinant([[stiff[0][0] - w * w * mass[0][0], stiff[0][1] - w * w * mass[0][1]],
                            [stiff[1][0] - w * w * mass[1][0],
                             stiff[1][1] - w * w * mass[1][1] + w * momentum]])
    found, step = [], 0.5
    for k in range(-800, 800):
        low, high = step * k, step * (k + 1)
        if dynamic(low) * dynamic(high) > 0:
            continue
        for _ in range(40):
            middle = (low + high) / 2
            if dynamic(low) * dynamic(middle) > 0:
                low = middle
            else:
                high = middle
        found.append(low)
    return sorted(found, key=abs)


def steady(width, carried, rate, force, spun=0.0):
    """Amplitude of the bending moment at the root under forces at rate [rad/s] on the
    end's way and turn [N m]; damped as the first frequency. spun: what the spin takes
    off the inertia against turns [kg m²]."""
    stiff, mass, inertia = beam(width)
    mass = added(mass, carried)
    damped = 2j * DAMPING * 2 * math.pi * abs(frequencies(width, carried)[0]) * rate
    rows = [[k + (damped - rate**2) * m for k, m in zip(*pair)] for pair in zip(stiff, mass)]
    rows[1][1] += rate**2 * spun
    whole = determinant(rows)
    way = (force[0] * rows[1][1] - force[1] * rows[0][1]) / whole
    turn = (force[1] * rows[0][0] - force[0] * rows[1][0]) / whole
    return abs(MODULUS * inertia * (6 * way / LENGTH**2 - 2 * turn / LENGTH))


def body(name, mass, inertia, center, origin, turned=""):
    values = ", ".join(f'"{value:.9g} kg m^2"' for value in inertia)
    return f"""[[body]]
name = "{name}"
mass = "{mass} kg"
center_of_mass = {scene_text.lengths(center)}
inertia = [{values}]
placement = {{ origin = {scene_text.lengths(origin)}{turned} }}
"""


def scene(folder, name, width, bodies, drives, duration):
    scene_text.write_bar(folder, (LENGTH, HEIGHT, width), (10, 2, 2))
    file = folder / "scene.toml"
    file.write_text(scene_text.head(name, world=WORLD) + scene_text.part_body("bar") +
                    body("holder", HOLDER, (1e-5,) * 3, (0, 0, 0), (1e3 * LENGTH, 0, 0)) +
                    bodies + scene_text.joint("W", "weld", "ground", "bar") +
                    scene_text.joint("V", "weld", "bar", "holder", (1e3 * LENGTH, 0, 0)) +
                    drives + f"""[simulation]
duration = "{duration} s"
instants = 101
{scene_text.BAR}pins = {{ W = "x0", V = "x1" }}
damping = {DAMPING}
limits = {{ safety_factor = {STRENGTH / ALLOWED}, deflection = "20 mm", singular_zones = "exclude" }}
[accuracy]
peak_stress = "5 %"
""")
    return file


DISC = 5.0  # kg
UNBALANCE = 0.08e-3 * DISC  # kg m


def disc_on_the_end(folder, speed, polar):
    """polar: inertia about its axis, twice that across [kg m²]; speed in rpm."""
    return scene(folder, "disc", HEIGHT,
                 body("disc", DISC, (polar, polar / 2, polar / 2),
                      (0, 1e3 * UNBALANCE / DISC, 0), (1e3 * LENGTH, 0, 0)),
                 scene_text.joint("T", "revolute", "holder", "disc", (1e3 * LENGTH, 0, 0),
                                  (1, 0, 0)) + f"""[[drive]]
joint = "T"
law = "speed"
from = "0 deg"
speed = "{speed} rpm"
""", 0.6)


def disc_stress(speed, polar):
    """At the corner of the root, with the weight [MPa]; frequencies still and spun [Hz]."""
    rate = speed * math.pi / 30
    mass = DISC + HOLDER
    stands = [[mass, 0], [0, polar / 2]]
    still = frequencies(HEIGHT, stands)
    spun = frequencies(HEIGHT, stands, polar * rate)
    moment = math.sqrt(2) * steady(HEIGHT, stands, rate, (UNBALANCE * rate**2, 0), polar)
    weight = GRAVITY * LENGTH * (mass + DENSITY * HEIGHT**2 * LENGTH / 2)
    inertia = beam(HEIGHT)[2]
    return (moment + weight) * HEIGHT / 2 / inertia / 1e6, abs(still[0]), spun


WIDTH, UNFOLDED = 0.02, 0.25  # m, s
JIB, TO_JIB, JIB_INERTIA = 4.0, 0.15, 0.03
SPINDLE, TO_SPINDLE, SPINDLE_INERTIA, OFF = 2.0, 0.15, 0.002, 0.8e-3


def forearm(stretch):
    """What it weighs on the end; stretch: cosine of its angle."""
    lever = (JIB * TO_JIB + SPINDLE * TO_SPINDLE) * stretch
    turn = JIB * TO_JIB**2 + SPINDLE * TO_SPINDLE**2 + JIB_INERTIA + SPINDLE_INERTIA
    return [[JIB + SPINDLE + HOLDER, lever], [lever, turn]]


def forearm_that_unfolds(folder, speed, to):
    """From 180 deg, folded back, to an angle in deg, and stays there; speed in rpm."""
    end = 1e3 * LENGTH
    turned = ', angle = "180 deg"'
    bodies = (body("jib", JIB, (JIB_INERTIA / 1.5, JIB_INERTIA / 1.5, JIB_INERTIA),
                   (1e3 * TO_JIB, 0, 0), (end, 0, 0), turned) +
              body("spindle", SPINDLE,
                   (SPINDLE_INERTIA / 1.5, SPINDLE_INERTIA / 1.5, SPINDLE_INERTIA),
                   (1e3 * OFF, 0, 0), (end - 1e3 * TO_SPINDLE, 0, 0), turned))

    def hinge(name, first, second, at):
        return f"""[[joint]]
name = "{name}"
type = "revolute"
between = ["{first}", "{second}"]
at = {{ {first} = {scene_text.lengths(at)}, {second} = {scene_text.lengths((0, 0, 0))} }}
axis = [0, 0, 1]
normal = {{ {first} = [1, 0, 0], {second} = [1, 0, 0] }}
"""
    drives = hinge("T", "holder", "jib", (0, 0, 0)) + hinge(
        "R", "jib", "spindle", (1e3 * TO_SPINDLE, 0, 0)) + f"""[[drive]]
joint = "T"
law = "quintic"
from = "180 deg"
to = "{to} deg"
duration = "{UNFOLDED} s"
[[drive]]
joint = "R"
law = "speed"
from = "0 deg"
speed = "{speed} rpm"
"""
    return scene(folder, "forearm", WIDTH, bodies, drives, 1.0)


def forearm_stress(speed, stretch):
    """At the root as it swings on where it stands [MPa]."""
    rate = speed * math.pi / 30
    carried = forearm(stretch)
    force = SPINDLE * OFF * rate**2
    swing = steady(WIDTH, carried, rate, (force, TO_SPINDLE * force * stretch))
    arm = DENSITY * WIDTH * HEIGHT * LENGTH
    weight = GRAVITY * (LENGTH * (arm / 2 + carried[0][0]) + carried[0][1])
    return (swing + weight) * HEIGHT / 2 / beam(WIDTH)[2] / 1e6


def main():
    clevis = Path(sys.argv[1]).resolve()
    checks = support.Checks()
    check = partial(check_of, clevis)
    for speed, polar in ((5650, 0.1), (1700, 0.1), (2000, 1e-3)):
        part = check(disc_on_the_end, speed, polar).part
        truth, still, spun = disc_stress(speed, polar)
        row = (f"disc of {polar} kg m^2 at {speed} rpm, {truth:.4g} MPa by theory, "
               f"{ALLOWED:.4g} allowed: {part['verdict']}")
        checks.expect((part["verdict"] == "pass") == (truth < ALLOWED), row)
        if part["verdict"] != "pass":
            told = [float(word) for word in part["why"].split()
                    if word.replace(".", "").isdigit()]
            nearest = min(spun, key=lambda hertz: abs(abs(hertz) - speed / 60))
            checks.expect("spins on it" in part["why"] and
                          any(abs(value / abs(nearest) - 1) < 0.02 for value in told),
                          f"{still:.4g} Hz, spun {nearest:.4g}: {part['why']}")
    stretched = abs(frequencies(WIDTH, forearm(1.0))[0])
    for to, speed in ((0, 60 * stretched), (179, 60 * stretched)):
        stretch = math.cos(math.radians(to))
        answer = check(forearm_that_unfolds, speed, to)
        part, truth = answer.part, forearm_stress(speed, stretch)
        checks.expect((part["verdict"] == "pass") == (truth < ALLOWED),
                      f"forearm to {to} deg at {speed:.0f} rpm, {truth:.4g} MPa by theory: "
                      f"{part['verdict']}")
        if truth > ALLOWED:
            found = part["vibration"]["peak_MPa"]
            checks.expect(abs(found / truth - 1) < 0.1,
                          f"with vibration {found:.4g} MPa, {truth:.4g} by theory")
    return checks.exit_code()


if __name__ == "__main__":
    sys.exit(main())

#!/usr/bin/env python3
"""A bar whose one end is welded to the ground, or to a hub that spins: what only
carries a force, or a body that nothing holds, is no support. Buckling and deflection
are those of a cantilever.

    held_ends.py CLEVIS
"""
import math
import sys
import tempfile
from pathlib import Path

import scene_text
import support

LENGTH, WIDTH, THICKNESS, MODULUS, DENSITY = 0.2, 0.01, 0.003, 210e9, 7850.0
SECOND_MOMENT = WIDTH * THICKNESS**3 / 12
WELD = scene_text.joint("W", "weld", "ground", "bar")
TIP = (scene_text.body("block", "1 g", "1e-6 kg m^2", origin=(200, 0, 0)) +
       scene_text.joint("tip", "weld", "bar", "block", (200, 0, 0)))
PUSHED = '[part.forces]\npush = { face = "x1" }\n'


def write_scene(folder, mechanism, pins, forces):
    scene_text.write_bar(folder, (LENGTH, WIDTH, THICKNESS), (20, 2, 1))
    file = folder / "scene.toml"
    file.write_text(scene_text.head("bar") + scene_text.part_body("bar") + mechanism + f"""\
[simulation]
duration = "0.01 s"
instants = 3
{scene_text.BAR}pins = {{ {pins} }}
limits = {{ safety_factor = 1, buckling = 2.5, deflection = "0.8 mm" }}
{forces}""")
    return file


def pushed(folder, force, block):
    """force: text of its vector; block: whether it acts on a body at the tip."""
    push = f"""[[force]]
type = "constant"
name = "push"
body = "{"block" if block else "bar"}"
point = ["{0 if block else 200} mm", "0 mm", "0 mm"]
force = [{force}]
"""
    if block:
        return write_scene(folder, TIP + WELD + push, 'W = "x0", tip = "x1"', "")
    return write_scene(folder, WELD + push, 'W = "x0"', PUSHED)


def spinning(folder):
    """On a hub, from 300 mm inwards to 100 mm: pressed by its own inertia."""
    return write_scene(
        folder, scene_text.body("hub", "1 kg", "0.01 kg m^2", origin=(300, 0, 0)) +
        scene_text.joint("axle", "revolute", "ground", "hub", (300, 0, 0), (0, 0, 1)) +
        scene_text.joint("W", "weld", "hub", "bar") + """[[drive]]
joint = "axle"
law = "speed"
from = "0 deg"
speed = "314.159265 rad/s"
""", 'W = "x0"', "")


def spin_factor(steps=400):
    """Lowest factor of a cantilever under N(x), its inertia outwards of x from the
    tip, by Ritz with the powers x^2 to x^9."""
    omega, hub = 314.159265, 0.3
    powers = range(2, 10)

    def integral(f):
        h = LENGTH / steps
        return sum(f((i + 0.5) * h) for i in range(steps)) * h

    mass = DENSITY * WIDTH * THICKNESS
    # Pressed at x by all from there to the tip at 0.2, at radii 0.3 - x.
    def pressed(x):
        return mass * omega**2 * ((hub - x)**2 - (hub - LENGTH)**2) / 2
    rigidity = MODULUS * SECOND_MOMENT
    stiff = [[integral(lambda x: rigidity * a * (a - 1) * b * (b - 1) *
                       x**(a + b - 4) / LENGTH**(a + b)) for b in powers]
             for a in powers]
    loaded = [[integral(lambda x: pressed(x) * a * b * x**(a + b - 2) /
                        LENGTH**(a + b)) for b in powers] for a in powers]
    return lowest(stiff, loaded)


def solve(matrix, rhs):
    rows = [row[:] + [value] for row, value in zip(matrix, rhs)]
    n = len(rows)
    for k in range(n):
        pivot = max(range(k, n), key=lambda i: abs(rows[i][k]))
        rows[k], rows[pivot] = rows[pivot], rows[k]
        for i in range(k + 1, n):
            factor = rows[i][k] / rows[k][k]
            rows[i] = [a - factor * b for a, b in zip(rows[i], rows[k])]
    x = [0.0] * n
    for k in reversed(range(n)):
        x[k] = (rows[k][n] - sum(rows[k][j] * x[j] for j in range(k + 1, n))) / rows[k][k]
    return x


def lowest(stiff, loaded, iterations=60):
    """Of stiff x = factor loaded x, by inverse iteration."""
    x = [1.0] * len(stiff)
    factor = 0.0
    for _ in range(iterations):
        y = solve(stiff, [sum(a * b for a, b in zip(row, x)) for row in loaded])
        factor = max(map(abs, x)) / max(map(abs, y))
        scale = max(map(abs, y))
        x = [value / scale for value in y]
    return factor


def main():
    clevis = Path(sys.argv[1]).resolve()
    faults = []

    def expect(what, value, exact, tolerance=0.01):
        near = abs(value - exact) <= tolerance * abs(exact)
        print(f"{what}: {value:.5g}, {exact:.5g} by theory")
        if not near:
            faults.append(f"{what}: {value:.6g} instead of {exact:.6g}")

    push = 150.0
    column = math.pi**2 * MODULUS * SECOND_MOMENT / (4 * LENGTH**2) / push
    pull = 20.0
    bent = pull * LENGTH**3 / (3 * MODULUS * WIDTH**3 * THICKNESS / 12)
    for block in (False, True):
        on = "a body at its tip" if block else "its tip"
        with tempfile.TemporaryDirectory() as name:
            column_part = support.check(clevis, pushed(
                Path(name), f'"-{push} N", "0 N", "0 N"', block)).part
            expect(f"pushed at {on}: factor", column_part["buckling"]["factor"], column)
            expect(f"pushed at {on}: Euler", column_part["buckling"]["euler"], column)
            if column_part["verdict"] != "fail":
                faults.append(f"pushed at {on}: {column_part['verdict']}")
            across = support.check(clevis, pushed(
                Path(name), f'"0 N", "{pull} N", "0 N"', block)).part
            expect(f"pulled across at {on}: deflection, mm", across["deflection_mm"],
                   1e3 * bent)
            expect(f"pulled across at {on}: by beam theory, mm",
                   across["beam"]["deflection_mm"], 1e3 * bent)
            if across["verdict"] != "fail":
                faults.append(f"pulled across at {on}: {across['verdict']}")
    with tempfile.TemporaryDirectory() as name:
        part = support.check(clevis, spinning(Path(name))).part
        expect("pressed by its spin: factor", part["buckling"]["factor"], spin_factor())
    sys.exit("\n".join(faults) or None)


if __name__ == "__main__":
    main()

#!/usr/bin/env python3
"""Runs `clevis simulate` on the landing gear whose wheel an impedance holds,
leads and presses on a wall, and compares with closed forms and with an
integration of its own along the path.

    impedance.py CLEVIS GEOMETRY
"""
import math
import sys
import tempfile
from pathlib import Path

from closed_forms import LandingGear
from runs import changed, check_energy, forces, simulate
from source_systems import expect, faults, marker, uniform

STIFFNESS, DAMPING = 5e3, 75.2254  # N/m, N s/m
START = LandingGear(210)
TANGENT = [slope / math.hypot(*START.slope) for slope in START.slope]
MASS = START.mass_along_path(210)


def pushing(t):
    """Push [N] along the path at its start."""
    return (500 * t if t < 0.1 else 50.0 if t < 1 else
            max(0.0, 50 - 5e4 * (t - 1)))


def resting(_):
    return START.T, (0.0, 0.0)


def led(t, speed=0.1):
    """Target [mm] and its velocity [m/s] on the path."""
    angle = math.atan2(START.T[1] + 80, START.T[0]) - speed * t / 0.14
    c, s = math.cos(angle), math.sin(angle)
    return (140 * c, -80 + 140 * s), (speed * s, -speed * c)


def follow(target, push, absolute, end, step):
    """[l_x mm] every two steps from rest at 210 mm: one equation, M l'' +
    M' l'^2 / 2 = Q, by classical Runge-Kutta."""
    def mass(l_x):
        gear = LandingGear(l_x)
        return gear.mass_along_path(l_x) * (gear.slope[0]**2 +
                                            gear.slope[1]**2)

    def slope(t, y):
        l_x, rate = y  # mm, mm/s
        gear = LandingGear(l_x)
        place, speed = target(t)
        if absolute:
            speed = (0.0, 0.0)
        q = sum(gear.slope[i] * (
            -STIFFNESS * 1e-3 * (gear.T[i] - place[i]) -
            DAMPING * (1e-3 * rate * gear.slope[i] - speed[i]) +
            push(t) * TANGENT[i]) for i in (0, 1))
        bend = (mass(l_x + 1e-3) - mass(l_x - 1e-3)) / 2e-3
        return rate, (1e3 * q - 0.5 * bend * rate * rate) / mass(l_x)

    y, path = [210.0, 0.0], [210.0]
    for i in range(round(end / step)):
        t = i * step
        a = slope(t, y)
        b = slope(t + step / 2, [y[k] + step / 2 * a[k] for k in (0, 1)])
        c = slope(t + step / 2, [y[k] + step / 2 * b[k] for k in (0, 1)])
        d = slope(t + step, [y[k] + step * c[k] for k in (0, 1)])
        y = [y[k] + step / 6 * (a[k] + 2 * b[k] + 2 * c[k] + d[k])
             for k in (0, 1)]
        if i % 2:
            path.append(y[0])
    return path


def path_off(rows, path):
    """Largest distance of T [mm] from the path's at the same instants."""
    return max(math.dist(marker(row, "T")[:2], LandingGear(l_x).T)
               for row, l_x in zip(rows, path, strict=True))


def arc(row):
    """Way of T [mm] along its path since 210 mm."""
    x, y, _ = marker(row, "T")
    start = math.atan2(START.T[1] + 80, START.T[0])
    return 140 * (start - math.atan2(y + 80, x))


def check_push(clevis, geometry, folder):
    """The way under a push: K R sin(phi) = P cos(phi), P/K for small ones."""
    scene = geometry / "landing_gear/impedance.toml"
    result, rows, _ = simulate(clevis, scene, folder)
    check_energy("push", result)
    held = next(row for row in rows if row["t_s"] == 1)
    way = arc(held)
    exact = 140 * math.atan(50 / (STIFFNESS * 0.140))
    expect("push: way [mm]", way, exact, 1e-8)
    expect("push: P/K [mm]", way, 10, 0.02)
    off = path_off(uniform(scene, rows),
                   follow(resting, pushing, False, 1.2, 5e-4))
    expect("push: path [mm]", off, 0, 1e-4)
    print(f"push: {way:.6f} mm, closed form {exact:.6f} mm, path {off:.1e} mm "
          "off")


def extremes(rows):
    """[(t, arc)] where the way turns, by parabolas."""
    ways = [arc(row) for row in rows]
    for i in range(1, len(ways) - 1):
        before, here, after = ways[i - 1:i + 2]
        if (here - before) * (after - here) < 0:
            shift = 0.5 * (before - after) / (before - 2 * here + after)
            yield (rows[i]["t_s"] + shift * (rows[1]["t_s"] - rows[0]["t_s"]),
                   here - 0.25 * (before - after) * shift)


def ring_down(clevis, geometry, folder, damping):
    """(frequency [Hz], damping ratio) of the free motion from 2 um beside the
    target, undamped frequency and ratio by its extremes."""
    scene = changed(geometry / "landing_gear/impedance.toml", folder,
                    ('position = "210 mm"', 'position = "210.001 mm"'),
                    ('"50 N", "50 N"', '"0 N", "0 N"'),
                    ("75.2254 N s/m", f"{damping} N s/m"),
                    ('duration = "1.2 s"', 'duration = "0.15 s"'),
                    ("instants = 1201", "instants = 301"))
    _, rows, _ = simulate(clevis, scene, folder)
    (first, a), (second, b) = list(extremes(uniform(scene, rows)))[:2]
    decrement = math.log(-a / b)
    ratio = decrement / math.hypot(math.pi, decrement)
    damped = math.pi / (second - first)
    return damped / math.sqrt(1 - ratio**2) / (2 * math.pi), ratio


def check_ring_down(clevis, geometry, folder):
    for wanted in (0.7, 0.1):
        damping = 2 * wanted * math.sqrt(STIFFNESS * MASS)
        frequency, ratio = ring_down(clevis, geometry, folder, damping)
        exact = math.sqrt(STIFFNESS / MASS) / (2 * math.pi)
        expect("ring-down [Hz]", frequency / exact, 1, 2e-4)
        expect("ring-down: damping ratio", ratio, wanted, 1e-4)
        print(f"ring-down: {frequency:.4f} Hz, closed form {exact:.4f} Hz; "
              f"damping ratio {ratio:.5f} of {wanted}")


def led_by(clevis, geometry, folder, damping_of):
    """(rows, lag along the path [mm] after 0.45 s)"""
    scene = changed(geometry / "landing_gear/impedance_led.toml", folder,
                    ('"relative"', f'"{damping_of}"'))
    _, rows, _ = simulate(clevis, scene, folder)
    row = next(row for row in rows if row["t_s"] == 0.45)
    return uniform(scene, rows), 45 - arc(row)


def check_led(clevis, geometry, folder):
    """Damping of the absolute speed, as published, lags by b v / K."""
    for damping_of, lag in (("absolute", DAMPING * 0.1 / 5), ("relative", 0)):
        rows, found = led_by(clevis, geometry, folder, damping_of)
        off = path_off(rows, follow(led, lambda t: 0.0,
                                    damping_of == "absolute", 0.5, 5e-4))
        expect(f"led, {damping_of}: path [mm]", off, 0, 1e-4)
        # beside it the growth of the mass along the path
        expect(f"led, {damping_of}: lag [mm]", found, lag, 0.01)
        print(f"led, {damping_of}: lag {found:.4f} mm, b v / K = {lag:.4f} mm, "
              f"path {off:.1e} mm off")


def wall_force():
    """The same balance along the arc: force of the wall [N]."""
    low, high = 1.0, 3.0  # mm below the start
    for _ in range(100):
        sunk = 0.5 * (low + high)
        x = math.sqrt(140**2 - sunk**2)
        normal = 1e2 * (sunk - 1)
        along = (-sunk / 140, -x / 140)  # of the path, downwards
        pull = 5 * ((140 - x) * along[0] + (-10 + sunk) * along[1])
        low, high = ((sunk, high) if pull + normal * along[1] > 0
                     else (low, sunk))
    return 1e2 * (low - 1)


WALL_FORMULA = 5e3 * 1e5 / 1.05e5 * 0.009  # N


def wall_by(clevis, geometry, folder):
    """Force of the wall in the end [N]."""
    simulate(clevis, geometry / "landing_gear/impedance_wall.toml", folder)
    return forces(folder)[-1]["wall.effort_N"]


def check_wall(clevis, geometry, folder):
    found = wall_by(clevis, geometry, folder)
    expect("wall: force [N]", found, wall_force(), 1e-3)
    expect("wall: K k / (K + k) gap [N]", found, WALL_FORMULA, 0.01)
    print(f"wall: {found:.5f} N, arc {wall_force():.5f} N, straight "
          f"{WALL_FORMULA:.5f} N")


def main():
    clevis, geometry = str(Path(sys.argv[1]).resolve()), Path(sys.argv[2])
    with tempfile.TemporaryDirectory() as folder:
        for check in (check_push, check_ring_down, check_led, check_wall):
            check(clevis, geometry, folder)
    for fault in faults:
        print(fault)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())

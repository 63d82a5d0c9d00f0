#!/usr/bin/env python3
"""Runs `clevis simulate` on one block of 1 kg on a rail, with forces whose values
are extreme, and compares with closed forms.

    one_mass.py CLEVIS
"""
import math
import subprocess
import sys
import tempfile
from pathlib import Path

import runs
from source_systems import expect, faults


def scene(*tables, gravity=0.0, duration=1.0, instants=5, tolerance=1e-8):
    """x is the rail's distance; gravity pulls towards −x."""
    return f"""schema = 1
name = "one mass"
[world]
gravity = ["{-gravity!r} m/s^2", "0 m/s^2", "0 m/s^2"]
[[body]]
name = "block"
mass = "1 kg"
center_of_mass = ["0 m", "0 m", "0 m"]
inertia = ["1 kg m^2", "1 kg m^2", "1 kg m^2"]
[[joint]]
name = "rail"
type = "prismatic"
between = ["ground", "block"]
point = ["0 m", "0 m", "0 m"]
axis = [1, 0, 0]
{"".join(tables)}
[simulation]
duration = "{duration!r} s"
instants = {instants}
tolerance = {tolerance!r}
"""


def force(kind, **keys):
    lines = [f'{key} = "{value}"' for key, value in keys.items()]
    return "\n".join(["[[force]]", f'type = "{kind}"', 'joint = "rail"',
                      *lines, ""])


def start(position, rate):
    return (f'[[initial]]\njoint = "rail"\nposition = "{position!r} m"\n'
            f'rate = "{rate!r} m/s"\n')


def simulate(clevis, text, folder):
    """(simulate.json, rows of motion.csv, events)"""
    path = Path(folder) / "scene.toml"
    path.write_text(text)
    return runs.simulate(clevis, path, Path(folder) / "out")


def at_end(rows):
    return 1e-3 * rows[-1]["block.position_x_mm"]


def check_preload_alone(clevis, folder):
    """A spring of zero stiffness pulls with its preload, whatever `free`."""
    for name, keys in (("no free length", {}), ("free", {"free": "0.1 m"})):
        spring = force("spring", stiffness="0 N/m", preload="3 N", **keys)
        _, rows, _ = simulate(clevis, scene(spring), folder)
        expect(f"preload alone, {name} [m]", at_end(rows), -1.5, 1e-8)
    _, rows, _ = simulate(clevis, scene(
        force("spring", damping="2 N s/m", preload="3 N")), folder)
    expect("preload and damper [m]", at_end(rows),
           -1.5 * (1 - 0.5 * (1 - math.exp(-2))), 1e-8)


def decayed(k, c, pull, x, v, t):
    """x(t) of x'' + c x' + k x = pull, c² > 4 k."""
    fast = -0.5 * (c + math.sqrt(c * c - 4.0 * k))
    slow = k / fast
    a = (v - fast * (x - pull / k)) / (slow - fast)
    b = (x - pull / k) - a
    return pull / k + a * math.exp(slow * t) + b * math.exp(fast * t)


def expect_quick(name, result, most):
    """Steps of both methods, of which the implicit ones do the rest."""
    counts = result["motion"]["integration"]
    expect(f"{name}: steps", counts["steps"], 0, most)
    if counts["implicit_steps"] < 5:
        faults.append(f"{name}: {counts['implicit_steps']} implicit steps")


def check_stiff_dampers(clevis, folder):
    """Hard dampers leave nothing to integrate in small steps, and what hardly
    moves on a stop does not leave it."""
    for tolerance in (1e-4, 1e-6, 1e-8, 1e-10):
        for c in (1e6, 1e8, 1e10, 1e12):
            name = f"damper of {c:g} N s/m at {tolerance:g}"
            k = 0.1 * c
            result, rows, _ = simulate(clevis, scene(
                force("spring", stiffness=f"{k!r} N/m", free="0 m",
                      damping=f"{c!r} N s/m"),
                start(0.1, -1.0), tolerance=tolerance), folder)
            expect(f"{name} [m]", at_end(rows),
                   decayed(k, c, 0.0, 0.1, -1.0, 1.0), tolerance)
            expect_quick(name, result, 100)
        for model in ({}, {"transition": "1 um"}):
            check_stop(clevis, folder, tolerance, model)


def check_stop(clevis, folder, tolerance, model):
    name = f"stop of 1e10 N s/m at {tolerance:g} {model}"
    result, rows, events = simulate(clevis, scene(
        force("stop", lower="0 m", stiffness="1e9 N/m",
              damping="1e10 N s/m", **model),
        start(0.1, -1.0), gravity=9.81, duration=2.0, instants=21,
        tolerance=tolerance), folder)
    fall = (math.sqrt(1.0 + 2.0 * 9.81 * 0.1) - 1.0) / 9.81
    if not model:
        names = [event for _, _, event in events]
        if names != ["press"]:
            faults.append(f"{name}: {len(names)} events, {names[:4]}")
        expect(f"{name}: press [s]", events[0][0], fall, 1e-8)
    expect(f"{name} [m]", at_end(rows), 0.0, max(tolerance, 1e-6))
    if not model or tolerance < 1e-7:  # else speeds of 1e-10 m/s are errors
        carried = runs.forces(Path(folder) / "out")[-1]["force_1.effort_N"]
        expect(f"{name}: effort at rest [N]", carried, 9.81, 1e-3)
    expect_quick(name, result, 400 if model else 100)


def shaken(frequency, ramp, duration):
    """Rests by friction of 10 N under 9 N sin(2 pi f t) + ramp t."""
    pull = force("servo", stiffness="100 N/m", law="sine", amplitude="0.09 m",
                 frequency=f"{frequency!r} Hz", **{"from": "0 m"})
    rubs = force("friction", breakaway="10 N", kinetic="9.9 N")
    grows = (f'[[force]]\ntype = "table"\njoint = "rail"\n'
             f'times = ["0 s", "{duration!r} s"]\n'
             f'efforts = ["0 N", "{ramp * duration!r} N"]\n')
    return scene(pull, rubs, grows, duration=duration)


def check_long_rest(clevis, folder):
    """150 000 periods at rest in steps of many, until one exceeds the breakaway:
    the first whose crest, at t, has 9 N + ramp t > 10 N."""
    frequency, periods = 2000.0, 150000
    ramp = 1.0 / ((periods - 0.25) / frequency)
    crest = (periods + 0.25) / frequency
    end = crest + 0.01 / frequency
    result, _, events = simulate(clevis, shaken(frequency, ramp, end), folder)

    def margin(t):
        return 10 - 9 * math.sin(2 * math.pi * frequency * t) - ramp * t

    low, high = crest - 0.2 / frequency, crest
    for _ in range(100):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if margin(middle) > 0 else (low, middle)
    if not events or events[0][2] != "slip":
        faults.append(f"long rest: events {events[:3]}")
    else:
        expect("long rest: slips [s]", events[0][0], low, 1e-9)
    expect("long rest: steps", result["motion"]["integration"]["steps"], 0, 60)
    # what would take minutes is refused before
    path = Path(folder) / "scene.toml"
    path.write_text(shaken(3.6e5, 0.0, 100.0))
    run = subprocess.run([clevis, "simulate", path], capture_output=True,
                         text=True, check=False)
    if run.returncode != 20 or "error[K008]" not in run.stderr:
        faults.append(f"long rest: {run.returncode} {run.stderr}")


def beyond_a_bend(v, gap, slope, end):
    """x at `end`: 1 kg from `gap` before a bend, at v, under -40 N, beyond the
    bend -40 N - slope times the way, and back."""
    a = 40.0
    at = math.sqrt(v * v - 2 * a * gap)  # speed at the bend, both ways
    w = math.sqrt(slope)
    swing = 2 * math.atan2(at / w, a / slope) / w
    left = end - (v - at) / a - swing
    return gap - at * left - 0.5 * a * left * left


def check_bend_beside_the_start(clevis, folder):
    """A bend of a table that is left and met again early in the first step."""
    slope, end = 1e6, 0.02
    for v in (0.1, 0.02, 0.005):
        for gap in (0.0, 1e-9, 1e-7):
            for tolerance in (1e-4, 1e-6, 1e-8):
                text = scene(
                    '[[force]]\ntype = "table"\njoint = "rail"\n'
                    'positions = ["1 mm", "1001 mm"]\n'
                    f'efforts = ["-40 N", "{-40 - slope!r} N"]\n',
                    start(1e-3 - gap, v), duration=end, tolerance=tolerance)
                _, rows, _ = simulate(clevis, text, folder)
                exact = 1e-3 - gap + beyond_a_bend(v, gap, slope, end)
                expect(f"bend {gap:g} m off at {v:g} m/s, {tolerance:g} [m]",
                       at_end(rows), exact, 1e-3 * tolerance)


def main():
    clevis = sys.argv[1]
    with tempfile.TemporaryDirectory() as folder:
        check_preload_alone(clevis, folder)
        check_stiff_dampers(clevis, folder)
        check_long_rest(clevis, folder)
        check_bend_beside_the_start(clevis, folder)
    for fault in faults:
        print("FAULT", fault)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())

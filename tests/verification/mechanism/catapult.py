#!/usr/bin/env python3
"""Runs `clevis simulate` on the catapults and compares with their closed forms.

    catapult.py CLEVIS GEOMETRY [--table]

One cord: v = sqrt(a L). With the element: two masses on two springs, modes by
hand. Same largest force on the vehicle, same speed, 1.5 m against 2.135 m.
"""
import csv
import math
import subprocess
import sys
import tempfile
from pathlib import Path

VEHICLE, ELEMENT = 10.0, 45.86                      # kg
SPRING, FREE = 8755.5, 0.73253                       # N/m, m
CORD, SLACK = 2339.3, 0.33178
ALONE, ALONE_SLACK = 468.384, 2.135


def closed_form():
    """Run, speed and time at which the cord slacks, largest force."""
    a, b = (SPRING + CORD) / ELEMENT, -CORD / ELEMENT
    c, d = -CORD / VEHICLE, CORD / VEHICLE
    middle, root = (a + d) / 2, math.sqrt((a - d)**2 / 4 + b * c)
    squares = (middle - root, middle + root)
    shapes = [(-b, a - square) for square in squares]
    rest = (FREE, FREE + SLACK)                     # where both are slack
    (p, q), (r, s) = shapes
    det = p * s - r * q
    sizes = ((-rest[0] * s + rest[1] * r) / det,
             (-p * rest[1] + q * rest[0]) / det)

    def at(t):
        x, v = list(rest), [0.0, 0.0]
        for square, shape, size in zip(squares, shapes, sizes):
            w = math.sqrt(square)
            for i in (0, 1):
                x[i] += shape[i] * size * math.cos(w * t)
                v[i] -= shape[i] * size * w * math.sin(w * t)
        return x, v, CORD * (SLACK - (x[1] - x[0]))

    step, t, largest = 1e-5, 1e-3, 0.0
    while at(t)[2] > 0:
        largest = max(largest, at(t)[2])
        t += step
    low, high = t - step, t
    for _ in range(60):
        t = (low + high) / 2
        low, high = (t, high) if at(t)[2] > 0 else (low, t)
    x, v, _ = at(t)
    return {"run": x[1], "speed": v[1], "time": t, "force": largest,
            "element": x[0]}


def simulate(clevis, scene):
    """The same of a scene."""
    with tempfile.TemporaryDirectory() as folder:
        run = subprocess.run([clevis, "simulate", scene, "--out", folder],
                             capture_output=True, text=True)
        if run.returncode:
            sys.exit(run.stderr)
        read = {name: list(csv.DictReader(open(Path(folder) / name)))
                for name in ("motion.csv", "forces.csv", "events.csv")}
    release = next(float(e["t_s"]) for e in read["events.csv"]
                   if e["force"] == "cord" and e["event"] == "release")
    x = [key for key in read["motion.csv"][0]
         if key.startswith("vehicle") and key.endswith("x_mm")][0]
    after = [(float(row["t_s"]), float(row[x]) / 1e3)
             for row in read["motion.csv"] if float(row["t_s"]) > release]
    (t0, x0), (t1, x1) = after[0], after[-1]        # it coasts
    speed = (x1 - x0) / (t1 - t0)
    force = max(float(row["cord.effort_N"]) for row in read["forces.csv"])
    return {"run": x0 - speed * (t0 - release), "speed": speed,
            "time": release, "force": force}


def main():
    clevis, geometry = sys.argv[1], Path(sys.argv[2])
    found = {name: simulate(clevis, geometry / f"catapult/{name}.toml")
             for name in ("scene", "reference")}
    peak = ALONE * ALONE_SLACK
    known = {"scene": closed_form(), "reference": {
        "run": ALONE_SLACK, "force": peak,
        "speed": math.sqrt(peak / VEHICLE * ALONE_SLACK),
        "time": math.pi / 2 * math.sqrt(VEHICLE / ALONE)}}
    if "--table" in sys.argv:
        print("| catapult | guide m | speed m/s | largest force N | time s |")
        print("|---|---|---|---|---|")
        for name, row in found.items():
            print(f"| {name} | {row['run']:.4f} | {row['speed']:.3f} | "
                  f"{row['force']:.1f} | {row['time']:.4f} |")
        print(f"\nguides: {found['scene']['run'] / found['reference']['run']:.4f}"
              f" of one cord's; the element has moved "
              f"{known['scene']['element']:.3f} m by then")
        return 0
    faults = []
    for name, row in found.items():
        for key, value in row.items():
            # the largest force is of the instants, 0.5 ms apart
            allowed = 1e-4 if key == "force" else 1e-7
            off = abs(value / known[name][key] - 1)
            print(f"{name} {key}: {value:.9g}, off by {off:.1e}")
            if not off < allowed:
                faults.append(f"{name} {key}")
    ratio = found["scene"]["run"] / found["reference"]["run"]
    for what, value, target, allowed in (
            ("guides", ratio, 0.70, 0.005),
            ("speeds", found["scene"]["speed"] / found["reference"]["speed"],
             1.0, 1e-3),
            ("forces", found["scene"]["force"] / peak, 1.0, 1e-3),
            ("guide [m]", found["scene"]["run"], 1.5, 1e-3)):
        print(f"{what}: {value:.5f}")
        if not abs(value - target) < allowed:
            faults.append(what)
    print("\n".join(f"FAIL {fault}" for fault in faults) or "pass")
    return len(faults) > 0


if __name__ == "__main__":
    sys.exit(main())

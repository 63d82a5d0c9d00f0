"""The landing gear on its gas cylinder at rest, by closed forms.

At rest the gas presses with (p - p_environment) A, stop and ground give way by
F/k, and virtual work balances the cylinder against the ground. The weights drop
out of that balance as the difference of the two pressures is taken.

usage: landing_gear_pneumatic.py CLEVIS
"""
import csv
import math
import subprocess
import sys
import tempfile
from pathlib import Path

SCENES = "geometry/landing_gear/pneumatic"
AREA = math.pi / 4 * 15e-3 ** 2       # m^2
STOP, GROUND = 1e7, 1e6               # N/m
TRANSITION = 1e-4                     # m, in which the ground's force sets in
FD, ED, DC = 0.21024, 0.06, 0.14      # m
EDC = math.radians(82.5611)
DD1 = 0.21


def at_rest(clevis, scene, folder):
    run = subprocess.run([clevis, "simulate", scene, "--out", folder],
                         capture_output=True, text=True)
    if run.returncode != 0:
        sys.exit(f"{scene}: exit {run.returncode}\n{run.stderr}")
    with (Path(folder) / "forces.csv").open() as file:
        last = list(csv.DictReader(file))[-1]
    return {key: float(value) for key, value in last.items()}


def wheel_rates(length):
    """dx/dl and dy/dl of T, which moves as C does about D."""
    q1 = math.acos((FD ** 2 + ED ** 2 - length ** 2) / (2 * FD * ED))
    turn = length / (FD * ED * math.sin(q1))
    theta = math.pi - EDC - (q1 - math.acos(DD1 / FD))
    return DC * math.sin(theta) * turn, -DC * math.cos(theta) * turn


def against_the_wheel(row):
    """What the ground asks of the cylinder, by virtual work."""
    dx, dy = wheel_rates(1e-3 * row["gas.position_mm"])
    # friction acts against the creep of the wheel
    creep = math.copysign(1, row["gas.rate_m_per_s"])
    return (-dy * row["ground.effort_N"] +
            creep * abs(dx) * row["ground.friction_N"])


def faults(clevis, folder):
    high = at_rest(clevis, SCENES + ".toml", folder)
    low = at_rest(clevis, SCENES + "_published.toml", folder)
    checks = []
    for row, pressure in ((high, 10.2e6), (low, 0.1e6)):
        checks.append((f"gas at {pressure:g} Pa", row["gas.effort_N"],
                       pressure * AREA, 1e-4))
        depth = 1e-3 * row["ground.position_mm"]
        t = min(1.0, depth / TRANSITION)
        checks.append(("ground", row["ground.effort_N"],
                       (3 - 2 * t) * t * t * GROUND * depth, 1e-3))
    checks.append(("stop", high["end.effort_N"],
                   -STOP * 1e-3 * (high["end.position_mm"] - 260), 1e-3))
    cylinder = [row["gas.effort_N"] + row["end.effort_N"]
                for row in (high, low)]
    wheel = [against_the_wheel(row) for row in (high, low)]
    checks.append(("virtual work", cylinder[0] - cylinder[1],
                   wheel[0] - wheel[1], 1e-3))
    if low["end.effort_N"] != 0 or not high["end.effort_N"] < -300:
        yield "the stop must hold at 10.2 MPa, and at 0.1 MPa not be reached"
    for name, value, wanted, error in checks:
        print(f"{name}: {value:.8g} N, closed form {wanted:.8g} N")
        if not abs(value / wanted - 1) <= error:
            yield f"{name}: {value} N, not {wanted} N"


def main():
    with tempfile.TemporaryDirectory() as folder:
        found = list(faults(sys.argv[1], folder))
    print("\n".join(found) or "the cylinder, the stop and the ground agree")
    return len(found) > 0


if __name__ == "__main__":
    sys.exit(main())

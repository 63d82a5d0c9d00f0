#!/usr/bin/env python3
"""Runs `clevis simulate` on the landing gear and judges what it prints.

    landing_gear.py CLEVIS FOLDER

Expected numbers: the statics and kinematics of the source mechanism, found
with other code (three printed digits of a millimetre, four of a force).
"""
import csv
import json
import math
import subprocess
import sys
import tempfile
from collections import defaultdict
from pathlib import Path

faults = []


def expect(what, found, expected, tolerance):
    if not abs(found - expected) <= tolerance:
        faults.append(f"{what}: {found} instead of {expected} +- {tolerance}")


def simulate(clevis, scene, folder):
    run = subprocess.run([clevis, "simulate", scene, "--json", "--out", folder],
                         capture_output=True, check=True)
    result = json.loads(run.stdout)
    if result != json.loads((folder / "simulate.json").read_text()):
        faults.append("stdout and simulate.json differ")
    with open(folder / "reactions.csv", newline="") as file:
        reactions = list(csv.DictReader(file))
    with open(folder / "motion.csv", newline="") as file:
        return result, reactions, list(csv.DictReader(file))


def vector(row, name, unit):
    return [float(row[f"{name}_{axis}_{unit}"]) for axis in "xyz"]


def check_structure(result):
    s = result["structure"]
    expect("mobility", s["mobility_rank"], 1, 0)
    expect("Chebyshev", s["mobility_chebyshev"], 1, 0)
    expect("spatial mobility", s["as_spatial"]["mobility_rank"], 1, 0)
    expect("redundant", s["as_spatial"]["redundant_constraints"], 6, 0)
    expect("class", s["assur_corrected"]["class"], 2, 0)
    expect("class as published", s["assur_published"]["class"], 3, 0)


def check_closed_form(result):
    lever = result["slide_lever"]
    expect("DCE turns", abs(lever["rotation_deg"]), 113.34, 0.0051)
    expect("|DC| corrected", lever["largest_DC_error_rel"], 0, 1e-9)
    expected = [(160, 43.688, 193.009, 92.1, 3.7383),
                (210, 132.678, 104.682, 151.5, 2.3562),
                (260, 104.815, -32.811, 201.1, 4.6559)]
    for row, (l_x, x, y, published, ratio) in zip(lever["instants"], expected,
                                                  strict=True):
        expect("l_x", row["cylinder_mm"], l_x, 1e-9)
        expect("C x", row["C_simulated_mm"][0], x, 1e-3)
        expect("C y", row["C_simulated_mm"][1], y, 1e-3)
        expect("|DC| simulated", row["DC_simulated_mm"], 140, 1e-9)
        expect("|DC| published", row["DC_published_mm"], published, 0.051)
        expect("v_C/v_cyl", row["speed_ratio_simulated"], ratio, 0.51e-4)


def check_statics(reactions):
    force = {(float(r["t_s"]), r["joint"]):
             math.hypot(*vector(r, "force_on_b_world", "N"))
             for r in reactions}
    for t, A, C, D, E in [(0, 3739, 2638, 2970, 609),
                          (1000, 1231, 902, 1632, 1857),
                          (2000, 1558, 2140, 5213, 5029)]:
        for joint, value in zip("ABCDEF", (A, A, C, D, E, E)):
            # masses move so slowly that they count for less than 1e-3 N
            expect(f"|{joint}| at {t} s", force[t, joint], value, 0.51)


def check_balance(reactions, motion):
    """Sum of all on each body, from the printed reactions alone: in slow
    motion without gravity nothing else acts but drive and wheel load."""
    at = {float(row["t_s"]): row for row in motion}
    sums = defaultdict(lambda: [0.0, 0.0, 0.0])  # (t, body): Fx, Fy, Mz

    def add(t, body, point, f, moment, sign):
        s = sums[t, body]
        s[0] += sign * f[0]
        s[1] += sign * f[1]
        s[2] += sign * (1e-3 * (point[0] * f[1] - point[1] * f[0]) + moment)

    for r in reactions:
        t = float(r["t_s"])
        point = vector(r, "point_world", "mm")
        f = vector(r, "force_on_b_world", "N")
        moment = float(r["moment_on_b_world_z_N_m"])
        if r["joint"] == "cylinder":  # the drive pushes E away from F
            row = at[t]
            F = vector(row, "FE1.position", "mm")
            along = [point[i] - F[i] for i in range(2)]
            effort = float(row["cylinder.drive_effort_N"])
            length = math.hypot(*along)
            f = [f[i] + effort * along[i] / length for i in range(2)]
        add(t, r["body_b"], point, f, moment, 1)
        add(t, r["body_a"], point, f, moment, -1)
    for t, row in at.items():
        add(t, "wheel", vector(row, "T.marker", "mm"), (500, 1000), 0, 1)
    for (t, body), (fx, fy, m) in sums.items():
        if body == "ground":
            continue
        # inertia at this speed is below 1e-3 N; the CSV has 12 digits
        if max(abs(fx), abs(fy), abs(m)) > 1e-3:
            faults.append(f"{body} at {t} s out of balance: {fx}, {fy}, {m}")
    expect("bodies in balance", len(sums), 7 * len(at), 0)


def check_refusals(clevis, scene, folder):
    """Lengths of the closed form that make no triangle."""
    for setting in ("EC=0.145 mm", "DC=140 m", "FD=1 mm"):
        done = subprocess.run(
            [clevis, "simulate", scene, "--out", folder, "--set",
             f"closed_form.slide_lever.{setting}"], capture_output=True, text=True)
        expect(f"exit code with {setting}", done.returncode, 10, 0)
        if "make no triangle" not in done.stderr:
            faults.append(f"{setting}: {done.stderr}")


def main():
    clevis, scenes = sys.argv[1], Path(sys.argv[2])
    with tempfile.TemporaryDirectory() as folder:
        for name in ("scene", "loaded"):
            result, _, _ = simulate(clevis, scenes / f"{name}.toml",
                                    Path(folder) / name)
            check_structure(result)
            check_closed_form(result)
            expect("power balance",
                   result["motion"]["max_power_balance_error"], 0, 1e-10)
        result, reactions, motion = simulate(clevis, scenes / "slow.toml",
                                             Path(folder) / "slow")
        check_statics(reactions)
        check_balance(reactions, motion)
        check_refusals(clevis, scenes / "scene.toml", Path(folder) / "refused")
    print("\n".join(faults) or "all as expected")
    return bool(faults)


if __name__ == "__main__":
    sys.exit(main())

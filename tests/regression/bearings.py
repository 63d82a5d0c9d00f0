#!/usr/bin/env python3
"""The source's bearing on the landing gear, by command: 1118.03 N on C = 1470 N
give 2.27e6 revolutions, the static check fails, and so does the scene.

    bearings.py CLEVIS
"""
import csv
import json
import subprocess
import sys
import tempfile
from pathlib import Path

SCENE = "geometry/landing_gear/bearings.toml"


def faults(clevis, folder):
    run = subprocess.run([clevis, "simulate", SCENE, "--json", "--out", folder],
                         capture_output=True, text=True, check=True)
    bearings = {b["name"]: b for b in json.loads(run.stdout)["bearings"]}
    pin = bearings["C"]
    for key, value, error in (("mean_load_N", 1118.034, 1e-3),
                              ("static_load_N", 1118.034, 1e-3),
                              ("life_revolutions", 2.273e6, 1e3),
                              ("swing_deg", 113.34, 5e-3),
                              ("travel_deg", 113.34, 5e-3),
                              ("static_safety", 550 / 1118.034, 1e-6)):
        if not abs(pin[key] - value) <= error:
            yield f"C: {key} = {pin[key]}, not {value}"
    codes = [warning["code"] for warning in pin["warnings"]]
    if pin["verdict"] != "fail" or codes != ["B001", "B004"]:
        yield f"C: {pin['verdict']} with {codes}"
    rows = {row["name"]: row for row in
            csv.DictReader((Path(folder) / "bearings.csv").open())}
    if float(rows["C"]["life_revolutions"]) != pin["life_revolutions"]:
        yield "bearings.csv and simulate.json differ"

    check = subprocess.run([clevis, "check", SCENE, "--json", "--out", folder],
                           capture_output=True, text=True)
    result = json.loads(check.stdout)
    if check.returncode != 1 or result["verdict"] != "fail":
        yield f"check: exit {check.returncode}, {result.get('verdict')}"
    checked = {b["name"]: b for b in result["bearings"]}["C"]
    if abs(checked["life_revolutions"] / pin["life_revolutions"] - 1) > 1e-6:
        yield "check and simulate differ"
    yield from comparison_faults(clevis, folder, result)
    if 'name="static safety"' not in (Path(folder) / "junit.xml").read_text():
        yield "junit.xml has no case of the bearings"


def comparison_faults(clevis, folder, result):
    """`clevis compare` with a baseline that holds another static load."""
    for factor, expected in ((1.0, 0), (1.0001, 3)):
        baseline = Path(folder) / "baseline.json"
        next(b for b in result["bearings"]
             if b["name"] == "C")["static_load_N"] *= factor
        baseline.write_text(json.dumps(result))
        run = subprocess.run([clevis, "compare", folder, baseline],
                             capture_output=True, text=True)
        if run.returncode != expected or (
                expected and "static_load" not in run.stdout):
            yield f"compare: exit {run.returncode}: {run.stdout} {run.stderr}"


def main():
    with tempfile.TemporaryDirectory() as folder:
        found = list(faults(sys.argv[1], folder))
    print("\n".join(found) or "the source's bearing fails as it must")
    return len(found) > 0


if __name__ == "__main__":
    sys.exit(main())

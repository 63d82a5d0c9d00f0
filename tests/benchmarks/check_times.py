#!/usr/bin/env python3
"""What `clevis check` takes as a user starts it, and whether another build says the same.

    check_times.py CLEVIS [OTHER] [--runs N] [--scene NAME]...

Runs each scene N times (3), with OTHER in turn where it is given: a machine that is busy or warm
is so for both. Prints the least processor time of user and system and the least wall time,
against the goal. Of two builds it compares verdict, peak, band and deflection of every part.
"""
import argparse
import json
import os
import resource
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]

# name: arguments, goal of the wall time [s]
SCENES = {
    "reference link, 1 %": (["geometry/reference_link/scene.toml"], 0.20),
    "reference link, 0.1 %": (["geometry/reference_link/scene.toml", "--tolerance", "0.1%"], 0.45),
    "loaded.toml": (["geometry/landing_gear/loaded.toml"], 1.5),
    "scene.toml": (["geometry/landing_gear/scene.toml"], 1.5),
    "pneumatic.toml": (["geometry/landing_gear/pneumatic.toml"], 8.0),
}


def run(clevis, arguments, folder):
    """One check: user, system and wall seconds, and its result."""
    before, start = resource.getrusage(resource.RUSAGE_CHILDREN), time.monotonic()
    done = subprocess.run([clevis, "check", *arguments, "--out", folder], cwd=ROOT,
                          stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
    wall, after = time.monotonic() - start, resource.getrusage(resource.RUSAGE_CHILDREN)
    if done.returncode > 1:  # 1: a part fails
        sys.exit(f"{clevis}: {done.stderr}")
    result = json.loads((Path(folder) / "result.json").read_text())
    return (after.ru_utime - before.ru_utime, after.ru_stime - before.ru_stime, wall), result


def figures(result):
    """Of each part what a user reads first."""
    for part in result["parts"]:
        peak = part["peak_von_mises"]
        yield part["name"], part["verdict"], {
            "peak": peak["value_MPa"], "band low": peak["band_MPa"][0], "band high": peak["band_MPa"][1],
            "deflection": part["deflection_mm"]}


def difference(one, other):
    """The largest relative one of two results, or what they do not agree on at all."""
    largest = 0.0
    for (name, verdict, a), (_, verdict_b, b) in zip(figures(one), figures(other), strict=True):
        if verdict != verdict_b:
            return f"{name}: {verdict} and {verdict_b}"
        for key in a:
            largest = max(largest, abs(a[key] - b[key]) / max(abs(a[key]), 1e-300))
    return f"figures within {largest:.0e}"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("clevis")
    parser.add_argument("other", nargs="?")
    parser.add_argument("--runs", type=int, default=3)
    parser.add_argument("--scene", action="append", choices=list(SCENES))
    options = parser.parse_args()
    builds = [os.path.abspath(build) for build in (options.clevis, options.other) if build]
    which = dict(zip(builds, ("  first", "  second") if len(builds) == 2 else ("",)))
    for name in options.scene or SCENES:
        arguments, goal = SCENES[name]
        times, results = {build: [] for build in builds}, {}
        for _ in range(options.runs):
            for build in builds:
                with tempfile.TemporaryDirectory() as folder:
                    seconds, results[build] = run(build, arguments, folder)
                times[build].append(seconds)
        for build in builds:
            user, system, wall = (min(column) for column in zip(*times[build]))
            print(f"{name:22} user {user:6.2f} s  system {system:5.2f} s  wall {wall:6.2f} s"
                  f"  goal {goal:.2f} s{which[build]}")
        if len(builds) == 2:
            print(f"{name:22} {difference(results[builds[0]], results[builds[1]])}")


if __name__ == "__main__":
    main()

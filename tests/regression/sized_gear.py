#!/usr/bin/env python3
"""The landing gear with the sizes that the study of 200 variants found: all parts
hold, vibration and buckling included, with the mass that the study tells.

    sized_gear.py CLEVIS ROOT
"""
import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

from support import Checks, check

SCENE = "geometry/landing_gear/sized.toml"
BLOW = ["--set", "simulation.duration=0.09 s", "--set", "simulation.instants=46"]


def main():
    clevis, root = str(Path(sys.argv[1]).resolve()), Path(sys.argv[2])
    os.chdir(root)
    checks = Checks()
    subprocess.run([clevis, "mesh", SCENE], check=True, stdout=subprocess.DEVNULL)
    with tempfile.TemporaryDirectory() as folder:
        answer = check(clevis, SCENE, "--tolerance", "10%", *BLOW, out=Path(folder) / "out")
    checks.expect(answer.code == 0, f"exit {answer.code}")
    checks.expect(len(answer.parts) == 5, f"{len(answer.parts)} parts")
    for part in answer.parts:
        checks.expect(part["verdict"] == "pass", f"{part['name']}: {part['verdict']}")
        checks.expect(part.get("vibration") is not None, f"{part['name']} vibrates")
    mass = sum(part["mass_kg"] for part in answer.parts)
    told = float(re.search(r"lightest that passes: \w+, ([\d.]+) kg",
                           Path("results/studies/sizing.txt").read_text())[1])
    checks.expect(abs(mass / told - 1.0) < 0.02,
                  f"{mass:.3f} kg; the lightest variant has {told} kg")
    return checks.exit_code()


if __name__ == "__main__":
    sys.exit(main())

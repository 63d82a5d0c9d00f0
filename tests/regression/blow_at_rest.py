#!/usr/bin/env python3
"""`clevis export` and `study` of a blow: the static load that stresses as much.

    blow_at_rest.py CLEVIS

A rod without Poisson's ratio, struck along by four times its mass through a
spring of 1e9 N/m. d'Alembert's peak times the section is the force that the
deck must push with, and the peak that every model of the study must show; with
that force F the rod takes F² l/(2 E A) up, and CalculiX (where it is
installed) has its displacements.
"""
import json
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

import blow_bands

RATIO, CONTACT = 4, 1e9
NEAR = 0.01


def call(*arguments):
    run = subprocess.run([str(a) for a in arguments], capture_output=True,
                         text=True)
    if run.returncode != 0:
        sys.exit(f"exit {run.returncode} of {arguments}\n{run.stderr}")
    return json.loads(run.stdout)


def pushed_with(deck):
    """Sum of the forces along x [N]."""
    total, reading = 0.0, False
    for line in deck.read_text().splitlines():
        if line.startswith("*"):
            reading = line.startswith("*CLOAD")
        elif reading:
            _, component, force = line.split(",")
            total += float(force) if component.strip() == "1" else 0.0
    return total


def main():
    clevis = sys.argv[1]
    peak = blow_bands.peak(RATIO, CONTACT)  # MPa
    force = peak * 1e6 * blow_bands.AREA
    way = force * blow_bands.LENGTH / (blow_bands.MODULUS * blow_bands.AREA)
    known = []
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        scene = blow_bands.write_rod(folder, 6, [(RATIO, CONTACT)])
        deck = call(clevis, "export", scene, "--json", "--out",
                    folder / "deck")["decks"][0]
        known.append(("force of the deck [N]", -pushed_with(Path(deck["file"])),
                      force))
        study = call(clevis, "study", scene, "--json", "--out",
                     folder / "study", "--split", "2")
    runs = [run for run in study["parts"][0]["runs"] if "left_out" not in run]
    for run in runs:
        if "peak_MPa" in run:
            known.append((f"peak of {run['series']}, {run['setting']} [MPa]",
                          run["peak_MPa"], peak))
        if run.get("energy_mJ"):
            known.append((f"energy of {run['series']}, {run['setting']} [mJ]",
                          run["energy_mJ"], force * way / 2.0))
    series = {run["series"] for run in runs}
    faults = 0
    if "3-D" not in series or len(known) < 10:
        print("FAILED the study has no models")
        faults = 1
    if shutil.which("ccx"):
        apart = [run["displacement_difference"] for run in runs
                 if "displacement_difference" in run]
        print(f"CalculiX: displacements {apart}")
        # one column of C3D20R has motions without energy: cut cells count
        faults += not apart or not apart[-1] < NEAR
    for what, value, exact in known:
        off = value / exact - 1
        faults += not abs(off) < NEAR
        print(f"{'ok' if abs(off) < NEAR else 'FAILED':7}{what}: {value:.5g}, "
              f"{off:+.2%} of {exact:.5g}")
    return faults > 0


if __name__ == "__main__":
    sys.exit(main())

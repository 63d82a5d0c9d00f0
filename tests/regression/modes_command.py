#!/usr/bin/env python3
"""`clevis modes` against CalculiX on the same cells, cut finer.

    modes_command.py CLEVIS ROOT

Free vibrations of the landing gear's link AB; files; one JSON document. Skipped (77) without ccx.
"""
import json
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

SCENE = "geometry/landing_gear/scene.toml"
PART = "AB"
MODES = 9  # three elastic
# What CalculiX's quadratic hexahedra leave when each cell is cut in eight;
# on the cells as they are 0.5 % and more.
CALCULIX = 0.002


def run(*command, cwd):
    return subprocess.run(command, cwd=cwd, check=True, capture_output=True,
                          text=True).stdout


def calculix_frequencies(clevis, root, folder):
    run(clevis, "export", SCENE, "--part", PART, "--out", folder, "--split",
        "2", "--elements", "C3D20", cwd=root)
    deck = (Path(folder) / f"{PART}.inp").read_text()
    model = deck[:deck.index("*BOUNDARY")]
    (Path(folder) / "modes.inp").write_text(
        model + f"*STEP\n*FREQUENCY\n{MODES}\n*END STEP\n")
    run("ccx", "modes", cwd=folder)
    rows = re.findall(r"^ +\d+ +\S+ +\S+ +(\S+) +\S+ *$",
                      (Path(folder) / "modes.dat").read_text(), re.M)
    return [float(row) for row in rows[:MODES]]


def faults(clevis, root, folder):
    document = json.loads(run(clevis, "modes", SCENE, "--part", PART,
                              "--modes", str(MODES), "--out", folder, "--json",
                              cwd=root))
    if document != json.loads((Path(folder) / "modes.json").read_text()):
        yield "modes.json is not what --json prints"
    [part] = document["parts"]
    if part["supports"] != "free" or not part["converged"]:
        yield f"not a converged free part: {part['supports']}"
    modes = part["modes"]
    kinds = [mode["kind"] for mode in modes]
    if kinds != 6 * ["rigid"] + 3 * ["elastic"]:
        yield f"kinds {kinds}"
    for axis in "xyz":
        share = sum(mode["participation_" + axis] for mode in modes[:6])
        if abs(share - 1) > 1e-9:
            yield f"rigid motions carry {share} of the mass along {axis}"
    for mode in modes[6:]:
        if not (Path(folder) / mode["file"]).is_file():
            yield f"{mode['file']} is missing"
    expected = calculix_frequencies(clevis, root, folder)
    for mode, frequency in zip(modes[6:], expected[6:]):
        ratio = mode["frequency_hz"] / frequency
        print(f"{mode['frequency_hz']:.2f} Hz, CalculiX {frequency:.2f} Hz")
        if abs(ratio - 1) > CALCULIX:
            yield f"mode {mode['mode']}: {ratio} of CalculiX's frequency"


def main():
    clevis, root = sys.argv[1:3]
    if shutil.which("ccx") is None:
        return 77
    with tempfile.TemporaryDirectory() as folder:
        found = list(faults(str(Path(clevis).resolve()), root, folder))
    for fault in found:
        print(fault, file=sys.stderr)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())

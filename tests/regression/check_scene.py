#!/usr/bin/env python3
"""Checks a scene into a fresh folder: the exit code must be the verdict's.

    check_scene.py CLEVIS SCENE FOLDER
"""
import json
import shutil
import subprocess
import sys
from pathlib import Path

EXIT_OF_VERDICT = {"pass": 0, "fail": 1, "not judged": 4}


def main():
    clevis, scene, folder = sys.argv[1], sys.argv[2], Path(sys.argv[3])
    shutil.rmtree(folder, ignore_errors=True)
    run = subprocess.run([clevis, "check", scene, "--out", folder, "--json",
                          "--linear-vtu"],
                         stdout=subprocess.PIPE, text=True)
    document = json.loads(run.stdout)
    if "error" in document:
        return 1  # stderr says why
    stored = json.loads((folder / "result.json").read_text())
    print(f"{document['scene']}: {document['verdict']}, exit {run.returncode}, "
          f"{document['seconds']['total']:.1f} s")
    for part in document["parts"]:
        peak = part["peak_von_mises"]
        print(f"  {part['name']}: {peak['value_MPa']:.3f} MPa "
              f"{peak['band_MPa']} {peak['verdict']}, {part['model']}, "
              f"{part['seconds']['total']:.1f} s")
    faults = []
    if stored != document:
        faults.append("result.json is not what --json printed")
    if run.returncode != EXIT_OF_VERDICT[document["verdict"]]:
        faults.append(f"exit {run.returncode} for {document['verdict']}")
    if not document["parts"]:
        faults.append("no part was checked")
    print("\n".join(faults))
    return len(faults)


if __name__ == "__main__":
    sys.exit(main())

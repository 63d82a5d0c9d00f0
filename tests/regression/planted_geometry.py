#!/usr/bin/env python3
"""Lengthens link AB of the landing gear by 0.1 mm: clevis must notice.

    planted_geometry.py CLEVIS ROOT BASELINE

In the part alone: bore and joint do not coincide (L003, exit 12). In part and
scene alike: `clevis compare` returns 3, and names the part and the joints.
"""
import json
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

SCENE = "geometry/landing_gear/scene.toml"
GEO = "geometry/landing_gear/link_ab.geo"


def replace_once(file, old, new):
    text = file.read_text()
    if text.count(old) != 1:
        raise SystemExit(f"{file}: {old!r} stands there {text.count(old)} times")
    file.write_text(text.replace(old, new))


def run(clevis, *arguments, **options):
    return subprocess.run([clevis, *arguments], text=True,
                          capture_output=True, **options)


def part_alone(clevis, folder):
    replace_once(folder / GEO, "length_ab = 140,", "length_ab = 140.1,")
    mesh = run(clevis, "mesh", SCENE, "--part", "AB", cwd=folder)
    if mesh.returncode:
        return [f"clevis mesh: exit {mesh.returncode}: {mesh.stderr}"]
    check = run(clevis, "check", SCENE, "--json", cwd=folder)
    code = json.loads(check.stdout).get("error", {}).get("code")
    if check.returncode == 12 and code == "L003":
        return []
    return [f"part alone: exit {check.returncode}, {code}; not 12, L003"]


def part_and_scene(clevis, folder, baseline):
    replace_once(folder / SCENE, 'AB = ["140 mm", "0 mm"',
                 'AB = ["140.1 mm", "0 mm"')
    check = run(clevis, "check", SCENE, "--out", "out", cwd=folder)
    if check.returncode not in (0, 1, 4):
        return [f"part and scene: exit {check.returncode}: {check.stderr}"]
    compared = run(clevis, "compare", folder / "out", baseline, "--json")
    moved = {(row["of"], row["quantity"])
             for row in json.loads(compared.stdout)["moved"]
             if row["regression"]}
    faults = []
    if compared.returncode != 3:
        faults.append(f"part and scene: compare returned {compared.returncode}")
    for name, quantity in (("AB", "mass"), ("B", "peak_force")):
        if not any(of.split()[-1] == name and what == quantity
                   for of, what in moved):
            faults.append(f"{quantity} of {name} is not among {sorted(moved)}")
    return faults


def main():
    clevis, root = Path(sys.argv[1]).resolve(), Path(sys.argv[2])
    with tempfile.TemporaryDirectory() as temporary:
        folder = Path(temporary)
        for tree in ("geometry", "meshes"):
            shutil.copytree(root / tree / "landing_gear",
                            folder / tree / "landing_gear")
        faults = part_alone(clevis, folder)
        faults += part_and_scene(clevis, folder, Path(sys.argv[3]).resolve())
    print("\n".join(faults) or "0.1 mm noticed, in the part and in both")
    return len(faults)


if __name__ == "__main__":
    sys.exit(main())

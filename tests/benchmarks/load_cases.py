#!/usr/bin/env python3
"""200 load cases on one mesh: clevis's one factorisation against CalculiX,
which factors at every step.

    load_cases.py CLEVIS [CASES] [SPLIT]

The reference link, held at one eye, is pulled at the other in 200 directions: its
cosine pressures turn, so that the loads span many columns. Both programs solve all cases
on the same hexahedra (SPLIT 2: also cut in eight) with quadratic elements (clevis p = 2 with 27 nodes,
CalculiX C3D20R) in one `clevis study`, on one thread, and find every stress.
"""
import json
import math
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]

def scene(cases):
    text = (ROOT / "geometry/reference_link/scene.toml").read_text()
    head = text[:text.index("[[part.case]]")].replace(
        'geometry = "link.geo"',
        f'mesh = "{ROOT / "meshes/reference_link/link.msh"}"')
    for k in range(cases):
        angle = 2.0 * math.pi * k / cases
        x, y = 1000.0 * math.cos(angle), 1000.0 * math.sin(angle)
        head += f"""
[[part.case]]
name = "case {k}"
pins = {{ bore_B = ["{x:.9f} N", "{y:.9f} N", "0 N"] }}
fixed = {{ bore_A = ["x", "y", "z"] }}
"""
    return head


def main():
    clevis = str(Path(sys.argv[1]).resolve())
    cases = int(sys.argv[2]) if len(sys.argv) > 2 else 200
    split = sys.argv[3] if len(sys.argv) > 3 else "1"
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "scene.toml"
        file.write_text(scene(cases))
        run = subprocess.run([clevis, "study", file, "--json", "--out", folder,
                              "--every-instant", "--split", split],
                             stdout=subprocess.PIPE, text=True, check=True)
    part = json.loads(run.stdout)["parts"][0]
    runs = {(r["series"], r["setting"]): r for r in part["runs"]}
    pairs = [("3-D", "h"), ("3-D, cells halved", "h/2")][:int(split)]
    for ours, theirs in pairs:
        a = runs.get((ours, "p = 2"))
        b = runs.get(("CalculiX C3D20R", theirs))
        if not a or not b or "left_out" in a or "left_out" in b:
            print(f"{theirs}: left out")
            continue
        seconds, other = a["seconds"]["cpu"], b["seconds"]["cpu"]
        print(f"{cases} cases, {theirs}: clevis {a['dofs']} DoF {seconds:.2f} s, "
              f"CalculiX {b['dofs']} DoF {other:.2f} s: {other / seconds:.0f} "
              f"times; displacements within "
              f"{100 * b['displacement_difference']:.2g} %")


if __name__ == "__main__":
    sys.exit(main())

#!/usr/bin/env python3
"""Meshes of solids from STEP that gmsh and its sizes make hard.

    step_meshes.py CLEVIS

- A thin tube with two cross bores has cells a few walls long, not islands of small ones.
- A bore along the long axis of an ellipse ends on a steep round: its faces are its wall.
- Cells with two faces on a cylinder are taken out, and no second attempt is needed.
- A probe stands anywhere on a cylinder's wall, and just inside of it.
"""
import json
import math
import subprocess
import sys
import tempfile
from pathlib import Path

import support

CLEVIS = Path(sys.argv[1]).resolve()

TUBE = """SetFactory("OpenCASCADE");
Cylinder(1) = {0, 0, 0, 0, 0, 300, 15};
Cylinder(2) = {0, 0, 0, 0, 0, 300, 13};
BooleanDifference(3) = { Volume{1}; Delete; }{ Volume{2}; Delete; };
Cylinder(4) = {-50, 0, 16, 100, 0, 0, 4};
Cylinder(5) = {-50, 0, 284, 100, 0, 0, 4};
BooleanDifference(6) = { Volume{3}; Delete; }{ Volume{4, 5}; Delete; };
"""

ELLIPSE = """SetFactory("OpenCASCADE");
Ellipse(1) = {0, 0, 0, 20, 12};
Curve Loop(1) = {1};
Plane Surface(1) = {1};
Extrude {0, 0, 60} { Surface{1}; }
Cylinder(2) = {-50, 0, 15, 100, 0, 0, 5};
BooleanDifference(3) = { Volume{1}; Delete; }{ Volume{2}; Delete; };
"""

ROD = """SetFactory("OpenCASCADE");
Cylinder(1) = {0, 0, 0, 0, 0, 100, 10};
"""

ROD_SCENE = f"""schema = 1
name = "rod"
{support.STEEL}
[[part]]
name = "rod"
geometry = "rod.step"
material = "steel"

[part.faces]
low = {{ plane = {{ normal = [0, 0, -1] }} }}
high = {{ plane = {{ normal = [0, 0, 1] }} }}

[[part.case]]
name = "pull"
traction = {{ low = ["0 MPa", "0 MPa", "-50 MPa"], high = ["0 MPa", "0 MPa", "50 MPa"] }}
probes = [
{{probes}}
]
"""


def write_step(folder, name, text):
    (folder / f"{name}.geo").write_text(text)
    subprocess.run(["gmsh", f"{name}.geo", "-0", "-o", f"{name}.step"], cwd=folder,
                   check=True, capture_output=True)


def cells_of(folder, name, text):
    """Of the scene that `init` writes."""
    write_step(folder, name, text)
    subprocess.run([CLEVIS, "init", name, "--geometry", f"{name}.step"], cwd=folder,
                   check=True, capture_output=True)
    done = subprocess.run([CLEVIS, "mesh", f"{name}/scene.toml"], cwd=folder,
                          capture_output=True, text=True, timeout=100)
    if done.returncode:
        return None, done.stderr
    line = next(line for line in done.stdout.splitlines() if " cells, " in line)
    return int(line.split(": ")[1].split()[0]), line


def attempts(folder, size):
    """gmsh's meshings of the rod at a size, by the mesher as clevis asks it."""
    (folder / "request.json").write_text(json.dumps(
        {"file": str(folder / "rod.step"), "format": 1, "length_unit": 0.0, "points": [],
         "facets": False, "mesh": str(folder / "sized.msh"), "mesh_size": size,
         "groups": {"low": [2]}, "finer": 1.0, "finer_at": []}))
    done = subprocess.run([CLEVIS.parent / "clevis-mesher", "request.json", "answer.json"],
                          cwd=folder, check=True, capture_output=True, text=True)
    return done.stdout.count("Done meshing 3D")


def main():
    checks = support.Checks()
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        cells, said = cells_of(folder, "tube", TUBE)
        checks.expect(cells is not None and 3000 < cells < 20000, f"tube: {said}")
        cells, said = cells_of(folder, "ellipse", ELLIPSE)
        checks.expect(cells is not None, f"ellipse: {said}")

        write_step(folder, "rod", ROD)
        counts = {size: attempts(folder, 1e-3 * size) for size in range(7, 15)}
        checks.expect(set(counts.values()) == {1}, f"attempts by size in mm: {counts}")

        radii = (10.0, 9.8)
        angles = (0.0, 37.0, 90.0, 180.0, 237.0)
        probes = [(r * math.cos(math.radians(a)), r * math.sin(math.radians(a)), z)
                  for r in radii for a in angles for z in (50.0, 37.0)]
        (folder / "rod.toml").write_text(ROD_SCENE.replace("{probes}", ",\n".join(
            f'{{ name = "p{k}", at = ["{x:.9f} mm", "{y:.9f} mm", "{z} mm"], quantity = "stress_zz" }}'
            for k, (x, y, z) in enumerate(probes))))
        answer = support.check(CLEVIS, folder / "rod.toml", "--tolerance", "5%", exits=support.JUDGED)
        values = [probe["value_MPa"] for probe in answer.part["probes"]]
        checks.expect(len(values) == len(probes) and
                      all(abs(value - 50.0) < 0.5 for value in values),
                      f"rod: {answer}, probes {values}")
    return checks.exit_code()


if __name__ == "__main__":
    sys.exit(main())

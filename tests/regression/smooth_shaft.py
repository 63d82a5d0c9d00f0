#!/usr/bin/env python3
"""A smooth elliptical shaft from STEP under torque: no cell of its mesh kinks the
surface, so nothing is told as a notch.

    smooth_shaft.py CLEVIS
"""
import subprocess
import sys
import tempfile
from pathlib import Path

import scene_text
import support

SHAFT = """SetFactory("OpenCASCADE");
Disk(1) = {0, 0, 0, 15, 8};
Extrude {0, 0, 120} { Surface{1}; }
"""


SCENE = scene_text.head("elliptical shaft") + scene_text.part_body("shaft") + \
    scene_text.joint("A", "weld", "ground", "shaft") + """[[force]]
name = "turn"
type = "constant"
body = "shaft"
point = ["0 mm", "0 mm", "120 mm"]
force = ["0 N", "0 N", "0 N"]
moment = ["0 N m", "0 N m", "200 N m"]
[simulation]
duration = "1 s"
instants = 2
[[part]]
name = "shaft"
geometry = "shaft.step"
material = "steel"
pins = { A = "a" }
forces = { turn = { face = "e" } }
limits = { safety_factor = 1 }
[part.faces]
a = { plane = { normal = [0, 0, -1] } }
e = { plane = { normal = [0, 0, 1] } }
"""


def main():
    clevis = Path(sys.argv[1]).resolve()
    # Of the cells that it takes by itself one has two faces on the curve.
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        (folder / "shaft.geo").write_text(SHAFT)
        subprocess.run(["gmsh", "-0", "-v", "1", "shaft.geo", "-o", "shaft.step"],
                       cwd=folder, check=True, capture_output=True)
        (folder / "scene.toml").write_text(SCENE)
        answer = support.check(clevis, folder / "scene.toml", exits=support.JUDGED)
    zones = answer.part["singular_zones"]
    print(f"{answer}, {len(zones)} zones")
    if answer.part["verdict"] != "pass" or zones:
        sys.exit(f"{answer} {zones}")


if __name__ == "__main__":
    main()

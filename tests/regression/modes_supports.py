#!/usr/bin/env python3
"""`clevis modes` on the supports of a blow and of a plane case, one failure, and
--max-dofs.

    modes_supports.py CLEVIS ROOT

Cook's clamped membrane vibrates in its plane; the ejector's clamped rod at
3.5160/(2 pi) sqrt(E I/(m l^3)), less what shear takes at six diameters; a part
that its case leaves free is told, and the others are computed.
"""
import json
import math
import re
import subprocess
import sys
import tempfile
from pathlib import Path

import support

SHEAR = 0.015   # of the rod's frequency, Timoshenko against Euler
SCENE = """schema = 1
name = "three"
{material}[[part]]
name = "loose"
mesh = "{rod}"
length_unit = "mm"
material = "steel"
[[part.case]]
name = "slides"
traction = {{ tip = ["1 MPa", "0 MPa", "0 MPa"] }}
fixed = {{ root = ["x"] }}
[[part]]
name = "rod"
mesh = "{rod}"
length_unit = "mm"
material = "steel"
[[part]]
name = "plate"
mesh = "{plate}"
length_unit = "mm"
material = "steel"
[[part.case]]
name = "shear"
traction = {{ tip = ["0 MPa", "1 MPa", "0 MPa"] }}
fixed = {{ root = ["x", "y"] }}
[[impact]]
name = "blow"
part = "rod"
face = "tip"
direction = [0, -1, 0]
mass = "0.2 kg"
speed = "1 m/s"
stiffness = "1e7 N/m"
fixed = {{ root = ["x", "y", "z"] }}
"""


def limited(clevis, scene, folder, most):
    """The plate's modes by solutions of no more degrees of freedom."""
    run = subprocess.run(
        [clevis, "modes", str(scene), "--part", "plate", "--modes", "4", "--out",
         f"{folder}/limited", "--max-dofs", str(most), "--json"],
        capture_output=True, text=True)
    return json.loads(run.stdout)


def main():
    clevis, root = sys.argv[1:3]
    with tempfile.TemporaryDirectory() as folder:
        scene = Path(folder) / "scene.toml"
        scene.write_text(SCENE.format(
            material=support.STEEL,
            rod=f"{root}/meshes/ejector/workpiece.msh",
            plate=f"{root}/meshes/cook/membrane.msh"))
        run = subprocess.run(
            [clevis, "modes", str(scene), "--modes", "4", "--out",
             folder + "/out", "--json"], capture_output=True, text=True)
        if not run.stdout.startswith("{") or "parts" not in run.stdout:
            sys.exit(run.stdout + run.stderr)
        [refused] = limited(clevis, scene, folder, 100)["failures"]
        fewest = re.match(r".*?(\d+) degrees of freedom, --max-dofs allows 100",
                          refused["problem"])
        [coarse] = limited(clevis, scene, folder, fewest[1] if fewest else 1000)["parts"]
        files = [path.name for path in Path(folder, "out").iterdir()]
    document = json.loads(run.stdout)
    rod, plate = document["parts"]
    [failure] = document["failures"]
    diameter, length = 0.010, 0.060
    euler = (3.5160 / (2 * math.pi) * diameter / 4 *
             math.sqrt(210e9 / 7850) / length**2)
    first = rod["modes"][0]["frequency_hz"]
    faults = [text for text, wrong in (
        (f"exit {run.returncode}, 12 expected", run.returncode != 12),
        (f"failure {failure}", failure["code"] != "F001" or
         "loose" not in failure["what"]),
        (f"rod on {rod['supports']}", rod["supports"] != "blow"),
        (f"rod's first {first} Hz, Euler's {euler}",
         not 1 - SHEAR < first / euler < 1),
        (f"plate by {plate['model']}", plate["model"] != "plane stress" or
         not plate["converged"]),
        (f"refused {refused}", refused["code"] != "F007" or not fewest),
        (f"first degree alone: {coarse['degree']}",
         coarse["degree"] != 2 or coarse["converged"]),
        ("plate moves across", any(mode["participation_z"] != 0
                                   for mode in plate["modes"])),
        (f"files {files}", "plate_mode_1.vtu" not in files)) if wrong]
    if faults:
        sys.exit("\n".join(faults) + "\n" + run.stderr)


if __name__ == "__main__":
    main()

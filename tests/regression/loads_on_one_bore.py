#!/usr/bin/env python3
"""A spring and a force on the pin's bore of an arm that a contact throws back: many
loads on one bore, combined into few columns, stay in balance, and no self-check refuses a
sound scene.

    loads_on_one_bore.py CLEVIS
"""
import sys
import tempfile
from pathlib import Path

import scene_text
import support

GEOMETRY = """SetFactory("OpenCASCADE");
Rectangle(1) = {-12, -10, 0, 144, 20};
Disk(2) = {0, 0, 0, 4}; Disk(3) = {60, 0, 0, 4}; Disk(4) = {120, 0, 0, 4};
BooleanDifference(5) = { Surface{1}; Delete; }{ Surface{2, 3, 4}; Delete; };
a() = Curve In BoundingBox {-5, -5, -1, 5, 5, 1};
b() = Curve In BoundingBox {55, -5, -1, 65, 5, 1};
c() = Curve In BoundingBox {115, -5, -1, 125, 5, 1};
Physical Curve("bore_A") = {a()};
Physical Curve("bore_M") = {b()};
Physical Curve("bore_B") = {c()};
Physical Surface("body") = {5};
MeshSize{:} = 5;
Transfinite Curve{a()} = 17; Transfinite Curve{b()} = 17;
Transfinite Curve{c()} = 17;
Mesh.RecombineAll = 1; Mesh.ElementOrder = 2;
"""


SCENE = scene_text.head("loads on one bore") + f"""[[body]]
name = "arm"
part = "arm"
placement = {{ origin = ["0 mm", "0 mm", "0 mm"], angle = "10 deg" }}
[[joint]]
name = "A"
type = "revolute"
between = ["ground", "arm"]
at = {{ ground = ["0 mm", "0 mm", "0 mm"], arm = ["0 mm", "0 mm", "0 mm"] }}
axis = [0, 0, 1]
normal = {{ ground = [1, 0, 0], arm = [1, 0, 0] }}
[[initial]]
joint = "A"
position = "10 deg"
rate = "-20 rad/s"
[[force]]
name = "floor"
type = "contact"
body = "arm"
center = ["120 mm", "0 mm", "0 mm"]
radius = "5 mm"
plane_point = ["0 mm", "-5 mm", "0 mm"]
normal = [0, 1, 0]
stiffness = "3e6 N/m"
model = "hunt-crossley"
damping = "0.45 s/m"
[[force]]
name = "back"
type = "spring"
joint = "A"
stiffness = "0 N m/rad"
preload = "1 N m"
[[force]]
name = "pull"
type = "table"
between = ["ground", "arm"]
from = ["-200 mm", "0 mm", "0 mm"]
to = ["0 mm", "0 mm", "0 mm"]
axis = [1, 0, 0]
times = ["0 s", "0.02 s", "0.02 s"]
efforts = ["3000 N", "3000 N", "0 N"]
[[part]]
name = "arm"
geometry = "arm.geo"
length_unit = "mm"
thickness = "10 mm"
material = "steel"
pins = {{ A = "bore_A" }}
limits = {{ safety_factor = 1.1 }}
[part.forces]
floor = {{ face = "bore_B" }}
back = {{ face = "bore_A" }}
pull = {{ face = "bore_A" }}
[simulation]
duration = "0.11 s"
instants = 21
"""


def main():
    faults = []
    for model in ("plane-stress", "layered"):
        with tempfile.TemporaryDirectory() as folder:
            scene = Path(folder) / "scene.toml"
            scene.write_text(SCENE)
            (Path(folder) / "arm.geo").write_text(GEOMETRY)
            answer = support.check(sys.argv[1], scene, "--mesh", "--model",
                                   model, "--tolerance", "5%")
        print(f"{model}: {answer}")
        if answer.code != 0:
            faults.append(model)
            print(f"FAILED {answer.text}")
    return len(faults) > 0


if __name__ == "__main__":
    sys.exit(main())

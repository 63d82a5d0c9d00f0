#!/usr/bin/env python3
"""Linear buckling of whole runs.

    buckling.py CLEVIS ROOT

- Two links, clamped at one bore and pressed at the other, against CalculiX's
  *BUCKLE on the exported deck, its cells cut finer (skipped without ccx).
- A clamped column under three times its Euler load must fail, by its buckling;
  under a third of it, it passes.
- A strip that linear theory bends by half of its length does not pass.
- The shape and the numbers stand in the files.
"""
import math
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

import hex_mesh
import support

CALCULIX = 0.005

MATERIAL = f"""schema = 1
name = "buckling"
{support.STEEL}"""

LINK = MATERIAL + """
[[part]]
name = "link"
mesh = "{mesh}"
length_unit = "mm"
material = "steel"

[[part.case]]
name = "press"
fixed = {{ {held} = ["x", "y", "z"] }}
pins = {{ {pressed} = ["{x} N", "{y} N", "0 N"] }}
"""

BAR = MATERIAL + """
[[part]]
name = "bar"
mesh = "bar.msh"
length_unit = "mm"
material = "steel"
limits = {{ singular_zones = "exclude", safety_factor = 1.5 }}

[[part.case]]
name = "{case}"
fixed = {{ root = ["x", "y", "z"] }}
traction = {{ tip = ["{x} MPa", "{y} MPa", "0 MPa"] }}
"""


def bar_mesh(path, length, width, height, cells):
    """A box of hexahedra along x, root at x = 0, tip at x = length."""
    ends = dict.fromkeys(hex_mesh.SIDES) | {"x0": "root", "x1": "tip"}
    hex_mesh.write(path, hex_mesh.block(
        (cells, 1, 1), lambda x, y, z: (length * x, width * y, height * z),
        ends))


def check(clevis, folder, text, name):
    """Each with files of its own."""
    (folder / name).mkdir()
    scene = folder / name / "scene.toml"
    scene.write_text(text.replace('"bar.msh"', '"../bar.msh"'))
    return support.check(clevis, scene, exits=support.JUDGED)


def calculix_factor(clevis, scene, folder):
    subprocess.run([clevis, "export", scene, "--out", folder, "--split", "2",
                    "--elements", "C3D20"], check=True, capture_output=True)
    deck = (folder / "link.inp").read_text()
    step = deck.index("*STATIC")
    (folder / "buckle.inp").write_text(
        deck[:step] + "*BUCKLE\n1\n" + deck[step + len("*STATIC\n"):])
    subprocess.run(["ccx", "buckle"], cwd=folder, check=True,
                   capture_output=True)
    rows = re.findall(r"^ +1 +(\S+) *$", (folder / "buckle.dat").read_text(),
                      re.M)
    return float(rows[0])


def link_faults(clevis, root, folder):
    links = [("ab", "meshes/landing_gear/link_ab.msh", "bore_A", "bore_B"),
             ("reference", "meshes/reference_link/link.msh", "bore_B",
              "bore_A")]
    for name, mesh, held, pressed in links:
        direction = PRESS[name]
        text = LINK.format(mesh=root / mesh, held=held, pressed=pressed,
                           x=direction[0], y=direction[1])
        found = check(clevis, folder, text, name)
        part = found.part
        factor = part["buckling"]["factor"]
        low, high = part["buckling"]["band"]
        if not (found.out / "link_buckling.vtu").is_file():
            yield f"{name}: link_buckling.vtu is missing"
        if "buckling" not in found.text:
            yield f"{name}: the table does not tell its buckling"
        if shutil.which("ccx") is None:
            continue
        reference = calculix_factor(clevis, folder / name / "scene.toml",
                                    folder / f"{name}_ccx")
        print(f"{name}: {factor:.4f} [{low:.4f}, {high:.4f}], CalculiX "
              f"{reference:.4f}")
        if abs(factor / reference - 1) > CALCULIX:
            yield f"{name}: {factor / reference} of CalculiX's factor"


def column_faults(clevis, folder):
    length, side = 1000.0, 10.0
    bar_mesh(folder / "bar.msh", length, side, side, 20)
    euler = math.pi ** 2 * 210e3 * side ** 4 / 12 / (2 * length) ** 2
    for share, verdict in ((3.0, "fail"), (1 / 3, "pass")):
        text = BAR.format(case="press", x=-share * euler / side ** 2, y=0)
        part = check(clevis, folder, text, f"column_{share:.1f}").part
        factor = part["buckling"]["factor"]
        print(f"column, {share:.3f} times Euler's load: {part['verdict']}, "
              f"factor {factor:.4f}; {part['why']}")
        if part["verdict"] != verdict:
            yield f"column at {share}: {part['verdict']}: {part['why']}"
        if abs(factor * share - 1) > 0.01:
            yield f"column at {share}: factor {factor}"


def bed_faults(clevis, folder):
    """A column whose foot rests on an elastic bed: u tan u = k I l / (E I), by
    beam theory."""
    length, width, height, bed, press = 200.0, 20.0, 10.0, 1000.0, 200.0
    bar_mesh(folder / "bar.msh", length, width, height, 20)
    low, high = 0.0, math.pi / 2
    for _ in range(100):
        u = 0.5 * (low + high)
        low, high = (u, high) if u * math.tan(u) < bed * length / 210e3 else (low, u)
    truth = (u / length) ** 2 * 210e3 * height ** 2 / 12 / press
    text = BAR.format(case="press", x=-press, y=0).replace(
        'fixed = { root = ["x", "y", "z"] }', f'foundation = {{ root = "{bed} N/mm^3" }}')
    part = check(clevis, folder, text, "bed").part
    factor = part["buckling"]["factor"]
    print(f"column on a bed: {part['verdict']}, {factor:.4f}, by beam theory {truth:.4f}")
    if part["verdict"] != "fail" or abs(factor / truth - 1) > 0.01:
        yield f"column on a bed: {part['verdict']}, {factor} for {truth}"


def strip_faults(clevis, folder):
    bar_mesh(folder / "bar.msh", 1000.0, 10.0, 1.0, 40)
    text = BAR.replace('"0 MPa"]', '"{z} MPa"]').format(
        case="bend", x=0, y=0, z=0.03)
    part = check(clevis, folder, text, "strip").part
    print(f"strip: {part['deflection_mm']:.0f} mm, {part['why']}")
    if part["deflection_mm"] < 500:
        yield f"strip: deflection {part['deflection_mm']}"
    if part["verdict"] != "not judged" or "small displ" not in part["why"]:
        yield f"strip: {part['verdict']}: {part['why']}"


# Newtons that press the bore towards the held one.
PRESS = {"ab": (-2e3, 0.0), "reference": (20e3, 0.0)}


def main():
    clevis, root = sys.argv[1:3]
    clevis, root = str(Path(clevis).resolve()), Path(root).resolve()
    found = []
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for fault in (*column_faults(clevis, folder),
                      *bed_faults(clevis, folder),
                      *strip_faults(clevis, folder),
                      *link_faults(clevis, root, folder)):
            found.append(fault)
    for fault in found:
        print(fault, file=sys.stderr)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())

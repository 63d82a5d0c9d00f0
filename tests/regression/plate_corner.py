#!/usr/bin/env python3
"""A block as thick as it is wide, held at one side and pulled at the other: its
deflection by plane stress is that of its 3-D model, however fine the cells are at the
corners of the held side, where the stress, and so the thinning, has no bound.

    plate_corner.py CLEVIS
"""
import sys
import tempfile
from pathlib import Path

import hex_mesh
import scene_text
import support

SIDE, PULL = 20.0, 100.0  # mm, MPa
CELLS = 8


def graded(share, power):
    """From 0 to 1, finer at both ends."""
    return (0.5 * (2 * share)**power if share < 0.5 else
            1 - 0.5 * (2 * (1 - share))**power)


def place(x, y, power):
    return SIDE * x**power, SIDE * (graded(y, power) - 0.5)


def write_flat(path, power):
    """Quadrilaterals; groups x0 and x1."""
    row = CELLS + 1
    nodes = [place(i / CELLS, j / CELLS, power) for j in range(row) for i in range(row)]
    elements = [f"1 2 {group} {group} {j * row + i + 1} {(j + 1) * row + i + 1}"
                for group, i in ((2, 0), (3, CELLS)) for j in range(CELLS)]
    elements += [f"3 2 1 1 {at} {at + 1} {at + row + 1} {at + row}"
                 for at in (j * row + i + 1 for j in range(CELLS) for i in range(CELLS))]
    path.write_text(
        '$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n3\n1 2 "x0"\n1 3 "x1"\n'
        f'2 1 "body"\n$EndPhysicalNames\n$Nodes\n{len(nodes)}\n' +
        "".join(f"{k} {x:.17g} {y:.17g} 0\n" for k, (x, y) in enumerate(nodes, 1)) +
        f"$EndNodes\n$Elements\n{len(elements)}\n" +
        "".join(f"{k} {element}\n" for k, element in enumerate(elements, 1)) +
        "$EndElements\n")


def check(clevis, folder, keys, fixed, *arguments):
    (folder / "scene.toml").write_text(
        scene_text.head("block", world="") + scene_text.BAR + f"""{keys}\
limits = {{ deflection = "0.02 mm", singular_zones = "exclude" }}
[[part.case]]
name = "pull"
fixed = {{ {fixed} }}
traction = {{ x1 = ["{PULL} MPa", "0 MPa", "0 MPa"] }}
""")
    part = support.check(clevis, folder / "scene.toml", *arguments,
                         exits=support.JUDGED).part
    return part["deflection_mm"], part["deflection_band_mm"], part["model"]


def main():
    clevis = Path(sys.argv[1]).resolve()
    checks = support.Checks()
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        # half of it, from its middle plane
        hex_mesh.write(folder / "bar.msh", hex_mesh.block(
            (CELLS, CELLS, 4), lambda x, y, z: (*place(x, y, 2), SIDE / 2 * z)))
        truth, band, model = check(clevis, folder, "", 'x0 = ["x", "y"], z0 = ["z"]',
                                   "--model", "3d")
        along = PULL * SIDE / 210e3
        checks.expect(along < truth < 1.05 * along and band[1] - band[0] < 0.001 * truth,
                      f"{model}: {truth:.6f} mm, free to thin at its root {along:.6f}")
        for power in (1, 2, 4):
            write_flat(folder / "bar.msh", power)
            value, band, model = check(clevis, folder, f'thickness = "{SIDE} mm"\n',
                                       'x0 = ["x", "y"]')
            checks.expect(abs(value / truth - 1) < 0.005,
                          f"cells by power {power}, {model}: {value:.6f} mm")
            checks.holds(band, truth, "its band")
    return checks.exit_code()


if __name__ == "__main__":
    sys.exit(main())

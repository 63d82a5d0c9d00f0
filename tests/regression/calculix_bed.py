#!/usr/bin/env python3
"""Parts on elastic beds as `clevis export` writes them, solved by CalculiX, against
clevis.

    calculix_bed.py CLEVIS

A block whose leaning side lies on a bed, and one on two beds. Of hexahedra the
displacements, to 0.3 % of the largest: C3D20R has other functions. Of tetrahedra,
whose C3D10 are clevis' own of degree 2, its strain energy of that degree, the bed's
with it, to 1e-5: springs that only had the bed's sums would be off by more.
"""
import math
import subprocess
import sys
import tempfile
from pathlib import Path

import hex_mesh
import support

SCENE = f"""schema = 1
name = "on a bed"
{support.STEEL}
[[part]]
name = "block"
mesh = "part.msh"
length_unit = "mm"
material = "steel"

[[part.case]]
name = "push"
traction = {{{{ x1 = ["-20 MPa", "8 MPa", "5 MPa"] }}}}
foundation = {{{{ {{beds}} }}}}
probes = [
{{probes}}
]
"""
# As soft as the block itself, so that both bend.
LEANING = 'x0 = { normal = "3000 N/mm^3", tangential = "700 N/mm^3" }'
TWO = 'x0 = "900 N/mm^3", z0 = { normal = "2000 N/mm^3", tangential = "20 N/mm^3" }'
# Corners and middles of edges, which both have as nodes.
PLACES = [(x, y, z) for x in (0, 0.5, 1) for y in (0, 1) for z in (0, 1)]
TOLERANCE = 3e-3


def leaning(x, y, z):
    """x0 leans by 35 degrees."""
    return 40 * x - 14 * z * (1 - x), 25 * y, 20 * z


def moved_nodes(deck):
    """Places and displacements of the nodes of a .frd [mm]."""
    nodes, moved, inside = {}, {}, ""
    for line in deck.with_suffix(".frd").read_text(encoding="ascii").splitlines():
        if line.startswith("    2C"):
            inside = "nodes"
        elif line.startswith(" -4"):
            inside = "moved" if "DISP" in line else ""
        elif line.startswith(" -3"):
            inside = ""
        elif inside and line.startswith(" -1"):
            into = nodes if inside == "nodes" else moved
            into[int(line[3:13])] = [float(line[13 + 12 * k:25 + 12 * k])
                                     for k in range(3)]
    return nodes, moved


def displacements(deck, places):
    nodes, moved = moved_nodes(deck)
    found = []
    for place in places:
        node = min(nodes, key=lambda n: math.dist(nodes[n], place))
        assert math.dist(nodes[node], place) < 1e-3, place
        found.append(moved[node])
    return found


def energy(deck):
    """Half of what the forces of the deck do [mJ]."""
    _, moved = moved_nodes(deck)
    text = deck.with_suffix(".inp").read_text()
    lines = text[text.index("*CLOAD"):text.index("*NODE FILE")].splitlines()[1:]
    work = 0.0
    for line in lines:
        node, component, force = line.split(",")
        work += float(force) * moved[int(node)][int(component) - 1]
    return 0.5 * work


def compare(clevis, folder, checks, name, mesh, beds):
    places = [leaning(*place) for place in PLACES]
    probes = "\n".join(
        f'  {{ name = "p{i}_{axis}", at = ["{p[0]} mm", "{p[1]} mm", "{p[2]} mm"], '
        f'quantity = "displacement_{axis}" }},'
        for i, p in enumerate(places) for axis in "xyz")
    hex_mesh.write(folder / "part.msh", mesh)
    scene = folder / "scene.toml"
    scene.write_text(SCENE.format(beds=beds, probes=probes))
    part = support.check(clevis, scene, exits=support.JUDGED).part
    of_clevis = {probe["name"]: probe["value_mm"] for probe in part["probes"]}
    deck = folder / "deck"
    subprocess.run([clevis, "export", scene, "--out", deck], check=True,
                   capture_output=True)
    subprocess.run(["ccx", "block"], cwd=deck, check=True, capture_output=True)
    if len(mesh[1][0]) == 4:
        own = part["peak_von_mises"]["sequence"][1]
        assert own["degree"] == 2, own
        checks.near(f"{name}: energy", energy(deck / "block"),
                    own["strain_energy_mJ"], 1e-5)
        return
    largest, worst = 0.0, 0.0
    for i, moved in enumerate(displacements(deck / "block", places)):
        for axis, value in zip("xyz", moved):
            largest = max(largest, abs(value))
            worst = max(worst, abs(value - of_clevis[f"p{i}_{axis}"]))
    checks.expect(worst < TOLERANCE * largest,
                  f"{name}: {worst / largest:.2e} of {largest:.4g} mm")


def main(clevis):
    clevis = str(Path(clevis).resolve())
    checks = support.Checks()
    block = hex_mesh.block((8, 5, 4), leaning)
    with tempfile.TemporaryDirectory() as temporary:
        folder = Path(temporary)
        compare(clevis, folder, checks, "hexahedra", block, LEANING)
        compare(clevis, folder, checks, "hexahedra, two beds", block, TWO)
        compare(clevis, folder, checks, "tetrahedra",
                hex_mesh.tetrahedra(block), LEANING)
    return checks.exit_code()


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))

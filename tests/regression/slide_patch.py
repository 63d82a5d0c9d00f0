#!/usr/bin/env python3
"""A block that slides on a beam presses where it is.

    slide_patch.py CLEVIS

A cantilever, strong at its root and slender from x = 40 mm on, carries a block
20 mm long at x = 70 to 80 mm of its 100 mm of flat wall. Right of x = 40 mm
statics alone say what bends it: the beam's stress 6 F (x_block - x)/(b h²).
The same beam under a pressure on cells that end with the block, on another
mesh, with another kind of load, is the second witness; smeared over the wall
the block would seem to stress it less than half as much.
"""
import json
import subprocess
import sys
import tempfile
from pathlib import Path

import hex_mesh

LENGTH, ROOT, SLENDER, DEPTH = 100.0, 20.0, 5.0, 8.0  # mm
THIN_FROM = 40.0
FORCE, BLOCK, AT = 200.0, 20.0, 80.0  # N, mm
NEAR = 0.01  # of the peak: where the slender piece begins the stress is not
#              quite the beam's
SAME = 0.003  # of two ways to load the same beam
MATERIAL = """[material.steel]
youngs_modulus = "210 GPa"
poissons_ratio = 0.3
density = "7850 kg/m^3"
yield_strength = "1000 MPa"
"""


def height(x):
    """Of the beam: a cosine from the root's to the slender one's."""
    if x >= THIN_FROM:
        return SLENDER
    s = x / THIN_FROM
    return ROOT + (SLENDER - ROOT) * s * s * (3.0 - 2.0 * s)


def place(x, y, z):
    return x, (y - 1.0) * height(x), (z - 0.5) * DEPTH


def write_beam(path, stations, patch=None):
    """Cells end at the stations [mm]; those of the wall between the patch's
    ends are a group of their own."""
    def mapping(x, y, z):
        return place(stations[round(x * (len(stations) - 1))], y, z)
    nodes, cells, groups = hex_mesh.block(
        (len(stations) - 1, 2, 1), mapping, {"y1": "wall"})
    if patch:
        quads = groups.pop("wall")
        def inside(quad):
            return all(patch[0] - 1e-9 <= nodes[v][0] <= patch[1] + 1e-9
                       for v in quad)
        groups["patch"] = [q for q in quads if inside(q)]
    hex_mesh.write(path, (nodes, cells, groups))


def slide_scene(folder, pin, force_at="0 mm"):
    # Stations that no edge of the block meets.
    write_beam(folder / "beam.msh",
               [LENGTH * i / 41 for i in range(42)])
    scene = folder / "scene.toml"
    scene.write_text(f"""schema = 1
name = "block on a beam"
[world]
gravity = ["0 m/s^2", "0 m/s^2", "0 m/s^2"]
{MATERIAL}[[body]]
name = "beam"
part = "beam"
[[body]]
name = "block"
mass = "0.1 kg"
center_of_mass = ["0 mm", "0 mm", "0 mm"]
inertia = ["10 kg mm^2", "10 kg mm^2", "10 kg mm^2"]
placement = {{ origin = ["70 mm", "0 mm", "0 mm"] }}
[[joint]]
name = "root"
type = "weld"
between = ["ground", "beam"]
at = {{ ground = ["0 mm", "0 mm", "0 mm"], beam = ["0 mm", "0 mm", "0 mm"] }}
[[joint]]
name = "slide"
type = "prismatic"
between = ["beam", "block"]
at = {{ beam = ["0 mm", "0 mm", "0 mm"], block = ["0 mm", "0 mm", "0 mm"] }}
axis = [1, 0, 0]
[[drive]]
joint = "slide"
law = "ramp"
from = "70 mm"
to = "{AT} mm"
duration = "1 s"
[[force]]
name = "press"
type = "constant"
body = "block"
point = ["{force_at}", "0 mm", "0 mm"]
force = ["0 N", "-{FORCE} N", "0 N"]
[simulation]
duration = "1 s"
instants = 11
[[part]]
name = "beam"
mesh = "beam.msh"
length_unit = "mm"
material = "steel"
pins = {{ root = "x0", slide = {pin} }}
drives = {{ slide = {{ face = "x1" }} }}
[accuracy]
peak_stress = "0.5 %"
""")
    return scene


def pressure_scene(folder):
    write_beam(folder / "pressed.msh",
               [2.0 * i for i in range(35)] + [70.0 + 2.5 * i for i in range(13)],
               (AT - BLOCK / 2, AT + BLOCK / 2))
    scene = folder / "pressed.toml"
    pressure = FORCE / (BLOCK * DEPTH)
    scene.write_text(f"""schema = 1
name = "beam under a pressure"
{MATERIAL}[[part]]
name = "beam"
mesh = "pressed.msh"
length_unit = "mm"
material = "steel"
limits = {{ singular_zones = "exclude" }}
[[part.case]]
name = "pressed"
fixed = {{ x0 = ["x", "y", "z"] }}
pressure = {{ patch = "{pressure} MPa" }}
[accuracy]
peak_stress = "0.5 %"
""")
    return scene


def check(clevis, scene, out):
    run = subprocess.run([clevis, "check", str(scene), "--json", "--out",
                          str(out)], capture_output=True, text=True)
    document = json.loads(run.stdout) if run.stdout else {}
    return run.returncode, document, run.stderr


def peak_of(document):
    part = document["parts"][0]
    outside = part.get("peak_outside") or {}
    peak = outside if outside.get("sequence") else part["peak"]
    return {k: peak[k] for k in ("value", "band_low", "band_high")}, part


def main():
    clevis = sys.argv[1]
    faults = []

    def expect(truth, what):
        print(("ok: " if truth else "FAULT: ") + what)
        if not truth:
            faults.append(what)

    beam = 6.0 * FORCE * (AT - THIN_FROM) / (DEPTH * SLENDER**2)
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        pin = f'{{ group = "wall", length = "{BLOCK} mm" }}'
        code, document, text = check(clevis, slide_scene(folder, pin),
                                     folder / "slide")
        expect("parts" in document, f"block: exit {code} {text[-400:]}")
        slide, part = peak_of(document)
        print("block", slide, part["peak"]["label"], part["model"])
        expect(part["peak"]["label"] == "t = 1 s",
               "worst where the block is furthest out")
        code, document, text = check(clevis, pressure_scene(folder),
                                     folder / "pressed")
        pressed, _ = peak_of(document)
        print("pressed", pressed, "beam", beam)
        scale = slide["value"] / pressed["value"]
        expect(abs(scale - 1.0) < SAME, f"block over pressure {scale:.5f}")
        unit = 1e6 if slide["value"] > 1e6 else 1.0
        expect(abs(slide["value"] / unit / beam - 1.0) < 0.05,
               f"{slide['value'] / unit:.4g} MPa, the beam's {beam:.4g}")
        # 5 mm off its middle: beyond its middle third (l/6) it lifts off, and
        # the force acts where the block's load does.
        code, document, text = check(
            clevis, slide_scene(folder, pin, "5 mm"), folder / "tilted")
        tilted, _ = peak_of(document)
        lever = (AT + 5.0 - THIN_FROM) / (AT - THIN_FROM)
        expect(abs(tilted["value"] / slide["value"] / lever - 1.0) < 0.015,
               f"tilted {tilted['value'] / slide['value']:.4f}, arm {lever:.4f}")
        # Without a length, and where a block would have to be pulled.
        code, _, text = check(clevis, slide_scene(folder, '"wall"'),
                              folder / "unknown")
        expect(code == 12 and "L007" in text, f"unknown: exit {code}")
        code, _, text = check(clevis, slide_scene(folder, pin, "11 mm"),
                              folder / "off")
        expect(code == 12 and "L007" in text and "tilts" in text,
               f"tilts off: exit {code}\n{text[-300:]}")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())

#!/usr/bin/env python3
"""A block that slides on a beam presses where it is.

    slide_patch.py CLEVIS

A cantilever with 100 mm of flat wall carries a block 20 mm long, from 70 to
80 mm; no edge of a cell is an edge of the block. The strain energy is the
beam's, of bending and shear, under the pressure of a rigid block: even where
the force stands in its middle, lifting off over a part of its length where it
stands 5 mm beside it. Spread over the wall the load would leave less than a
third of it; a millimetre aside is 4 %. The same of a piston in a round tube, as
a solid of revolution, whose force beside its middle presses at two ends.
"""
import math
import sys
import tempfile
from pathlib import Path

import hex_mesh
import support

LENGTH, HEIGHT, DEPTH = 100.0, 5.0, 8.0  # mm
FORCE, BLOCK, AT = 200.0, 20.0, 80.0  # N, mm
MODULUS, POISSON = 210e3, 0.3  # MPa
BEAM = 0.005  # what beam theory leaves out of the energy
UNIFORM = 0.001  # of the same model, where only the load differs
INNER, OUTER = 8.0, 12.0  # mm, of the tube
WALL = 0.015  # what the tube's wall gives way under the piston


RECTANGLE = (DEPTH * HEIGHT**3 / 12.0, DEPTH * HEIGHT * 5.0 / 6.0)


def ring():
    """Second moment and area in shear of the tube (Cowper 1966)."""
    m2 = (INNER / OUTER)**2
    share = (6.0 * (1.0 + POISSON) * (1.0 + m2)**2
             / ((7.0 + 6.0 * POISSON) * (1.0 + m2)**2
                + (20.0 + 12.0 * POISSON) * m2))
    return (math.pi / 4.0 * (OUTER**4 - INNER**4),
            share * math.pi * (OUTER**2 - INNER**2))


def energy(load, section=RECTANGLE, steps=20000):
    """Of bending and shear [mJ] under load(x) [N/mm], by midpoints from the
    free end."""
    inertia, area = section
    shear = MODULUS / (2.0 * (1.0 + POISSON))
    step = LENGTH / steps
    total = force = moment = 0.0
    for k in range(steps):
        added = load(LENGTH - (k + 0.5) * step) * step
        moment += (force + 0.5 * added) * step
        force += added
        total += step * (moment**2 / (2.0 * MODULUS * inertia)
                         + 0.5 * force**2 / (shear * area))
    return total


def even(middle, length):
    return lambda x: FORCE / length * (abs(x - middle) < 0.5 * length)


def lifted(middle, aside):
    """Rigid block on a wall that cannot pull, its force beyond the middle
    third: a triangle over 3 (l/2 - e)."""
    length = 3.0 * (0.5 * BLOCK - aside)
    end = middle + 0.5 * BLOCK
    return lambda x: (2.0 * FORCE / length**2 * (x - end + length)
                      if end - length < x < end else 0.0)


def tilted(middle, aside):
    """A piston that its bore holds on all sides: linear, of both signs."""
    return lambda x: (FORCE / BLOCK
                      * (1.0 + 12.0 * aside * (x - middle) / BLOCK**2)
                      * (abs(x - middle) < 0.5 * BLOCK))


def write_tube(path):
    def place(x, y, z):
        radius = INNER + (OUTER - INNER) * z
        angle = -2.0 * math.pi * y
        return LENGTH * x, radius * math.cos(angle), radius * math.sin(angle)
    hex_mesh.write(path, hex_mesh.block(
        (23, 16, 2), place, {"z0": "bore_in", "z1": "round_out"}, closed=True))


def write_scene(folder, pin, force_at="0 mm"):
    write_tube(folder / "tube.msh")
    hex_mesh.write(folder / "beam.msh", hex_mesh.block(
        (41, 2, 2), lambda x, y, z: (LENGTH * x, HEIGHT * (y - 1.0),
                                     DEPTH * (z - 0.5)), {"y1": "wall"}))
    scene = folder / "scene.toml"
    scene.write_text(f"""schema = 1
name = "block on a beam"
[world]
gravity = ["0 m/s^2", "0 m/s^2", "0 m/s^2"]
[material.steel]
youngs_modulus = "{MODULUS} MPa"
poissons_ratio = {POISSON}
density = "7850 kg/m^3"
yield_strength = "1000 MPa"
[[body]]
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
instants = 6
[[part]]
name = "beam"
mesh = "beam.msh"
length_unit = "mm"
material = "steel"
pins = {{ root = "x0", slide = {pin} }}
drives = {{ slide = {{ face = "x1" }} }}
[accuracy]
peak_stress = "2 %"
""")
    return scene


class Checks(support.Checks):
    def __init__(self, clevis, folder):
        super().__init__()
        self.clevis, self.folder = clevis, folder

    def run(self, *arguments, tube=False):
        scene = write_scene(self.folder, *arguments)
        if tube:
            scene.write_text(scene.read_text().replace("beam.msh", "tube.msh"))
        return support.check(self.clevis, scene, "--model",
                             "revolution" if tube else "auto")

    def energy(self, *arguments, tube=False):
        """Largest over the motion [mJ]; when, and the worst stress."""
        found = self.run(*arguments, tube=tube)
        if not found.parts:
            print(found.text[-400:])
            return float("nan"), None
        return (found.part["strain_energy_mJ"],
                found.part["peak_von_mises"]["case"])

    def refused(self, word, *arguments):
        found = self.run(*arguments)
        self.expect(found.code != 0 and "L007" in found.codes
                    and word in found.text, f'refused for "{word}": {found}')


def main():
    pin = f'{{ group = "wall", length = "{BLOCK} mm" }}'
    with tempfile.TemporaryDirectory() as name:
        checks = Checks(sys.argv[1], Path(name))
        centred, when = checks.energy(pin)
        wanted = energy(even(AT, BLOCK))
        checks.expect(abs(centred / wanted - 1.0) < BEAM,
                      f"energy {centred:.5g} mJ, the beam's {wanted:.5g}")
        checks.expect(when == "t = 1 s", f"worst furthest out: {when}")
        aside, _ = checks.energy(pin, "5 mm")
        ratio = energy(lifted(AT, 5.0)) / wanted
        checks.expect(abs(aside / centred / ratio - 1.0) < UNIFORM,
                      f"lifting off {aside / centred:.5f}, wanted {ratio:.5f}")
        shifted, _ = checks.energy(
            f'{{ group = "wall", length = "{BLOCK} mm", offset = "-6 mm" }}',
            "-6 mm")
        ratio = energy(even(AT - 6.0, BLOCK)) / wanted
        checks.expect(abs(shifted / centred / ratio - 1.0) < UNIFORM,
                      f"offset {shifted / centred:.5f}, wanted {ratio:.5f}")
        bore = f'{{ group = "bore_in", length = "{BLOCK} mm" }}'
        tube, _ = checks.energy(bore, "4 mm", tube=True)
        wanted = energy(tilted(AT, 4.0), ring())
        checks.expect(abs(tube / wanted - 1.0) < WALL,
                      f"tube {tube:.5g} mJ, the beam's {wanted:.5g}")
        checks.refused("it is not known how much", '"wall"')
        checks.refused("tilts", pin, "11 mm")
    return checks.exit_code()


if __name__ == "__main__":
    sys.exit(main())

"""Rows of parts: clevis, CalculiX and dolfinx on the same geometry and loads."""
import json
import math
import re
import shutil
import sys
from pathlib import Path

import measure

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[2]
sys.path.insert(0, str(ROOT / "tests/regression"))

from support import frd_rows, von_mises  # noqa: E402

YOUNG, POISSON = 210e3, 0.3  # MPa
DEBIAN_PYTHON = "/usr/bin/python3"  # whose packages dolfinx is one of
LIMIT = 600  # processor seconds of a process
TOLERANCES = ["10 %", "3 %", "1 %", "0.3 %", "0.1 %"]

STEEL = """
[material.steel]
youngs_modulus = "210 GPa"
poissons_ratio = 0.3
density = "7850 kg/m^3"
yield_strength = "355 MPa"
"""
# E is pulled along x, C turns against it, D holds: balanced about D.
AT_E = (1000.0, 0.0)
E = ((140.0**2 + 60.0**2 - 145.0**2) / 280.0, 0.0)
E = (E[0], math.sqrt(60.0**2 - E[0]**2))
AT_C = (0.0, AT_E[0] * E[1] / 140.0)
AT_D = (-AT_E[0] - AT_C[0], -AT_E[1] - AT_C[1])


class Part:
    """A part, its loads, and its known peak of von Mises stress [MPa]; None: that of
    reference_row()."""

    def __init__(self, name, title, geo, case, peak, doubt, source, spec, hexahedra,
                 sizes):
        self.name, self.title, self.geo, self.case = name, title, geo, case
        self.peak, self.doubt, self.source = peak, doubt, source
        self.spec, self.hexahedra = spec, hexahedra
        self.sizes = sizes  # of cells: clevis begins on the first

    def tolerances(self):
        """Of clevis; those of tetrahedra below 0.3 % take minutes."""
        return TOLERANCES if self.hexahedra else TOLERANCES[:-1]

    def scene(self, size=None):
        parameters = "" if size is None else f'parameters = {{ h = "{size} mm" }}\n'
        return (f'schema = 1\nname = "{self.title}"\n{STEEL}\n[[part]]\nname = "part"\n'
                f'geometry = "part.geo"\nlength_unit = "mm"\nmaterial = "steel"\n'
                f'{parameters}\n[[part.case]]\nname = "load"\n{self.case}\n')


def pins(forces):
    return "pins = { " + ", ".join(
        f'{name} = ["{x!r} N", "{y!r} N", "0 N"]' for name, (x, y) in forces.items()) + " }"


def pin_spec(forces, centres, radius, thickness):
    return [{"group": name, "force": forces[name], "centre": centres[name],
             "radius": radius, "thickness": thickness} for name in forces]


LINK = {"bore_A": (-1000.0, 0.0), "bore_B": (1000.0, 0.0)}
PLATE = {"bore_D": AT_D, "bore_C": AT_C, "bore_E": AT_E}
OVERKILL = ("the finest of `clevis study`, 3-D on halved cells at p = 4; that it is clevis' own is "
            "what the rows of dolfinx are to be read for")
PARTS = [
    Part("reference_link", "Reference link, 8 mm thick, hexahedra",
         ROOT / "geometry/reference_link/link.geo", pins(LINK), None, None, OVERKILL,
         {"pins": pin_spec(LINK, {"bore_A": (0, 0), "bore_B": (140, 0)}, 7.5, 8.0),
          "held": [[152.5, 0, 4], [-12.5, 0, 4], [152.5, 0, -4]]}, True, [1, 0.5]),
    Part("plate", "Triangular plate DCE of the landing gear, 8 mm thick, hexahedra",
         ROOT / "geometry/landing_gear/link_dce.geo", pins(PLATE), None, None, OVERKILL,
         {"pins": pin_spec(PLATE, {"bore_D": (0, 0), "bore_C": (140, 0), "bore_E": E}, 7.5, 8.0),
          "held": [[152, 0, 4], [-12, 0, 4], [152, 0, -4]]}, True, [1, 0.5]),
    Part("sphere", "Eighth of a hollow sphere under inner pressure, tetrahedra of order 2",
         HERE / "sphere.geo",
         'pressure = { inner = "50 MPa" }\n'
         'fixed = { cut_x = ["x"], cut_y = ["y"], cut_z = ["z"] }',
         1.5 * 50.0 * 8.0 / 7.0, 0.0, "closed form, 3 p b³ / (2 (b³ − a³))",
         {"pressure": {"inner": 50.0}, "fixed": {"cut_x": 0, "cut_y": 1, "cut_z": 2}},
         False, [3, 2, 1.4, 1]),
    Part("tube", "Quarter of a thick tube under inner pressure, tetrahedra of order 2",
         HERE / "tube.geo",
         'pressure = { bore_wall = "50 MPa" }\n'
         'fixed = { cut_x = ["x"], cut_y = ["y"], cut_z = ["z"] }',
         50.0 * math.sqrt((5.0 / 3.0)**2 + 1.0 + 5.0 / 3.0), 0.0, "closed form, Lamé's",
         {"pressure": {"bore_wall": 50.0}, "fixed": {"cut_x": 0, "cut_y": 1, "cut_z": 2}},
         False, [3, 2, 1.4, 1]),
]


def row(part, program, method, setting, run, work, peak, band="", remark=""):
    return {"kind": "part", "problem": part.name, "program": program, "method": method,
            "setting": setting, "user_s": f"{run.user:.4f}", "wall_s": f"{run.wall:.4f}",
            "work_s": work, "error": peak, "band": band, "remark": remark}


def prepare(part, folder, size=None):
    shutil.copy(part.geo, folder / "part.geo")
    scene = folder / "scene.toml"
    scene.write_text(part.scene(size))
    return scene


def runs_of(command, rounds, **more):
    """Equal runs; long ones once."""
    runs = [measure.run(command, LIMIT, **more)]
    while len(runs) < rounds and runs[0].user < 5.0:
        runs.append(measure.run(command, LIMIT, **more))
    return runs


def reference_row(clevis, part, folder):
    """Peak and doubt [MPa] by `clevis study`."""
    scene = prepare(part, folder)
    measure.must([clevis, "mesh", scene])
    one = measure.run([clevis, "study", scene, "--out", folder / "study"], LIMIT)
    found = re.search(r"reference ([\d.]+) \+- ([\d.e-]+) MPa", one.text)
    if found is None:
        raise RuntimeError(f"clevis study of {part.name}: {one.errors or one.text[-300:]}")
    return {**row(part, "clevis study", "reference", "", one, "", found[1], found[2]),
            "kind": "reference"}


def by_clevis(clevis, part, folder, tolerances, rounds):
    """`clevis check`, the mesh there: all of a process, with its band. The peak stands
    where the error will."""
    scene = prepare(part, folder)
    measure.must([clevis, "mesh", scene])
    for tolerance in tolerances:
        command = [clevis, "check", scene, "--out", folder / "out", "--jobs", "1",
                   "--tolerance", tolerance.replace(" ", "")]
        one = measure.least(runs_of(command, rounds))
        if one.status not in (0, 1, 4):
            yield row(part, "clevis check", "auto", tolerance, one, "", "", "",
                      one.errors.split("\n")[0] or "over the limit")
            continue
        found = json.loads((folder / "out/result.json").read_text())["parts"][0]
        peak = found["peak_von_mises"]
        low, high = peak["band_MPa"]
        yield row(part, "clevis check", "auto", tolerance, one, "", f"{peak['value_MPa']:.6g}",
                  f"{low:.6g} to {high:.6g}", peak["verdict"])


def by_calculix(clevis, part, folder, rounds):
    """ccx on decks that clevis exports; meshing and export are not counted."""
    fine = [(1, n) for n in (1, 2, 3)] if part.hexahedra else [(h, 1) for h in part.sizes]
    for size, split in fine:
        deck = folder / f"deck_{size}_{split}"
        scene = prepare(part, folder, None if part.hexahedra else size)
        measure.must([clevis, "mesh", scene])
        measure.must([clevis, "export", scene, "--out", deck, "--split", split])
        one = measure.least(runs_of(["ccx", "part"], rounds, cwd=deck))
        setting = ("h" if split == 1 else f"h/{split}") if part.hexahedra else f"{size} mm"
        element = "C3D20R" if part.hexahedra else "C3D10"
        if one.status != 0:
            yield row(part, "CalculiX 2.20", element, setting, one, "", "", "", "stopped")
            continue
        rows = frd_rows(deck / "part.frd", "STRESS", 6)
        peak = max(von_mises(*values) for values in rows)
        yield row(part, "CalculiX 2.20", element, setting, one, "", f"{peak:.6g}", "",
                  f"{len(rows)} nodes")
        shutil.rmtree(deck)


def finer(part, size):
    """The geometry with cells of another size, hexahedra also through the thickness."""
    text = part.geo.read_text()
    if part.hexahedra:
        return text.replace("h = 1; ", f"h = {size}; ").replace(
            "Layers{1}", f"Layers{{{round(1 / size)}}}")
    return text.replace("h = 3 ]", f"h = {size} ]")


def by_dolfinx(part, folder, rounds):
    """dolfinx on meshes of order 2 by gmsh; forms are compiled before the clock runs."""
    compiled = set()
    for size in part.sizes:
        (folder / "dolfinx.geo").write_text(finer(part, size))
        mesh = folder / "dolfinx.msh"
        measure.must(["gmsh", "-3", "-order", "2", "-format", "msh41", folder / "dolfinx.geo",
                      "-o", mesh])
        # of the fine mesh degree 4 takes minutes and more
        for degree in (1, 2, 3, 4) if part.hexahedra and size == 1 else (1, 2, 3):
            request = {"mesh": str(mesh), "degree": degree, "young": YOUNG,
                       "poisson": POISSON, **part.spec}
            command = [DEBIAN_PYTHON, HERE / "dolfinx_part.py", json.dumps(request)]
            if degree not in compiled:
                measure.run(command, LIMIT)
                compiled.add(degree)
            one = measure.least(runs_of(command, rounds))
            setting = f"{size} mm" if not part.hexahedra else (
                "h" if size == 1 else f"h/{round(1 / size)}")
            if one.status != 0:
                yield row(part, "dolfinx 0.5", f"p = {degree}", setting, one, "", "", "",
                          (one.errors.strip().split("\n") or ["stopped"])[-1][:80])
                continue
            found = json.loads(one.text.strip().split("\n")[-1])
            yield row(part, "dolfinx 0.5", f"p = {degree}", setting, one,
                      f"{found['seconds']:.4f}", f"{found['peak']:.6g}", "",
                      f"{found['equations']} equations")

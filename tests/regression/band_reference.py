"""Known peaks of the band study's parts without a closed form: each by two
models or meshes of its own, far finer than what is judged.

Parts from a plane without Poisson's ratio have plane stress at any thickness:
quadrangles of degree 4 on two meshes, far graded to the peak, and CalculiX's CPS8
beside them, whose stress at nodes wavers by some 0.03 %. Those with one: extruded hexahedra of degree 4 on
two meshes, graded to the peak. Solids of revolution: CalculiX's CAX8 on two
meshes. Others: tetrahedra of degree 4 on two meshes.
"""
import csv
import math
import re
import tempfile
from pathlib import Path

import band_outline
import band_run
import band_shapes
import calculix_flat

# cells over Shape.size away from the peak and near it, cells round an arc
PLANE_LEVELS = ((1.4, 0.65, 16), (1.0, 0.45, 20))
LAYERS = ((0.15, 0.5, 0.85, 1.0), (0.07, 0.25, 0.5, 0.75, 0.93, 1.0))
SOLID_LEVELS = ((1.4, 0.4, 16), (1.1, 0.27, 20))
FLAT_LEVELS = ((0.36, 0.06, 60), (0.21, 0.035, 100))
HIGH_LEVELS = ((0.6, 0.1, 36), (0.36, 0.06, 60))
CALCULIX_MAY_DIFFER = 1e-3
PARTS = [f"{family}-{k}" for family in (
    "plate_hole", "eye_link", "hook", "lug", "shoulder", "tee", "pressed_holes",
    "stepped_bar", "grooved_bar", "hub_disc", "boss_plate", "bracket_boss",
    "cross_bore") for k in (1, 2)]
COLUMNS = ("part", "stress_MPa", "error", "deflection_mm", "way",
           "other_stress_MPa", "other_deflection_mm", "other_way")


def spread(shape, fine, coarse):
    """Cells that grow from fine near the focus to coarse."""
    if not shape.focus:
        return ""
    text = "".join(
        f"Point({9001 + k}) = {{{', '.join(f'{v:.12g}' for v in at)}}};\n"
        for k, at in enumerate(shape.focus))
    tags = ", ".join(str(9001 + k) for k in range(len(shape.focus)))
    return text + ("Field[1] = Distance;\nField[1].PointsList = {" + tags + "};\n"
                   "Field[2] = Threshold;\nField[2].InField = 1;\n"
                   f"Field[2].SizeMin = {fine:.6g};\nField[2].SizeMax = {coarse:.6g};\n"
                   f"Field[2].DistMin = {0.4 * shape.size:.6g};\n"
                   f"Field[2].DistMax = {2.5 * shape.size:.6g};\n"
                   "Background Field = 2;\n")


def options(order, size, quads):
    return (f"Mesh.MeshSizeMax = {size:.6g};\nMesh.Algorithm = 6;\n"
            f"Mesh.ElementOrder = {order};\nGeneral.NumThreads = 1;\n"
            f"Mesh.MshFileVersion = 4.1;\nMesh.HighOrderOptimize = {int(not quads)};\n"
            + ("Mesh.RecombineAll = 1;\nMesh.SubdivisionAlgorithm = 1;\n"
               if quads else ""))


def outline(shape, cells, size):
    drawn = shape.outline(True)
    drawn.sizes = drawn.arc_sizes(cells, size)
    return drawn


def plane(clevis, folder, shape, level):
    far, close, cells = PLANE_LEVELS[level]
    for tries in range(12):
        scale = shape.size * 0.96**tries
        text = (band_outline.extruded(outline(shape, cells, far * scale),
                                      shape.thickness, LAYERS[level])
                + spread(shape, close * scale, far * scale)
                + options(4, far * scale, True) + "Mesh.MshFileVersion = 2.2;\n")
        band_run.run_gmsh(folder, text)
        if not flat_corners(folder / "part.msh"):
            break
    return by_clevis(clevis, folder, shape, text)


def flat_corners(path):
    """Hexahedra with two faces on one round surface: their map is singular
    where these meet. Of a .msh file of format 2.2."""
    lines = iter(path.read_text(encoding="ascii").splitlines())
    names, faces, cells = {}, set(), []
    for line in lines:
        if line == "$PhysicalNames":
            for _ in range(int(next(lines))):
                dim, tag, name = next(lines).split(maxsplit=2)
                names[int(dim), int(tag)] = name.strip('"')
        elif line == "$Elements":
            for _ in range(int(next(lines))):
                words = list(map(int, next(lines).split()))
                ends = words[3 + words[2]:]
                if words[1] == 93:
                    cells.append(ends[:8])
                elif words[1] == 37 and names[2, words[3]].startswith(
                        ("bore", "round")):
                    faces.add(frozenset(ends[:4]))
    sides = ((0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7))
    return sum(sum(frozenset(cell[k] for k in side) in faces for side in sides) > 1
               for cell in cells)


def solid(clevis, folder, shape, level):
    far, close, cells = SOLID_LEVELS[level]
    tight = "".join(band_shapes.tight(low, high, 2 * math.pi * r / cells)
                    for low, high, r in shape.tight)
    text = (shape.solid + tight + spread(shape, close * shape.size, far * shape.size)
            + options(2, far * shape.size, False))
    return by_clevis(clevis, folder, shape, text)


def by_clevis(clevis, folder, shape, text, model="3d"):
    flat = model == "plane-stress"
    code, said = band_run.run_gmsh(folder, text, 2 if flat else 3)
    if code:
        raise SystemExit(f"{shape.name}: gmsh: {said[-400:]}")
    (folder / "scene.toml").write_text(
        band_run.scene(shape, flat, 1e-5 if flat else 1e-4))
    part, why, took = band_run.check(clevis, folder, ["--model", model], 1500)
    if part is None:
        raise SystemExit(f"{shape.name}: {why}")
    peak = part["peak_von_mises"]
    steps = ", ".join(f"{m['peak_MPa']:.5g}" for m in peak["sequence"][-3:])
    return (peak["value_MPa"], part["deflection_mm"],
            f"clevis {part['model']} on {part['cells']} cells (by degree {steps}; {took:.0f} s)")


def flat_script(shape, level):
    far, close, cells = FLAT_LEVELS[level]
    return (band_outline.flat(outline(shape, cells, shape.size))
            + spread(shape, close * shape.size, far * shape.size)
            + options(2, far * shape.size, True))


def by_calculix(folder, shape, level, kind, load):
    """Without supports of its own a part's displacement is not told."""
    stress, way, count = calculix_flat.solved(folder, flat_script(shape, level), kind,
                                              load, shape.nu)
    return (stress, way if shape.fixed else math.nan,
            f"CalculiX {kind}, {count} elements")


def turned(_, folder, shape, level):
    pulled = re.search(r'right = \["([0-9.e]+) MPa', shape.case.get("traction", ""))
    turns = re.search(r'\["([0-9.e]+) rpm', shape.case.get("angular_velocity", ""))
    return by_calculix(folder, shape, level, "CAX8", calculix_flat.turning(
        {"right": float(pulled[1])} if pulled else {},
        next(group for group, axis in shape.fixed.items() if axis == "x"),
        float(turns[1]) * math.pi / 30 if turns else 0.0))


def numbers(text):
    return [float(word.split()[0]) for word in re.findall(r'"([^"]+)"', text)]


def pushed(centre, value):
    """Pressure on a hole."""
    def traction(x, y):
        r = math.dist((x, y), centre)
        return value * (x - centre[0]) / r, value * (y - centre[1]) / r
    return traction


def borne(centre, radius, force, thickness):
    """Cosine pressure of a pin on a hole."""
    size = math.hypot(*force[:2])
    top = 2 * size / (math.pi * radius * thickness)

    def traction(x, y):
        out = ((x - centre[0]) / radius, (y - centre[1]) / radius)
        value = top * max(0.0, (out[0] * force[0] + out[1] * force[1]) / size)
        return value * out[0], value * out[1]
    return traction


def plane_stress(clevis, folder, shape, level):
    """Of a balanced case."""
    far, close, cells = HIGH_LEVELS[level]
    text = (band_outline.flat(outline(shape, cells, shape.size))
            + spread(shape, close * shape.size, far * shape.size)
            + options(4, far * shape.size, True))
    found = by_clevis(clevis, folder, shape, text, "plane-stress")
    other, _, way = plane_stress_by_calculix(folder, shape, level)
    if abs(other / found[0] - 1) > CALCULIX_MAY_DIFFER:
        raise SystemExit(f"{shape.name}: {found[0]} by clevis, {other} by CalculiX")
    return found[0], math.nan, f"{found[2]}; {way}: {other:.8g}"


def plane_stress_by_calculix(folder, shape, level):
    drawn = shape.outline(True)
    tractions = {}
    for key, text in shape.case.items():
        for group, value in re.findall(r"(\w+) = (\[[^\]]*\]|\"[^\"]*\")", text):
            if key == "traction":
                tractions[group] = lambda x, y, t=numbers(value)[:2]: t
                continue
            centre, radius = drawn.circle(group)
            tractions[group] = (
                borne(centre, radius, numbers(value), shape.thickness)
                if key == "pins" else pushed(centre, numbers(value)[0]))
    return by_calculix(folder, shape, level, "CPS8", calculix_flat.balanced(tractions))


def rows(path):
    if not path.exists():
        return {}
    with open(path, newline="", encoding="utf-8") as file:
        return {row["part"]: row for row in csv.DictReader(file)}


def write(clevis, names):
    """The known peaks of the named parts, default all, into the table."""
    solve = {"plane": plane, "turned": turned, "solid": solid, "uniform": plane_stress}
    for name in names or PARTS:
        shape = band_shapes.shape(name)
        found = []
        for level in (0, 1):
            with tempfile.TemporaryDirectory() as folder:
                found.append(solve["uniform" if shape.kind == "plane" and shape.nu == 0.0
                                   else shape.kind](clevis, Path(folder), shape, level))
        first, last = found
        row = {"part": name, "stress_MPa": f"{last[0]:.8g}",
               "error": f"{abs(first[0] / last[0] - 1):.2g}",
               "deflection_mm": f"{last[1]:.6g}", "way": last[2],
               "other_stress_MPa": f"{first[0]:.8g}",
               "other_deflection_mm": f"{first[1]:.6g}", "other_way": first[2]}
        print(row, flush=True)
        if not abs(first[0] / last[0] - 1) <= band_run.MOST_DOUBT:
            print(f"{name}: too far apart to judge by, left out", flush=True)
            continue
        kept = rows(band_run.REFERENCES) | {name: row}
        with open(band_run.REFERENCES, "w", newline="", encoding="utf-8") as file:
            table = csv.DictWriter(file, COLUMNS, lineterminator="\n")
            table.writeheader()
            table.writerows(kept[part] for part in PARTS if part in kept)

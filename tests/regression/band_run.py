"""One check of the band study: a mesh drawn at random, checked, judged."""
import csv
import json
import math
import subprocess
import time
from dataclasses import dataclass
from pathlib import Path

import band_outline
import band_shapes

TOLERANCES = (0.002, 0.005, 0.01, 0.02, 0.05)
MOST_CELLS = {"tet4": 1000, "tet10": 700, "hex": 120, "split": 250, "flat": 450}
MOST_DOUBT = 0.001  # of a known peak that rows are judged by
REFERENCES = Path(__file__).resolve().parent / "band_references.csv"


@dataclass
class Mesh:
    kind: str      # "tet4", "tet10", "hex", "split" (tets cut into hexes), "flat"
    order: int
    size: float    # of the cells, over Shape.size
    seed: int
    algorithm: int         # of gmsh, for surfaces
    curvature: int         # cells round a full turn; 0: not asked for
    layers: tuple = ()     # heights, up to 1
    quads: bool = False    # of flat meshes
    optimize: int = 0      # gmsh's Mesh.HighOrderOptimize


def kinds(shape):
    allowed = ["tet10", "tet10", "tet10"]
    if shape.exact:
        allowed.append("tet4")
    if shape.kind != "solid":
        allowed += ["hex", "hex"]
    else:
        allowed.append("split")
    if shape.flat:
        allowed.append("flat")
    return allowed


def draw_mesh(rng, shape):
    kind = rng.choice(kinds(shape))
    order = {"tet4": 1, "tet10": 2, "split": 2, "flat": rng.choice((2, 2, 3)),
             "hex": rng.choice((1, 2, 2, 3) if shape.exact else (2, 2, 3))}[kind]
    quads = kind == "flat" and rng.random() < 0.5
    if kind == "flat" and not quads:
        order = 2
    count = rng.choice((1, 2, 3))
    cuts = sorted(rng.uniform(0.2, 0.8) for _ in range(count - 1))
    if count == 3 and cuts[1] - cuts[0] < 0.15:
        cuts = [0.3, 0.7]
    return Mesh(kind, order, math.exp(rng.uniform(math.log(0.45), math.log(1.6))),
                rng.randrange(1, 10**6),
                rng.choice((1, 5, 6)),
                rng.choice((0, 10, 14, 20)), tuple(cuts) + (1.0,), quads,
                rng.choice((0, 1, 1)))


def options(mesh, size):
    high = f"Mesh.ElementOrder = {mesh.order};\n" if mesh.order > 1 else ""
    if mesh.order > 1 and mesh.kind != "flat":
        high += f"Mesh.HighOrderOptimize = {mesh.optimize};\n"
    cut = {"hex": 1, "split": 2}.get(mesh.kind, int(mesh.quads))
    return (f"Mesh.MeshSizeMax = {size:.6g};\nMesh.MeshSizeMin = {size / 8:.6g};\n"
            f"Mesh.Algorithm = {mesh.algorithm};\n"
            f"Mesh.RandomSeed = {mesh.seed};\nMesh.RandomFactor = 1e-4;\n"
            "General.NumThreads = 1;\nMesh.MshFileVersion = 4.1;\n" + high
            + (f"Mesh.SubdivisionAlgorithm = {cut};\n" if cut else "")
            + ("Mesh.RecombineAll = 1;\n" if cut == 1 else ""))


def script(shape, mesh, size, aligned=False):
    if shape.kind == "solid":
        tight = "".join(
            band_shapes.tight(low, high, min(size, 2 * math.pi * r / mesh.curvature))
            for low, high, r in shape.tight) if mesh.curvature else ""
        return shape.solid + tight + options(mesh, size)
    layers = mesh.layers if mesh.kind == "hex" else None
    if layers == (1.0,) and shape.kind == "turned":  # a quarter in one cell is too much
        layers = (0.5, 1.0)
    outline = shape.outline(aligned)
    outline.sizes = outline.arc_sizes(mesh.curvature, size)
    if mesh.kind == "flat":
        text = band_outline.flat(outline)
    elif shape.kind == "turned":
        text = band_outline.turned(outline, layers)
    else:
        text = band_outline.extruded(outline, shape.thickness, layers)
    return text + options(mesh, size)


def scene(shape, flat, tolerance, mesh_file="part.msh"):
    case = dict(shape.case)
    fixed = {g: c for g, c in shape.fixed.items() if not (flat and g == "bottom")}
    if fixed:
        case["fixed"] = "{ " + ", ".join(
            f'{group} = ["{axis}"]' for group, axis in fixed.items()) + " }"
    return (f'schema = 1\nname = "{shape.name}"\n\n[material.steel]\n'
            f'youngs_modulus = "210 GPa"\npoissons_ratio = {shape.nu}\n'
            'density = "7850 kg/m^3"\nyield_strength = "2000 MPa"\n\n'
            f'[[part]]\nname = "part"\nmesh = "{mesh_file}"\nlength_unit = "mm"\n'
            + (f'thickness = "{shape.thickness} mm"\n' if flat else "")
            + 'material = "steel"\n\n[[part.case]]\nname = "load"\n'
            + "".join(f"{key} = {value}\n" for key, value in case.items())
            + f'\n[accuracy]\npeak_stress = "{100 * tolerance:.6g} %"\n')


def run_gmsh(folder, text, dim=3):
    (folder / "part.geo").write_text(text)
    run = subprocess.run(["timeout", "60", "gmsh", f"-{dim}", "-v", "2", "part.geo", "-o", "part.msh"],
                         cwd=folder, capture_output=True, text=True)
    return run.returncode, run.stdout + run.stderr


def cell_count(path):
    """Elements of the largest dimension in a .msh file of format 4.1, and how
    many types of them there are."""
    count, top, types = 0, 0, set()
    with open(path, encoding="ascii") as file:
        for line in file:
            if line.startswith("$Elements"):
                blocks = int(next(file).split()[0])
                for _ in range(blocks):
                    dim, _, kind, n = map(int, next(file).split())
                    if dim > top:
                        count, top, types = 0, dim, set()
                    if dim == top:
                        count += n
                        types.add(kind)
                    for _ in range(n):
                        next(file)
                break
    return count, len(types)


def make_mesh(folder, shape, mesh):
    """Meshes, coarser while there are too many cells; the cells, or why not."""
    size = shape.size * mesh.size
    limit, before = MOST_CELLS[mesh.kind], math.inf
    for _ in range(14):
        code, said = run_gmsh(folder, script(shape, mesh, size),
                              2 if mesh.kind == "flat" else 3)
        if code or not (folder / "part.msh").exists():
            return 0, said.strip().splitlines()[-1:]
        cells, kinds_found = cell_count(folder / "part.msh")
        # no longer fewer: gmsh wants so many round the curves
        enough = cells <= limit or 0.95 * before < cells <= 4 * limit
        before = cells
        if enough and (kinds_found == 1 or mesh.kind != "hex"):
            return cells, ""
        if enough:  # triangles are left: another try
            mesh.seed += 1
            size *= 0.95
            continue
        mesh.curvature = mesh.curvature - 4 if mesh.curvature > 6 else 0
        size *= 1.3
    return 0, "too many cells"


def check(clevis, folder, arguments=(), seconds=300):
    started = time.monotonic()
    try:
        run = subprocess.run([clevis, "check", folder / "scene.toml", "--out",
                              folder / "out", "--json", "--jobs", "1", *arguments],
                             capture_output=True, text=True, timeout=seconds)
    except subprocess.TimeoutExpired:
        return None, "no answer", seconds
    took = time.monotonic() - started
    try:
        result = json.loads(run.stdout)
        if result.get("failures"):
            return None, str(result["failures"][0])[:160], took
        return result["parts"][0], "", took
    except (ValueError, IndexError, KeyError):
        said = run.stderr.strip() or run.stdout.strip()
        return None, " ".join(said.split())[:160], took


def references():
    """{name: (stress MPa, its error, deflection mm)}"""
    with open(REFERENCES, newline="", encoding="utf-8") as file:
        return {row["part"]: (float(row["stress_MPa"]), float(row["error"]),
                              float(row["deflection_mm"] or "nan"))
                for row in csv.DictReader(file)}


def truth(shape, stored, flat):
    if shape.truth:
        way = shape.truth[1] if math.isnan(shape.flat_way) or not flat else shape.flat_way
        return shape.truth[0], 0.0, way
    return stored[shape.name]


COLUMNS = ("row", "part", "kind", "order", "model", "cells", "tolerance", "peak",
           "verdict", "value", "low", "high", "truth", "held", "miss", "ratio",
           "used", "deflection", "deflection_truth", "deflection_low",
           "deflection_high", "deflection_held", "seconds", "note")


def judge(part, known, allowed):
    """Columns of a check beside the known peak; allowed: what the known value
    itself may be off [1]."""
    stress, _, way = known
    peak = part["peak_von_mises"]
    value, (low, high) = peak["value_MPa"], peak["band_MPa"]
    miss = max(low - stress, stress - high, 0.0) / stress
    reach = max(high - value, value - low)
    error = abs(value - stress)
    row = {"used": part["model"], "peak": peak["verdict"], "verdict": part["verdict"],
           "value": value, "low": low, "high": high, "truth": stress,
           "held": miss <= allowed, "miss": miss,
           "ratio": reach / max(error, 1e-6 * stress),
           "deflection": part["deflection_mm"], "deflection_truth": way}
    band = part.get("deflection_band_mm")
    if band and way and way == way:
        row["deflection_low"], row["deflection_high"] = band
        row["deflection_held"] = (band[0] <= way * (1 + allowed)
                                  and way * (1 - allowed) <= band[1])
    return row


def one(clevis, folder, shape, mesh, tolerance, model, known):
    """A row of the study."""
    row = {"part": shape.name, "kind": mesh.kind, "order": mesh.order,
           "tolerance": tolerance, "model": model}
    cells, why = make_mesh(folder, shape, mesh)
    row["cells"] = cells
    if not cells:
        return row | {"peak": "no mesh", "note": why}
    (folder / "scene.toml").write_text(scene(shape, mesh.kind == "flat", tolerance))
    part, why, took = check(clevis, folder, ["--model", model])
    row["seconds"] = took
    if part is None:
        return row | {"peak": "refused", "note": why}
    return row | judge(part, known, known[1])


def parts(stored):
    """Names of all that may be drawn."""
    closed = [f"{family}-{k}" for family in
              ("lame_ring", "spinning_ring", "hollow_sphere") for k in (1, 2, 3)]
    return closed + [name for name, known in stored.items() if known[1] <= MOST_DOUBT]


def draw_model(rng, shape, mesh):
    if mesh.kind == "flat" and shape.fixed:  # a solid would be free along z
        return rng.choice(("auto", "auto", "layered"))
    if shape.kind == "plane" and mesh.kind in ("hex", "flat"):
        return rng.choice(("auto", "auto", "3d", "layered"))
    return rng.choice(("auto", "3d"))


def drawn(clevis, folder, shape, rng, stored):
    """A row with mesh, tolerance and model drawn."""
    mesh = draw_mesh(rng, shape)
    tolerance = rng.choice(TOLERANCES)
    model = draw_model(rng, shape, mesh)
    known = truth(shape, stored, mesh.kind == "flat")
    return one(clevis, folder, shape, mesh, tolerance, model, known)


def line(row):
    """A row in words."""
    if "value" not in row:
        return f"{row['part']}, {row['kind']} {row['order']}: {row['peak']}, {row['note']}"
    return (f"{row['part']}, {row['kind']} {row['order']}, {row['cells']} cells, "
            f"{row['tolerance']:.1%}, {row['used']}: {row['peak']} "
            f"{row['value']:.4g} [{row['low']:.4g}, {row['high']:.4g}] MPa, truth "
            f"{row['truth']:.5g}"
            + ("" if row["held"] else f", MISSES by {row['miss']:.2%}")
            + f"; width/error {row['ratio']:.2g}; {row['seconds']:.1f} s")

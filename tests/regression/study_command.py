#!/usr/bin/env python3
"""`clevis study` and `clevis export`: files, JSON, refusals, and CalculiX.

    study_command.py CLEVIS ROOT contract|calculix

`calculix` needs ccx and returns 77 without it: clevis's and CalculiX's
displacements must agree within 0.5 %, and to the digits of the .frd on flat
tetrahedra, where both have the same equations.
"""
import csv
import json
import shutil
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree
from pathlib import Path

from schemas import errors

MATERIAL = """
schema = 1
name = "{name}"
[material.steel]
youngs_modulus = "210 GPa"
poissons_ratio = 0.3
density = "7850 kg/m^3"
yield_strength = "355 MPa"
[[part]]
name = "ring"
mesh = "{mesh}"
length_unit = "mm"
material = "steel"
"""
SQUEEZED = """
[[part.case]]
name = "squeezed"
pressure = {{ bore_A = "{inside}", round_rim = "10 MPa" }}
probes = [{{ name = "P", at = ["13 mm", "4 mm", "5 mm"], quantity = "displacement_x" }}]
"""
PRESSED = """
thickness = "6 mm"
[[part.case]]
name = "pressed"
pressure = { bore_A = "20 MPa", rim = "10 MPa" }
"""
SPUN = """
[[part.case]]
name = "spun"
fixed = { bore_A = ["x", "y", "z"] }
angular_acceleration = ["0 rad/s^2", "0 rad/s^2", "10000 rad/s^2"]
"""
BENT = """
[[part.case]]
name = "bent"
fixed = { root = ["x", "y", "z"] }
traction = { tip = ["2 MPa", "0 MPa", "1 MPa"] }
"""
AGREE = 5e-3
FLAT_AGREE = 1e-5  # six digits in the .frd


class Checks:
    def __init__(self):
        self.bad = 0

    def expect(self, holds, claim, seen=""):
        self.bad += not holds
        print(f"{'ok' if holds else 'FAILED':7}{claim}"
              + ("" if holds else f": {seen!r}"))


def scene(folder, root, mesh, *cases):
    file = Path(folder) / "scene.toml"
    file.write_text(MATERIAL.format(
        name="a ring", mesh=root / "tests/data/meshes" / mesh) + "".join(cases))
    return str(file)


def call(clevis, *arguments, path=None):
    environment = {"PATH": path} if path is not None else None
    return subprocess.run([clevis, *arguments], capture_output=True, text=True,
                          check=False, env=environment)


def study_files(checks, folder, document):
    names = sorted(p.name for p in folder.iterdir())
    checks.expect(names == [".lock", "ring_peak.gp", "ring_study.csv", "ring_study.gp",
                            "study.json"], "files, without gnuplot", names)
    for script in folder.glob("*.gp") if shutil.which("gnuplot") else ():
        done = subprocess.run(["gnuplot", "-d", script.name], cwd=folder, capture_output=True,
                              text=True, check=False)
        texts = []
        if done.returncode == 0:
            root = ElementTree.parse(script.with_suffix(".svg")).getroot()
            texts = [text.strip() for text in root.itertext()]
        checks.expect("peak von Mises stress" in texts and texts.count("clevis check") == 1
                      and not done.stderr, f"{script.name} draws", (done, texts))
    with open(folder / "ring_study.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    runs = document["parts"][0]["runs"]
    checks.expect(len(rows) == len(runs), "a CSV row per run", len(rows))
    checks.expect(json.loads((folder / "study.json").read_text()) == document,
                  "study.json is what --json prints")


def contract(clevis, root, checks):
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        file = scene(folder, root, "ring.msh",
                     SQUEEZED.format(inside="20 MPa"))
        out = folder / "out"
        run = call(clevis, "study", file, "--json", "--out", str(out), path="")
        checks.expect(run.returncode == 0, "study", run)
        checks.expect(run.stderr.count("gnuplot-nox") == 1, "a missing gnuplot is told once",
                      run.stderr)
        document = json.loads(run.stdout)
        schema = json.loads((root / "docs/study.schema.json").read_text())
        broken = list(errors(document, schema, schema))
        checks.expect(not broken, "it holds to study.schema.json", broken[:5])
        part = document["parts"][0]
        checks.expect("left out" in document["calculix"],
                      "a missing ccx is told", document["calculix"])
        series = {r["series"] for r in part["runs"] if "left_out" not in r}
        checks.expect({"plane stress", "2-D x 2+2 terms", "2-D x 3+3 terms",
                       "2-D x 4+4 terms", "axisymmetric", "3-D",
                       "plane stress, deal.II", "3-D, deal.II",
                       "3-D, cells halved", "clevis check"} == series,
                      "every model is there", series)
        peaks = {(r["series"], r["setting"]): r["peak_MPa"] for r in part["runs"]
                 if "left_out" not in r}
        for (name, setting), peak in peaks.items():
            own = peaks.get((name.removesuffix(", deal.II"), setting))
            checks.expect(abs(peak / own - 1) < 1e-8,
                          f"{name}, {setting}: the peak of either engine", (peak, own))
        checks.expect(not any(s.startswith("CalculiX") for s in series),
                      "no CalculiX without ccx", series)
        # Lame: u(r) of a ring, plane stress; sigma peaks at the bore.
        a, b, p, q, e, nu = 10.0, 20.0, 20.0, 10.0, 210e3, 0.3
        k = 1.0 / (b * b - a * a)
        c1, c2 = (p * a * a - q * b * b) * k, (p - q) * a * a * b * b * k
        exact = ((1 - nu) * c1 * a + (1 + nu) * c2 / a) / e
        got = part["reference"]["probes"][0]["value_mm"]
        checks.expect(abs(got - exact) < 1e-4 * abs(exact),
                      f"reference of the probe is Lame's {exact:.6g} mm", got)
        revolved = [abs(r["probes"][0]["value_mm"] / exact - 1)
                    for r in part["runs"] if r["series"] == "axisymmetric"]
        checks.expect(len(revolved) == 4
                      and revolved == sorted(revolved, reverse=True)
                      and revolved[-1] < 1e-4,
                      "by Fourier terms each degree comes nearer to Lame",
                      revolved)
        for r in part["runs"]:
            checks.expect("left_out" in r or (
                r["memory_MB"] > 10 and r["seconds"]["total"] > 0
                and r["seconds"]["cpu"] > 0 and r["dofs"] > 0),
                f"{r['series']}, {r['setting']}: cost", r)
        study_files(checks, out, document)
        refused = call(clevis, "study", file, "--part", "rim", "--json")
        checks.expect(refused.returncode == 2
                      and json.loads(refused.stdout)["error"]["code"] == "U001",
                      "unknown part", refused)
        exported = call(clevis, "export", file, "--json", "--out", str(out))
        decks = json.loads(exported.stdout)["decks"]
        checks.expect(exported.returncode == 0 and len(decks) == 1
                      and Path(decks[0]["file"]).read_text().count("\n*STEP\n")
                      == decks[0]["steps"] == 1, "export", exported)
        unbalanced = scene(folder, root, "ring.msh", """
[[part.case]]
name = "pulled"
pins = { bore_A = ["1 N", "0 N", "0 N"] }
""")
        refused = call(clevis, "export", unbalanced)
        checks.expect(refused.returncode == 12 and "L001" in refused.stderr,
                      "unbalanced part", refused)


def triangles(clevis, root, checks):
    """A flat mesh of triangles: terms through the thickness stand on
    quadrangles. At the bore of Lame's ring: r -20, hoop 20/3, axial 0 MPa."""
    with tempfile.TemporaryDirectory() as folder:
        file = scene(folder, root, "ring_flat_tri6.msh", PRESSED)
        run = call(clevis, "study", file, "--json", "--out", folder, path="")
    checks.expect(run.returncode == 0, "study of triangles", run)
    runs = json.loads(run.stdout)["parts"][0]["runs"]
    checks.expect(not any("left_out" in r for r in runs),
                  "triangles: every run is made", runs)
    exact = (400 + 400 / 9 + 400 / 3) ** 0.5
    last = {r["series"]: r.get("peak_MPa", 0) for r in runs
            if r["series"].endswith("terms")}
    checks.expect(len(last) == 3 and all(abs(peak / exact - 1) < 1e-3
                                         for peak in last.values()),
                  f"triangles, terms: peak is Lame's {exact:.6g} MPa", last)


def agreement(clevis, root, checks, mesh, case, limit):
    with tempfile.TemporaryDirectory() as folder:
        run = call(clevis, "study", scene(folder, root, mesh, case), "--json",
                   "--out", folder, "--split", "2")
    if run.returncode != 0:
        checks.expect(False, f"study of {mesh}", run)
        return
    runs = [r for r in json.loads(run.stdout)["parts"][0]["runs"]
            if r["series"].startswith("CalculiX")]
    checks.expect(len(runs) > 0, "CalculiX took part", run.stdout)
    if not runs:
        return
    for r in runs:
        print(f"       {mesh} {r['series']} {r['setting']}: "
              f"{r.get('displacement_difference', r.get('left_out'))}")
    finest = runs[-1]
    checks.expect(finest.get("displacement_difference", 1.0) <= limit,
                  f"{mesh}, {finest['series']}: displacements within "
                  f"{100 * limit:g} %", finest)


def main():
    clevis, root = str(Path(sys.argv[1]).resolve()), Path(sys.argv[2])
    checks = Checks()
    if sys.argv[3] == "contract":
        contract(clevis, root, checks)
        triangles(clevis, root, checks)
    elif shutil.which("ccx") is None:
        print("skipped: no ccx (Debian: calculix-ccx)")
        return 77
    else:
        squeezed = SQUEEZED.format(inside="20 MPa")
        agreement(clevis, root, checks, "ring.msh", squeezed, AGREE)
        agreement(clevis, root, checks, "ring.msh", SPUN, AGREE)
        # C3D10's four points do not integrate curved edges exactly.
        agreement(clevis, root, checks, "ring_tetrahedra.msh", SPUN, AGREE)
        agreement(clevis, root, checks, "box_tetrahedra.msh", BENT, FLAT_AGREE)
    return checks.bad > 0


if __name__ == "__main__":
    sys.exit(main())

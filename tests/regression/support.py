"""What scripts share: a run of `clevis check` and what it says, the peak that
CalculiX finds on the deck that clevis exports, and the list of faults."""
import json
import math
import re
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

JUDGED = (0, 1, 4)  # exit codes of a check that came to a verdict


def steel(ratio=0.3, strength=355.0):
    """The material of a scene; strength in MPa."""
    return f"""
[material.steel]
youngs_modulus = "210 GPa"
poissons_ratio = {ratio}
density = "7850 kg/m^3"
yield_strength = "{strength} MPa"
"""


STEEL = steel()


@dataclass
class Answer:
    code: int
    result: dict  # result.json; empty where the scene was refused
    text: str     # stdout and stderr
    out: Path     # folder of the result files

    @property
    def parts(self):
        return self.result.get("parts") or []

    @property
    def part(self):
        return self.parts[0]

    @property
    def peak(self):
        return self.part["peak_von_mises"]["value_MPa"]

    @property
    def band(self):
        return self.part["peak_von_mises"]["band_MPa"]

    @property
    def codes(self):
        """Of the diagnostics told, as L007."""
        return set(re.findall(r"\b([A-Z]\d{3})\b", self.text))

    def __str__(self):
        if not self.parts:
            return f"exit {self.code}, {' '.join(sorted(self.codes))}"
        low, high = self.band
        return (f"{self.peak:.2f} [{low:.2f}, {high:.2f}] MPa, "
                f"{self.part['verdict']} {self.part['why']}")


def check(clevis, scene, *arguments, out=None, exits=None):
    """out: folder of the files, default `out` beside the scene. exits: codes
    that may come; any other ends the script with what clevis said."""
    out = Path(out or Path(scene).parent / "out")
    (out / "result.json").unlink(missing_ok=True)
    run = subprocess.run([clevis, "check", scene, "--out", out, *arguments],
                         capture_output=True, text=True)
    text = run.stdout + run.stderr
    if exits is not None and run.returncode not in exits:
        sys.exit(f"exit {run.returncode}\n{text}")
    file = out / "result.json"
    result = json.loads(file.read_text()) if file.is_file() else {}
    return Answer(run.returncode, result, text, out)


def gmsh(folder, script, name="part", dimension=3):
    """Writes script as NAME.geo and meshes it as NAME.msh."""
    (Path(folder) / f"{name}.geo").write_text(script)
    subprocess.run(["gmsh", f"-{dimension}", "-v", "1", f"{name}.geo", "-o",
                    f"{name}.msh"], cwd=folder, check=True,
                   capture_output=True)


def make_meshes(clevis, scene):
    """Of the parts that have a `geometry`."""
    subprocess.run([clevis, "mesh", scene], check=True, capture_output=True)


class Checks:
    """Claims that hold or not, printed as they are looked at."""

    def __init__(self):
        self.faults = []

    def expect(self, holds, claim):
        print(("ok: " if holds else "FAULT: ") + claim, flush=True)
        if not holds:
            self.faults.append(claim)
        return holds

    def near(self, claim, value, exact, tolerance):
        return self.expect(abs(value - exact) <= tolerance * abs(exact),
                           f"{claim}: {value:.5g}, {exact:.5g} by theory")

    def holds(self, band, truth, claim, slack=0.0):
        """slack: what the truth itself may be off [1]."""
        low, high = band
        return self.expect(
            low <= truth * (1 + slack) and truth * (1 - slack) <= high,
            f"{claim}: [{low:.5g}, {high:.5g}], truth {truth:.5g}")

    def exit_code(self):
        for fault in self.faults:
            print("FAULT:", fault, file=sys.stderr)
        return 1 if self.faults else 0


def frd_rows(path, name, count):
    """Values at the nodes of the last block `name` of a .frd file."""
    found, inside = [], False
    for line in Path(path).read_text(encoding="ascii").splitlines():
        if line.startswith(" -4"):
            inside = name in line
            if inside:
                found = []
        elif inside and line.startswith(" -1"):
            found.append([float(line[13 + 12 * k:25 + 12 * k])
                          for k in range(count)])
    return found


def von_mises(x, y, z, xy, yz, zx):
    return math.sqrt(0.5 * ((x - y)**2 + (y - z)**2 + (z - x)**2)
                     + 3 * (xy * xy + yz * yz + zx * zx))


def calculix_peak(clevis, scene, folder, part, *arguments):
    """Largest von Mises stress at a node [MPa] by ccx, nodes."""
    subprocess.run([clevis, "export", scene, "--out", folder, *arguments],
                   check=True, capture_output=True)
    subprocess.run(["ccx", part], cwd=folder, check=True, capture_output=True)
    rows = frd_rows(Path(folder) / f"{part}.frd", "STRESS", 6)
    return max(von_mises(*row) for row in rows), len(rows)

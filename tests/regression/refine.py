#!/usr/bin/env python3
"""`refine` cuts the cells of a mesh: eight times as many, the same part, the
converged peak of the reference link in the bands of both, and degree 1 nearer to
it with the finer cells. Arguments: clevis scene."""
import json
import subprocess
import sys
import tempfile

from support import Checks, make_meshes

CONVERGED = 55.013  # MPa, +- 0.001


def checked(clevis, scene, refine):
    with tempfile.TemporaryDirectory() as folder:
        run = subprocess.run(
            [clevis, "check", scene, "--set", f"part.link.refine={refine}", "--model", "3d",
             "--json", "--out", folder], capture_output=True, text=True, check=False)
    try:
        return json.loads(run.stdout)["parts"][0]
    except (ValueError, KeyError, IndexError):
        sys.exit(f"refine = {refine}: exit {run.returncode}\n{run.stdout}\n{run.stderr}")


def main():
    clevis, scene = sys.argv[1:3]
    make_meshes(clevis, scene)
    checks = Checks()
    whole, pieces = (checked(clevis, scene, n) for n in (1, 2))
    checks.expect(pieces["cells"] == 8 * whole["cells"],
                  f"{whole['cells']} cells become {pieces['cells']}")
    checks.expect(abs(pieces["mass_kg"] / whole["mass_kg"] - 1.0) < 1e-9, "the mass stays")
    checks.expect(any("refine" in note for note in pieces["notes"]), "a note says so")
    first = [part["peak_von_mises"]["sequence"][0]["peak_MPa"] for part in (whole, pieces)]
    checks.expect(abs(first[1] - CONVERGED) < 0.7 * abs(first[0] - CONVERGED),
                  f"degree 1 is nearer to {CONVERGED} MPa: {first[0]:.3f}, {first[1]:.3f}")
    for part in (whole, pieces):
        low, high = part["peak_von_mises"]["band_MPa"]
        checks.expect(low <= CONVERGED <= high,
                      f"{part['cells']} cells: {low:.3f} to {high:.3f} MPa hold it")
    return checks.exit_code()


if __name__ == "__main__":
    sys.exit(main())

#!/usr/bin/env python3
"""`--max-time` ends the meshing of a CAD part, not its judgement: an eighth of a
hollow sphere under pressure, which is to yield, fails (Lamé).

    late_rounds.py CLEVIS
"""
import subprocess
import sys
import tempfile
from pathlib import Path

import support

INNER, OUTER, PRESSURE = 10.0, 15.0, 100.0  # mm, MPa

SPHERE = f"""SetFactory("OpenCASCADE");
Sphere(1) = {{0, 0, 0, {OUTER}, 0, Pi/2, Pi/2}};
Sphere(2) = {{0, 0, 0, {INNER}, 0, Pi/2, Pi/2}};
BooleanDifference(3) = {{ Volume{{1}}; Delete; }}{{ Volume{{2}}; Delete; }};
"""

SCENE = f"""schema = 1
name = "sphere"
{support.steel(strength=100.0)}
[[part]]
name = "sphere"
geometry = "sphere.step"
material = "steel"
limits = {{ safety_factor = 1.2, singular_zones = "exclude" }}
[part.faces]
inner = {{ nearest = ["5.7735 mm", "5.7735 mm", "5.7735 mm"] }}
sx = {{ plane = {{ normal = [-1, 0, 0] }} }}
sy = {{ plane = {{ normal = [0, -1, 0] }} }}
sz = {{ plane = {{ normal = [0, 0, -1] }} }}
[[part.case]]
name = "full"
pressure = {{ inner = "{PRESSURE} MPa" }}
fixed = {{ sx = ["x"], sy = ["y"], sz = ["z"] }}
[accuracy]
peak_stress = "0.1 %"
"""


def main():
    checks = support.Checks()
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        (folder / "sphere.geo").write_text(SPHERE)
        subprocess.run(["gmsh", "-0", "-o", "sphere.step", "sphere.geo"], cwd=folder,
                       check=True, timeout=60, stdout=subprocess.DEVNULL)
        (folder / "scene.toml").write_text(SCENE)
        found = support.check(sys.argv[1], folder / "scene.toml", "--max-time", "0.1 s")
        # At the bore σ_r = −p, σ_θ = p (2 a³ + b³)/(2 (b³ − a³)).
        a3, b3 = INNER**3, OUTER**3
        truth = PRESSURE * (1.0 + (2.0 * a3 + b3) / (2.0 * (b3 - a3)))
        checks.expect("no finer mesh" in found.text, f"it is late: {found}")
        checks.expect(found.code == 1, f"it fails: exit {found.code}")
        checks.expect(found.part["name"] == "sphere" and found.part["mass_kg"] > 0.0,
                      "its row is whole")
        checks.holds(found.band, truth, "von Mises by Lamé")
    return checks.exit_code()


if __name__ == "__main__":
    sys.exit(main())

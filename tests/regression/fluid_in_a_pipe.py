#!/usr/bin/env python3
"""A fluid in a pipe bends it on as an axial load of pressure times bore would.

    fluid_in_a_pipe.py CLEVIS

A pipe that is clamped at one end and guided at the other, free to slide in its seals,
buckles at p A = 20.19 E I/l² ([TimoshenkoGere]) though its wall is not pressed along. As
a dead load the pressure would pull it straight.
"""
import math
import sys
import tempfile
from pathlib import Path

import scene_text
import support
from round_bar import MODULUS

INNER, OUTER = 10.0, 11.0  # mm
AREA = math.pi * INNER**2
RIGIDITY = MODULUS * math.pi / 4 * (OUTER**4 - INNER**4)


def pipe(folder, length, pressure):
    """length: mm; pressure: MPa."""
    lines = ["Point(1) = {0, 0, 0};"]
    for k, (y, z) in enumerate(((1, 0), (0, 1), (-1, 0), (0, -1))):
        lines.append(f"Point({2 + k}) = {{0, {INNER * y}, {INNER * z}}};"
                     f" Point({6 + k}) = {{0, {OUTER * y}, {OUTER * z}}};")
    for k in range(4):
        n = (k + 1) % 4
        lines.append(f"Circle({1 + k}) = {{{2 + k}, 1, {2 + n}}};"
                     f" Circle({5 + k}) = {{{6 + k}, 1, {6 + n}}};"
                     f" Line({9 + k}) = {{{2 + k}, {6 + k}}};")
    lines.append("Transfinite Curve {1:8} = 4; Transfinite Curve {9:12} = 2;"
                 " ends[] = {}; outside[] = {}; inside[] = {}; volumes[] = {};")
    for k in range(4):
        n = (k + 1) % 4
        lines.append(f"Curve Loop({1 + k}) = {{{9 + k}, {5 + k}, {-9 - n}, {-1 - k}}};"
                     f" Plane Surface({1 + k}) = {{{1 + k}}};")
    lines.append(f"""Transfinite Surface {{1:4}}; Recombine Surface {{1:4}};
For q In {{1:4}}
  e[] = Extrude {{{length}, 0, 0}} {{ Surface{{q}}; Layers{{{round(length / 25)}}}; Recombine; }};
  ends[] += e[0]; volumes[] += e[1]; outside[] += e[3]; inside[] += e[5];
EndFor
Physical Surface("left") = {{1:4}}; Physical Surface("right") = {{ends[]}};
Physical Surface("round_out") = {{outside[]}}; Physical Surface("bore_in") = {{inside[]}};
Physical Volume("body") = {{volumes[]}}; Mesh.ElementOrder = 2;
""")
    support.gmsh(folder, "\n".join(lines), name="bar")
    file = folder / "scene.toml"
    file.write_text(f"""{scene_text.head("pipe", world="")}{scene_text.BAR}\
limits = {{ safety_factor = 1.3, singular_zones = "exclude" }}
[[part.case]]
name = "fluid"
pressure = {{ bore_in = "{pressure} MPa" }}
fixed = {{ left = ["x", "y", "z"], right = ["y", "z"] }}
[accuracy]
peak_stress = "5 %"
""")
    return file


def main():
    clevis = Path(sys.argv[1]).resolve()
    checks = support.Checks()
    for length, pressure in ((1500, 20), (300, 20)):
        factor = 20.19 * RIGIDITY / length**2 / (pressure * AREA)
        with tempfile.TemporaryDirectory() as name:
            part = support.check(clevis, pipe(Path(name), length, pressure),
                                 exits=support.JUDGED).part
        low = part["buckling"]["band"][0]
        checks.expect(low <= factor, f"{length} mm: from {low:.4g} on, {factor:.4g} by theory")
        if factor < 1.5:
            checks.expect(part["verdict"] != "pass" and low < 1.5,
                          f"{length} mm: {part['verdict']}")
        else:
            checks.expect(low > 1.5, f"{length} mm: enough is known")
    return checks.exit_code()


if __name__ == "__main__":
    sys.exit(main())

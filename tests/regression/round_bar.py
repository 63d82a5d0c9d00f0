"""A round bar of steel, meshed by gmsh, that scripts share."""
import math
import tempfile
from pathlib import Path

import support

DIAMETER, MODULUS, DENSITY = 20.0, 210e3, 7.85e-9  # mm, MPa, t/mm³
INERTIA = math.pi * DIAMETER**4 / 64


def round_bar(folder, pieces):
    """bar.msh along x from 0; pieces: (length, layers, group of its wall). Groups left
    and right at the ends."""
    inner, outer = DIAMETER / 2 * 0.55 / math.sqrt(2), DIAMETER / 2 / math.sqrt(2)
    lines = ["Point(1) = {0, 0, 0};"]
    for k, (y, z) in enumerate(((1, 1), (-1, 1), (-1, -1), (1, -1))):
        lines.append(f"Point({2 + k}) = {{0, {inner * y}, {inner * z}}};"
                     f" Point({6 + k}) = {{0, {outer * y}, {outer * z}}};")
    for k in range(4):
        n = (k + 1) % 4
        lines.append(f"Line({1 + k}) = {{{2 + k}, {2 + n}}};"
                     f" Circle({5 + k}) = {{{6 + k}, 1, {6 + n}}};"
                     f" Line({9 + k}) = {{{2 + k}, {6 + k}}};")
    lines.append("Transfinite Curve {1:8} = 3; Transfinite Curve {9:12} = 2;"
                 " Curve Loop(1) = {1, 2, 3, 4}; Plane Surface(1) = {1};")
    for k in range(4):
        lines.append(f"Curve Loop({2 + k}) = {{{9 + k}, {5 + k}, {-9 - (k + 1) % 4}, "
                     f"{-1 - k}}}; Plane Surface({2 + k}) = {{{2 + k}}};")
    lines.append("Transfinite Surface {1:5}; Recombine Surface {1:5};"
                 " now[] = {1, 2, 3, 4, 5}; volumes[] = {};"
                 ' Physical Surface("left") = {1:5};')
    for number, (length, layers, group) in enumerate(pieces):
        wall = f"wall{number}"
        lines.append(f"""next[] = {{}}; {wall}[] = {{}};
For q In {{0:4}}
  e[] = Extrude {{{length}, 0, 0}} {{ Surface{{now[q]}}; Layers{{{layers}}}; Recombine; }};
  next[] += e[0]; volumes[] += e[1];
  If(q > 0)
    {wall}[] += e[3];
  EndIf
EndFor
now[] = next[];
Physical Surface("{group}") = {{{wall}[]}};""")
    lines.append('Physical Surface("right") = {now[]}; Physical Volume("body") ='
                 " {volumes[]}; Mesh.ElementOrder = 2;")
    support.gmsh(folder, "\n".join(lines) + "\n", name="bar")


def check_of(clevis, make, *arguments):
    """Answer to a scene that make(folder, *arguments) writes."""
    with tempfile.TemporaryDirectory() as name:
        answer = support.check(clevis, make(Path(name), *arguments), exits=support.JUDGED)
    print(f"{make.__name__} {arguments[:1]}: {answer.part['verdict']}, "
          f"{answer.part['why']}", flush=True)
    return answer

"""Largest von Mises stress of a solid of revolution by CalculiX's CAX8."""
import math
import subprocess

import support


def read(path):
    """Nodes, eight-node quadrangles and edges by group of a .msh file (2.2)."""
    lines = iter(path.read_text(encoding="ascii").splitlines())
    names, nodes, quads, edges = {}, {}, [], {}
    for line in lines:
        if line == "$PhysicalNames":
            for _ in range(int(next(lines))):
                dim, tag, name = next(lines).split(maxsplit=2)
                names[int(dim), int(tag)] = name.strip('"')
        elif line == "$Nodes":
            for _ in range(int(next(lines))):
                tag, x, y, _ = next(lines).split()
                nodes[int(tag)] = (float(x), float(y))
        elif line == "$Elements":
            for _ in range(int(next(lines))):
                field = list(map(int, next(lines).split()))
                kind, group, ends = field[1], field[3], field[3 + field[2]:]
                if kind == 16:
                    quads.append(ends)
                elif kind == 8:
                    edges.setdefault(names[1, group], []).append(set(ends[:2]))
    return nodes, quads, edges


def deck(nodes, quads, edges, pull, held, spin, nu):
    """pull: {group: MPa outwards}; held: group without way along the axis;
    spin: rad/s. Radius first, axis second."""
    text = ["*NODE,NSET=ALL"]
    text += [f"{tag},{y:.12g},{x:.12g},0." for tag, (x, y) in nodes.items()]
    text.append("*ELEMENT,TYPE=CAX8,ELSET=E")
    faces = {}
    for number, quad in enumerate(quads, 1):
        a, b, c, d, ab, bc, cd, da = quad
        at = [nodes[tag] for tag in (a, b, c, d)]
        area = sum(at[k - 1][0] * at[k][1] - at[k][0] * at[k - 1][1] for k in range(4))
        if area > 0:  # radius and axis change places
            a, b, c, d, ab, bc, cd, da = a, d, c, b, da, cd, bc, ab
        text.append(",".join(map(str, (number, a, b, c, d, ab, bc, cd, da))))
        for k, ends in enumerate(((a, b), (b, c), (c, d), (d, a)), 1):
            faces[frozenset(ends)] = (number, k)
    text.append(f"*MATERIAL,NAME=M\n*ELASTIC\n210000,{nu}\n*DENSITY\n7.85e-9\n"
                "*SOLID SECTION,ELSET=E,MATERIAL=M\n1.")
    text.append("*BOUNDARY")
    low = min(x for x, _ in nodes.values())
    text += [f"{tag},2,2" for tag, (x, _) in nodes.items() if abs(x - low) < 1e-9]
    assert held in edges
    text.append("*STEP\n*STATIC\n*DLOAD")
    for group, stress in pull.items():
        for edge in edges[group]:
            number, k = faces[frozenset(edge)]
            text.append(f"{number},P{k},{-stress:.12g}")
    if spin:
        text.append(f"E,CENTRIF,{spin**2:.12g},0.,0.,0.,0.,1.,0.")
    text.append("*NODE FILE,OUTPUT=2D\nU\n*EL FILE,OUTPUT=2D\nS\n*END STEP")
    return "\n".join(text) + "\n"


def solved(folder, script, pull, held, spin, nu):
    """Largest von Mises stress [MPa] and displacement [mm], elements.

    script: of gmsh, with the meridian as surface 1 and its groups."""
    (folder / "axis.geo").write_text(script + "Mesh.MshFileVersion = 2.2;\n"
                                     "Mesh.SecondOrderIncomplete = 1;\n",
                                     encoding="ascii")
    subprocess.run(["gmsh", "-2", "-v", "1", "axis.geo", "-o", "axis.msh"],
                   cwd=folder, check=True, capture_output=True)
    mesh = read(folder / "axis.msh")
    (folder / "axis.inp").write_text(deck(*mesh, pull, held, spin, nu),
                                     encoding="ascii")
    subprocess.run(["ccx", "axis"], cwd=folder, check=True, capture_output=True)
    result = folder / "axis.frd"
    return (max(support.von_mises(*row)
                for row in support.frd_rows(result, "STRESS", 6)),
            max(math.hypot(*way) for way in support.frd_rows(result, "DISP", 3)), len(mesh[1]))

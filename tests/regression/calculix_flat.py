"""Largest von Mises stress of a plane part (CPS8) or a solid of revolution (CAX8)
by CalculiX."""
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
                    edges.setdefault(names[1, group], []).append(ends)
    return nodes, quads, edges


def elements(quads, nodes, kind):
    """Lines of the quadrangles, turned to the left, and (element, side) of every
    pair of corners."""
    text, faces = [f"*ELEMENT,TYPE={kind},ELSET=E"], {}
    for number, quad in enumerate(quads, 1):
        a, b, c, d, ab, bc, cd, da = quad
        at = [nodes[tag] for tag in (a, b, c, d)]
        area = sum(at[k - 1][0] * at[k][1] - at[k][0] * at[k - 1][1] for k in range(4))
        if area < 0:
            a, b, c, d, ab, bc, cd, da = a, d, c, b, da, cd, bc, ab
        text.append(",".join(map(str, (number, a, b, c, d, ab, bc, cd, da))))
        for k, ends in enumerate(((a, b), (b, c), (c, d), (d, a)), 1):
            faces[frozenset(ends)] = (number, k)
    return text, faces


def deck(kind, nodes, quads, edges, load, nu):
    """load: function(nodes, edges, faces) of the lines of supports and of loads."""
    text = ["*NODE,NSET=ALL"]
    text += [f"{tag},{x:.12g},{y:.12g},0." for tag, (x, y) in nodes.items()]
    lines, faces = elements(quads, nodes, kind)
    supports, loads = load(nodes, edges, faces)
    return "\n".join(text + lines + [
        f"*MATERIAL,NAME=M\n*ELASTIC\n210000,{nu}\n*DENSITY\n7.85e-9",
        "*SOLID SECTION,ELSET=E,MATERIAL=M\n1.", "*BOUNDARY", *supports,
        "*STEP\n*STATIC", *loads,
        "*NODE FILE,OUTPUT=2D\nU\n*EL FILE,OUTPUT=2D\nS\n*END STEP"]) + "\n"


def turning(pull, held, spin):
    """pull: {group: MPa outwards}; held: group without way along the axis;
    spin: rad/s. Nodes: radius first, axis second."""
    def load(nodes, edges, faces):
        assert held in edges
        low = min(axis for _, axis in nodes.values())
        loads = ["*DLOAD"]
        for group, stress in pull.items():
            for edge in edges[group]:
                number, side = faces[frozenset(edge[:2])]
                loads.append(f"{number},P{side},{-stress:.12g}")
        if spin:
            loads.append(f"E,CENTRIF,{spin**2:.12g},0.,0.,0.,0.,1.,0.")
        return [f"{tag},2,2" for tag, (_, axis) in nodes.items()
                if abs(axis - low) < 1e-9], loads
    return load


GAUSS = ((-math.sqrt(0.6), 5 / 9), (0.0, 8 / 9), (math.sqrt(0.6), 5 / 9))


def edge_forces(at, traction):
    """Forces at the ends and the middle of an edge, per unit of thickness."""
    forces = [[0.0, 0.0] for _ in at]
    for s, weight in GAUSS:
        shape = (s * (s - 1) / 2, s * (s + 1) / 2, 1 - s * s)
        slope = (s - 0.5, s + 0.5, -2 * s)
        point = [sum(n * p[k] for n, p in zip(shape, at)) for k in (0, 1)]
        along = math.hypot(*(sum(n * p[k] for n, p in zip(slope, at)) for k in (0, 1)))
        value = traction(*point)
        for n, force in zip(shape, forces):
            for k in (0, 1):
                force[k] += weight * along * n * value[k]
    return forces


def balanced(tractions):
    """tractions: {group: function(x, y) of MPa}, in balance: three supports that
    carry nothing."""
    def load(nodes, edges, faces):
        sums = {}
        for group, traction in tractions.items():
            for edge in edges[group]:
                for tag, force in zip(edge, edge_forces([nodes[t] for t in edge], traction)):
                    for k in (0, 1):
                        sums[tag, k] = sums.get((tag, k), 0.0) + force[k]
        ends = min(nodes, key=lambda t: nodes[t]), max(nodes, key=lambda t: nodes[t])
        return ([f"{ends[0]},1,2", f"{ends[1]},2,2"],
                ["*CLOAD"] + [f"{tag},{k + 1},{force:.12g}"
                              for (tag, k), force in sums.items() if force])
    return load


def solved(folder, script, kind, load, nu):
    """Largest von Mises stress [MPa] and displacement [mm], elements.

    script: of gmsh, with the section as surface 1 and its groups.
    kind: "CPS8", or "CAX8" with x as the axis."""
    (folder / "flat.geo").write_text(script + "Mesh.MshFileVersion = 2.2;\n"
                                     "Mesh.SecondOrderIncomplete = 1;\n",
                                     encoding="ascii")
    subprocess.run(["gmsh", "-2", "-v", "1", "flat.geo", "-o", "flat.msh"],
                   cwd=folder, check=True, capture_output=True)
    nodes, quads, edges = read(folder / "flat.msh")
    if kind == "CAX8":
        nodes = {tag: (y, x) for tag, (x, y) in nodes.items()}
    (folder / "flat.inp").write_text(deck(kind, nodes, quads, edges, load, nu),
                                     encoding="ascii")
    subprocess.run(["ccx", "flat"], cwd=folder, check=True, capture_output=True)
    result = folder / "flat.frd"
    return (max(support.von_mises(*row)
                for row in support.frd_rows(result, "STRESS", 6)),
            max(math.hypot(*way) for way in support.frd_rows(result, "DISP", 3)),
            len(quads))

"""Structured meshes of hexahedra, and of tetrahedra cut from them, as .msh files
(format 2.2), for tests."""
from itertools import permutations

SIDES = ("x0", "x1", "y0", "y1", "z0", "z1")


def block(divisions, mapping, names=None, closed=False):
    """Unit cube in nx × ny × nz cells, moved by mapping(x, y, z).

    names: group of each side, default the side's own name; None leaves it out.
    closed: the sides y0 and y1 are one (a ring).
    Returns nodes, cells, groups (name -> quadrilaterals).
    """
    nx, ny, nz = divisions
    rows = ny if closed else ny + 1
    names = {side: side for side in SIDES} | (names or {})

    def node(i, j, k):
        return (k * rows + j % rows) * (nx + 1) + i

    nodes = [mapping(i / nx, j / ny, k / nz) for k in range(nz + 1)
             for j in range(rows) for i in range(nx + 1)]
    cells, groups = [], {}
    for k in range(nz):
        for j in range(ny):
            for i in range(nx):
                v = [node(i + di, j + dj, k + dk) for dk in (0, 1)
                     for di, dj in ((0, 0), (1, 0), (1, 1), (0, 1))]
                cells.append(v)
                faces = {"x0": (i == 0, (0, 4, 7, 3)),
                         "x1": (i == nx - 1, (1, 2, 6, 5)),
                         "y0": (j == 0 and not closed, (0, 1, 5, 4)),
                         "y1": (j == ny - 1 and not closed, (3, 7, 6, 2)),
                         "z0": (k == 0, (0, 3, 2, 1)),
                         "z1": (k == nz - 1, (4, 5, 6, 7))}
                for side, (outside, corners) in faces.items():
                    if outside and names[side]:
                        groups.setdefault(names[side], []).append(
                            [v[c] for c in corners])
    return nodes, cells, groups


def tetrahedra(mesh):
    """Each hexahedron of a block in six, alike on both sides of a face."""
    nodes, cells, groups = mesh
    ways = []
    for way in permutations((1, 2, 4)):
        corners, at = [0], 0
        for step in way:
            at += step
            corners.append(at)
        odd = way in ((1, 4, 2), (2, 1, 4), (4, 2, 1))
        ways.append([corners[i] for i in ((0, 2, 1, 3) if odd else
                                          (0, 1, 2, 3))])
    # block() numbers round the bottom, then round the top
    round_of = (0, 1, 3, 2, 4, 5, 7, 6)
    lexical = [round_of.index(i) for i in range(8)]
    split = [[cell[lexical[c]] for c in way] for cell in cells for way in ways]
    faces = {}
    for cell in split:
        for out in range(4):
            face = tuple(v for k, v in enumerate(cell) if k != out)
            faces.setdefault(frozenset(face), face)
    triangles = {}
    for name, quads in groups.items():
        for quad in quads:
            triangles.setdefault(name, []).extend(
                face for key, face in faces.items() if key <= set(quad))
    return nodes, split, triangles


def write(path, mesh):
    """Cells of 8 or 4 nodes, their faces of 4 or 3."""
    nodes, cells, groups = mesh
    cell_type, face_type = (5, 3) if len(cells[0]) == 8 else (4, 2)
    names = "".join(f'2 {k} "{name}"\n' for k, name in enumerate(groups, 2))
    elements = [f"{face_type} 2 {k} {k} " + " ".join(str(v + 1) for v in face)
                for k, faces in enumerate(groups.values(), 2) for face in faces]
    elements += [f"{cell_type} 2 1 1 " + " ".join(str(v + 1) for v in cell)
                 for cell in cells]
    with open(path, "w", encoding="ascii") as file:
        file.write("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n"
                   f'$PhysicalNames\n{len(groups) + 1}\n3 1 "body"\n{names}'
                   f"$EndPhysicalNames\n$Nodes\n{len(nodes)}\n")
        for number, (x, y, z) in enumerate(nodes, 1):
            file.write(f"{number} {x:.17g} {y:.17g} {z:.17g}\n")
        file.write(f"$EndNodes\n$Elements\n{len(elements)}\n")
        for number, element in enumerate(elements, 1):
            file.write(f"{number} {element}\n")
        file.write("$EndElements\n")

"""Plane outlines as gmsh scripts: drawn, extruded, or turned round the x axis."""
import math


class Outline:
    """Closed loops of lines and arcs, each piece with the group it belongs to
    (None: to none). Lengths in mm, the outer loop first."""

    def __init__(self):
        self.points, self.pieces, self.loops = [], [], []
        self.sizes = {}  # of cells at points

    def _point(self, at):
        for number, other in enumerate(self.points):
            if math.dist(at, other) < 1e-9:
                return number
        self.points.append(at)
        return len(self.points) - 1

    def _line(self, a, b, group):
        self.pieces.append(((self._point(a), self._point(b)), group))
        return len(self.pieces) - 1

    def _arc(self, a, centre, b, group):
        """Shorter than half a turn."""
        self.pieces.append(((self._point(a), self._point(centre),
                             self._point(b)), group))
        return len(self.pieces) - 1

    def hole(self, centre, radius, group, turned=0.0):
        at = [(centre[0] + radius * math.cos(turned + k * math.pi / 2),
               centre[1] + radius * math.sin(turned + k * math.pi / 2))
              for k in range(4)]
        self.loops.append([self._arc(at[k], centre, at[(k + 1) % 4], group)
                           for k in range(4)])

    def polygon(self, corners):
        """corners: (x, y, radius of its fillet, group of the fillet, group of
        the side to the next corner)."""
        ends = []
        for k, (x, y, radius, _, _) in enumerate(corners):
            before, behind = corners[k - 1], corners[(k + 1) % len(corners)]
            u = _unit(before[0] - x, before[1] - y)
            v = _unit(behind[0] - x, behind[1] - y)
            if not radius:
                ends.append(((x, y), None, (x, y)))
                continue
            half = 0.5 * math.acos(u[0] * v[0] + u[1] * v[1])
            reach, way = radius / math.tan(half), radius / math.sin(half)
            w = _unit(u[0] + v[0], u[1] + v[1])
            ends.append(((x + reach * u[0], y + reach * u[1]),
                         (x + way * w[0], y + way * w[1]),
                         (x + reach * v[0], y + reach * v[1])))
        loop = []
        for k, (first, centre, last) in enumerate(ends):
            if centre:
                loop.append(self._arc(first, centre, last, corners[k][3]))
            to = ends[(k + 1) % len(ends)][0]
            if math.dist(last, to) > 1e-9:
                loop.append(self._line(last, to, corners[k][4]))
        self.loops.append(loop)

    def eyes(self, ends, group):
        """Outer loop round two circles (x, radius) on the x axis, joined by
        their common tangents; the circles belong to group 0, group 1."""
        (x1, r1), (x2, r2) = ends
        tilt = math.acos((r1 - r2) / (x2 - x1))

        def at(x, r, angle):
            return (x + r * math.cos(angle), r * math.sin(angle))
        a, b = at(x1, r1, tilt), at(x1, r1, math.pi)
        c, d = at(x1, r1, -tilt), at(x2, r2, -tilt)
        e, f = at(x2, r2, 0.0), at(x2, r2, tilt)
        self.loops.append([
            self._arc(a, (x1, 0.0), b, group[0]),
            self._arc(b, (x1, 0.0), c, group[0]), self._line(c, d, None),
            self._arc(d, (x2, 0.0), e, group[1]),
            self._arc(e, (x2, 0.0), f, group[1]), self._line(f, a, None)])

    def arc_sizes(self, cells, largest):
        """Of the cells at the ends of arcs: so many round a full turn; 0: all
        as large as elsewhere."""
        sizes = {}
        for ends, _ in self.pieces:
            if len(ends) == 3 and cells:
                r = math.dist(self.points[ends[0]], self.points[ends[1]])
                for k in (ends[0], ends[2]):
                    sizes[k] = min(sizes.get(k, largest), 2 * math.pi * r / cells)
        return sizes

    def circle(self, group):
        """Centre and radius of a hole."""
        ends = next(ends for ends, of in self.pieces if of == group)
        start, centre = self.points[ends[0]], self.points[ends[1]]
        return centre, math.dist(start, centre)

    def script(self):
        """Points, curves k + 1 of the pieces k, and plane surface 1."""
        text = [f"Point({k + 1}) = {{{x:.15g}, {y:.15g}, 0"
                + (f", {self.sizes[k]:.6g}" if k in self.sizes else "") + "};"
                for k, (x, y) in enumerate(self.points)]
        for k, (ends, _) in enumerate(self.pieces):
            kind = "Circle" if len(ends) == 3 else "Line"
            tags = ", ".join(str(end + 1) for end in ends)
            text.append(f"{kind}({k + 1}) = {{{tags}}};")
        for k, loop in enumerate(self.loops):
            tags = ", ".join(str(piece + 1) for piece in loop)
            text.append(f"Curve Loop({k + 1}) = {{{tags}}};")
        tags = ", ".join(str(k + 1) for k in range(len(self.loops)))
        return "\n".join(text) + f"\nPlane Surface(1) = {{{tags}}};\n"

    def groups(self):
        """{group: positions of its pieces in the order of the loops}"""
        found = {}
        for position, piece in enumerate(p for loop in self.loops for p in loop):
            group = self.pieces[piece][1]
            if group:
                found.setdefault(group, []).append((position, piece))
        return found


def _unit(x, y):
    size = math.hypot(x, y)
    return x / size, y / size


def flat(outline):
    """The outline as a flat mesh."""
    lines = "".join(
        f'Physical Curve("{group}") = {{'
        + ", ".join(str(piece + 1) for _, piece in pieces) + "};\n"
        for group, pieces in outline.groups().items())
    return outline.script() + lines + 'Physical Surface("body") = {1};\n'


def _sides(outline):
    return "".join(
        f'Physical Surface("{group}") = {{'
        + ", ".join(f"out[{2 + position}]" for position, _ in pieces) + "};\n"
        for group, pieces in outline.groups().items())


def extruded(outline, thickness, layers=None, start=0.0):
    """layers: heights of the layers of hexahedra, up to 1; None: a free mesh.
    Bottom and top are groups."""
    text = outline.script()
    if start:
        text += f"Translate {{0, 0, {start:.15g}}} {{ Surface{{1}}; }}\n"
    return (text + f"out[] = Extrude {{0, 0, {thickness:.15g}}} {{ Surface{{1}};"
            + _layers(layers) + " };\n" + _sides(outline)
            + 'Physical Surface("bottom") = {1};\n'
            'Physical Surface("top") = {out[0]};\n'
            'Physical Volume("body") = {out[1]};\n')


def _layers(layers):
    if layers is None:
        return ""
    return (" Layers{{" + ", ".join("1" for _ in layers) + "}, {"
            + ", ".join(f"{height:.12g}" for height in layers)
            + "}}; Recombine;")


def turned(outline, layers=None, quarters=1):
    """Round the x axis, y the radius: quarters of a turn; of one quarter the
    planes y = 0 ("cut_y") and z = 0 ("cut_z") are groups."""
    text = outline.script() + "next = 1;\n"
    names, volumes, last = {}, [], ""
    for k in range(quarters):
        text += (f"q{k}[] = Extrude {{ {{1, 0, 0}}, {{0, 0, 0}}, Pi/2 }} {{ "
                 f"Surface{{next}};{_layers(layers)} }};\nnext = q{k}[0];\n")
        for group, pieces in outline.groups().items():
            names.setdefault(group, []).extend(
                f"q{k}[{2 + position}]" for position, _ in pieces)
        volumes.append(f"q{k}[1]")
        last = f"q{k}[0]"
    if quarters == 1:
        names["cut_z"], names["cut_y"] = ["1"], [last]
    else:
        text += "Coherence;\n"
    return (text + "".join(
        f'Physical Surface("{name}") = {{{", ".join(tags)}}};\n'
        for name, tags in names.items())
        + f'Physical Volume("body") = {{{", ".join(volumes)}}};\n')

#!/usr/bin/env python3
"""Draws docs/figures/joint_TYPE.svg: frames, coordinates and reactions of each joint.

    draw_joints.py [--check]

What a type holds and its coordinates come from the table in
src/mechanism/joints/joint_types.cc; here stands only how its bodies look. With
--check nothing is written: it fails if a committed figure differs, or if the
table of docs/scene/joints.md does.
"""
import math
import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
SOURCE = ROOT / "src/mechanism/joints/joint_types.cc"
PAGE = ROOT / "docs/scene/joints.md"
FIGURES = ROOT / "docs/figures"

# Screen directions of x, y, z; all lengths in px.
PROJECTION = ((-0.80, 0.40), (0.95, 0.27), (0.0, -1.08))
PANEL, HEIGHT = 310, 310
AXIS, FORCE = 66, 92
GREY, BLUE, PURPLE, ORANGE = "#8a8f98", "#2f6fb0", "#7b2d8e", "#d06a00"
AXES = ("#c62828", "#2e7d32", "#1546c0")
SAMPLE_ANGLE, SAMPLE_SLIDE = math.radians(50), 85.0
SAMPLE_PLANE = (45.0, 70.0)


# ---- traits -------------------------------------------------------------

def array(text, name):
    """Elements of a constexpr std::array as (kind, axis), coordinates with names."""
    body = re.search(rf"constexpr std::array {name}\{{(.*?)\}};", text, re.S)[1]
    found = []
    pattern = (r'Coordinate\{"(\w+)",\s*\{k(\w),\s*(\d)\}\}|(k\w+)\[(\d)\]|'
               r"JointRow\{(?:JointRow::Kind::)?k(\w+),\s*(\d)\}")
    for named, kind, axis, other, index, row, of in re.findall(pattern, body):
        if other:
            found.append(array(text, other)[int(index)])
        elif named:
            found.append((named, kind, int(axis)))
        else:
            found.append((row, int(of)))
    return found


def traits():
    """{type: (held rows, coordinates)} of joint_types.cc."""
    text = SOURCE.read_text()
    table = {}
    for entry in re.findall(r"JointTraits\{(.*?)\}(?=,\s*(?:JointTraits|\}))", text, re.S):
        name = re.search(r'\.name = "(\w+)"', entry)
        if name is None:
            continue
        rows = array(text, re.search(r"\.rows = (\w+)", entry)[1])
        given = re.search(r"\.coordinates = (\w+)", entry)
        table[name[1]] = rows, array(text, given[1]) if given else []
    return table


# ---- vectors ------------------------------------------------------------

def add(a, b, factor=1.0):
    return tuple(x + factor * y for x, y in zip(a, b))


def turn(axis, angle):
    """Rotation about a coordinate axis: columns."""
    c, s = math.cos(angle), math.sin(angle)
    i, j = (axis + 1) % 3, (axis + 2) % 3
    columns = [[0.0] * 3 for _ in range(3)]
    columns[axis][axis] = 1.0
    columns[i][i] = columns[j][j] = c
    columns[i][j], columns[j][i] = s, -s
    return columns


def product(a, b):
    return [[sum(a[k][r] * b[c][k] for k in range(3)) for r in range(3)]
            for c in range(3)]


def cross(a, b):
    return tuple(a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3]
                 for k in range(3))


def unit(a):
    length = math.sqrt(sum(x * x for x in a))
    return tuple(x / length for x in a)


IDENTITY = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]


# ---- drawing ------------------------------------------------------------

class Picture:
    """SVG of one or two panels; `origin` is where (0, 0, 0) is on the screen."""

    def __init__(self):
        self.lines, self.origin = [], (0.0, 0.0)

    def at(self, p):
        return tuple(self.origin[k] + sum(p[i] * PROJECTION[i][k] for i in range(3))
                     for k in range(2))

    def path(self, points, colour, width=2.0, closed=False, fill="none", dashes=""):
        where = " L".join(f"{x:.1f} {y:.1f}" for x, y in points)
        dashed = f' stroke-dasharray="{dashes}"' if dashes else ""
        self.lines.append(f'<path d="M{where}{" Z" if closed else ""}" fill="{fill}" '
                          f'stroke="{colour}" stroke-width="{width}"{dashed}/>')

    def polygon(self, points, colour):
        self.path([self.at(p) for p in points], colour, 1.2, True, shade(colour))

    def text(self, where, words, colour="#222", size=13, anchor="middle"):
        self.lines.append(f'<text x="{where[0]:.1f}" y="{where[1]:.1f}" fill="{colour}" '
                          f'font-size="{size}" text-anchor="{anchor}">{words}</text>')

    def head(self, before, tip, colour, size=7.0):
        dx, dy = tip[0] - before[0], tip[1] - before[1]
        length = math.hypot(dx, dy) or 1.0
        dx, dy = dx / length * size, dy / length * size
        points = [tip, (tip[0] - dx - dy / 2, tip[1] - dy + dx / 2),
                  (tip[0] - dx + dy / 2, tip[1] - dy - dx / 2)]
        self.path(points, colour, 1.0, True, colour)

    def arrow(self, start, end, colour, width=2.0, label="", dashes=""):
        a, b = self.at(start), self.at(end)
        self.path([a, b], colour, width, dashes=dashes)
        self.head(a, b, colour)
        if label:
            length = math.hypot(b[0] - a[0], b[1] - a[1]) or 1.0
            self.text((b[0] + 13 * (b[0] - a[0]) / length,
                       b[1] + 13 * (b[1] - a[1]) / length + 4), label, colour)

    def arc(self, centre, first, second, radius, angles, colour, label="", width=2.0):
        """From `first` towards `second`, both at right angles to the axis."""
        begin, end = angles
        steps = 24
        points = []
        for k in range(steps + 1):
            angle = begin + (end - begin) * k / steps
            points.append(self.at(add(add(centre, first, radius * math.cos(angle)),
                                      second, radius * math.sin(angle))))
        self.path(points, colour, width)
        self.head(points[-3], points[-1], colour)
        if label:
            middle, hub = points[steps // 2], self.at(centre)
            length = math.hypot(middle[0] - hub[0], middle[1] - hub[1]) or 1.0
            across = (middle[0] - hub[0]) / length
            anchor = "start" if across > 0.3 else "end" if across < -0.3 else "middle"
            self.text((middle[0] + 8 * across,
                       middle[1] + 14 * (middle[1] - hub[1]) / length + 4), label, colour,
                      anchor=anchor)

    def frame(self, centre, axes, dashes="", mark=""):
        for k, name in enumerate("xyz"):
            self.arrow(centre, add(centre, axes[k], AXIS), AXES[k], 1.8,
                       name + mark, dashes)

    def svg(self, width, title):
        return (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {HEIGHT}" '
                f'width="{width}" height="{HEIGHT}" font-family="sans-serif">\n'
                f"<title>{title}</title>\n"
                f'<rect width="{width}" height="{HEIGHT}" fill="#fff"/>\n'
                + "\n".join(self.lines) + "\n</svg>\n")


def shade(colour):
    return {GREY: "#d9dce1", BLUE: "#c8dcf0"}[colour]


# ---- bodies -------------------------------------------------------------

def disc(centre, first, second, radius, count=32):
    return [add(add(centre, first, radius * math.cos(2 * math.pi * k / count)),
                second, radius * math.sin(2 * math.pi * k / count)) for k in range(count)]


def cylinder(picture, colour, centre, axes, along, low, high, radius):
    """About axis `along` of `axes`, from low to high."""
    first, second = axes[(along + 1) % 3], axes[(along + 2) % 3]
    ends = [disc(add(centre, axes[along], z), first, second, radius) for z in (low, high)]
    hull = convex([picture.at(p) for end in ends for p in end])
    picture.path(hull, colour, 1.2, True, shade(colour))
    # the end that faces the reader lies farther down the screen's depth
    near = 1 if depth(axes[along]) > 0 else 0
    picture.path([picture.at(p) for p in ends[near]], colour, 1.2, True, shade(colour))


def depth(direction):
    """Towards the reader where positive."""
    (a, b), (c, d), (e, f) = PROJECTION
    view = cross((a, c, e), (b, d, f))
    sign = 1.0 if view[2] > 0 else -1.0
    return sign * sum(x * y for x, y in zip(view, direction))


def box(picture, colour, centre, axes, size, shift=(0.0, 0.0, 0.0)):
    """Edges 2·size; the three faces that the reader sees."""
    middle = centre
    for k in range(3):
        middle = add(middle, axes[k], shift[k])
    for k in range(3):
        side = 1.0 if depth(axes[k]) > 0 else -1.0
        i, j = (k + 1) % 3, (k + 2) % 3
        face = add(middle, axes[k], side * size[k])
        picture.polygon([add(add(face, axes[i], a * size[i]), axes[j], b * size[j])
                         for a, b in ((-1, -1), (1, -1), (1, 1), (-1, 1))], colour)


def convex(points):
    """Hull, counterclockwise."""
    points = sorted(points)
    def half(points):
        hull = []
        for p in points:
            while len(hull) > 1 and ((hull[-1][0] - hull[-2][0]) * (p[1] - hull[-2][1])
                                     <= (hull[-1][1] - hull[-2][1]) * (p[0] - hull[-2][0])):
                hull.pop()
            hull.append(p)
        return hull[:-1]
    return half(points) + half(points[::-1])


def ball(picture, colour, centre, radius):
    x, y = picture.at(centre)
    picture.lines.append(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="{radius}" '
                         f'fill="{shade(colour)}" stroke="{colour}" stroke-width="1.2"/>')


ZERO = (0.0, 0.0, 0.0)


def revolute(picture, d, R):
    cylinder(picture, GREY, ZERO, IDENTITY, 2, -34, 0, 20)
    box(picture, GREY, ZERO, IDENTITY, (8, 30, 6), (0, -46, -17))
    box(picture, BLUE, ZERO, R, (34, 7, 6), (48, 0, 15))
    cylinder(picture, BLUE, ZERO, IDENTITY, 2, 0, 26, 20)


def prismatic(picture, d, R):
    box(picture, GREY, ZERO, IDENTITY, (7, 7, 80), (0, 0, 35))
    box(picture, BLUE, d, R, (20, 20, 16))


def on_rod(picture, d, R):
    cylinder(picture, GREY, ZERO, IDENTITY, 2, -45, 125, 7)
    box(picture, BLUE, d, R, (28, 6, 6), (42, 0, 0))
    cylinder(picture, BLUE, d, IDENTITY, 2, -16, 16, 17)


def screw(picture, d, R):
    cylinder(picture, GREY, ZERO, IDENTITY, 2, -45, 125, 8)
    for turn_ in range(17):  # right-handed: up while it turns from x to y
        points = []
        for k in range(13):
            angle = -1.2 + 3.1 * k / 12
            points.append(picture.at((8 * math.cos(angle), 8 * math.sin(angle),
                                      -42 + 10 * (turn_ + angle / (2 * math.pi)))))
        picture.path(points, GREY, 1.0)
    box(picture, BLUE, d, R, (28, 6, 6), (42, 0, 0))
    cylinder(picture, BLUE, d, IDENTITY, 2, -16, 16, 17)


def universal(picture, d, R):
    box(picture, GREY, ZERO, IDENTITY, (5, 5, 34), (0, -48, 0))
    for side in (-1, 1):
        box(picture, GREY, ZERO, IDENTITY, (5, 28, 5), (0, -24, 39 * side))
    cylinder(picture, GREY, ZERO, IDENTITY, 2, -36, 36, 5)
    cylinder(picture, BLUE, ZERO, R, 0, -36, 36, 5)
    for side in (-1, 1):
        box(picture, BLUE, ZERO, R, (5, 28, 5), (39 * side, 24, 0))
    box(picture, BLUE, ZERO, R, (34, 5, 5), (0, 52, 0))


def spherical(picture, d, R):
    box(picture, GREY, ZERO, IDENTITY, (9, 30, 9), (0, -50, 0))
    ball(picture, GREY, ZERO, 27)
    box(picture, BLUE, ZERO, R, (6, 34, 6), (0, 50, 0))
    ball(picture, BLUE, ZERO, 19)


def planar(picture, d, R):
    box(picture, GREY, ZERO, IDENTITY, (72, 76, 4), (26, 34, -5))
    box(picture, BLUE, d, R, (26, 18, 9), (0, 0, 9))


def weld(picture, d, R):
    box(picture, GREY, ZERO, IDENTITY, (20, 34, 14), (0, -34, 0))
    box(picture, BLUE, ZERO, IDENTITY, (14, 34, 10), (0, 34, 0))


def distance(picture, d, R):
    box(picture, GREY, ZERO, IDENTITY, (16, 16, 12), (0, 0, -12))
    box(picture, BLUE, d, R, (16, 16, 12), (0, 0, 12))
    picture.path([picture.at(ZERO), picture.at(d)], "#444", 4.0)
    ball(picture, GREY, ZERO, 6)
    ball(picture, BLUE, d, 6)


def point_on_line(picture, d, R):
    for side in (-1, 1):
        box(picture, GREY, ZERO, IDENTITY, (4, 4, 85), (0, 14 * side, 38))
    box(picture, BLUE, d, R, (6, 30, 6), (0, 40, 0))
    ball(picture, BLUE, d, 10)


BODIES = {"revolute": revolute, "prismatic": prismatic, "cylindrical": on_rod,
          "screw": screw, "universal": universal, "spherical": spherical,
          "planar": planar, "weld": weld, "distance": distance,
          "point_on_line": point_on_line}


# ---- figures ------------------------------------------------------------

def pose(coordinates):
    """Of J on b in J on a, at a positive value of every coordinate."""
    d, R = list(ZERO), IDENTITY
    for name, kind, axis in coordinates:
        if kind == "T":
            d[axis] = SAMPLE_PLANE[axis] if axis < 2 else SAMPLE_SLIDE
        else:  # about z, the turned x, y of b, one after the other
            R = product(R, turn(about(kind, axis), SAMPLE_ANGLE))
    return tuple(d), R


def about(kind, axis):
    """Axis of J on b at its turn: cardan and universal angles count from z."""
    return (2, 0, 1)[axis] if kind in "CU" else axis


def draw_coordinates(picture, coordinates, d):
    R, at = IDENTITY, ZERO
    slides = [c for c in coordinates if c[1] == "T"]
    for name, kind, axis in slides:
        end = list(at)
        end[axis] = d[axis]
        picture.arrow(at, tuple(end), PURPLE, 3.0)
        middle = picture.at(tuple(0.6 * a + 0.4 * b for a, b in zip(at, end)))
        picture.text((middle[0] - 12, middle[1] + (14 if axis == 1 else 0)), name, PURPLE, 13,
                     "end")
        at = tuple(end)
    for name, kind, axis in coordinates:
        if kind == "T":
            continue
        k = about(kind, axis)
        i, j = (k + 1) % 3, (k + 2) % 3
        radius = {2: 58, 0: 54, 1: 60}[k]
        picture.arc(d, R[i], R[j], radius, (0, SAMPLE_ANGLE), PURPLE, name, 3.0)
        R = product(R, turn(k, SAMPLE_ANGLE))


def draw_reaction(picture, rows, d, R):
    def force(direction, label):
        picture.arrow(ZERO, add(ZERO, direction, FORCE), ORANGE, 3.0, label)

    def moment(axis, label, at=0.62):
        first = unit(cross(axis, (0.3, 0.5, 0.8)))
        centre = add(ZERO, axis, FORCE * at)
        picture.arc(centre, first, cross(axis, first), 15, (0.4, 5.4), ORANGE, "", 2.6)
        x, y = picture.at(centre)
        right = x >= picture.origin[0] - 1
        picture.text((x + (20 if right else -20), y - 8), label, ORANGE, 13,
                     "start" if right else "end")

    for kind, axis in rows:
        direction = tuple(IDENTITY[axis])
        letter = "xyz"[axis]
        if kind == "T":
            force(direction, f"F{letter}")
        elif kind == "R":
            moment(direction, f"M{letter}")
        elif kind == "U":
            normal = unit(cross(IDENTITY[2], R[0]))
            picture.arrow(ZERO, add(ZERO, normal, FORCE), "#777", 1.4, "z × x′", "4 3")
            moment(normal, "M", 0.62)
        elif kind == "Screw":
            force(direction, "Fz")
            moment(direction, "Mz = −Fz lead/2π", 0.8)
        else:
            force(unit(d), "F, along the rod")


def figure(name, rows, coordinates):
    picture = Picture()
    d, R = pose(coordinates)
    if name == "distance":
        d = (10.0, 105.0, 60.0)
    shift = picture.at(tuple(x / 2 for x in d))
    picture.origin = (PANEL / 2 - shift[0], HEIGHT / 2 + 12 - shift[1])
    BODIES[name](picture, d, R)
    if name == "distance":
        for where, mark in ((ZERO, "origin on a"), (d, "origin on b")):
            x, y = picture.at(where)
            picture.text((x + 26, y + 2), mark, "#222", 12, "start")
    else:
        picture.frame(ZERO, IDENTITY)
    if coordinates:
        picture.frame(d, R, "5 3", "′")
    draw_coordinates(picture, coordinates, d)
    picture.text((12, 22), name, "#222", 16, "start")
    frames = "; x y z: J on a" + (", x′ y′ z′: J on b" if coordinates else " and on b")
    picture.text((12, HEIGHT - 10), "a grey, b blue" + ("" if name == "distance" else frames),
                 "#555", 11, "start")
    picture.origin = (1.5 * PANEL, HEIGHT / 2 + 12)
    for k in range(3):
        picture.arrow(ZERO, add(ZERO, IDENTITY[k], AXIS * 0.6), AXES[k], 1.4)
    draw_reaction(picture, rows, d, R)
    picture.text((PANEL + 12, 22), f"reaction on b: {len(rows)}", "#222", 13, "start")
    picture.text((PANEL + 12, HEIGHT - 10), "along and about the axes of J on a", "#555",
                 11, "start")
    return picture.svg(2 * PANEL, f"{name} joint")


def page_faults(table):
    """Rows of the page against the traits: held motions and coordinates."""
    told = {}
    pattern = r'^\| `"(\w+)"` \| (\d)[^|]*\| ([^|]*)\|$'
    for name, held, names in re.findall(pattern, PAGE.read_text(), re.M):
        told.setdefault(name, (int(held), re.findall(r"`(\w+)`", names)))
    for name, (rows, coordinates) in table.items():
        wanted = len(rows), [c[0] for c in coordinates]
        if told.get(name) != wanted:
            yield f"{PAGE.name}: {name}: {told.get(name)}, the code has {wanted}"
        if f"figures/joint_{name}.svg" not in PAGE.read_text():
            yield f"{PAGE.name} has no figure of {name}"


def main():
    table = traits()
    if set(table) != set(BODIES):
        sys.exit(f"types of {SOURCE.name} and pictures differ: {set(table) ^ set(BODIES)}")
    faults = list(page_faults(table))
    for name, (rows, coordinates) in table.items():
        file = FIGURES / f"joint_{name}.svg"
        text = figure(name, rows, coordinates)
        if "--check" not in sys.argv:
            FIGURES.mkdir(exist_ok=True)
            file.write_text(text)
        elif not file.is_file() or file.read_text() != text:
            faults.append(f"{file.name} is not what draw_joints.py draws")
    print("\n".join(faults) or f"{len(table)} joint types")
    return len(faults) > 0


if __name__ == "__main__":
    sys.exit(main())

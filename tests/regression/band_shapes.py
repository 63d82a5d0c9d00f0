"""Parts whose largest von Mises stress is known, with dimensions drawn at
random: what the band study meshes. Lengths in mm, stresses in MPa, forces in N.

No peak is at a corner without bound: re-entrant corners have fillets, supports
are planes of symmetry or none (loads in balance).
"""
import math
import random
from dataclasses import dataclass, field

from band_outline import Outline


@dataclass
class Shape:
    name: str
    kind: str            # "plane": extruded; "turned": round x; "solid"
    size: float          # length that cells are measured by
    case: dict           # keys of [[part.case]] as TOML
    nu: float = 0.3
    outline: object = None   # of plane and turned parts: function(aligned)
    thickness: float = 0.0
    fixed: dict = field(default_factory=dict)
    flat: bool = True        # may be meshed flat, with `thickness`
    exact: bool = True       # every curved face is a cylinder with its group
    solid: str = ""          # gmsh script of a solid part
    tight: tuple = ()        # of a solid: (corner, corner, radius) of small curves
    focus: tuple = ()        # (x, y, z) where the peak lies, for the reference
    truth: tuple = ()        # closed form: stress MPa, deflection mm or None
    flat_way: float = math.nan   # deflection if meshed flat, where it is another


YOUNG = 210e3


def between(rng, low, high):
    return float(f"{rng.uniform(low, high):.3g}")


def vector(x, y=0.0, z=0.0, unit="MPa"):
    return "[" + ", ".join(f'"{value:.15g} {unit}"' for value in (x, y, z)) + "]"


def equivalent(a, b, c):
    return math.sqrt(0.5 * ((a - b)**2 + (b - c)**2 + (c - a)**2))


def quarter_ring(a, b):
    ring = Outline()
    ring.loops.append([
        ring._line((a, 0.0), (b, 0.0), "cut_y"),
        ring._arc((b, 0.0), (0.0, 0.0), (0.0, b), "round_outer"),
        ring._line((0.0, b), (0.0, a), "cut_x"),
        ring._arc((0.0, a), (0.0, 0.0), (a, 0.0), "bore_inner")])
    return ring


def whole_ring(a, b, turned):
    ring = Outline()
    ring.hole((0.0, 0.0), b, "round_outer", turned)
    ring.hole((0.0, 0.0), a, "bore_inner", turned)
    return ring


def lame_ring(rng, name):
    a, p = between(rng, 10, 25), between(rng, 20, 80)
    b, t = float(f"{a * rng.uniform(1.4, 3.0):.3g}"), between(rng, 4, 20)
    whole, turned = rng.random() < 0.5, rng.uniform(0, 1.5)
    hoop = p * (b * b + a * a) / (b * b - a * a)
    out = a / YOUNG * (hoop + 0.3 * p)
    across = 0.3 * t / YOUNG * (hoop - p)
    return Shape(
        name, "plane", min(b - a, t) * 0.7, {"pressure": f'{{ bore_inner = "{p} MPa" }}'},
        outline=lambda aligned: whole_ring(a, b, turned) if whole
        else quarter_ring(a, b),
        thickness=t, truth=(equivalent(hoop, -p, 0.0), math.hypot(
            out, across / 2 if whole else across)),
        flat_way=math.hypot(out, across / 2),  # held at its mid-plane
        fixed={} if whole else {"cut_x": "x", "cut_y": "y", "bottom": "z"})


def spinning_ring(rng, name):
    """Without Poisson's ratio plane stress is exact at any thickness."""
    a, rpm = between(rng, 15, 40), between(rng, 3000, 12000)
    b, t = float(f"{a * rng.uniform(2.0, 4.0):.3g}"), between(rng, 5, 25)
    turned = rng.uniform(0, 1.5)
    load = 7.85e-9 * (rpm * math.pi / 30)**2  # density times square of the rate

    def way(r):
        return r * load * 3 / 8 * (a * a + b * b + (a * b / r)**2 - r * r / 3) / YOUNG
    return Shape(
        name, "plane", min(b - a, t) * 0.7,
        {"angular_velocity": vector(0, 0, rpm, "rpm")}, nu=0.0,
        outline=lambda aligned: whole_ring(a, b, turned), thickness=t,
        truth=(0.25 * load * (3 * b * b + a * a),
               max(way(a + (b - a) * k / 400) for k in range(401))))


def plate_hole(rng, name):
    r, p = between(rng, 4, 10), between(rng, 40, 100)
    w, t = r * rng.uniform(2.0, 4.5), between(rng, 3, 16)
    length = w * rng.uniform(1.2, 1.8)
    x, y = rng.uniform(-0.2, 0.2) * w, rng.uniform(-0.25, 0.25) * (w - r)
    turned = rng.uniform(0, 1.5)

    def outline(aligned):
        plate = Outline()
        plate.polygon([(-length, -w, 0, None, None), (length, -w, 0, None, "right"),
                       (length, w, 0, None, None), (-length, w, 0, None, "left")])
        plate.hole((x, y), r, "bore_hole", 0.0 if aligned else turned)
        return plate
    return Shape(
        name, "plane", 0.9 * r, {"traction": f"{{ left = {vector(-p)}, right = {vector(p)} }}"},
        outline=outline, thickness=t, focus=((x, y + r, 0), (x, y - r, 0)))


def eye_link(rng, name):
    r1, r2 = between(rng, 5, 9), between(rng, 5, 12)
    R1, R2 = r1 * rng.uniform(1.7, 2.4), r2 * rng.uniform(1.7, 2.4)
    length, t = (R1 + R2) * rng.uniform(1.4, 2.4), between(rng, 5, 14)
    force, turned = between(rng, 2000, 9000), rng.uniform(0, 1.5)

    def outline(aligned):
        link = Outline()
        link.eyes(((0.0, R1), (length, R2)), ("round_A", "round_B"))
        link.hole((0.0, 0.0), r1, "bore_A", 0.0 if aligned else turned)
        link.hole((length, 0.0), r2, "bore_B", 0.0 if aligned else 2 * turned)
        return link
    return Shape(
        name, "plane", 0.8 * (R1 - r1), {
            "pins": f"{{ bore_A = {vector(-force, unit='N')}, bore_B = {vector(force, unit='N')} }}"},
        nu=0.0, outline=outline, thickness=t,
        focus=((0, r1, 0), (0, -r1, 0), (length, r2, 0), (length, -r2, 0)))


def hook(rng, name):
    """Two arms pulled apart by pins, joined by a bar aside: bending."""
    r = between(rng, 4, 6)
    w, ri = r * rng.uniform(1.9, 2.6), between(rng, 4, 9)
    length, drop = w * rng.uniform(4, 6), w * rng.uniform(2.2, 3.5)
    t, force, turned = between(rng, 6, 14), between(rng, 500, 1500), rng.uniform(0, 1.5)
    outer = 0.97 * w

    def outline(aligned):
        part = Outline()
        part.polygon([
            (-w, -drop - w, outer, "round_c", None),
            (length + w, -drop - w, outer, "round_d", None),
            (length + w, w, outer, "round_e", None),
            (length - w, w, outer, "round_f", None),
            (length - w, -drop + w, ri, "round_g", None),
            (w, -drop + w, ri, "round_h", None),
            (w, w, outer, "round_i", None),
            (-w, w, outer, "round_j", None)])
        part.hole((0.0, 0.0), r, "bore_A", 0.0 if aligned else turned)
        part.hole((length, 0.0), r, "bore_B", 0.0 if aligned else turned)
        return part
    return Shape(
        name, "plane", 0.9 * (w - 0.5 * r), {
            "pins": f"{{ bore_A = {vector(-force, unit='N')}, bore_B = {vector(force, unit='N')} }}"},
        nu=0.0, outline=outline, thickness=t, focus=(
            (w + 0.3 * ri, -drop + w + 0.3 * ri, 0),
            (length - w - 0.3 * ri, -drop + w + 0.3 * ri, 0),
            (0, r, 0), (0, -r, 0), (length, r, 0), (length, -r, 0)))


def lug(rng, name):
    r = between(rng, 5, 10)
    R, t = r * rng.uniform(1.7, 2.3), between(rng, 5, 15)
    b, rf = R * rng.uniform(0.6, 0.75), 0.0
    rf = (R - b) * rng.uniform(0.5, 0.9)
    foot, length = 1.3 * R, R * rng.uniform(3, 4)
    force, turned = between(rng, 3000, 10000), rng.uniform(0, 1.5)

    def outline(aligned):
        part = Outline()
        part.polygon([
            (-R, -R, 0.98 * R, "round_c", None), (foot, -R, 0, None, None),
            (foot, -b, rf, "round_f", None), (length, -b, 0, None, "end"),
            (length, b, 0, None, None), (foot, b, rf, "round_g", None),
            (foot, R, 0, None, None), (-R, R, 0.98 * R, "round_d", None)])
        part.hole((0.0, 0.0), r, "bore_A", 0.0 if aligned else turned)
        return part
    return Shape(
        name, "plane", 0.8 * (R - r), {
            "pins": f"{{ bore_A = {vector(-force, unit='N')} }}",
            "traction": f"{{ end = {vector(force / (2 * b * t))} }}"},
        nu=0.0, outline=outline, thickness=t, focus=(
            (0, r, 0), (0, -r, 0), (foot + 0.5 * rf, b, 0), (foot + 0.5 * rf, -b, 0)))


def shoulder(rng, name):
    d, t = between(rng, 12, 24), between(rng, 4, 14)
    wide, p = d * rng.uniform(1.3, 2.0), between(rng, 50, 120)
    rf = 0.5 * (wide - d) * rng.uniform(0.4, 0.95)

    def outline(aligned):
        bar = Outline()
        bar.polygon([
            (-1.2 * wide, -wide / 2, 0, None, None), (0, -wide / 2, 0, None, None),
            (0, -d / 2, rf, "round_f", None), (1.8 * d, -d / 2, 0, None, "right"),
            (1.8 * d, d / 2, 0, None, None), (0, d / 2, rf, "round_g", None),
            (0, wide / 2, 0, None, None), (-1.2 * wide, wide / 2, 0, None, "left")])
        return bar
    return Shape(
        name, "plane", 0.3 * d, {"traction": f"{{ left = {vector(-p * d / wide)}, "
                                 f"right = {vector(p)} }}"},
        nu=0.0, outline=outline, thickness=t,
        focus=((0.7 * rf, d / 2, 0), (0.7 * rf, -d / 2, 0)))


def tee(rng, name):
    """A rib on a flange, pulled against the pressure under the flange."""
    web, flange = between(rng, 6, 10), between(rng, 7, 12)
    wide, high = web * rng.uniform(4, 6), web * rng.uniform(2, 3.5)
    rf, t, p = between(rng, 2, 6), between(rng, 5, 25), between(rng, 15, 40)
    rf = min(rf, 0.5 * high)

    def outline(aligned):
        part = Outline()
        part.polygon([
            (-wide / 2, -flange, 0, None, "under"), (wide / 2, -flange, 0, None, None),
            (wide / 2, 0, 0, None, None), (web / 2, 0, rf, "round_f", None),
            (web / 2, high + rf, 0, None, "web"), (-web / 2, high + rf, 0, None, None),
            (-web / 2, 0, rf, "round_g", None), (-wide / 2, 0, 0, None, None)])
        return part
    return Shape(
        name, "plane", 0.6 * web, {"traction": f"{{ web = {vector(0, p)}, "
                                   f"under = {vector(0, -p * web / wide)} }}"},
        outline=outline, thickness=t, focus=(
            (web / 2 + 0.3 * rf, 0.3 * rf, 0), (-web / 2 - 0.3 * rf, 0.3 * rf, 0)))


def pressed_holes(rng, name):
    r1, r2 = between(rng, 5, 9), between(rng, 4, 8)
    gap, rim, t = between(rng, 4, 10), between(rng, 6, 14), between(rng, 4, 20)
    p1, p2, turned = between(rng, 30, 90), between(rng, 10, 60), rng.uniform(0, 1.5)
    apart = r1 + gap + r2
    half = max(r1, r2) + rim

    def outline(aligned):
        part = Outline()
        corner = 0.5 * half
        part.polygon([(-r1 - rim, -half, corner, "round_c", None),
                      (apart + r2 + rim, -half, corner, "round_d", None),
                      (apart + r2 + rim, half, corner, "round_e", None),
                      (-r1 - rim, half, corner, "round_f", None)])
        part.hole((0.0, 0.0), r1, "bore_A", 0.0 if aligned else turned)
        part.hole((apart, 0.0), r2, "bore_B", 0.0 if aligned else turned)
        return part
    return Shape(
        name, "plane", 0.9 * min(gap, rim), {
            "pressure": f'{{ bore_A = "{p1} MPa", bore_B = "{p2} MPa" }}'},
        nu=0.0, outline=outline, thickness=t, focus=((r1, 0, 0), (apart - r2, 0, 0)))


def stepped_bar(rng, name):
    neck = between(rng, 10, 16)
    inner, collar = neck * rng.uniform(0.3, 0.55), neck * rng.uniform(1.3, 1.9)
    rf, p = (collar - neck) * rng.uniform(0.35, 0.9), between(rng, 60, 120)

    def outline(aligned):
        bar = Outline()
        bar.polygon([
            (-1.2 * collar, inner, 0, None, "round_bore"),
            (1.6 * neck, inner, 0, None, "right"), (1.6 * neck, neck, 0, None, "round_neck"),
            (0, neck, rf, None, None), (0, collar, 0, None, "round_collar"),
            (-1.2 * collar, collar, 0, None, "left")])
        return bar
    return Shape(
        name, "turned", 0.5 * (neck - inner), {"traction": f"{{ right = {vector(p)} }}"},
        outline=outline, exact=False, flat=False,
        fixed={"left": "x", "cut_y": "y", "cut_z": "z"}, focus=((0.6 * rf, neck, 0),))


def grooved_bar(rng, name):
    radius = between(rng, 12, 20)
    inner, deep = radius * rng.uniform(0.25, 0.4), radius * rng.uniform(0.15, 0.3)
    root, p = between(rng, 1.5, 4), between(rng, 40, 90)
    wide = deep * rng.uniform(0.8, 1.2) + 0.5 * root

    def outline(aligned):
        bar = Outline()
        bar.polygon([
            (0, inner, 0, None, "round_bore"),
            (2.4 * radius, inner, 0, None, "right"), (2.4 * radius, radius, 0, None, "round_a"),
            (1.2 * radius + wide, radius, 0, None, None),
            (1.2 * radius, radius - deep, root, None, None),
            (1.2 * radius - wide, radius, 0, None, "round_b"),
            (0, radius, 0, None, "left")])
        return bar
    return Shape(
        name, "turned", 0.5 * (radius - deep - inner), {
            "traction": f"{{ right = {vector(p)} }}"},
        outline=outline, exact=False, flat=False,
        fixed={"left": "x", "cut_y": "y", "cut_z": "z"},
        focus=((1.2 * radius, radius - deep, 0),))


def hub_disc(rng, name):
    """Half of a spinning disc: hub, fillet, web."""
    bore, rpm = between(rng, 10, 18), between(rng, 4000, 12000)
    hub, outer = bore * rng.uniform(1.4, 1.8), bore * rng.uniform(3.0, 5.0)
    web, long = bore * rng.uniform(0.25, 0.5), bore * rng.uniform(0.8, 1.2)
    rf = min(0.7 * (long - web), between(rng, 2, 5))

    def outline(aligned):
        disc = Outline()
        disc.polygon([
            (0, bore, 0, None, "bore_shaft"), (long, bore, 0, None, None),
            (long, hub, 0, None, "round_hub"), (web, hub, rf, None, None),
            (web, outer, 0, None, "round_rim"), (0, outer, 0, None, "mid")])
        return disc
    return Shape(
        name, "turned", 0.6 * min(hub - bore, long), {"angular_velocity": vector(rpm, unit="rpm")},
        outline=outline, exact=False, flat=False,
        fixed={"mid": "x", "cut_y": "y", "cut_z": "z"},
        focus=((0, bore, 0), (long, bore, 0), (web + 0.3 * rf, hub + 0.3 * rf, 0)))


def _box(name, low, high, e=1e-3):
    corners = ", ".join(f"{v - e:.9g}" for v in low) + ", " + ", ".join(
        f"{v + e:.9g}" for v in high)
    return (f"s() = Surface In BoundingBox{{{corners}}};\n"
            f'Physical Surface("{name}") = s();\n')


def tight(low, high, size):
    corners = ", ".join(f"{v:.9g}" for v in (*low, *high))
    return (f"p() = Point In BoundingBox{{{corners}}};\n"
            f"MeshSize{{p()}} = {size:.6g};\n")


CUTS = {"cut_x": "x", "cut_y": "y", "cut_z": "z"}


def hollow_sphere(rng, name):
    a, p = between(rng, 10, 25), between(rng, 20, 80)
    b = float(f"{a * rng.uniform(1.4, 2.5):.3g}")
    script = f"""SetFactory("OpenCASCADE");
Sphere(1) = {{0, 0, 0, {b}, 0, Pi/2, Pi/2}};
Sphere(2) = {{0, 0, 0, {a}, 0, Pi/2, Pi/2}};
BooleanDifference(3) = {{ Volume{{1}}; Delete; }}{{ Volume{{2}}; Delete; }};
""" + _box("inner", (0, 0, 0), (a, a, a)) + _box("cut_x", (0, 0, 0), (0, b, b)) \
        + _box("cut_y", (0, 0, 0), (b, 0, b)) + _box("cut_z", (0, 0, 0), (b, b, 0)) \
        + 'Physical Volume("body") = {3};\n'
    hoop = p * (b**3 + 2 * a**3) / (2 * (b**3 - a**3))
    way = a / YOUNG * ((1 - 0.3) * hoop + 0.3 * p)
    return Shape(name, "solid", 0.6 * (b - a), {"pressure": f'{{ inner = "{p} MPa" }}'},
                 solid=script, fixed=CUTS, flat=False, exact=False,
                 truth=(hoop + p, way))


def boss_plate(rng, name):
    """Quarter of a plate with a boss on both faces, pulled."""
    half, long, t = between(rng, 16, 26), between(rng, 28, 40), between(rng, 2.5, 6)
    boss, high, rf = between(rng, 5, 9), between(rng, 5, 9), between(rng, 1.5, 3.5)
    rf, p = min(rf, 0.7 * high), between(rng, 60, 120)
    script = f"""SetFactory("OpenCASCADE");
Box(1) = {{{-long}, {-half}, 0, {2 * long}, {2 * half}, {t}}};
Cylinder(2) = {{0, 0, {0.5 * t}, 0, 0, {high + 0.5 * t}, {boss}}};
BooleanUnion(3) = {{ Volume{{1}}; Delete; }}{{ Volume{{2}}; Delete; }};
c() = Curve In BoundingBox{{{-boss - .01}, {-boss - .01}, {t - .01}, {boss + .01}, {boss + .01}, {t + .01}}};
f() = Fillet{{3}}{{c()}}{{{rf}}};
Box(9) = {{0, 0, -1, {2 * long}, {2 * half}, {high + t + 9}}};
BooleanIntersection(10) = {{ Volume{{f()}}; Delete; }}{{ Volume{{9}}; Delete; }};
""" + _box("cut_x", (0, 0, 0), (0, half, high + t)) \
        + _box("cut_y", (0, 0, 0), (long, 0, high + t)) \
        + _box("mid", (0, 0, 0), (long, half, 0)) \
        + _box("end", (long, 0, 0), (long, half, t)) \
        + 'Physical Volume("body") = {10};\n'
    return Shape(name, "solid", 0.8 * t, {"traction": f"{{ end = {vector(p)} }}"},
                 solid=script, fixed={"cut_x": "x", "cut_y": "y", "mid": "z"},
                 flat=False, exact=False,
                 tight=(((-1, -1, t - 0.1), (boss + rf + 1, boss + rf + 1, t + rf + 0.1), rf),),
                 focus=((0, boss + 0.6 * rf, t), (0, boss + 0.8 * rf, t)))


def bracket_boss(rng, name):
    """A plate with two bores and a boss with a fillet, pulled by its pins."""
    t, force = 8.0, 5000.0
    r1 = 5.0
    apart, boss = between(rng, 55, 70), between(rng, 10, 15)
    high, rf = between(rng, 6, 12), between(rng, 2.5, 5)
    e = 1e-2
    script = f"""SetFactory("OpenCASCADE");
Box(1) = {{-50, -30, 0, 100, 60, {t}}};
Cylinder(2) = {{0, 0, {0.5 * t}, 0, 0, {high + 0.5 * t}, {boss}}};
BooleanUnion(3) = {{ Volume{{1}}; Delete; }}{{ Volume{{2}}; Delete; }};
c() = Curve In BoundingBox{{{-boss - e}, {-boss - e}, {t - e}, {boss + e}, {boss + e}, {t + e}}};
f() = Fillet{{3}}{{c()}}{{{rf}}};
Cylinder(11) = {{{-apart / 2}, 0, -1, 0, 0, {t + 2}, {r1}}};
Cylinder(12) = {{{apart / 2}, 0, -1, 0, 0, {t + 2}, {r1}}};
BooleanDifference(20) = {{ Volume{{f()}}; Delete; }}{{ Volume{{11, 12}}; Delete; }};
""" + _box("bore_A", (-apart / 2 - r1, -r1, 0), (-apart / 2 + r1, r1, t), e) \
        + _box("bore_B", (apart / 2 - r1, -r1, 0), (apart / 2 + r1, r1, t), e) \
        + 'Physical Volume("body") = {20};\n'
    return Shape(name, "solid", 5.0, {
        "pins": f"{{ bore_A = {vector(-force, unit='N')}, bore_B = {vector(force, unit='N')} }}"},
        solid=script, flat=False, exact=False, tight=tuple(
            ((x - r1 - 1, -r1 - 1, -1), (x + r1 + 1, r1 + 1, t + 1), r1)
            for x in (-apart / 2, apart / 2)) + ((
                (-boss - rf - 1, -boss - rf - 1, t - 0.1),
                (boss + rf + 1, boss + rf + 1, t + rf + 0.1), 2 * rf),),
        focus=tuple((sx * apart / 2, sy * r1, z) for sx in (-1, 1)
                    for sy in (-1, 1) for z in (0, t)))


def cross_bore(rng, name):
    """An eighth of a block with crossing bores under pressure."""
    r1, p = between(rng, 6, 10), between(rng, 30, 80)
    r2, half = r1 * rng.uniform(0.5, 0.8), r1 * rng.uniform(2.2, 3.2)
    script = f"""SetFactory("OpenCASCADE");
Box(1) = {{0, 0, 0, {half}, {half}, {half}}};
Cylinder(2) = {{-1, 0, 0, {half + 2}, 0, 0, {r1}}};
Cylinder(3) = {{0, -1, 0, 0, {half + 2}, 0, {r2}}};
BooleanDifference(4) = {{ Volume{{1}}; Delete; }}{{ Volume{{2, 3}}; Delete; }};
""" + _box("bore_1", (0, 0, 0), (half, r1, r1)) \
        + _box("bore_2", (0, 0.5 * r1, 0), (r2, half, r2)) \
        + _box("cut_x", (0, 0, 0), (0, half, half)) \
        + _box("cut_y", (0, 0, 0), (half, 0, half)) \
        + _box("cut_z", (0, 0, 0), (half, half, 0)) \
        + 'Physical Volume("body") = {4};\n'
    return Shape(name, "solid", 0.5 * r1, {
        "pressure": f'{{ bore_1 = "{p} MPa", bore_2 = "{p} MPa" }}'},
        solid=script, fixed=CUTS, flat=False,
        focus=((0, r1, 0), (r2, r1, 0),
               (0, math.sqrt(r1 * r1 - r2 * r2), r2)))


FAMILIES = {
    f.__name__: f for f in (
        lame_ring, spinning_ring, hollow_sphere, plate_hole, eye_link, hook, lug,
        shoulder, tee, pressed_holes, stepped_bar, grooved_bar, hub_disc,
        boss_plate, bracket_boss, cross_bore)}


def shape(name):
    """name: FAMILY-N; its dimensions are drawn from the name itself."""
    family = name.rsplit("-", 1)[0]
    return FAMILIES[family](random.Random(name), name)

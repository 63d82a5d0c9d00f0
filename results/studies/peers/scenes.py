"""The mechanisms of tests/benchmarks as scenes of clevis, and the point of each
that tests/benchmarks/reference_points.csv knows.

Numbers stand here once more, beside those of tests/support: whoever changes one of
them misses the reference.
"""
import csv
import math
from pathlib import Path

ROOT = Path(__file__).resolve().parents[3]
REFERENCES = ROOT / "tests/benchmarks/reference_points.csv"


def vector(values, unit=""):
    return "[" + ", ".join(f'"{v!r} {unit}"' if unit else repr(v) for v in values) + "]"


class Scene:
    """TOML of a scene, by and by."""

    def __init__(self, title, gravity, duration, instants):
        self.parts = [f'schema = 1\nname = "{title}"\n\n[world]\n'
                      f'gravity = {vector(gravity, "m/s^2")}\n',
                      f'[simulation]\nduration = "{duration!r} s"\ninstants = {instants}\n']

    def add(self, table, **keys):
        self.parts.append(f"[[{table}]]\n" + "".join(
            f"{key} = {value}\n" for key, value in keys.items()))

    def body(self, name, mass, centre, inertia, origin=(0.0, 0.0, 0.0), angle=0.0,
             axes=None):
        place = f'origin = {vector(origin, "m")}, '
        place += (f"x_axis = {vector(axes[0])}, y_axis = {vector(axes[1])}" if axes
                  else f'angle = "{angle!r} rad"')
        self.add("body", name=f'"{name}"', mass=f'"{mass!r} kg"',
                 center_of_mass=vector(centre, "m"), inertia=vector(inertia, "kg m^2"),
                 placement="{ " + place + " }")

    def joint(self, name, kind, a, b, axis=(0.0, 0.0, 1.0), at=None, point=None, **more):
        where = ({"at": f'{{ {a} = {vector(at[0], "m")}, {b} = {vector(at[1], "m")} }}'}
                 if at else {"point": vector(point, "m")})
        self.add("joint", name=f'"{name}"', type=f'"{kind}"', between=f'["{a}", "{b}"]',
                 **where, **({"axis": vector(axis)} if axis else {}), **more)

    def marker(self, name, body, point):
        self.add("marker", name=f'"{name}"', body=f'"{body}"', point=vector(point, "m"))

    def text(self):
        return "\n".join([self.parts[0], *self.parts[2:], self.parts[1]])


def pinned(scene, name, a, b, at_a, at_b):
    scene.joint(name, "revolute", a, b, at=((*at_a, 0.0), (*at_b, 0.0)))


def turned(p, angle, origin=(0.0, 0.0)):
    c, s = math.cos(angle), math.sin(angle)
    return (origin[0] + c * p[0] - s * p[1], origin[1] + s * p[0] + c * p[1])


def andrews():
    d, e, rr, ss, zf, zt, u = 0.028, 0.02, 0.007, 0.035, 0.02, 0.04, 0.04
    beta, gamma, phi = -0.0617138900142764496, 0.455279819163070380, 0.222668390165885885
    delta, epsilon = 0.487364979543842550, 1.23054744454982120
    A, B = (-0.06934, -0.00227), (-0.03635, 0.03273)
    scene = Scene("Andrews' squeezing mechanism", (0.0, 0.0, 0.0), 0.03, 4)
    for name, mass, inertia, centre, origin, angle in (
            ("K1", 0.04325, 2.194e-6, (0.00092, 0.0), (0.0, 0.0), beta),
            ("K2", 0.00365, 4.410e-7, (-0.0115, 0.0), turned((rr, 0.0), beta), beta),
            ("K3", 0.02373, 5.255e-6, (0.01043, -0.01874), B, gamma),
            ("K4", 0.00706, 5.667e-7, (0.0, 0.01421 - e), turned((zt, 0.0), delta, A),
             phi + delta),
            ("K5", 0.07050, 1.169e-5, (0.02308, 0.00916), A, delta),
            ("K6", 0.00706, 5.667e-7, (zf - 0.01421, 0.0), turned((0.0, -u), epsilon, A),
             epsilon - phi),
            ("K7", 0.05498, 1.912e-5, (-0.00449, -0.01228), A, epsilon)):
        scene.body(name, mass, (*centre, 0.0), (inertia,) * 3, (*origin, 0.0), angle)
    pinned(scene, "O", "ground", "K1", (0.0, 0.0), (0.0, 0.0))
    pinned(scene, "F", "K1", "K2", (rr, 0.0), (0.0, 0.0))
    pinned(scene, "B", "ground", "K3", B, (0.0, 0.0))
    pinned(scene, "A5", "ground", "K5", A, (0.0, 0.0))
    pinned(scene, "H", "K5", "K4", (zt, 0.0), (0.0, 0.0))
    pinned(scene, "A7", "ground", "K7", A, (0.0, 0.0))
    pinned(scene, "G", "K7", "K6", (0.0, -u), (0.0, 0.0))
    pinned(scene, "E3", "K2", "K3", (-d, 0.0), (0.0, -ss))
    pinned(scene, "E4", "K2", "K4", (-d, 0.0), (0.0, -e))
    pinned(scene, "E6", "K2", "K6", (-d, 0.0), (zf, 0.0))
    scene.add("force", type='"spring"', name='"spring"', between='["ground", "K3"]',
              **{"from": vector((0.014, 0.072, 0.0), "m"), "to": vector((0.02, -0.018, 0.0), "m"),
                 "stiffness": '"4530 N/m"', "free": '"0.07785 m"'})
    scene.add("force", type='"constant"', name='"motor"', body='"K1"',
              point=vector((0.0, 0.0, 0.0), "m"), force=vector((0.0, 0.0, 0.0), "N"),
              moment=vector((0.0, 0.0, 0.033), "N m"))
    scene.marker("tip", "K1", (1.0, 0.0, 0.0))
    return scene, lambda m: (m("tip", 0), m("tip", 1), 0.0)


def light_cart_pole():
    scene = Scene("light cart with a pole", (0.0, -9.81, 0.0), 10.0, 11)
    scene.body("cart", 1e-6, (0.0, 0.0, 0.0), (1e-9,) * 3)
    scene.body("pole", 1.0, (1.0, 0.0, 0.0), (1e-9,) * 3)
    scene.joint("rails", "prismatic", "ground", "cart", (1.0, 0.0, 0.0),
                point=(0.0, 0.0, 0.0))
    pinned(scene, "hinge", "cart", "pole", (0.0, 0.0), (0.0, 0.0))
    scene.marker("tip", "pole", (1.0, 0.0, 0.0))
    scene.marker("cart", "cart", (0.0, 0.0, 0.0))
    return scene, lambda m: (m("tip", 0) - m("cart", 0), m("tip", 1) - m("cart", 1),
                             m("cart", 0))


def crank_rocker():
    ground, lengths, phi, spin = 0.20, (0.05, 0.18, 0.12), 0.5, 30.0
    P = turned((lengths[0], 0.0), phi)
    apart = (ground - P[0], -P[1])
    distance = math.hypot(*apart)
    foot = (distance**2 + lengths[1]**2 - lengths[2]**2) / (2.0 * distance)
    coupler = math.atan2(apart[1], apart[0]) + math.acos(foot / lengths[1])
    Q = turned((lengths[1], 0.0), coupler, P)
    rocker = math.atan2(Q[1], Q[0] - ground)
    scene = Scene("crank-rocker", (0.0, -9.81, 0.0), 10.0, 11)
    for name, length, origin, angle in (("crank", lengths[0], (0.0, 0.0), phi),
                                        ("coupler", lengths[1], P, coupler),
                                        ("rocker", lengths[2], (ground, 0.0), rocker)):
        scene.body(name, 2.0 * length, (0.5 * length, 0.0, 0.0), (length**3 / 6.0,) * 3,
                   (*origin, 0.0), angle)
    pinned(scene, "O", "ground", "crank", (0.0, 0.0), (0.0, 0.0))
    pinned(scene, "P", "crank", "coupler", (lengths[0], 0.0), (0.0, 0.0))
    pinned(scene, "G", "ground", "rocker", (ground, 0.0), (0.0, 0.0))
    pinned(scene, "Q", "coupler", "rocker", (lengths[1], 0.0), (lengths[2], 0.0))
    scene.add("initial", joint='"O"', rate=f'"{spin!r} rad/s"')
    scene.marker("tip", "crank", (1.0, 0.0, 0.0))
    return scene, lambda m: (m("tip", 0), m("tip", 1), 0.0)


BAR = (1e-4, 1.0 / 12.0, 1.0 / 12.0)


def two_window_four_bar():
    scene = Scene("two-window four-bar", (0.0, -9.81, 0.0), 10.0, 11)
    for i in range(5):
        name, origin = (f"upright_{i}", (float(i), 0.0, 0.0)) if i < 3 else (
            f"level_{i - 3}", (i - 3.0, 1.0, 0.0))
        scene.body(name, 1.0, (0.5, 0.0, 0.0), BAR, origin,
                   0.5 * math.pi if i < 3 else 0.0)
    for i in range(3):
        pinned(scene, f"A{i}", "ground", f"upright_{i}", (float(i), 0.0), (0.0, 0.0))
    for i in range(2):
        pinned(scene, f"B{i}", f"upright_{i}", f"level_{i}", (1.0, 0.0), (0.0, 0.0))
        pinned(scene, f"C{i}", f"upright_{i + 1}", f"level_{i}", (1.0, 0.0), (1.0, 0.0))
    scene.add("initial", joint='"A0"', rate='"-1 rad/s"')
    scene.marker("tip", "upright_0", (1.0, 0.0, 0.0))
    return scene, lambda m: (m("tip", 0), m("tip", 1), 0.0)


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def unit(a):
    length = math.sqrt(sum(x * x for x in a))
    return tuple(x / length for x in a)


def spatial_slider_crank():
    scene = Scene("spatial slider-crank", (0.0, 0.0, -9.81), 5.0, 51)
    pivot, ball, end = (0.0, 0.1, 0.12), (0.0, 0.1, 0.2), (0.2, 0.0, 0.0)
    x = unit(tuple(b - a for a, b in zip(ball, end)))
    y = unit(cross((1.0, 0.0, 0.0), x))
    scene.body("crank", 0.12, (0.0, 0.0, 0.04), (1e-4,) * 3, pivot)
    scene.body("rod", 0.5, (0.15, 0.0, 0.0), (4e-4, 4e-3, 4e-3), ball, axes=(x, y))
    scene.body("slider", 2.0, (0.0, 0.0, 0.0), (1e-3,) * 3, end)
    along_x = (1.0, 0.0, 0.0)
    scene.joint("crank", "revolute", "ground", "crank", along_x, point=pivot)
    scene.joint("ball", "spherical", "crank", "rod", None, point=ball)
    # z of the slider's side along x, x of the rod's side across it
    scene.joint("hinge", "universal", "slider", "rod", along_x, point=end,
                normal=vector(y))
    scene.joint("guide", "prismatic", "ground", "slider", along_x, point=(0.0, 0.0, 0.0))
    scene.add("initial", joint='"crank"', rate='"6 rad/s"')
    scene.marker("slider", "slider", (0.0, 0.0, 0.0))
    return scene, lambda m: (m("slider", 0), 0.0, 0.0)


def governor():
    angle, middle, free = math.pi / 6.0, 0.5, 0.5
    depth = middle * math.cos(angle) + math.sqrt(free**2 - (middle * math.sin(angle))**2)
    scene = Scene("governor", (0.0, 0.0, -9.81), 10.0, 11)
    scene.body("shaft", 1.0, (0.0, 0.0, 0.0), (0.1,) * 3)
    scene.body("sleeve", 1.0, (0.0, 0.0, 0.0), (0.1,) * 3, (0.0, 0.0, -depth))
    scene.joint("bearing", "revolute", "ground", "shaft", point=(0.0, 0.0, 0.0))
    scene.joint("guide", "prismatic", "shaft", "sleeve", point=(0.0, 0.0, 0.0))
    for name, side in (("left", -1.0), ("right", 1.0)):
        lean = side * angle
        scene.body(name, 6.0, (0.0, 0.0, -0.9), (0.35, 0.35, 0.02),
                   axes=((math.cos(lean), 0.0, math.sin(lean)), (0.0, 1.0, 0.0)))
        scene.joint(f"hinge_{name}", "revolute", "shaft", name, (0.0, 1.0, 0.0),
                    point=(0.0, 0.0, 0.0))
        scene.add("force", type='"spring"', name=f'"spring_{name}"',
                  between=f'["{name}", "sleeve"]',
                  **{"from": vector((0.0, 0.0, -middle), "m"),
                     "to": vector((0.0, 0.0, 0.0), "m"), "stiffness": '"8e5 N/m"',
                     "damping": '"4e4 N s/m"', "free": f'"{free!r} m"'})
    scene.add("initial", joint='"bearing"', rate=f'"{2.0 * math.pi!r} rad/s"')
    scene.marker("sleeve", "sleeve", (0.0, 0.0, 0.0))
    return scene, lambda m: (0.0, 0.0, m("sleeve", 2))


def bricard():
    corners = [(0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (1.0, -1.0, 0.0), (1.0, -1.0, 1.0),
               (0.0, -1.0, 1.0), (0.0, 0.0, 1.0)]
    scene = Scene("Bricard's mechanism", (0.0, -9.81, 0.0), 10.0, 11)
    along = [tuple(b - a for a, b in zip(corners[i], corners[(i + 1) % 6])) for i in range(6)]
    axes = [cross(along[i - 1], along[i]) for i in range(6)]
    names = [f"bar_{i}" for i in range(5)] + ["ground"]
    for i in range(5):
        scene.body(names[i], 1.0, (0.5, 0.0, 0.0), BAR, corners[i],
                   axes=(along[i], cross(axes[i], along[i])))
    for i in range(6):
        scene.joint(f"hinge_{i}", "revolute", names[i - 1], names[i], axes[i],
                    point=corners[i])
    scene.marker("corner", "bar_3", (0.0, 0.0, 0.0))
    return scene, lambda m: tuple(m("corner", k) for k in range(3))


SCENES = {"andrews": andrews, "light_cart_pole": light_cart_pole, "governor": governor,
          "bricard": bricard, "two_window_four_bar": two_window_four_bar,
          "crank_rocker": crank_rocker, "spatial_slider_crank": spatial_slider_crank}


def references(problem):
    """{time [s]: point}."""
    with open(REFERENCES, newline="") as file:
        return {float(row["t_s"]): tuple(float(row[k]) for k in "xyz")
                for row in csv.DictReader(file) if row["problem"] == problem}


def error(problem, folder):
    """Largest distance from the known points of what `clevis simulate` wrote [m]."""
    point = SCENES[problem]()[1]
    known, worst, met = references(problem), 0.0, 0
    with open(Path(folder) / "motion.csv", newline="") as file:
        for row in csv.DictReader(file):
            t = min(known, key=lambda at: abs(at - float(row["t_s"])))
            if abs(t - float(row["t_s"])) > 1e-9:
                continue
            here = point(lambda name, k: 1e-3 * float(row[f"{name}.marker_{'xyz'[k]}_mm"]))
            worst, met = max(worst, math.dist(here, known[t])), met + 1
    if met != len(known):
        raise RuntimeError(f"{problem}: {met} of {len(known)} known instants")
    return worst

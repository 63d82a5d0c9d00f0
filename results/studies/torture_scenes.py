"""Scenes whose loads act for moments only, drawn at random.

Each has what must be found (a closed form, by joint, drive or force, where
there is one) and is run again with fifty times the instants.
"""
import math
import random

MM = 1e-3
MOST_INSTANTS = 100_000


class Scene:
    """A scene file in the making; `truth` has largest loads by closed form."""

    def __init__(self, kind, instants, duration=1.0, motion=None):
        self.kind, self.instants, self.duration = kind, instants, duration
        self.blocks, self.truth, self.motion = [], {}, motion
        self.gravity = [0.0, 0.0, 0.0]

    def add(self, table, **keys):
        lines = [f"[[{table}]]"]
        lines += [f"{key} = {toml(value)}" for key, value in keys.items()]
        self.blocks.append("\n".join(lines))

    def text(self, times=1, most=MOST_INSTANTS):
        instants = min((self.instants - 1) * times + 1,
                       max(most, self.instants))
        head = [f'schema = 1\nname = "{self.kind}"\n[world]\ngravity = '
                + toml([f"{g:.9g} m/s^2" for g in self.gravity])]
        tail = [f'[simulation]\nduration = "{self.duration:.12g} s"\n'
                f"instants = {instants}"]
        if self.motion:
            tail.append(f'motion = "{self.motion}"')
        return "\n\n".join(head + self.blocks) + "\n\n" + "\n".join(tail) + "\n"

    def body(self, name, mass=1.0, com=(0, 0, 0), inertia=1e-3, **more):
        self.add("body", name=name, mass=f"{mass:.12g} kg",
                 center_of_mass=lengths(com),
                 inertia=[f"{inertia:.9g} kg m^2"] * 3, **more)


def toml(value):
    if isinstance(value, str):
        return f'"{value}"'
    if isinstance(value, dict):
        return ("{ " + ", ".join(f"{k} = {toml(v)}" for k, v in value.items())
                + " }")
    if isinstance(value, (list, tuple)):
        return "[" + ", ".join(toml(v) for v in value) + "]"
    return f"{value}"


def lengths(vector):
    return [f"{x:.15g} m" for x in vector]


def seconds(times):
    return [f"{t:.15g} s" for t in times]


def instants_of(rng):
    return rng.choice([2, 3, 5, 11, 16, 21, 51, 101, 201, 201, 501, 2001])


def log_uniform(rng, low, high):
    return math.exp(rng.uniform(math.log(low), math.log(high)))


def slider(scene, name="block", mass=1.0):
    scene.body(name, mass)
    scene.add("joint", name=f"guide_{name}", type="prismatic",
              between=["ground", name], point=lengths((0, 0, 0)),
              axis=[1, 0, 0])


def crank(scene, rate, length=0.1, mass=0.5):
    """Turns at a constant rate [rad/s] from 0 on; centre of mass half way."""
    scene.body("crank", mass, (length / 2, 0, 0))
    scene.add("joint", name="hinge", type="revolute",
              between=["ground", "crank"], point=lengths((0, 0, 0)),
              axis=[0, 0, 1])
    scene.add("drive", joint="hinge", law="speed", **{"from": "0 rad"},
              speed=f"{rate:.15g} rad/s")


def pulses(rng, duration, most=4):
    """Times and efforts of pulses that do not overlap, and the largest."""
    times, efforts = [0.0], [0.0]
    count = rng.randint(1, most)
    room = duration / count
    for k in range(count):
        width = min(log_uniform(rng, 1e-5, 0.1) * duration, 0.9 * room)
        start = room * k + rng.uniform(0.01, 0.99) * (room - width) + 1e-9
        top = rng.choice([-1, 1]) * log_uniform(rng, 10, 2000)
        if rng.random() < 0.5:  # a step up and down again
            times += [start, start, start + width, start + width]
            efforts += [0.0, top, top, 0.0]
        else:
            times += [start, start + width * rng.uniform(0.1, 0.9),
                      start + width]
            efforts += [0.0, top, 0.0]
    return times, efforts, max(abs(e) for e in efforts)


def pulse_on_a_held_block(rng):
    scene = Scene("pulse on a held block", instants_of(rng))
    slider(scene)
    scene.add("drive", joint="guide_block", law="constant", **{"from": "0 m"})
    times, efforts, most = pulses(rng, scene.duration)
    scene.add("force", name="pulse", type="table", joint="guide_block",
              times=seconds(times), efforts=[f"{e:.12g} N" for e in efforts])
    scene.truth = {"drive guide_block": most, "force pulse": most}
    return scene


def pulse_on_a_crank(rng):
    """The drive's torque: gravity's cosine and the pulse."""
    scene = Scene("pulse on a turning crank", instants_of(rng))
    scene.gravity = [0.0, -9.81, 0.0]
    rate = rng.uniform(1, 40)
    crank(scene, rate)
    times, efforts, most = pulses(rng, scene.duration)
    scene.add("force", name="pulse", type="table", joint="hinge",
              times=seconds(times), efforts=[f"{e:.12g} N m" for e in efforts])

    def effort(t, side):
        i = max(k for k in range(len(times)) if times[k] <= t - side * 1e-13)
        if i + 1 == len(times):
            return efforts[i]
        part = (t - times[i]) / (times[i + 1] - times[i])
        return efforts[i] + part * (efforts[i + 1] - efforts[i])

    def torque(t, side):
        return 0.5 * 9.81 * 0.05 * math.cos(rate * t) - effort(t, side)

    grid = [scene.duration * k / 20000 for k in range(1, 20001)]
    ends = [abs(torque(t, side)) for t in times[1:] for side in (-1, 1)]
    scene.truth = {"force pulse": most, "drive hinge":
                   max(ends + [abs(torque(t, 0)) for t in grid])}
    return scene


def sine_of_a_block(rng):
    scene = Scene("sine of a block", instants_of(rng))
    slider(scene)
    frequency = rng.choice([1, 2, 5, 10, 12.5, 25, 50, 100, 200,
                            rng.uniform(1, 300)])
    amplitude = log_uniform(rng, 1e-4, 0.1)
    scene.add("drive", joint="guide_block", law="sine", **{"from": "0 m"},
              amplitude=f"{amplitude:.15g} m", frequency=f"{frequency:.15g} Hz")
    omega = 2 * math.pi * frequency
    if frequency * scene.duration >= 1:
        scene.truth = {"drive guide_block": amplitude * omega**2}
    return scene


def two_sines(rng):
    """A spring between two blocks on drives of their own."""
    scene = Scene("two sines and a spring", instants_of(rng))
    drives = []
    for name in ("left", "right"):
        slider(scene, name)
        f, a = rng.uniform(1, 60), log_uniform(rng, 1e-3, 0.05)
        drives.append((f, a))
        scene.add("drive", joint=f"guide_{name}", law="sine",
                  **{"from": "0 m"}, amplitude=f"{a:.15g} m",
                  frequency=f"{f:.15g} Hz")
    scene.add("force", name="spring", type="spring", between=["left", "right"],
              **{"from": lengths((0, 0, 0))}, to=lengths((0, 0, 0)),
              axis=[1, 0, 0], stiffness="1e5 N/m", free="0 m")
    (f, a), (g, b) = drives
    scene.truth = {"force spring": 1e5 * max(
        abs(a * math.sin(2 * math.pi * f * t) - b * math.sin(2 * math.pi * g * t))
        for t in (k / 100000 for k in range(100001)))}
    return scene


def quick_quintic(rng):
    duration = log_uniform(rng, 0.1, 20)
    scene = Scene("quick quintic", instants_of(rng), duration)
    slider(scene)
    quick = log_uniform(rng, 1e-4, 0.3) * duration
    start = rng.uniform(0, duration - quick)
    stroke = rng.choice([-1, 1]) * log_uniform(rng, 1e-3, 0.2)
    scene.add("drive", joint="guide_block", law="quintic", **{"from": "0 m"},
              to=f"{stroke:.15g} m", start=f"{start:.15g} s",
              duration=f"{quick:.15g} s")
    scene.truth = {"drive guide_block":
                   10 / math.sqrt(3) * abs(stroke) / quick**2}
    return scene


def ball_on_a_plate(rng):
    """A crank's ball dips into a plate, or just does not, once a turn."""
    scene = Scene("crank's ball and plate", instants_of(rng))
    rate = 2 * math.pi * rng.choice([1, 3, 10, 25, rng.uniform(1, 40)])
    crank(scene, rate)
    depth = rng.choice([-1, 1, 1, 1]) * log_uniform(rng, 1e-8, 5e-4)
    stiffness = log_uniform(rng, 1e5, 1e8)
    model = rng.choice(["penalty", "hunt-crossley", "damped"])
    more = {"damping": "0 N s/m"}
    if model == "hunt-crossley":
        more = {"damping": "0.1 s/m", "model": model,
                "stiffness": f"{stiffness:.12g} N/m^1.5"}
    elif model == "damped":
        more = {"damping": f"{1e-4 * stiffness:.12g} N s/m"}
    keys = {"stiffness": f"{stiffness:.12g} N/m"} | more
    scene.add("force", name="plate", type="contact", body="crank",
              center=lengths((0.1, 0, 0)), radius="5 mm",
              plane_point=lengths((0, 0.105 - depth, 0)), normal=[0, -1, 0],
              **keys)
    if model == "penalty":
        scene.truth = {"force plate": stiffness * max(depth, 0.0)}
    return scene


def stop_of_a_sine(rng):
    scene = Scene("sine against a stop", instants_of(rng))
    slider(scene)
    amplitude = 0.05
    frequency = rng.uniform(1, 30)
    depth = rng.choice([-1, 1, 1, 1]) * log_uniform(rng, 1e-8, 1e-2)
    stiffness = log_uniform(rng, 1e4, 1e8)
    scene.add("drive", joint="guide_block", law="sine", **{"from": "0 m"},
              amplitude=f"{amplitude} m", frequency=f"{frequency:.15g} Hz")
    scene.add("force", name="stop", type="stop", joint="guide_block",
              upper=f"{amplitude - depth:.15g} m",
              stiffness=f"{stiffness:.12g} N/m", damping="0 N s/m")
    scene.truth = {"force stop": stiffness * max(depth, 0.0)}
    return scene


def cam(rng):
    """A table over the angle of a crank, with narrow teeth."""
    scene = Scene("cam", instants_of(rng))
    rate = rng.uniform(1, 30)
    crank(scene, rate)
    reach = rate * scene.duration
    positions, efforts = [0.0], [0.0]
    for _ in range(rng.randint(1, 6)):
        width = log_uniform(rng, 1e-5, 0.2)
        start = positions[-1] + log_uniform(rng, 1e-3, 3.0)
        positions += [start, start + width / 2, start + width]
        efforts += [0.0, rng.choice([-1, 1]) * log_uniform(rng, 1, 500), 0.0]
    scene.add("force", name="cam", type="table", joint="hinge",
              positions=[f"{q:.15g} rad" for q in positions],
              efforts=[f"{e:.12g} N m" for e in efforts])
    most = 0.0
    for i, q in enumerate(positions):
        if q <= reach:
            most = max(most, abs(efforts[i]))
        elif positions[i - 1] < reach:
            part = (reach - positions[i - 1]) / (q - positions[i - 1])
            most = max(most, abs(efforts[i - 1] + part
                                 * (efforts[i] - efforts[i - 1])))
    scene.truth = {"force cam": most}
    return scene


def one_sense(rng):
    """A force that acts forward only on a block that a sine moves."""
    scene = Scene("force on one sense", instants_of(rng))
    slider(scene)
    frequency, amplitude = rng.uniform(1.1, 20), 0.02
    scene.add("drive", joint="guide_block", law="sine", **{"from": "0 m"},
              amplitude=f"{amplitude} m", frequency=f"{frequency:.15g} Hz")
    cut = log_uniform(rng, 1, 1000)
    sense = rng.choice(["increasing", "decreasing"])
    scene.add("force", name="cut", type="table", joint="guide_block",
              times=["0 s"], efforts=[f"{-cut:.12g} N"], acts_on=sense)
    inertia = amplitude * (2 * math.pi * frequency) ** 2
    # at the bottom inertia and the cut add up, before or behind the turn
    scene.truth = {"force cut": cut, "drive guide_block": inertia + cut}
    return scene


def four_bar(rng, with_part=False):
    """A loop of pins, its crank fast; loads without closed form. Its coupler is
    the link of the studies, 0.2 m long, if a part is wanted."""
    scene = Scene("four-bar", instants_of(rng))
    if with_part:
        scene.blocks.append(COUPLER)
    scene.gravity = [0.0, -9.81, 0.0]
    a, b, c, d = 0.05, 0.2, 0.15, 0.22
    q = 0.7
    pin = (a * math.cos(q), a * math.sin(q))
    dx, dy = d - pin[0], -pin[1]
    reach = math.hypot(dx, dy)
    turn = math.atan2(dy, dx)
    up = math.acos((b * b + reach * reach - c * c) / (2 * b * reach))
    coupler = turn + up
    end = (pin[0] + b * math.cos(coupler), pin[1] + b * math.sin(coupler))
    rocker = math.atan2(end[1], end[0] - d)
    for name, origin, angle, length in (
            ("crank", (0, 0), q, a), ("coupler", pin, coupler, b),
            ("rocker", (d, 0), rocker, c)):
        placement = {"origin": lengths((*origin, 0)),
                     "angle": f"{angle:.15g} rad"}
        if with_part and name == "coupler":
            scene.add("body", name=name, part=name, placement=placement)
        else:
            scene.body(name, 0.3, (length / 2, 0, 0), 1e-4,
                       placement=placement)
    for name, pair, points in (
            ("A", ("ground", "crank"), ((0, 0), (0, 0))),
            ("B", ("crank", "coupler"), ((a, 0), (0, 0))),
            ("C", ("coupler", "rocker"), ((b, 0), (c, 0))),
            ("D", ("ground", "rocker"), ((d, 0), (0, 0)))):
        scene.add("joint", name=name, type="revolute", between=list(pair),
                  at={body: lengths((*p, 0)) for body, p in zip(pair, points)},
                  axis=[0, 0, 1])
    law = rng.choice(["speed", "sine", "quintic"])
    keys = {"speed": {"speed": f"{rng.uniform(5, 300):.12g} rad/s"},
            "sine": {"amplitude": f"{rng.uniform(0.1, 2):.12g} rad",
                     "frequency": f"{rng.uniform(1, 40):.12g} Hz"},
            "quintic": {"to": f"{q + rng.uniform(0.5, 12):.12g} rad",
                        "start": f"{rng.uniform(0, 0.5):.12g} s",
                        "duration": f"{log_uniform(rng, 0.01, 0.5):.12g} s"}}
    scene.add("drive", joint="A", law=law, **{"from": f"{q:.15g} rad"},
              **keys[law])
    if rng.random() < 0.5:
        times, efforts, _ = pulses(rng, scene.duration)
        scene.add("force", name="pulse", type="table", joint="D",
                  times=seconds(times),
                  efforts=[f"{e / 20:.12g} N m" for e in efforts])
    return scene


COUPLER = """[material.steel]
youngs_modulus = "210 GPa"
poissons_ratio = 0.3
density = "7850 kg/m^3"
yield_strength = "355 MPa"

[accuracy]
peak_stress = "5 %"

[[part]]
name = "coupler"
geometry = "link.geo"
length_unit = "mm"
material = "steel"
pins = { B = "bore_A", C = "bore_B" }
limits = { safety_factor = 1.5 }"""


def free_block(rng):
    """A block on a spring, integrated, under pulses and against a stop."""
    scene = Scene("free block", instants_of(rng), motion="dynamic")
    slider(scene)
    scene.add("force", name="spring", type="spring", joint="guide_block",
              stiffness=f"{log_uniform(rng, 100, 1e5):.12g} N/m",
              damping="2 N s/m", free="0 m")
    times, efforts, most = pulses(rng, scene.duration)
    scene.add("force", name="pulse", type="table", joint="guide_block",
              times=seconds(times), efforts=[f"{e:.12g} N" for e in efforts])
    scene.truth = {"force pulse": most}
    if rng.random() < 0.5:
        scene.add("force", name="stop", type="stop", joint="guide_block",
                  upper=f"{log_uniform(rng, 1e-5, 1e-2):.12g} m",
                  stiffness=f"{log_uniform(rng, 1e5, 1e7):.12g} N/m",
                  damping="10 N s/m")
    return scene


def falling_block(rng):
    """Falls on the ground, elastic: the first blow is the hardest."""
    scene = Scene("falling block", instants_of(rng), motion="dynamic")
    mass, height = rng.uniform(0.1, 10), log_uniform(rng, 0.01, 1)
    scene.gravity = [-9.81, 0.0, 0.0]
    slider(scene, mass=mass)
    stiffness = log_uniform(rng, 1e5, 1e9)
    scene.add("force", name="ground", type="stop", joint="guide_block",
              lower=f"{-height:.15g} m", stiffness=f"{stiffness:.12g} N/m",
              damping="0 N s/m")
    speed = math.sqrt(2 * 9.81 * height)
    weight = mass * 9.81
    if speed / 9.81 + 4 * math.sqrt(mass / stiffness) < scene.duration:
        scene.truth = {"force ground": weight + math.sqrt(
            weight**2 + stiffness * mass * speed**2)}
    return scene


KINDS = [pulse_on_a_held_block, pulse_on_a_crank, sine_of_a_block, two_sines,
         quick_quintic, ball_on_a_plate, stop_of_a_sine, cam, one_sense,
         four_bar, free_block, falling_block]


def draw_parts(seed, count):
    """`count` four-bars whose coupler is a part."""
    for k in range(count):
        yield four_bar(random.Random(seed * 2_000_003 + k), with_part=True)


def draw(seed, count):
    """`count` scenes, the kinds in turn; the same for the same seed."""
    for k in range(count):
        rng = random.Random(seed * 1_000_003 + k)
        yield KINDS[k % len(KINDS)](rng)

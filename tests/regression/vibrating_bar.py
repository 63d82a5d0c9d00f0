#!/usr/bin/env python3
"""A part of a mechanism that vibrates under an impact, from scene to files.

    vibrating_bar.py CLEVIS

A bar slides with a block at its back against a stop. Of rigid bodies stop and
block press on both ends for a time in which a wave runs along the bar once and
a half: over long before the bar bends, and yet the block, a mass welded to it,
throws d'Alembert's wave back with nearly twice the force. Then the bar rings on.
The block left out, the stress nowhere exceeds that at the stop. History and fields
are those of the instants' loads.

Pulled at both ends at once, long after a soft touch, by a sharp ramp or by stairs
the bar has twice the pull in its middle where the waves meet, however many
instants are asked for; after a ramp of its period nothing, and by a sine of its
period four times more each cycle. Triangles whose corners alone are known are
straight between them.
"""
import csv
import math
import sys
import tempfile
from pathlib import Path

import scene_text
import support

LENGTH, SIDE, MODULUS, DENSITY = 0.2, 0.01, 210e9, 7850.0
AREA = SIDE**2
MASS = DENSITY * AREA * LENGTH
SPEED, STIFFNESS = 0.1, 7e9
NEAR = 0.01
MATERIAL = support.steel(ratio=0.0)
STEP = [(0, 0), (0.1, 0), (0.1, 1)]  # times [ms] and shares

PULL = 4000.0  # [N]
PERIOD = 2e3 * LENGTH * math.sqrt(DENSITY / MODULUS)  # first along the bar [ms]


def block_text(mass, center, end):
    """A block welded to the bar; center and end along x [mm]."""
    return scene_text.body(
        "block", f"{mass} kg", "1000 kg mm^2", (center, 0, 0)) + scene_text.joint(
            "end", "weld", "block", "bar", (end, 0, 0))


def pulls(law, ends=("x0", "x1"), pulled="bar"):
    """law: times [ms] and shares of PULL."""
    times = ", ".join(f'"{time:.9g} ms"' for time, _ in law)
    return "".join(f"""[[force]]
name = "pull_{face}"
type = "table"
between = ["ground", "{pulled}"]
from = ["{x - 500} mm", "0 mm", "0 mm"]
to = ["{x} mm", "0 mm", "0 mm"]
axis = [1, 0, 0]
times = [{times}]
efforts = [{", ".join(f'"{side * share * PULL:.9g} N"' for _, share in law)}]
""" for face, x, side in (("x0", 0, -1), ("x1", 200, 1)) if face in ends)


def write_bar(folder, cells=20):
    scene_text.write_bar(folder, (LENGTH, SIDE, SIDE), (cells, 1, 1))


def bar_scene(folder, name, mechanism, pins, faces, duration="0.5 ms", instants=201,
              damping=0, links=""):
    """faces: those of the forces."""
    write_bar(folder)
    scene = folder / "scene.toml"
    scene.write_text(scene_text.head(name, MATERIAL) + scene_text.part_body("bar") +
                     mechanism + f"""[simulation]
duration = "{duration}"
instants = {instants}
tolerance = 1e-9
{links}{scene_text.BAR}damping = {damping}
pins = {{ {pins} }}
limits = {{ safety_factor = 2.0 }}
[part.forces]
{faces}""")
    return scene


def write_scene(folder, block, speed=SPEED, stiffness=STIFFNESS, upper=0.01, more="",
                faces="", instants=201, damping=0):
    """It slides against a stop."""
    end = ', end = "x0"' if block else ""
    slide = scene_text.joint("slide", "prismatic", "ground", "bar", axis=(1, 0, 0))
    return bar_scene(
        folder, "bar against a stop", (block_text(2, -50, 0) if block else "") +
        slide + f"""[[initial]]
joint = "slide"
rate = "{speed} m/s"
[[force]]
type = "stop"
name = "stop"
joint = "slide"
upper = "{upper} mm"
stiffness = "{stiffness} N/m"
damping = "0 N s/m"
transition = "1e-6 mm"
{more}""", f'slide = {{ group = "y0", length = "200 mm" }}{end}',
        f'stop = {{ face = "x1" }}\n{faces}', instants=instants, damping=damping)


def waves(block, steps=200):
    """Force of the stop [N], and where the stress in the bar is largest and how
    large [mm], [MPa]: d'Alembert's waves between the stop, whose force is that on
    rigid bodies, and the block, a mass."""
    wave, rate = math.sqrt(MODULUS / DENSITY), math.sqrt(STIFFNESS / (MASS + block))
    peak = SPEED * math.sqrt(STIFFNESS * (MASS + block))
    impedance = MODULUS * AREA / wave
    step = LENGTH / wave / steps
    decay = math.exp(-impedance / block * step) if block else 0.0
    count = int(4e-4 / step)
    f, g, v = [], [], 0.0  # rates of the waves at the block, its speed
    for i in range(count + steps):
        time = (i + 0.5) * step - LENGTH / wave
        force = peak * math.sin(rate * time) if 0.0 < time < math.pi / rate else 0.0
        f.append(force / impedance + (g[i - 2 * steps] if i >= 2 * steps else 0.0))
        after = v * decay + 2.0 * f[i] * (1.0 - decay)
        mean = 2.0 * f[i] + ((v - after) * block / impedance / step if block else 0.0)
        g.append(mean - f[i])
        v = after
    most, at = max((abs(f[i + j] - g[i - j]), j)
                   for j in range(steps + 1) for i in range(j, count - j))
    if not block:
        at = steps  # first; anywhere else later
    return peak, 1e3 * LENGTH * at / steps, most * impedance / AREA / 1e6


def check(clevis, block, expect):
    force, place, exact = waves(block)
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        found = support.check(clevis, write_scene(folder, block))
        part = found.part
        with (folder / "out/bar_history.csv").open() as file:
            history = max(float(row["peak_von_mises_MPa"])
                          for row in csv.DictReader(file))
        fields = (folder / "out/bar.vtu").exists()
    still = part["peak_von_mises"]["value_MPa"]
    vibration = part["vibration"]
    expect("at rest, block or not: the stop's force over the section", still,
           force / AREA / 1e6)
    expect("history", history, still)
    expect("fields", fields, True)
    if not vibration:
        expect("not exceeded", exact, still)
        return found.code
    expect("with vibration", vibration["peak_MPa"], exact)
    expect("band above", vibration["band_MPa"][1] > exact, True)
    expect("ratio", vibration["ratio"], exact / still)
    away = abs(vibration["at_mm"][0] - place)
    expect(f"place {away:.1f} mm off", away < 0.02e3 * LENGTH, True)
    expect("safety factor", part["safety_factor"], 355 / exact)
    return found.code


def check_pull(clevis, what, law, exact, expect, **scene):
    """exact: with vibration, over PULL."""
    faces = "".join(f'pull_{face} = {{ face = "{face}" }}\n'
                    for face in ("x0", "x1"))
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        part = support.check(clevis, write_scene(
            folder, False, more=pulls(law), faces=faces, **scene)).part
    still = PULL / AREA / 1e6
    expect(f"{what}: at rest", part["peak_von_mises"]["value_MPa"], still)
    vibration = part["vibration"]
    if not vibration:
        expect(f"{what}: not exceeded", exact, 1.0)
        return
    expect(f"{what}: with vibration", vibration["peak_MPa"], exact * still)
    low, high = vibration["band_MPa"]
    expect(f"{what}: band {low:.2f} to {high:.2f}",
           low <= exact * still <= high, True)


def check_pulls(clevis, expect):
    """The touch of the stop leaves the bar with 0.4 MPa; then a jump."""
    touch = dict(speed=0.01, stiffness=1e8, upper=0.001, damping=0.003)
    jump = [(0, 0), (0.35, 0), (0.35, 1)]
    for instants in (3, 1001):
        check_pull(clevis, f"jump, {instants} instants", jump, 2.0, expect,
                   instants=instants, **touch)
    alone = dict(speed=0, upper=1)
    check_pull(clevis, "ramp of 1 us", [(0, 0), (0.1, 0), (0.101, 1)], 2.0,
               expect, **alone)
    check_pull(clevis, "ramp of a period",
               [(0, 0), (0.1, 0), (0.1 + PERIOD, 1)], 1.0, expect, **alone)
    stairs = [(0, 0)]
    for i in range(60):
        at = 0.1 + 1e-4 * i
        stairs += [(at, i / 60), (at, (i + 1) / 60)]
    check_pull(clevis, "stairs", stairs, 2.0, expect, **alone)
    # Four times more each cycle: 4/pi of the pull in the middle, by pi/2 each
    # half cycle.
    cycles, each = 3, 48
    sine = [(0, 0)] + [(0.05 + PERIOD * i / each, math.sin(2 * math.pi * i / each))
                       for i in range(cycles * each + 1)]
    check_pull(clevis, "sine", sine, 4.0 * cycles, expect, **alone)
    check_pull(clevis, "slow", [(0, 0), (0.5, 1)], 1.0, expect, **alone)


def check_welded(clevis, expect):
    """Welded to the ground at one end and pulled at the other at once: the wave
    comes back from the weld with twice the pull. A free bar would have less."""
    with tempfile.TemporaryDirectory() as name:
        scene = bar_scene(Path(name), "bar pulled at one end",
                          scene_text.joint("held", "weld", "ground", "bar") +
                          pulls(STEP, ("x1",)),
                          'held = "x0"', 'pull_x1 = { face = "x1" }\n')
        found = support.check(clevis, scene)
        part = found.part
    still = PULL / AREA / 1e6
    expect("welded: at rest", part["peak_von_mises"]["value_MPa"], still)
    expect("welded: with vibration", part["vibration"]["peak_MPa"], 2.0 * still)
    low, high = part["vibration"]["band_MPa"]
    expect(f"welded: band {low:.2f} to {high:.2f}", low <= 2.0 * still <= high, True)


def check_triangles(clevis, expect, edges=8):
    """Welded to the ground at one end and pulled at the other by a triangle each three
    periods, known at its corners: the third of its waves runs with the bar's own. At the
    weld is twice what came in, less what came in half a period before, and so on."""
    period = 2 * PERIOD  # [ms]
    law = [(1.5 * period * k, k % 2) for k in range(edges + 1)]

    def pull(t):
        k = int(t / (1.5 * period))
        if t < 0 or k >= edges:
            return 0.0
        share = t / (1.5 * period) - k
        return share if k % 2 == 0 else 1.0 - share

    def at_weld(t):
        return 2 * sum((-1)**k * pull(t - (2 * k + 1) * PERIOD / 2)
                       for k in range(int(t / PERIOD) + 1))

    exact = max(abs(at_weld(period * i / 500)) for i in range(500 * 2 * edges))
    for instants in (3, 41):
        with tempfile.TemporaryDirectory() as name:
            scene = bar_scene(
                Path(name), "bar pulled by triangles",
                scene_text.joint("held", "weld", "ground", "bar") +
                pulls(law, ("x1",)), 'held = "x0"', 'pull_x1 = { face = "x1" }\n',
                duration=f"{3 * edges * PERIOD * 1.5:.9g} ms", instants=instants)
            write_bar(Path(name), 40)
            part = support.check(clevis, scene, exits=support.JUDGED).part
        vibration = part["vibration"]
        still = PULL / AREA / 1e6
        expect(f"triangles, {instants} instants", vibration["peak_MPa"], exact * still)
        low, high = vibration["band_MPa"]
        expect(f"triangles: band {low:.2f} to {high:.2f}",
               low <= exact * still <= high, True)


def struck_peak(block, end, count=400):
    """Largest stress at the root of the bar over that at rest, a mass at its tip
    pulled at once, until `end` [s]: by modes beta tan beta = MASS/block."""
    modes = []
    for n in range(count):
        low, high = n * math.pi, (n + 0.5) * math.pi
        for _ in range(100):
            beta = 0.5 * (low + high)
            low, high = ((beta, high) if beta * math.tan(beta) * block < MASS
                         else (low, beta))
        share = block / MASS
        square = 0.5 - math.sin(2 * beta) / (4 * beta) + share * math.sin(beta)**2
        load = ((math.sin(beta) - beta * math.cos(beta)) / beta**2 +
                share * math.sin(beta))
        modes.append((beta * math.sqrt(MODULUS / DENSITY) / LENGTH,
                      load / square * beta))
    return max(1.0 - sum(c * math.cos(w * end * i / 4000) for w, c in modes)
               for i in range(4001))


def check_weighed(clevis, expect, block=0.3):
    """Welded to the ground at one end, a block at the other that is pulled at
    once: it swings on the bar, and its wave runs along it."""
    with tempfile.TemporaryDirectory() as name:
        scene = bar_scene(Path(name), "block on a bar",
                          block_text(block, 200, 200) +
                          scene_text.joint("held", "weld", "ground", "bar") +
                          pulls([(0, 0), (0.05, 0), (0.05, 1)], ("x1",), "block"),
                          'held = "x0", end = "x1"', "")
        found = support.check(clevis, scene)
        part = found.part
    still = PULL / AREA / 1e6
    expect("weighed: at rest", part["peak_von_mises"]["value_MPa"], still)
    exact = struck_peak(block, 0.45e-3) * still
    expect("weighed: with vibration", part["vibration"]["peak_MPa"], exact)
    low, high = part["vibration"]["band_MPa"]
    expect(f"weighed: band {low:.2f} to {high:.2f}", low <= exact <= high, True)


def check_redundant(clevis, expect):
    """Welded to the ground at both ends and pushed across: what shares its reactions
    as if it were rigid has no vibration; with its own stiffness it has twice the
    stress at rest."""
    found = {}
    for links in ("rigid", "elastic"):
        with tempfile.TemporaryDirectory() as name:
            welds = "".join(scene_text.joint(f"weld_{face}", "weld", "ground", "bar", (x, 0, 0))
                            for face, x in (("x0", 0), ("x1", 200)))
            push = '''[[force]]
name = "push"
type = "table"
between = ["ground", "bar"]
from = ["100 mm", "500 mm", "0 mm"]
to = ["100 mm", "5 mm", "0 mm"]
axis = [0, 1, 0]
times = ["0 ms", "0.05 ms", "0.05 ms"]
efforts = ["0 N", "0 N", "-200 N"]
'''
            scene = bar_scene(Path(name), "bar between welds", welds + push,
                              'weld_x0 = "x0", weld_x1 = "x1"',
                              'push = { face = "y1" }\n', duration="4 ms",
                              damping=0.02, links=f'links = "{links}"\n')
            found[links] = support.check(clevis, scene)
    rigid, elastic = found["rigid"].part["vibration"], found["elastic"].part["vibration"]
    expect("redundant, shared as rigid: F008", "F008" in str(rigid), True)
    expect("redundant, elastic: between 1.7 and 2.1 times at rest",
           1.7 < elastic["ratio"] < 2.1, True)


BED = 1e12  # [N/m^3]


def bedded_peak(ramp, end, steps=100):
    """Largest stress of the bar on a bed, its tip pulled within `ramp` [s] from
    time 0 to `end` [MPa]: by d'Alembert's waves f(t + x/c) + g(t - x/c), `steps`
    times per transit."""
    speed = math.sqrt(MODULUS / DENSITY)
    impedance = MODULUS * AREA / speed
    rate, step = BED * AREA / impedance, LENGTH / speed / steps
    count, decay = int(end / step), math.exp(-rate * step)
    f, g, u = [], [], 0.0  # rates of f and g at the bed, its displacement
    for i in range(count + steps):
        time = (i + 0.5) * step - LENGTH / speed
        share = 0.0 if time < 0.0 else 1.0 if time >= ramp else time / ramp
        f.append(share * PULL / impedance + (g[i - 2 * steps] if i >= 2 * steps else 0.0))
        after = u * decay + 2.0 * f[i] / rate * (1.0 - decay)
        g.append((after - u) / step - f[i])
        u = after
    return impedance / AREA / 1e6 * max(
        abs(f[i + j] - g[i - j]) for j in range(steps + 1) for i in range(j, count - j))


def check_bedded(clevis, expect):
    """On a bed waves thrown back grow sharper and sharper: after a step the mesh
    cannot follow, and the band says so."""
    for ramp in (20e-6, 5e-6, 0.0):
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            write_bar(folder)
            scene = folder / "scene.toml"
            scene.write_text(scene_text.head("bench", MATERIAL, world="") +
                             scene_text.BAR + f"""[[part.history]]
name = "pull"
file = "pull.csv"
faces = {{ tip = "x1" }}
foundation = {{ x0 = "{BED} N/m^3" }}
interpolation = "linear"
""")
            rows = ((0.0, 0), (0.3, 0), (0.3 + 1e3 * ramp, 1), (2.0, 1))
            (folder / "pull.csv").write_text("time [ms],tip.force_x [N]\n" + "".join(
                f"{time:.9g},{share * PULL}\n" for time, share in rows))
            found = support.check(clevis, scene).part["vibration"]
        exact = bedded_peak(ramp, 1.7e-3)
        low, high = found["band_MPa"]
        what = f"bed, ramp of {1e6 * ramp:g} us"
        if ramp == 20e-6:
            expect(f"{what}: with vibration", found["peak_MPa"], exact)
        expect(f"{what}: band {low:.2f} to {high:.2f} of {exact:.2f}",
               low <= exact <= high, True)


def check_held_history(clevis, expect):
    """The same by a file of loads on a part that supports hold; of two files the
    one that swings the part more counts. Between few rows that the loads connect
    evenly there is no doubt."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        write_bar(folder)
        rows = {"slow": [(0, 0), (1, 0.9)],
                "jump": [*STEP, (1, 1)]}
        scene = folder / "scene.toml"
        scene.write_text(scene_text.head("bench", MATERIAL, world="") + scene_text.BAR +
                         "limits = { safety_factor = 2.0 }\n" + "".join(f"""[[part.history]]
name = "{file}"
file = "{file}.csv"
faces = {{ tip = "x1" }}
interpolation = "linear"
fixed = {{ x0 = ["x", "y", "z"] }}
""" for file in rows))
        for file, law in rows.items():
            (folder / f"{file}.csv").write_text("time [ms],tip.force_x [N]\n" + "".join(
                f"{time},{share * PULL}\n" for time, share in law))
        part = support.check(clevis, scene).part
    still = PULL / AREA / 1e6
    expect("held history: at rest", part["peak_von_mises"]["value_MPa"], still)
    expect("held history: its band", part["peak_von_mises"]["band_MPa"][1], still)
    expect("held history: with vibration", part["vibration"]["peak_MPa"], 2.0 * still)
    low, high = part["vibration"]["band_MPa"]
    expect(f"held history: band {low:.2f} to {high:.2f}",
           low <= 2.0 * still <= high, True)


def main():
    faults = []

    def expect(what, value, exact):
        holds = abs(value - exact) <= NEAR * abs(exact)
        print(f"{'ok' if holds else 'FAILED':7}{what}: {value:.6g}, "
              f"{exact:.6g} expected")
        if not holds:
            faults.append(what)

    # 355 MPa/2 is above what the stop presses with and below the waves
    expect("exit with a block", check(sys.argv[1], 2.0, expect), 1)
    check(sys.argv[1], 0.0, expect)
    check_pulls(sys.argv[1], expect)
    check_welded(sys.argv[1], expect)
    check_triangles(sys.argv[1], expect)
    check_weighed(sys.argv[1], expect)
    check_redundant(sys.argv[1], expect)
    check_held_history(sys.argv[1], expect)
    check_bedded(sys.argv[1], expect)
    return len(faults) > 0


if __name__ == "__main__":
    sys.exit(main())

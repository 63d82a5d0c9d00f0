#!/usr/bin/env python3
"""Parts that springs of their mechanism hold, as they vibrate and buckle, against bars by
closed form.

    springs.py CLEVIS

An arm on a hub that a servo holds, with a rotor at its end that is out of balance, runs at
the first frequency of arm and servo together. Its bending moment is that of the bar's equation of vibration, with the hub's stiffness, damping and inertia at one end
and the rotor's mass at the other. On a soft servo the arm vibrates by itself, and all that
is left is what the rigid one bears, far beneath the limit. A brake that sticks clamps it.
With a forearm on a servo between arm and rotor that swings by itself, too.

A column on a servo buckles where u tan u = k L/EI, P = u² EI/L²: under nine tenths of its
load, though it bears twice that on a rigid foot, and so does the servo under a rigid one.
On a hinge, with a spring across its top, it bows under Euler's load or tilts under k L:
four times and three times what it bore with its foot clamped and no spring. It falls where
the spring is softer, or none, though it stands still as long as nothing pushes it.
"""
import cmath
import math
import sys
import tempfile
from pathlib import Path

import scene_text
import support

LENGTH, HEIGHT, WIDTH = 300.0, 30.0, 60.0  # mm
MODULUS, DENSITY = 210e9, 7850.0
DAMPING = 0.02  # of the part
# Of the deflection of its end under a force, over that of bending: 3EI/(5/6 GAL²).
SHEAR = 0.25 * (HEIGHT / LENGTH)**2 * 2 * (1 + 0.3) * 6 / 5
ROTOR, OFF, TURNING = 5.0, 0.1e-3, 0.015  # kg, m, kg m²
ALLOWED = 40.0  # MPa
HUB, FORK, FORK_TURNING = 0.002, 0.1, 1e-4  # kg m², kg, kg m²
FOREARM, ELBOW = 0.1, 0.05  # m from its axis to the rotor, kg


def solved(matrix, right):
    """Of a few complex equations, by elimination."""
    rows = [list(row) + [value] for row, value in zip(matrix, right)]
    for k in range(len(rows)):
        pivot = max(range(k, len(rows)), key=lambda i: abs(rows[i][k]))
        rows[k], rows[pivot] = rows[pivot], rows[k]
        for i in range(len(rows)):
            if i == k:
                continue
            factor = rows[i][k] / rows[k][k]
            rows[i] = [a - factor * b for a, b in zip(rows[i], rows[k])]
    return [row[-1] / row[k] for k, row in enumerate(rows)]


class Arm:
    """The arm on its hub at a circular frequency: deflections of sin, cos, sinh, cosh of
    k x."""

    def __init__(self, omega, hub, damping):
        self.bending = (MODULUS * WIDTH * HEIGHT**3 / 12e12 * (1 + 2j * damping) /
                        (1 + SHEAR))
        self.k = (DENSITY * WIDTH * HEIGHT / 1e6 * omega**2 / self.bending) ** 0.25
        self.root, self.end = self.derivatives(0), self.derivatives(LENGTH / 1e3)
        self.held = [self.root[0], [self.bending * b - hub * a
                                    for a, b in zip(self.root[1], self.root[2])]]

    def derivatives(self, x):
        """Of order 0 to 3."""
        k = self.k
        s, c, sh, ch = (f(k * x) for f in (cmath.sin, cmath.cos, cmath.sinh, cmath.cosh))
        return ((s, c, sh, ch), (k * c, -k * s, k * ch, k * sh),
                (-k**2 * s, -k**2 * c, k**2 * sh, k**2 * ch),
                (-k**3 * c, k**3 * s, k**3 * ch, k**3 * sh))

    def largest_moment(self, amounts):
        points = (LENGTH / 1e3 * i / 40 for i in range(41))
        return max(abs(self.bending *
                       sum(a * b for a, b in zip(amounts, self.derivatives(x)[2])))
                   for x in points)


def hub_of(omega, stiffness, dashpot):
    return stiffness + 1j * omega * dashpot - omega**2 * HUB


def largest_moment(omega, stiffness, dashpot, damping=DAMPING):
    """Along the arm, in steady state [N m]."""
    arm = Arm(omega, hub_of(omega, stiffness, dashpot), damping)
    force, turning = ROTOR * OFF * omega**2, FORK_TURNING + TURNING
    end, bending = arm.end, arm.bending
    return arm.largest_moment(solved(
        arm.held +
        # The rotor's drive prescribes how it turns against the fork.
        [[bending * c - omega**2 * turning * b for b, c in zip(end[1], end[2])],
         [bending * d + (ROTOR + FORK) * omega**2 * a for a, d in zip(end[0], end[3])]],
        [0, 0, 0, force]))


def moment_with_forearm(omega, stiffness, dashpot, damping=DAMPING):
    """The same with the rotor on a rigid forearm, on a servo like that of the hub: its
    angle is one more unknown."""
    arm = Arm(omega, hub_of(omega, stiffness, dashpot), damping)
    mass, turning = ROTOR + FORK, FORK_TURNING + TURNING
    force, square = ROTOR * OFF * omega**2, omega**2
    servo = stiffness + 1j * omega * dashpot
    end, bending = arm.end, arm.bending
    return arm.largest_moment(solved(
        [row + [0] for row in map(list, arm.held)] +
        [[bending * c + servo * b for b, c in zip(end[1], end[2])] + [-servo],
         [bending * d + (mass + ELBOW) * square * a for a, d in zip(end[0], end[3])] +
         [mass * square * FOREARM],
         [-servo * b - square * mass * FOREARM * a for a, b in zip(end[0], end[1])] +
         [servo - square * turning - square * mass * FOREARM**2]],
        [0, 0, 0, -force, FOREARM * force])[:4])


def first_frequency(stiffness, low, high, moment=largest_moment):
    """Where the moment is largest between two [1/s]."""
    for _ in range(20):
        step = (high - low) / 200
        best = max((low + step * i for i in range(201)),
                   key=lambda w: moment(w, stiffness, 0.0))
        low, high = best - step, best + step
    return best


def servo(stiffness, dashpot):
    return f"""type = "servo"
stiffness = "{stiffness:.9g} N m/rad"
damping = "{dashpot:.9g} N m s/rad"
law = "constant"
from = "0 deg"
"""


BRAKE = """type = "friction"
breakaway = "1000 N m"
kinetic = "1000 N m"
"""


def scene(folder, omega, element, forearm=None):
    """forearm: the element on its axis; none: the fork is welded to the arm."""
    reach = 1e3 * FOREARM if forearm else 0.0
    scene_text.write_bar(folder, (LENGTH / 1e3, HEIGHT / 1e3, WIDTH / 1e3), (24, 2, 2))
    file = folder / "scene.toml"
    axis, end = (0, 0, 1), (LENGTH, 0, 0)
    elbow = (scene_text.body("elbow", f"{ELBOW} kg", "1e-5 kg m^2", origin=end) +
             scene_text.joint("F", "weld", "arm", "elbow", end) +
             scene_text.joint("E", "revolute", "elbow", "fork", end, axis) +
             f"""[[force]]
name = "elbow_axis"
joint = "E"
{forearm}[[initial]]
joint = "E"
position = "0 deg"
rate = "0 rad/s"
""") if forearm else scene_text.joint("F", "weld", "arm", "fork", end)
    file.write_text(scene_text.head("arm on a servo") +
                    scene_text.body("hub", "1 kg", f"{HUB} kg m^2") +
                    scene_text.part_body("arm") +
                    scene_text.body("fork", f"{FORK} kg", f"{FORK_TURNING} kg m^2",
                                    center=(reach, 0, 0), origin=end) +
                    scene_text.body("rotor", f"{ROTOR} kg", f"{TURNING} kg m^2",
                                    center=(1e3 * OFF, 0, 0),
                                    origin=(LENGTH + reach, 0, 0)) +
                    scene_text.joint("O", "revolute", "ground", "hub", axis=axis) +
                    scene_text.joint("W", "weld", "hub", "arm") + elbow +
                    scene_text.joint("T", "revolute", "fork", "rotor",
                                     (LENGTH + reach, 0, 0), axis) + f"""[[force]]
name = "axis"
joint = "O"
{element}[[initial]]
joint = "O"
position = "0 deg"
rate = "0 rad/s"
[[drive]]
joint = "T"
law = "speed"
from = "0 deg"
speed = "{omega:.9g} rad/s"
[simulation]
motion = "dynamic"
duration = "{60 / omega * 2 * math.pi:.9g} s"
instants = 101
[[part]]
name = "arm"
mesh = "bar.msh"
length_unit = "mm"
material = "steel"
damping = {DAMPING}
pins = {{ W = "x0", F = "x1" }}
limits = {{ safety_factor = {355 / ALLOWED:.9g}, singular_zones = "exclude" }}
""")
    return file


AIR = 1005 / (1005 - 287)  # its isentropic exponent
BRISTLES = """model = "lugre"
bristle_stiffness = "1e7 N m/rad"
bristle_damping = "1e3 N m s/rad"
"""
# mm, of the column; across its plane it stands on its foot alone.
SIDE, DEPTH, HIGH = 20.0, 60.0, 1000.0


def servo_at_foot(stiffness):
    """Of a column, in N m/rad."""
    return f"""[[force]]
type = "servo"
name = "axis"
joint = "O"
stiffness = "{stiffness:.9g} N m/rad"
damping = "100 N m s/rad"
law = "constant"
from = "0 deg"
"""


def brake_at_foot(breakaway, model=""):
    """Of a column, in N m."""
    return f"""[[force]]
type = "friction"
name = "brake"
joint = "O"
breakaway = "{breakaway:.9g} N m"
kinetic = "{breakaway:.9g} N m"
{model}"""


def gas_beside(chamber):
    """Between ground and hub, 300 mm up a column: 900 N m/rad where isothermal."""
    both = "".join(f"""[[force.chamber]]
pushes = "{pushes}"
area = "1000 mm^2"
origin = "200 mm"
dead_volume = "100 cm^3"
pressure = "5e5 Pa"
{chamber}""" for pushes in ("apart", "together"))
    return f"""[[force]]
type = "gas_cylinder"
name = "ram"
between = ["ground", "hub"]
from = ["300 mm", "-200 mm", "0 mm"]
to = ["300 mm", "0 mm", "0 mm"]
supply = {{ pressure = "5e5 Pa" }}
{both}"""


def table_at_foot(*efforts):
    """Of a column, in N m, evenly over angles of -0.1 to 0.1 rad."""
    last = len(efforts) - 1
    angles = ", ".join(f'"{0.2 * i / last - 0.1:.9g} rad"' for i in range(last + 1))
    moments = ", ".join(f'"{effort:.9g} N m"' for effort in efforts)
    return f"""[[force]]
type = "table"
name = "cam"
joint = "O"
positions = [{angles}]
efforts = [{moments}]
"""


def spring_at_top(stiffness):
    """Across a column, in N/m; of 0 a damper."""
    spring = f'stiffness = "{stiffness:.9g} N/m"\nfree = "500 mm"\n' if stiffness else ""
    return f"""[[force]]
type = "spring"
name = "top"
between = ["ground", "column"]
from = {scene_text.lengths((HIGH, -500, 0))}
to = {scene_text.lengths((HIGH, 0, 0))}
{spring}damping = "200 N s/m"
"""


def column(folder, load, element, names=("press",)):
    scene_text.write_bar(folder, (HIGH / 1e3, SIDE / 1e3, DEPTH / 1e3), (20, 2, 2))
    file = folder / "scene.toml"
    file.write_text(scene_text.head("column on a spring") +
                    scene_text.body("hub", "5 kg", "0.03 kg m^2") +
                    scene_text.part_body("column") +
                    scene_text.joint("O", "revolute", "ground", "hub", axis=(0, 0, 1)) +
                    scene_text.joint("W", "weld", "hub", "column") + element + f"""[[force]]
type = "constant"
name = "press"
body = "column"
point = {scene_text.lengths((HIGH, 0, 0))}
force = ["{-load:.9g} N", "0 N", "0 N"]
[[initial]]
joint = "O"
position = "0 deg"
rate = "0 rad/s"
[simulation]
motion = "dynamic"
duration = "0.1 s"
instants = 3
[[part]]
name = "column"
mesh = "bar.msh"
length_unit = "mm"
material = "steel"
pins = {{ W = "x0" }}
forces = {{ {", ".join(f'{name} = {{ face = "x1" }}' for name in names)} }}
limits = {{ safety_factor = 1.5, buckling = 1.5, singular_zones = "exclude" }}
""")
    return file


def buckling_load(stiffness, bending):
    """Of the column on a spring [N]."""
    length = HIGH / 1e3
    low, high = 1e-6, math.pi / 2
    for _ in range(60):
        middle = 0.5 * (low + high)
        if middle * math.tan(middle) < stiffness * length / bending:
            low = middle
        else:
            high = middle
    return (low / length)**2 * bending


def with_shear(load):
    """A buckling load by bending [N], as shear lowers it (Engesser)."""
    return load / (1 + load * 1.2 * 2.6 / (MODULUS * SIDE * DEPTH / 1e6))


def check_columns(clevis, checks):
    bending = MODULUS * SIDE**3 * DEPTH / 12e12
    clamped = math.pi**2 * bending / 4 / (HIGH / 1e3)**2
    at_foot = clamped * HIGH / 1e3  # a rigid one falls at `clamped`, too
    both = with_shear(buckling_load(at_foot, bending))
    # Between a hinge and a spring across its top it bows, or tilts as rigid.
    bowed = with_shear(4 * clamped)
    rows = [("on a servo", servo_at_foot(at_foot), both, ("press",)),
            ("on a servo, with a damper at its top", servo_at_foot(at_foot) +
             spring_at_top(0), both, ("press", "top")),
            ("on a servo, with one soft spring more than it needs", servo_at_foot(at_foot) +
             spring_at_top(1e-4 * clamped / (HIGH / 1e3)), both, ("press", "top")),
            ("with a stiff spring at its top", spring_at_top(8 * clamped / (HIGH / 1e3)),
             bowed, ("press", "top")),
            ("with a soft spring at its top", spring_at_top(3 * clamped / (HIGH / 1e3)),
             3 * clamped, ("press", "top"))]
    for what, element, load, names in rows:
        for factor in (0.95, 1.6, 3.5):
            if factor < 1 and what != rows[0][0]:
                continue  # see check_positions()
            with tempfile.TemporaryDirectory() as name:
                file = column(Path(name), load / factor, element, names)
                answer = support.check(clevis, file, exits=support.JUDGED)
            part = answer.parts[0]
            checks.near(f"column {what}: buckling", part["buckling"]["factor"], factor,
                        1e-3)
            checks.expect((part["verdict"] == "pass") == (factor > 1.5),
                          f"{part['verdict']}, 1.5 wanted")


def check_positions(clevis, checks):
    """Of columns that stand still: they have no more than their springs hold, and on a
    bare hinge nothing; those that hang are held by what they carry. Friction at rest holds
    what it bears as they lean by 1/200, gas what it bears as it flows and takes heat."""
    load = 1e3  # of the column with its foot clamped twenty times as much
    foot, top = load * HIGH / 1e3, load / (HIGH / 1e3)
    barely = 1.2 * foot
    sway = foot / 200  # as it leans by 1/200
    bending = MODULUS * SIDE**3 * DEPTH / 12e12
    for what, element, press, factor, names in (
            ("on a servo that barely holds", servo_at_foot(barely), load,
             with_shear(buckling_load(barely, bending)) / load, ("press",)),
            ("on a servo too soft", servo_at_foot(0.9 * foot), load, 0.9, ("press",)),
            ("with a spring too soft at its top", spring_at_top(0.5 * top), load, 0.5,
             ("press", "top")),
            ("on a bare hinge", "", load, 0.0, ("press",)),
            ("on a weak brake", brake_at_foot(0.5 * sway), load, 0.5, ("press",)),
            ("on a brake that barely holds", brake_at_foot(1.2 * sway), load, 1.2,
             ("press",)),
            ("on weak bristles", brake_at_foot(0.5 * sway, BRISTLES), load, 0.5,
             ("press",)),
            ("on a strong brake", brake_at_foot(30 * sway), load, None, ("press",)),
            ("on a servo, with a cam that pushes on", servo_at_foot(2 * foot) +
             table_at_foot(-0.12 * foot, 0.12 * foot), load, 2 / 2.2, ("press",)),
            ("on a cam to one side", table_at_foot(0, 0, -foot), load, 0.0, ("press",)),
            ("on a cam to the other", table_at_foot(foot, 0, 0), load, 0.0, ("press",)),
            ("on a cam to both", table_at_foot(0.09 * foot, 0, -foot), load, 0.9,
             ("press",)),
            ("on gas", gas_beside(""), load, with_shear(
                buckling_load(900 * AIR, bending)) / load, ("press",)),
            ("on gas that conducts", gas_beside('heat = "conducting"\nwall_conductance = '
                                                '"1e4 W/K"\n'), load, 0.9, ("press",)),
            ("on gas of constant pressure", gas_beside(
                'valve = { opening = 1, area = "100 mm^2", discharge_coefficient = 0.8 }\n'),
             load, 0.0, ("press",)),
            ("hung from a weak brake", brake_at_foot(0.1 * sway), -load, None, ("press",)),
            ("hung from a bare hinge", "", -load, None, ("press",))):
        with tempfile.TemporaryDirectory() as name:
            file = column(Path(name), press, element, names)
            answer = support.check(clevis, file, exits=support.JUDGED)
        part = answer.parts[0]
        if factor is None:
            checks.expect(part["verdict"] == "pass", f"column {what}: {part['verdict']}")
            continue
        found = part["buckling"]["factor"]
        checks.expect(abs(found - factor) < 1e-3, f"column {what}: buckling {found:.4g}")
        checks.expect(part["verdict"] == "fail" and
                      "joined" not in part["buckling"]["remark"] and
                      (factor > 1.0) == ("not stable" not in part["buckling"]["remark"]),
                      f"{part['verdict']}, {part['buckling']['remark']}")


def check_high_limit(clevis, checks):
    """A limit of 15 counts a servo that holds twelve times the load."""
    load = 1e3
    servo = 12 * load * HIGH / 1e3
    bending = MODULUS * SIDE**3 * DEPTH / 12e12
    factor = with_shear(buckling_load(servo, bending)) / load
    with tempfile.TemporaryDirectory() as name:
        file = column(Path(name), load, servo_at_foot(servo))
        file.write_text(file.read_text().replace("buckling = 1.5", "buckling = 15"))
        part = support.check(clevis, file, exits=support.JUDGED).parts[0]
    checks.near("column on a servo, 15 wanted: buckling", part["buckling"]["factor"], factor,
                1e-3)
    checks.expect(part["verdict"] == "fail", part["verdict"])


def check_deflection(clevis, checks):
    """The column lying under its weight, on its hinge and on a spring at its other end: it
    sags as a beam on two supports, whatever the spring gives way."""
    weight = DENSITY * SIDE * DEPTH / 1e6 * 9.80665  # N/m
    bending = MODULUS * SIDE**3 * DEPTH / 12e12
    sag = 5 * weight * (HIGH / 1e3)**4 / 384 / bending * 1e3  # mm
    for stiffness in (1e5, 1e7):
        with tempfile.TemporaryDirectory() as name:
            file = column(Path(name), 1e-3, spring_at_top(stiffness), ("press", "top"))
            # Pressed by half of the weight, the spring is at rest.
            free = 500 + weight * HIGH / 1e3 / 2 / stiffness * 1e3
            text = file.read_text().replace('free = "500 mm"', f'free = "{free:.12g} mm"')
            file.write_text(text.replace(
                scene_text.WEIGHTLESS, '[world]\ngravity = ["0 m/s^2", "-9.80665 m/s^2", '
                '"0 m/s^2"]\n'))
            answer = support.check(clevis, file, exits=support.JUDGED)
        checks.near(f"on a hinge and a spring of {stiffness:g} N/m: deflection",
                    answer.part["deflection_mm"], sag, 3e-3)


def bushed_bar(folder):
    """200 mm that nothing but a stiff bushing at one end holds, pressed by 3 kN and pushed
    across by 20 N at the other, slowly."""
    scene_text.write_bar(folder, (0.2, 0.01, 0.01), (12, 2, 2))
    def force(name, value, direction):
        return f"""[[force]]
name = "{name}"
type = "table"
between = ["ground", "bar"]
from = ["200 mm", "0 mm", "0 mm"]
to = ["200 mm", "0 mm", "0 mm"]
axis = {direction}
times = ["0 s", "0.1 s", "1 s"]
efforts = ["0 N", "{value} N", "{value} N"]
"""
    file = folder / "scene.toml"
    file.write_text(scene_text.head("bushed bar") + scene_text.part_body("bar") +
                    force("press", -3000, "[1, 0, 0]") + force("push", 20, "[0, 1, 0]") + f"""
[[force]]
name = "bush"
type = "bushing"
between = ["ground", "bar"]
from = ["0 mm", "0 mm", "0 mm"]
to = ["0 mm", "0 mm", "0 mm"]
stiffness = ["1e8 N/m", "1e8 N/m", "1e8 N/m"]
angular_stiffness = ["1e6 N m/rad", "1e6 N m/rad", "1e6 N m/rad"]
[simulation]
duration = "0.2 s"
instants = 5
{scene_text.BAR}pins = {{}}
forces = {{ press = {{ face = "x1" }}, push = {{ face = "x1" }}, bush = {{ face = "x0" }} }}
limits = {{ safety_factor = 1.5, singular_zones = "exclude" }}
""")
    return file


def check_bushed_bar(clevis, checks):
    with tempfile.TemporaryDirectory() as name:
        answer = support.check(clevis, bushed_bar(Path(name)), "--tolerance", "20%",
                               exits=support.JUDGED)
    bending = MODULUS * 0.01**4 / 12
    euler = math.pi**2 * bending / 4 / 0.2**2 / 3000
    buckling = answer.part["buckling"]["factor"]
    checks.expect(0.97 * euler < buckling < 1.01 * euler,
                  f"bar on a bushing alone: buckles at {buckling:.4g}, clamped {euler:.4g}")
    bends = 20 * 0.2**3 / 3 / bending * 1e3  # mm
    found = answer.part["deflection_mm"]
    checks.expect(0.99 * bends < found < 1.6 * bends,
                  f"bar on a bushing alone: bends by {found:.4g} mm, "
                  f"{bends:.4g} clamped, {bends / (1 - 1 / euler):.4g} under both")


def main():
    clevis = Path(sys.argv[1]).resolve()
    checks = support.Checks()
    check_bushed_bar(clevis, checks)
    check_deflection(clevis, checks)
    check_high_limit(clevis, checks)
    section = WIDTH * HEIGHT**2 / 6e9  # [m³]
    stiff, dashpot = 94.5e3, 8.0
    omega = first_frequency(stiff, 100.0, 1000.0)
    free = first_frequency(0.0, 2000.0, 5000.0)
    clamped = first_frequency(1e9, 100.0, 1000.0)
    for share, first in ((1.0, omega), (1e-4, free), (1e4, clamped)):
        stiffness, damper = share * stiff, math.sqrt(share) * dashpot
        at_brake = share > 1.0
        turning = clamped if at_brake else omega
        truth = largest_moment(turning, stiffness, 0.0 if at_brake else damper)
        truth /= section * 1e6
        with tempfile.TemporaryDirectory() as name:
            file = scene(Path(name), turning,
                         BRAKE if at_brake else servo(stiffness, damper))
            answer = support.check(clevis, file, exits=support.JUDGED)
        part = answer.parts[0]
        vibration = part["vibration"]
        checks.near("lowest frequency", vibration["lowest_frequency_hz"],
                    first / 2 / math.pi, 0.005)
        if share >= 1.0:
            checks.near(f"peak, {part['peak_von_mises']['value_MPa']:.4g} at rest",
                        vibration["peak_MPa"], truth, 0.02)
        checks.expect((part["verdict"] == "pass") == (truth < ALLOWED),
                      f"{part['verdict']}, {ALLOWED} MPa allowed")
    both = first_frequency(stiff, 100.0, 1000.0, moment_with_forearm)
    truth = moment_with_forearm(both, stiff, dashpot) / section / 1e6
    with tempfile.TemporaryDirectory() as name:
        axes = servo(stiff, dashpot)
        answer = support.check(clevis, scene(Path(name), both, axes, axes),
                               exits=support.JUDGED)
    part = answer.parts[0]
    checks.near("with a forearm on a servo", part["vibration"]["lowest_frequency_hz"],
                both / 2 / math.pi, 0.005)
    checks.near(f"peak, {part['peak_von_mises']['value_MPa']:.4g} at rest",
                part["vibration"]["peak_MPa"], truth, 0.02)
    check_columns(clevis, checks)
    check_positions(clevis, checks)
    return checks.exit_code()


if __name__ == "__main__":
    sys.exit(main())

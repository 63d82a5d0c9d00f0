#!/usr/bin/env python3
"""Force of the teeth of a [[coupling]] with its pressure_angle.

- A bracket that carries a pinion has the stress that a rod in the place of the teeth,
  along their line of action, gives it: in a hub of its own, and straight on its bore.
- A motion does not change as teeth are resolved, their force does no work.
- A housing of two wheels is loaded by their torques alone, each bearing by the force.
- Friction that follows a bearing's reaction knows the teeth.
- What teeth cannot resolve is refused.

    tooth_forces.py CLEVIS MESH   (meshes/landing_gear/link_ab.msh)
"""
import csv
import json
import math
import subprocess
import sys
import tempfile
from pathlib import Path

import support

CLEVIS, MESH = (str(Path(argument).resolve()) for argument in sys.argv[1:3])
ANGLE, RADIUS, TORQUE = math.radians(20.0), 0.02, 4.0

BODY = """
[[body]]
name = "{name}"
mass = "1 kg"
center_of_mass = ["0 mm", "0 mm", "0 mm"]
inertia = ["1e-3 kg m^2", "1e-3 kg m^2", "1e-3 kg m^2"]
placement = {{ origin = ["{x} mm", "{y} mm", "0 mm"] }}
"""


def body(name, x=0.0, y=0.0):
    return BODY.format(name=name, x=x, y=y)


def joint(name, kind, a, b, point, more=""):
    x, y = point
    return f"""
[[joint]]
name = "{name}"
type = "{kind}"
between = ["{a}", "{b}"]
point = ["{x} mm", "{y} mm", "0 mm"]
{more}
"""


AXIS = "axis = [0, 0, 1]\nnormal = [1, 0, 0]"
HEAD = """schema = 1
name = "teeth"
[world]
gravity = ["0 m/s^2", "-9.81 m/s^2", "0 m/s^2"]
""" + support.STEEL
END = """
[simulation]
duration = "1 s"
instants = 3
"""
PART = f"""
[[part]]
name = "AB"
mesh = "{MESH}"
length_unit = "mm"
material = "steel"
pins = {{ A = "bore_A", B = "bore_B" }}
"""
DRIVE = """
[[drive]]
joint = "{0}"
law = "constant"
from = "{1}"
"""


def torque(on):
    return f"""
[[force]]
name = "torque"
type = "table"
joint = "{on}"
times = ["0 s", "1 s"]
efforts = ["{TORQUE} N m", "{TORQUE} N m"]
"""


def bracket(in_hub, by_teeth):
    """A bracket welded to the ground carries a pinion that a force on its lower side
    turns against a rack above it, or against a rod along the teeth's line of action."""
    carrier, bearing = ("hub", "bearing") if in_hub else ("bracket", "B")
    text = HEAD + '\n[[body]]\nname = "bracket"\npart = "AB"\n' + body("pinion", 140)
    text += joint("A", "weld", "ground", "bracket", (0, 0), AXIS)
    if in_hub:
        text += body("hub", 140) + joint("B", "weld", "bracket", "hub", (140, 0), AXIS)
    text += joint(bearing, "revolute", carrier, "pinion", (140, 0), AXIS)
    if by_teeth:
        text += body("rack", 140, 20)
        text += joint("slide", "prismatic", "ground", "rack", (140, 20), "axis = [1, 0, 0]")
        text += f"""
[[coupling]]
name = "mesh"
type = "rack"
joints = ["slide", "{bearing}"]
radius = "-20 mm"
pressure_angle = "20 deg"
""" + DRIVE.format("slide", "0 mm")
    else:
        away = f'["{140 + 100 * math.cos(ANGLE)!r} mm", "{20 - 100 * math.sin(ANGLE)!r} mm", "0 mm"]'
        text += f"""
[[joint]]
name = "rod"
type = "distance"
between = ["ground", "pinion"]
at = {{ ground = {away}, pinion = ["0 mm", "20 mm", "0 mm"] }}
length = "100 mm"
"""
    return text + f"""
[[force]]
name = "turning"
type = "constant"
body = "pinion"
point = ["0 mm", "-20 mm", "0 mm"]
force = ["{TORQUE / RADIUS} N", "0 N", "0 N"]
""" + END + PART


def check_bracket(folder, checks):
    force = TORQUE / RADIUS / math.cos(ANGLE)
    for in_hub in (True, False):
        peaks = []
        for by_teeth in (True, False):
            scene = folder / "bracket.toml"
            scene.write_text(bracket(in_hub, by_teeth))
            answer = support.check(CLEVIS, scene, exits=support.JUDGED)
            peaks.append(answer.peak)
            print(f"{'hub' if in_hub else 'bore'}, {'teeth' if by_teeth else 'rod'}: {answer}")
            if by_teeth:
                checks.expect("not in the reactions of" not in answer.text, "no note on teeth")
        checks.near("bracket under teeth as under a rod", peaks[0], peaks[1], 1e-6)
    motion = simulate(folder, bracket(True, True))
    found = motion["couplings"][0]
    checks.near("tooth force", found["peak_tooth_force_N"], force, 1e-9)
    checks.near("pitch radius", found["pitch_radii_mm"][0], 1e3 * RADIUS, 1e-12)


def simulate(folder, text, out=None):
    scene = folder / "motion.toml"
    scene.write_text(text)
    more = ["--out", str(out)] if out else []
    done = subprocess.run([CLEVIS, "simulate", scene, "--json", *more],
                          capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(done.stdout + done.stderr)
    return json.loads(done.stdout)


def housing(teeth, more=""):
    """Wheels of 30 and 60 mm on a housing that a weld holds; the first turns by a
    law, a torque loads the second."""
    return (HEAD + body("housing") + body("small") + body("large", 90)
            + joint("foot", "weld", "ground", "housing", (0, -100), AXIS)
            + joint("1", "revolute", "housing", "small", (0, 0), AXIS)
            + joint("2", "revolute", "housing", "large", (90, 0), AXIS) + f"""
[[coupling]]
name = "mesh"
type = "gear"
joints = ["1", "2"]
ratio = -2
{teeth}
[[drive]]
joint = "1"
law = "ramp"
from = "0 deg"
to = "360 deg"
duration = "1 s"
""" + more + torque("2") + END)


def rows_of(file):
    with open(file, encoding="utf-8") as lines:
        return list(csv.DictReader(lines))


def vector(row, name, unit):
    return [float(row[f"{name}_{axis}_{unit}"]) for axis in "xyz"]


def check_housing(folder, checks):
    out = {}
    for name, teeth in (("without", ""), ("with", 'pressure_angle = "20 deg"')):
        simulate(folder, housing(teeth), folder / name)
        out[name] = (rows_of(folder / name / "motion.csv"),
                     rows_of(folder / name / "reactions.csv"))
    columns = [name for name in out["without"][0][0] if name in out["with"][0][0]]
    checks.expect(all(one[name] == other[name] for name in columns
                      for one, other in zip(out["without"][0], out["with"][0])
                      if "error" not in name), "the motion and its efforts stay as they are")
    foot = [[row for row in out[name][1] if row["joint"] == "foot"] for name in out]
    worst = max(abs(a - b) for one, other in zip(*foot)
                for what, unit in (("force", "N"), ("moment", "N_m"))
                for a, b in zip(vector(one, f"{what}_on_b_world", unit),
                                vector(other, f"{what}_on_b_world", unit)))
    checks.expect(worst < 1e-7, f"the foot's reaction stays as it is: {worst:.1g}")
    for at, row in enumerate(out["with"][0]):
        force = vector(row, "mesh.tooth_force", "N")
        # Gravity and the wheels' inertia aside: both turn about their centres.
        for name, sign in (("1", -1.0), ("2", 1.0)):
            reaction = [r for r in out["with"][1] if r["joint"] == name][at]
            held = vector(reaction, "force_on_b_world", "N")
            left = max(abs(held[0] - sign * force[0]), abs(held[1] - sign * force[1] - 9.81))
            checks.expect(left < 1e-7, f"bearing {name} carries the teeth's force: {left:.1g} N")
        turning = force[1] * 0.03
        effort = float(row["mesh.coupling_effort_N_m"])
        checks.near("their moment is the coupling's", turning, effort, 1e-9)
        checks.near("they press apart", -force[0], abs(force[1]) * math.tan(ANGLE), 1e-9)


RUB = """
[[force]]
name = "rub"
type = "friction"
joint = "2"
kinetic_friction = 0.2
pin_radius = "10 mm"
"""


def check_friction(folder, checks):
    """Friction that follows the reaction of a wheel's bearing knows its teeth."""
    teeth = 'pressure_angle = "20 deg"'
    motion = simulate(folder, housing(teeth, RUB))
    bearing = next(joint for joint in motion["joints"] if joint["name"] == "2")
    rub = next(force for force in motion["forces"] if force["name"] == "rub")
    checks.near("friction of the bearing", rub["peak_effort_N_m"],
                0.2 * 0.01 * bearing["peak_force_N"], 1e-9)
    # 9.81 N without; the friction takes up to 3 % of the torque
    checks.expect(bearing["peak_force_N"] > 0.8 * TORQUE / 0.06,
                  "the bearing carries the teeth's force")
    free = housing(teeth, RUB).replace("[simulation]", '[simulation]\nmotion = "dynamic"')
    free = free[:free.index("[[drive]]")] + free[free.index("[[force]]"):]
    refused(folder, checks, free, "K011", "in a motion that forces decide", 12)
    refused(folder, checks, housing("", RUB), "K011", "their force is not resolved", 12)


def refused(folder, checks, text, code, told, exit_code=10):
    scene = folder / "refused.toml"
    scene.write_text(text)
    done = subprocess.run([CLEVIS, "simulate", scene], capture_output=True, text=True)
    checks.expect(done.returncode == exit_code and code in done.stderr and told in done.stderr,
                  f"refused: {told}")


def check_refusals(folder, checks):
    for text, code, told in (
            (housing('helix_angle = "10 deg"'), "S010", "stands without `pressure_angle`"),
            (housing('pressure_angle = "50 deg"'), "S006", "from 0 to 45 deg"),
            (housing('pressure_angle = "20 deg"').replace("ratio = -2", "ratio = 1"), "S010",
             "turn as one")):
        refused(folder, checks, text, code, told)


def main():
    checks = support.Checks()
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        check_housing(folder, checks)
        check_bracket(folder, checks)
        check_friction(folder, checks)
        check_refusals(folder, checks)
    return checks.exit_code()


if __name__ == "__main__":
    sys.exit(main())

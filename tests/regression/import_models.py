#!/usr/bin/env python3
"""`clevis import`: models of SDF and URDF move as they should.

    import_models.py CLEVIS SOURCE_DIR

Each model of tests/data/models is imported and simulated. A double pendulum in
either format, in frames turned against one another and with an inertial pose,
is held to an integration of its own two equations by Runge and Kutta and to a
scene written by hand; a four-bar, whose last joint closes the loop, to a scene
written by hand in another plane; a slider to the closed form.
"""
import csv
import math
import subprocess
import sys
import tempfile
import tomllib
from pathlib import Path

from support import Checks

CLEVIS, SOURCE = (Path(argument).resolve() for argument in sys.argv[1:3])
MODELS = SOURCE / "tests/data/models"
MOST = 1e-9  # m, of positions; 1, of directions
FINE = "1e-12"  # of trees; loops are integrated to 1e-9 at best


def imported(model, folder):
    """Scene of a model, and what clevis printed."""
    run = subprocess.run([CLEVIS, "import", MODELS / model, "--out", folder],
                         capture_output=True, text=True)
    if run.returncode != 0:
        sys.exit(f"{model}: exit {run.returncode}\n{run.stderr}")
    return (folder / "scene.toml").read_text(), run.stdout


def motion(text, folder, tolerance=FINE):
    """Rows of motion.csv of a scene."""
    folder.mkdir(exist_ok=True)
    scene = folder / "moved.toml"
    scene.write_text(text.replace("[simulation]\n",
                                  f"[simulation]\ntolerance = {tolerance}\n"))
    run = subprocess.run([CLEVIS, "simulate", scene, "--out", folder / "out"],
                         capture_output=True, text=True)
    if run.returncode != 0:
        sys.exit(f"{scene}: exit {run.returncode}\n{run.stderr}")
    with open(folder / "out/motion.csv", encoding="utf-8") as file:
        rows = [{k: float(v) for k, v in row.items() if v} for row in csv.DictReader(file)]
    # simulate adds instants of its own.
    return [min(rows, key=lambda row, t=k / 100: abs(row["t_s"] - t)) for k in range(101)]


def times(a, b):
    return [[sum(a[i][k] * b[k][j] for k in range(3)) for j in range(3)] for i in range(3)]


def turned(a, v):
    return [sum(a[i][k] * v[k] for k in range(3)) for i in range(3)]


def transposed(a):
    return [list(row) for row in zip(*a)]


def about(axis, angle):
    """Rotation matrix about x, y or z (0, 1, 2)."""
    c, s = math.cos(angle), math.sin(angle)
    i, j = (axis + 1) % 3, (axis + 2) % 3
    result = [[float(a == b) for b in range(3)] for a in range(3)]
    result[i][i], result[i][j], result[j][i], result[j][j] = c, -s, s, c
    return result


def rpy(roll, pitch, yaw):
    return times(about(2, yaw), times(about(1, pitch), about(0, roll)))


def orientation(row, body):
    w, x, y, z = (row[f"{body}.quaternion_{k}"] for k in "wxyz")
    return [[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]]


def origin(row, body):
    return [1e-3 * row[f"{body}.position_{k}_mm"] for k in "xyz"]


def distance(a, b):
    return math.dist(a, b)


# The double pendulum: masses, centres and links along x of the arms [m, kg].
M1, M2, S1, S2, L, BEND, DAMPING = 2.0, 1.2, 0.2, 0.15, 0.4, -0.5, 0.02
INERTIA = [[0.003, 0.001, -0.0005], [0.001, 0.02, 0.0007], [-0.0005, 0.0007, 0.021]]
_turn = rpy(0.4, 0.2, -0.3)  # of the inertial pose
INERTIA_1 = times(times(_turn, INERTIA), transposed(_turn))
I1, I2 = INERTIA_1[1][1], 0.009


def accelerations(state, gravity):
    """Of the arms' angles about y from x; gravity along x and z of the frame
    in which the angles are."""
    a, b, va, vb = state
    g, h = gravity
    coupled = M2 * L * S2
    m11, m12, m22 = M1 * S1**2 + I1 + M2 * L**2, coupled * math.cos(a - b), M2 * S2**2 + I2
    pull = DAMPING * (vb - va)
    f1 = (-coupled * math.sin(a - b) * vb**2 + pull
          + (M1 * S1 + M2 * L) * (-g * math.sin(a) - h * math.cos(a)))
    f2 = (coupled * math.sin(a - b) * va**2 - pull
          + M2 * S2 * (-g * math.sin(b) - h * math.cos(b)))
    det = m11 * m22 - m12**2
    return va, vb, (m22 * f1 - m12 * f2) / det, (m11 * f2 - m12 * f1) / det


def pendulum_states(gravity, instants, steps=400):
    """Angles at instants of 1 s by Runge and Kutta's fourth order."""
    state, found = (0.0, BEND, 0.0, 0.0), [(0.0, BEND)]
    h = 1.0 / (instants - 1) / steps
    for _ in range(instants - 1):
        for _ in range(steps):
            k = [accelerations(state, gravity)]
            for part in (0.5, 0.5, 1.0):
                k.append(accelerations(
                    [s + part * h * d for s, d in zip(state, k[-1])], gravity))
            state = tuple(s + h / 6 * (a + 2 * b + 2 * c + d)
                          for s, a, b, c, d in zip(state, *k))
        found.append(state[:2])
    return found


def vector(values, unit):
    return "[" + ", ".join(f'"{v!r} {unit}"' for v in values) + "]"


def pendulum_by_hand(gravity):
    """In the frame of the first arm at the start."""
    rows = ", ".join(vector(row, "kg m^2") for row in INERTIA_1)
    return f"""schema = 1
name = "by hand"
[world]
gravity = {vector(gravity, "m/s^2")}
[[body]]
name = "upper"
mass = "{M1} kg"
center_of_mass = ["{S1} m", "0.01 m", "0 m"]
inertia = [{rows}]
[[body]]
name = "lower"
mass = "{M2} kg"
center_of_mass = ["{S2} m", "0 m", "0 m"]
inertia = ["0.001 kg m^2", "0.009 kg m^2", "0.009 kg m^2"]
placement = {{ origin = ["{L} m", "0 m", "0 m"], x_axis = [{math.cos(BEND)!r}, 0, {-math.sin(BEND)!r}], y_axis = [0, 1, 0] }}
[[joint]]
name = "shoulder"
type = "revolute"
between = ["ground", "upper"]
at = {{ ground = ["0 m", "0 m", "0 m"], upper = ["0 m", "0 m", "0 m"] }}
axis = [0, 1, 0]
[[joint]]
name = "elbow"
type = "revolute"
between = ["upper", "lower"]
at = {{ upper = ["{L} m", "0 m", "0 m"], lower = ["0 m", "0 m", "0 m"] }}
axis = [0, 1, 0]
[[force]]
type = "spring"
joint = "elbow"
damping = "{DAMPING} N m s/rad"
[simulation]
duration = "1 s"
instants = 101
motion = "dynamic"
"""


def pendulum(checks, folder, model, start, frame, gravity):
    """start, frame: of the first arm in the world at the start."""
    text, _ = imported(model, folder / model.replace(".", "_"))
    rows = motion(text, folder / "moved")
    along = turned(transposed(frame), gravity)
    by_hand = motion(pendulum_by_hand(along), folder / "by_hand")
    states = pendulum_states((along[0], along[2]), len(by_hand))
    worst = worst_by_hand = 0.0
    for row, other, (a, b) in zip(rows, by_hand, states):
        elbow = [p + q for p, q in zip(start, turned(
            frame, [L * math.cos(a), 0.0, -L * math.sin(a)]))]
        tip = turned(frame, [math.cos(b), 0.0, -math.sin(b)])
        seen = [r[0] for r in orientation(row, "lower")]
        worst = max(worst, distance(origin(row, "lower"), elbow), distance(seen, tip))
        there = [p + q for p, q in zip(start, turned(frame, origin(other, "lower")))]
        turn = times(frame, orientation(other, "lower"))
        worst_by_hand = max(worst_by_hand, distance(origin(row, "lower"), there),
                            *(distance(p, q) for p, q in zip(
                                orientation(row, "lower"), turn)))
    moved = distance(origin(rows[0], "lower"), origin(rows[-1], "lower"))
    checks.expect(moved > 0.1, f"{model}: the elbow moves, by {moved:.3f} m in 1 s")
    checks.expect(worst < MOST, f"{model}: Runge and Kutta's motion to {worst:.1e}")
    checks.expect(worst_by_hand < MOST,
                  f"{model}: the motion by hand to {worst_by_hand:.1e}")


FOUR_BAR = f"""schema = 1
name = "by hand"
[world]
gravity = ["0 m/s^2", "-9.8 m/s^2", "0 m/s^2"]
[[body]]
name = "crank"
mass = "0.4 kg"
center_of_mass = ["40 mm", "0 mm", "0 mm"]
inertia = ["1e-5 kg m^2", "3e-4 kg m^2", "3e-4 kg m^2"]
placement = {{ origin = ["0 mm", "0 mm", "0 mm"], angle = "30 deg" }}
[[body]]
name = "coupler"
mass = "0.9 kg"
center_of_mass = ["110 mm", "0 mm", "0 mm"]
inertia = ["2e-5 kg m^2", "4e-3 kg m^2", "4e-3 kg m^2"]
placement = {{ origin = ["{80 * math.cos(math.pi / 6)!r} mm", "40 mm", "0 mm"], angle = "{math.atan2(1, 2)!r} rad" }}
[[body]]
name = "rocker"
mass = "0.7 kg"
center_of_mass = ["34 mm", "70 mm", "0 mm"]
inertia = ["2e-3 kg m^2", "1e-3 kg m^2", "2e-3 kg m^2"]
placement = {{ origin = ["200 mm", "0 mm", "0 mm"] }}
[[joint]]
name = "A"
type = "revolute"
between = ["ground", "crank"]
at = {{ ground = ["0 mm", "0 mm", "0 mm"], crank = ["0 mm", "0 mm", "0 mm"] }}
axis = [0, 0, 1]
[[joint]]
name = "B"
type = "revolute"
between = ["crank", "coupler"]
at = {{ crank = ["80 mm", "0 mm", "0 mm"], coupler = ["0 mm", "0 mm", "0 mm"] }}
axis = [0, 0, 1]
[[joint]]
name = "C"
type = "revolute"
between = ["coupler", "rocker"]
at = {{ coupler = ["{math.hypot(200, 100)!r} mm", "0 mm", "0 mm"], rocker = ["{80 * math.cos(math.pi / 6)!r} mm", "140 mm", "0 mm"] }}
axis = [0, 0, 1]
[[joint]]
name = "D"
type = "revolute"
between = ["ground", "rocker"]
at = {{ ground = ["200 mm", "0 mm", "0 mm"], rocker = ["0 mm", "0 mm", "0 mm"] }}
axis = [0, 0, 1]
[simulation]
duration = "1 s"
instants = 101
motion = "dynamic"
"""


def four_bar(checks, folder):
    text, told = imported("four_bar.sdf", folder / "four_bar")
    checks.expect("gravity: not in the file" in told, "assumed gravity is told")
    rows = motion(text, folder / "moved", "1e-11")
    by_hand = motion(FOUR_BAR, folder / "by_hand", "1e-11")
    worst = reach = 0.0
    for row, other in zip(rows, by_hand, strict=True):
        for name in ("coupler", "rocker"):
            x, y, z = origin(row, name)
            u, v, w = origin(other, name)
            # x and z of the one are x and y of the other.
            worst = max(worst, distance((x, z, -y), (u, v, w)))
            a, b = orientation(row, name), orientation(other, name)
            worst = max(worst, distance((a[0][0], a[2][0]), (b[0][0], b[1][0])))
        reach = max(reach, distance(origin(row, "coupler"), origin(rows[0], "coupler")))
    checks.expect(reach > 0.05, f"four-bar: the crank's pin moves, by {reach:.3f} m")
    checks.expect(worst < MOST, f"four-bar: the motion by hand to {worst:.1e}")


def slider(checks, folder):
    text, _ = imported("slider.sdf", folder / "slider")
    rows = motion(text, folder / "moved")
    omega, decay = math.sqrt(50 / 2), 3 / (2 * 2)
    damped = math.sqrt(omega**2 - decay**2)
    worst = 0.0
    for row in rows:
        t = row["t_s"]
        y = 2 + 0.1 * (1 - math.exp(-decay * t) * (
            math.cos(damped * t) + decay / damped * math.sin(damped * t)))
        worst = max(worst, distance(origin(row, "block"), (1, y, 3)))
    checks.expect(worst < MOST, f"slider: closed form to {worst:.1e}")


def lost(checks, folder):
    """Every element that is left out is told, once."""
    _, told = imported("double_pendulum.sdf", folder / "told")
    for line in ("visual bar: a shape to look at", "collision bar: a shape of contact",
                 "sensor gyro: a sensor", "plugin driver: a program; never run",
                 "physics fast: settings of a simulator"):
        checks.expect(told.count(line) == 1, f"told once: {line}")
    _, told = imported("double_pendulum.urdf", folder / "told_urdf")
    for line in ("link tip: no mass; it is a place on lower", "transmission drive: a drive",
                 "link world: taken for the ground"):
        checks.expect(told.count(line) == 1, f"told once: {line}")


    turned_axis = (MODELS / "double_pendulum.sdf").read_text().replace(
        "</xyz>", "</xyz><use_parent_model_frame>1</use_parent_model_frame>", 1)
    (folder / "turned.sdf").write_text(turned_axis)
    line = "use_parent_model_frame: of SDF up to 1.6"
    checks.expect(imported(folder / "turned.sdf", folder / "turned")[1].count(line) == 1,
                  "SDF 1.9: use_parent_model_frame is told")
    (folder / "old.sdf").write_text(turned_axis.replace(">1</use_p", ">0</use_p"))
    checks.expect(line not in imported(folder / "old.sdf", folder / "old")[1],
                  "its default is not")
    wheel = ("<robot name='r'><link name='world'/><link name='wheel'><inertial>"
             "<mass value='1'/><inertia ixx='1' iyy='1' izz='1' ixy='0' ixz='0' iyz='0'/>"
             "</inertial></link><joint name='hub' type='{}'><parent link='world'/>"
             "<child link='wheel'/><axis xyz='0 0 1'/><limit lower='{}' upper='{}' "
             "effort='0' velocity='0'/></joint></robot>")
    for name, values, line in (
            ("endless", ("continuous", -1, 2),
             "joint hub: continuous, its limits -1 and 2 are left out"),
            ("reversed", ("revolute", 1, -1),
             "joint hub: its limits are reversed, lower 1 and upper -1, and left out")):
        (folder / f"{name}.urdf").write_text(wheel.format(*values))
        text, told = imported(folder / f"{name}.urdf", folder / name)
        checks.expect(told.count(line) == 1, f"told once: {line}")
        checks.expect('"stop"' not in text, f"{name}: no stop")
    (folder / "free.urdf").write_text(wheel.format("continuous", 0, 0))
    checks.expect("left out" not in imported(folder / "free.urdf", folder / "free")[1],
                  "no limits, nothing told")


NESTED = """<sdf version="1.9"><world name="w">
<model name="base"><static>true</static><link name="plate"/></model>
<model name="machine">
  <pose>1 0 0 0 0 1.5707963267948966</pose>
  <link name="arm">{inertial}</link>
  <model name="sub">
    <pose>0 0.5 0 0 0 0</pose>
    <link name="arm"><pose>0 0 0.2 0 0 0</pose>{inertial}</link>
  </model>
  <joint name="knee" type="revolute"><parent>arm</parent><child>sub::arm</child>
    <axis><xyz expressed_in="__model__">1 0 0</xyz><dynamics><friction>0.01</friction></dynamics>
      <limit><lower>-1</lower><upper>2</upper><stiffness>300</stiffness></limit></axis></joint>
  <joint name="cross" type="universal"><parent>world</parent><child>arm</child>
    <axis><xyz>1 0 0</xyz></axis><axis2><xyz>0 1 0</xyz></axis2></joint>
</model></world></sdf>
"""
INERTIAL = ("<inertial><mass>1</mass><inertia><ixx>0.01</ixx><iyy>0.01</iyy><izz>0.01</izz>"
            "</inertia></inertial>")
# Before SDF 1.7 an axis may be in the model's frame. Gazebo's screws take rad/m.
SCREW = """<sdf version="1.4"><model name="old"><link name="nut">
<pose>0 0 1 0 0 1.5707963267948966</pose>{inertial}</link>
<joint name="thread" type="screw"><parent>world</parent><child>nut</child>
<thread_pitch>-100</thread_pitch><axis><xyz>1 0 0</xyz></axis></joint></model></sdf>
"""


def near(value, wanted):
    """Lists of numbers or of quantities, in SI units."""
    return all(abs(float(str(a).split()[0]) - b) < 1e-12
               for a, b in zip(value, wanted, strict=True))


def described(text, folder, name):
    """A model in this file's own text, as a scene's tables by name."""
    file = folder / f"{name}.sdf"
    file.write_text(text.format(inertial=INERTIAL))
    scene = tomllib.loads(imported(file, folder / name)[0])
    return {entry["name"]: entry for kind in ("body", "joint", "force")
            for entry in scene.get(kind, ())}


def scenes(checks, folder):
    """What the motions above do not have: nested models, a static one, joints of
    other types, forces."""
    found = described(NESTED, folder, "nested")
    checks.expect(set(found) == {
        "machine__arm", "machine__sub__arm", "machine__knee", "machine__cross",
        "machine__knee_friction", "machine__knee_stop"}, "nested: bodies, joints, forces")
    inner, knee, cross = (found[f"machine__{name}"] for name in ("sub__arm", "knee", "cross"))
    checks.expect(near(inner["placement"]["origin"], (0.5, 0, 0.2))
                  and near(inner["placement"]["x_axis"], (0, 1, 0)), "nested: placement")
    checks.expect(near(knee["point"], (0.5, 0, 0.2)) and near(knee["axis"], (0, 1, 0))
                  and knee["between"] == ["machine__arm", "machine__sub__arm"],
                  "nested: joint of the outer model")
    checks.expect(near(cross["axis"], (0, 1, 0)) and near(cross["normal"], (-1, 0, 0))
                  and cross["between"] == ["ground", "machine__arm"], "universal joint's axes")
    stop, friction = found["machine__knee_stop"], found["machine__knee_friction"]
    checks.expect((stop["lower"], stop["upper"], stop["stiffness"], stop["damping"])
                  == ("-1 rad", "2 rad", "300 N m/rad", "1 N m s/rad"), "limits are a stop")
    checks.expect(friction["breakaway"] == friction["kinetic"] == "0.01 N m", "friction")
    thread = described(SCREW, folder, "screw")["thread"]
    checks.expect(near(thread["axis"], (1, 0, 0)), "SDF 1.4: axis in the model's frame")
    lead = float(thread["lead"].split()[0])
    checks.expect(abs(lead - 2 * math.pi / 100) < 1e-12, "screw: right-handed lead")


def main():
    checks = Checks()
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        model, shelf = about(2, 0.3), about(2, 0.2)
        start = [p + q for p, q in zip((0.1, -0.2, 1.5), turned(model, (0.05, 0, 0.1)))]
        pendulum(checks, folder, "double_pendulum.sdf", start,
                 times(times(model, shelf), about(1, 0.7)), (0, 0, -9.81))
        pendulum(checks, folder, "double_pendulum.urdf", (0.1, 0.2, 0.3),
                 rpy(0.1, 0.7, 0.3), (0, 0, -9.8))
        four_bar(checks, folder)
        slider(checks, folder)
        lost(checks, folder)
        scenes(checks, folder)
    return checks.exit_code()


if __name__ == "__main__":
    sys.exit(main())

#!/usr/bin/env python3
"""Hard cases of the mechanism, end to end: what `clevis simulate` makes of
motions that break solvers.

    hard_motions.py CLEVIS GEOMETRY [FOLDER]

Every row runs a scene and compares with a closed form, a converged reference
or a refusal by name. With FOLDER the figures are written there as
hard_motions.csv and hard_motions.md (results/studies holds them).
"""
import csv
import json
import math
import subprocess
import sys
import tempfile
from pathlib import Path

CLEVIS, GEOMETRY = Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve()
G = 9.81
rows, faults = [], []


def simulate(text):
    """(exit code, code or "", document, rows of motion.csv)."""
    with tempfile.TemporaryDirectory() as folder:
        scene = Path(folder) / "scene.toml"
        scene.write_text(text)
        run = subprocess.run([CLEVIS, "simulate", scene, "--json", "--out",
                              Path(folder) / "out"], capture_output=True,
                             text=True, check=False)
        document = json.loads(run.stdout)
        motion = []
        if run.returncode == 0:
            with open(Path(folder) / "out/motion.csv", encoding="utf-8") as file:
                motion = [{k: float(v) for k, v in row.items() if v}
                          for row in csv.DictReader(file)]
    start = run.stderr.find("error[")
    code = run.stderr[start + 6:start + 10] if start >= 0 else ""
    return run.returncode, code, document, motion


def note(case, variant, measured, allowed, remark=""):
    good = measured <= allowed
    rows.append((case, variant, f"{measured:.1e}", f"{allowed:.0e}",
                 "yes" if good else "NO", remark))
    if not good:
        faults.append(f"{case}, {variant}: {measured} > {allowed}")


def refused(case, variant, text, code):
    exit_code, found, _, _ = simulate(text)
    good = found == code and exit_code == 12
    rows.append((case, variant, f"exit {exit_code}, {found}",
                 f"exit 12, {code}", "yes" if good else "NO", ""))
    if not good:
        faults.append(f"{case}, {variant}: exit {exit_code}, {found}")


def angle(row, body):
    """Of a body in the plane, of a quaternion about z."""
    return 2.0 * math.atan2(row[f"{body}.quaternion_z"],
                            row[f"{body}.quaternion_w"])


def body(name, mass=1.0, centre=0.5, inertia=1.0 / 12.0, at=(0.0, 0.0),
         turn=0.0):
    return f"""
[[body]]
name = "{name}"
mass = "{mass!r} kg"
center_of_mass = ["{centre!r} m", "0 m", "0 m"]
inertia = ["{0.001 * mass!r} kg m^2", "{inertia * mass!r} kg m^2", "{inertia * mass!r} kg m^2"]
placement = {{ origin = ["{at[0]!r} m", "{at[1]!r} m", "0 m"], angle = "{math.degrees(turn)!r} deg" }}
"""


def pin(name, a, b, on_a, on_b):
    return f"""
[[joint]]
name = "{name}"
type = "revolute"
between = ["{a}", "{b}"]
at = {{ {a} = ["{on_a!r} m", "0 m", "0 m"], {b} = ["{on_b!r} m", "0 m", "0 m"] }}
axis = [0, 0, 1]
"""


def head(gravity=G):
    return f"""schema = 1
name = "hard motion"

[world]
gravity = ["0 m/s^2", "{-gravity!r} m/s^2", "0 m/s^2"]
"""


def settings(duration, instants, tolerance=1e-8):
    return f"""
[simulation]
duration = "{duration!r} s"
instants = {instants}
tolerance = {tolerance!r}
"""


def initial(joint, rate):
    return f"""
[[initial]]
joint = "{joint}"
rate = "{rate!r} rad/s"
"""


def drive(joint, start, end):
    return f"""
[[drive]]
joint = "{joint}"
law = "ramp"
from = "{start!r} deg"
to = "{end!r} deg"
duration = "1 s"
"""


def windows(turn, rates, duration, instants, tolerance):
    """The two-window four-bar; rates of its uprights from the first on."""
    c, s = math.cos(turn), math.sin(turn)
    text = head()
    for i in range(3):
        text += body(f"upright_{i}", at=(float(i), 0.0), turn=turn)
    for i in range(2):
        text += body(f"level_{i}", at=(i + c, s))
    for i in range(3):
        text += pin(f"A{i}", "ground", f"upright_{i}", float(i), 0.0)
    text += pin("B0", "upright_0", "level_0", 1.0, 0.0)
    text += pin("B1", "upright_1", "level_0", 1.0, 1.0)
    text += pin("C1", "upright_1", "level_1", 1.0, 0.0)
    text += pin("C2", "upright_2", "level_1", 1.0, 1.0)
    for i, rate in enumerate(rates):
        text += initial(f"A{i}", rate)
    return text + settings(duration, instants, tolerance)


def speed(turn):
    """Of the windows that were upright at 1 rad/s: 3/2 w^2 + 7/2 g sin."""
    return math.sqrt(1.0 + 7.0 / 3.0 * G * (1.0 - math.sin(turn)))


def time_to(turn):
    n, up = 4000, 0.5 * math.pi
    h = (turn - up) / n
    total = 1.0 / speed(up) + 1.0 / speed(turn)
    total += sum((4 if i % 2 else 2) / speed(up + i * h) for i in range(1, n))
    return abs(total * h / 3.0)


END = (0.328458111539, 0.944518538179)  # of the first corner at 10 s


def windows_row(case, variant, text, allowed, branch):
    exit_code, code, _, motion = simulate(text)
    if exit_code != 0:
        faults.append(f"{case}, {variant}: refused with {code}")
        return
    last = angle(motion[-1], "upright_0")
    error = math.hypot(math.cos(last) - END[0], math.sin(last) - END[1])
    off = max(abs(math.remainder(angle(row, f"upright_{i}") -
                                 angle(row, "upright_0"), 2.0 * math.pi))
              for row in motion for i in (1, 2))
    note(case, variant, error, allowed, f"branch kept to {off:.1e} rad")
    if off > branch:
        faults.append(f"{case}, {variant}: {off} rad off the branch")


def tolerances():
    for digits in range(3, 11):
        tolerance = 10.0 ** -digits
        windows_row("tolerance, ten change points", f"{tolerance:.0e}",
                    windows(0.5 * math.pi, [-1.0], 10.0, 101, tolerance),
                    2.0 * tolerance + 2e-9, 1e-8)


def instants():
    """Instants within steps beside a change point, where dense output may be
    rough."""
    _, _, document, motion = simulate(
        windows(0.3, 3 * [-2.0], 10.0, 1001, 1e-7))
    note("instants within steps", f"{len(motion)}, ten change points",
         document["motion"]["integration"]["relative_energy_error"], 1e-7,
         "energy, relative")


def starts():
    case = "start at a change point"
    for name, turn, count in (("0 deg", 0.0, 1), ("180 deg", -math.pi, 3)):
        for beside in (0.0, 1e-12, 1e-6):
            at = turn + beside
            windows_row(case, f"{name}, {beside:g} rad beside",
                        windows(at, count * [-speed(at)], 10.0 - time_to(at),
                                101, 1e-9), 2e-8, 1e-8)
    refused(case, "180 deg, one rate for four branches",
            windows(math.pi, [4.0], 1.0, 3, 1e-8), "K010")
    refused(case, "rates of no branch",
            windows(0.0, [-4.0, -3.0, -4.0], 1.0, 3, 1e-8), "K007")


def masses():
    """Simple pendulums on a heavy one: the energy is the oracle."""
    for light in (1e-6, 1e6):
        text = head() + body("first") + body("second", mass=light,
                                             at=(1.0, 0.0), turn=0.5)
        text += pin("O", "ground", "first", 0.0, 0.0)
        text += pin("E", "first", "second", 1.0, 0.0)
        _, _, _, motion = simulate(text + settings(5.0, 101))
        energies, size = [], 0.0
        for row in motion:
            a, b = angle(row, "first"), angle(row, "second")
            wa = row["first.angular_velocity_z_rad_per_s"]
            wb = row["second.angular_velocity_z_rad_per_s"]
            vx = -wa * math.sin(a) - 0.5 * wb * math.sin(b)
            vy = wa * math.cos(a) + 0.5 * wb * math.cos(b)
            kinetic = (wa * wa / 6.0 + light * (0.5 * (vx * vx + vy * vy) +
                                                wb * wb / 24.0))
            height = 0.5 * math.sin(a) + light * (math.sin(a) +
                                                  0.5 * math.sin(b))
            energies.append(kinetic + G * height)
            size = max(size, kinetic)
        note("mass ratio", f"{light:g}", (max(energies) - min(energies)) / size,
             1e-7, "energy, relative")


def wall():
    """1 kg on 100 N/m against a wall of 1e8 N/m: no loss without damping."""
    text = (GEOMETRY / "wall/scene.toml").read_text()
    text = text.replace('"1e5 N/m"', '"1e8 N/m"').replace('"20 N s/m"',
                                                          '"0 N s/m"')
    _, _, _, motion = simulate(text)
    # half a period on the spring, then half a period on the wall
    period = math.pi / 10.0 + math.pi / math.sqrt(1e8 + 100.0)
    worst = 0.0
    for row in motion:
        t = math.remainder(row["t_s"], period)
        if abs(t) > 0.49 * math.pi / 10.0:
            continue
        worst = max(worst, abs(1e-3 * row["mass.position_x_mm"] -
                               0.1 * math.cos(10.0 * t)))
    note("stiffness", "wall of 1e8 N/m", worst, 1e-7, "position [m], nine blows")


def friction():
    """No friction: 1000 s of a pendulum; friction of zero is none."""
    text = head() + body("rod", centre=0.5, inertia=0.25, turn=math.pi)
    text += pin("O", "ground", "rod", 0.0, 0.0)
    none = ('\n[[force]]\ntype = "friction"\nname = "none"\njoint = "O"\n'
            'breakaway = "0 N m"\nkinetic = "0 N m"\n')
    period = 2.367841947576237
    for case, variant, more in (("1000 s", "pendulum", ""),
                                ("zero friction", "pendulum, 1000 s", none)):
        _, _, _, motion = simulate(text + more +
                                   settings(422.0 * period, 1689, 1e-10))
        if not motion:
            faults.append(f"{case}: refused")
            continue
        # hanging, and fastest, at every odd quarter of a period
        quarter = 0.25 * period
        odd = [row for row in motion
               if round(row["t_s"] / quarter) % 2 == 1 and
               abs(row["t_s"] / quarter - round(row["t_s"] / quarter)) < 1e-9]
        if len(odd) != 844:
            faults.append(f"{case}: {len(odd)} odd quarters of 844")
            continue
        drift = max(abs(math.cos(angle(row, "rod"))) for row in odd)
        note(case, variant, drift, 1e-7, "422 periods by elliptic functions")


def loop(length=2.0, mass=1.0, drives=""):
    up = math.radians(30.0)
    at = (math.cos(up), math.sin(up))
    return (head() + body("crank", turn=up) +
            body("coupler", mass=mass, at=at) +
            body("rocker", at=(2.0, 0.0), turn=up) +
            pin("A", "ground", "crank", 0.0, 0.0) +
            pin("B", "crank", "coupler", 1.0, 0.0) +
            pin("C", "coupler", "rocker", length, 1.0) +
            pin("D", "ground", "rocker", 2.0, 0.0) + drives + settings(1.0, 11))


def refusals():
    one = drive("A", 30.0, 60.0)
    massless = "\n".join(
        line for i, line in enumerate(loop(drives=one).split("\n"))
        if i > 12 or not line.startswith(("mass", "center", "inertia")))
    refused("refused", "massless link", massless, "K006")
    refused("refused", "loop that cannot close", loop(4.5, drives=one), "K001")
    refused("refused", "contradictory drives",
            loop(drives=one + drive("D", 30.0, 100.0)), "K003")
    refused("refused", "[[initial]] against the drive",
            loop(drives=one + initial("A", 2.0)), "K007")


def write(folder):
    header = ("case", "variant", "measured", "allowed", "good", "remark")
    with open(folder / "hard_motions.csv", "w", encoding="utf-8",
              newline="") as file:
        csv.writer(file, lineterminator="\n").writerows([header, *rows])
    lines = ["# Hard cases of the mechanism", "",
             "Written by `python3 tests/regression/hard_motions.py "
             "build/release/bin/clevis geometry results/studies`; errors are in",
             "m on bars of 1 m unless the remark says otherwise, or what clevis "
             "answers.", "", "| " + " | ".join(header) + " |",
             "|" + 6 * "---|"]
    lines += ["| " + " | ".join(row) + " |" for row in rows]
    (folder / "hard_motions.md").write_text("\n".join(lines) + "\n")


for part in (tolerances, instants, starts, masses, wall, friction, refusals):
    part()
if len(sys.argv) > 3:
    write(Path(sys.argv[3]))
for row in rows:
    print("  ".join(row))
for fault in faults:
    print("FAULT", fault)
sys.exit(bool(faults))

#!/usr/bin/env python3
"""[[part.history]]: the loads of a mechanism's part, read back from the file
that `clevis check` wrote, stress the part alone as they did in the mechanism,
in the part's frame and in the world's; a bar pushed at one end is stressed as
its inertia asks; one that is struck, from the first instant of its file on, by a
wave; one that turns under its load is bent as it is between two
rows; a driven lever is held by its driven pin; and what is refused.

    load_history.py CLEVIS SOURCE_DIR
"""
import csv
import math
import re
import sys
import tempfile
from pathlib import Path

import hex_mesh
import support

CLEVIS = str(Path(sys.argv[1]).resolve())
SOURCE = Path(sys.argv[2]).resolve()
SAME = 1e-9  # relative: rounding of the loads' balance
faults = []


def near(name, found, wanted, tolerance):
    print(f"{name}: {found:.9g}, wanted {wanted:.9g}")
    if not abs(found - wanted) <= tolerance * abs(wanted):
        faults.append(f"{name}: {found}, not {wanted} within {tolerance}")


def scene(mesh, history, ratio):
    return f"""schema = 1
name = "history"
{support.steel(ratio)}
[[part]]
name = "part"
mesh = "{mesh}"
length_unit = "mm"
material = "steel"
limits = {{ safety_factor = 1.5 }}
[[part.history]]
name = "bench"
file = "loads.csv"
{history}
"""


def check(folder, mesh, history, table, exits=(0, 1), ratio=0.3):
    (folder / "loads.csv").write_text(table)
    (folder / "scene.toml").write_text(scene(mesh, history, ratio))
    return support.check(CLEVIS, folder / "scene.toml", exits=exits)


def rotation(w, x, y, z):
    """Matrix from the part's frame to the world of a unit quaternion."""
    return [[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]]


def in_world(text):
    """The same loads by a world in which the part stands askew and turns in
    its plane, by a fiftieth of a radian in all: slow enough for the rows alone."""
    rows = list(csv.reader(text.splitlines()))
    starts = [i for i, title in enumerate(rows[0]) if "_x [" in title]
    turned = [rows[0] + [f"orientation_{c}" for c in "wxyz"]]
    last = float(rows[-1][0])
    for row in rows[1:]:
        half = 0.01 * float(row[0]) / last
        c, s = math.cos(half), math.sin(half)
        w, x, y, z = 0.1, 0.5, -0.7, 0.5  # times a turn about the part's z
        q = [w * c - z * s, x * c + y * s, y * c - x * s, z * c + w * s]
        R = rotation(*q)
        new = list(row)
        for start in starts:
            v = [float(f) for f in row[start:start + 3]]
            for i in range(3):
                new[start + i] = repr(sum(R[i][k] * v[k] for k in range(3)))
        turned.append(new + [repr(c) for c in q])
    return "\n".join(",".join(row) for row in turned) + "\n"


def round_trip(folder):
    whole = support.check(CLEVIS, SOURCE / "geometry/landing_gear/loaded.toml",
                          "--part", "DCE", out=folder / "whole", exits=(0, 1))
    table = (folder / "whole/DCE_loads.csv").read_text()
    mesh = SOURCE / "meshes/landing_gear/link_dce.msh"
    pins = 'pins = { D = "bore_D", E = "bore_E", C = "bore_C" }\n'
    wanted = whole.part
    for frame, text in (("part", table), ("world", in_world(table))):
        found = check(folder, mesh, pins + f'frame = "{frame}"', text).part
        for key in ("value_MPa", "instant_s"):
            near(f"DCE, {frame}, {key}", found["peak_von_mises"][key],
                 wanted["peak_von_mises"][key], SAME)
        near(f"DCE, {frame}, deflection", found["deflection_mm"],
             wanted["deflection_mm"], 1e-6)
    slow = re.sub(r",(angular_)?(acceleration|velocity)_[xyz] \[[^]]*\]", "", table.splitlines()[0])
    width = len(slow.split(","))
    bare = "\n".join([slow] + [",".join(r.split(",")[:width])
                               for r in table.splitlines()[1:]]) + "\n"
    found = check(folder, mesh, pins, bare)
    # What the turning itself adds (its square) is in no force.
    near("DCE without accelerations", found.peak,
         wanted["peak_von_mises"]["value_MPa"], 1e-3)
    if "its file has no accelerations; those that balance its loads reach" not in found.text:
        faults.append("no word on accelerations that balance the loads")


LEVER = """[[body]]
name = "part"
part = "part"
placement = {{ origin = ["0 mm", "0 mm", "0 mm"] }}
[[joint]]
name = "A"
type = "revolute"
between = ["ground", "part"]
at = {{ ground = ["0 mm", "0 mm", "0 mm"], part = ["0 mm", "0 mm", "0 mm"] }}
axis = [0, 0, 1]
[simulation]
duration = "1 s"
instants = 11
[[drive]]
joint = "A"
law = "quintic"
from = "0 deg"
to = "60 deg"
duration = "1 s"
[[force]]
type = "spring"
name = "S"
between = ["ground", "part"]
from = ["100 mm", "-100 mm", "0 mm"]
to = ["140 mm", "0 mm", "0 mm"]
stiffness = "1 N/mm"
free = "60 mm"
[[part]]
name = "part"
mesh = "{mesh}"
length_unit = "mm"
material = "steel"
pins = {{ A = "bore_A" }}
drives = {{ A = {{ face = "bore_A" }} }}
forces = {{ S = {{ face = "bore_B" }} }}
"""


def driven_lever(folder):
    """It bends and buckles from its driven pin on, and not between its two pins."""
    mesh = SOURCE / "meshes/reference_link/link.msh"
    (folder / "lever.toml").write_text(f"""schema = 1
name = "lever"
[world]
gravity = ["0 m/s^2", "0 m/s^2", "0 m/s^2"]
{support.steel(0.3)}""" + LEVER.format(mesh=mesh))
    whole = support.check(CLEVIS, folder / "lever.toml", out=folder / "lever", exits=(0, 1))
    found = check(folder, mesh, 'pins = { A = "bore_A", "force S" = "bore_B" }\n'
                  'faces = { "drive A" = "bore_A" }',
                  (folder / "lever/part_loads.csv").read_text())
    # Each climbs to its own degree.
    near("driven lever, peak", found.peak, whole.peak, 3e-3)
    near("driven lever, deflection", found.part["deflection_mm"], whole.part["deflection_mm"], 1e-4)
    if "bore_A counts as what alone holds the part" not in found.text:
        faults.append("no word on the pin that holds the lever")


def pushed_bar(folder):
    """A free bar of 200 x 20 x 10 mm pushed at one end, in kN and ms: the
    stress falls along it as 1 - x/L; half way it is half of F/A."""
    support.gmsh(folder, """SetFactory("OpenCASCADE");
Rectangle(1) = {0, 0, 0, 200, 20};
Transfinite Curve {1, 3} = 21; Transfinite Curve {2, 4} = 5;
Transfinite Surface {1}; Recombine Surface {1};
out[] = Extrude {0, 0, 10} { Surface{1}; Layers{2}; Recombine; };
Physical Volume("bar") = {1};
near() = Surface In BoundingBox {-1, -1, -1, 1, 21, 11};
Physical Surface("near") = {near()};
""", name="bar")
    table = "time [ms],push.force_x [kN]\n0,0\n1,10\n2,4\n"
    answer = check(folder, "bar.msh", 'faces = { push = "near" }', table)
    near("bar pushed by 10 kN: peak", answer.peak, 50.0, 0.01)
    near("bar: when", answer.part["peak_von_mises"]["instant_s"], 1e-3, SAME)
    loads = "time [s],push.force_x [N],acceleration_x [m/s^2]\n"
    mass = 7850.0 * 0.2 * 0.02 * 0.01
    a = 1e4 / mass
    answer = check(folder, "bar.msh", 'faces = { push = "near" }',
                   loads + f"0,10000,{a * 0.995}\n")
    near("bar with 0.5 % missing: peak", answer.peak, 50.0, 0.01)
    if "its loads leave at most 50 N" not in answer.text:
        faults.append(f"the rest is not told:\n{answer.text}")
    refused(folder, "L001", "bar.msh", 'faces = { push = "near" }',
            loads + f"0,10000,{a * 0.9}\n")
    gravity = ('faces = { push = "near" }\n'
               f'gravity = ["{-a * 0.1} m/s^2", "0 m/s^2", "0 m/s^2"]')
    check(folder, "bar.msh", gravity, loads + f"0,10000,{a * 0.9}\n")


TURNING = ("time [s],push.force_y [N],orientation_w,orientation_x,"
           "orientation_y,orientation_z,angular_velocity_x [rad/s]\n")


def turning_row(time, degrees):
    half = math.radians(degrees) / 2
    return f"{time},100,{math.cos(half)!r},{math.sin(half)!r},0,0,0\n"


def turning_bar(folder):
    """A clamped bar of 200 x 10 x 10 mm, 100 N at its end that stand in space
    while it turns about its length: bent across its diagonal by
    6 sqrt(2) F l/h^3 half way between two rows, where they have less."""
    bar = hex_mesh.block((20, 2, 2),
                         lambda x, y, z: (200 * x, 10 * y - 5, 10 * z - 5))
    hex_mesh.write(folder / "bar.msh", bar)
    held = 'faces = { push = "x1" }\nfixed = { x0 = ["x", "y", "z"] }\n'
    truth = 6 * math.sqrt(2) * 100 * 200 / 10**3
    for way in ("linear", "unknown"):
        answer = check(folder, "bar.msh",
                       held + f'frame = "world"\ninterpolation = "{way}"',
                       TURNING + turning_row(0, 5) + turning_row(1, 85),
                       ratio=0.0)
        # The clamp adds to it.
        near(f"bar that turns, {way}: peak", answer.peak, truth, 0.03)
        near(f"bar that turns, {way}: when",
             answer.part["peak_von_mises"]["instant_s"], 0.5, 0.05)
    for rows in ((0, 90), (0, 180, 360), (0, 40, 150)):
        refused(folder, "S006", "bar.msh", held + 'frame = "world"',
                TURNING + "".join(turning_row(i, a) for i, a in enumerate(rows)))
    # Its spin draws as its square, its end is pushed back evenly: by
    # -b^2/(4 a) at most of a t^2 - b t.
    spin, push = 2257.33, 80e3
    drawn = 7850 * spin**2 * 0.2**3 / (3 * 210e9) * 1e3
    back = push * 0.2 / (210e9 * 1e-4) * 1e3
    answer = check(folder, "bar.msh", held + 'interpolation = "linear"',
                   "time [s],angular_velocity_z [rad/s],push.force_x [N]\n"
                   f"0,0,0\n1,{spin},{-push}\n", ratio=0.0)
    near("bar that spins up: deflection", answer.part["deflection_mm"],
         back**2 / (4 * drawn), 0.01)


def held_where_its_reaction_is_given(folder):
    """The held end's section carries F/A, whether the file has its reaction or not."""
    bar = hex_mesh.block((10, 2, 2),
                         lambda x, y, z: (200 * x, 10 * y - 5, 10 * z - 5))
    hex_mesh.write(folder / "bar.msh", bar)
    held = 'fixed = { x0 = ["x", "y", "z"] }\n'
    for faces, columns, row in (('push = "x1"', "push.force_x [N]", "3000"),
                                ('push = "x1", root = "x0"',
                                 "push.force_x [N],root.force_x [N]", "3000,-3000")):
        found = check(folder, "bar.msh", f"faces = {{ {faces} }}\n{held}",
                      f"time [s],{columns}\n0,{row}\n", exits=support.JUDGED)
        near(f"section of the held end, {faces}",
             found.part["support_section"]["nominal_stress_MPa"], 30.0, 1e-6)


COLUMN = """[[body]]
name = "part"
part = "part"
placement = {{ origin = ["0 mm", "0 mm", "0 mm"] }}
[[joint]]
name = "W"
type = "weld"
between = ["ground", "part"]
at = {{ ground = ["0 mm", "0 mm", "0 mm"], part = ["0 mm", "0 mm", "0 mm"] }}
[simulation]
duration = "1 s"
instants = 2
[[force]]
name = "load"
type = "constant"
body = "part"
point = ["200 mm", "0 mm", "0 mm"]
force = ["-15 kN", "300 N", "0 N"]
[[part]]
name = "part"
mesh = "bar.msh"
length_unit = "mm"
material = "steel"
pins = {{ W = "x0" }}
forces = {{ load = {{ face = "x1" }} }}
"""


def welded_column(folder):
    """It buckles from its weld on, by whose moment it is known, under Euler's quarter;
    pressed at both ends without a moment nobody knows, and the band reaches down to it."""
    bar = hex_mesh.block((20, 2, 2),
                         lambda x, y, z: (200 * x, 10 * y - 5, 10 * z - 5))
    hex_mesh.write(folder / "bar.msh", bar)
    (folder / "column.toml").write_text(f"""schema = 1
name = "column"
[world]
gravity = ["0 m/s^2", "0 m/s^2", "0 m/s^2"]
{support.steel(0.3)}""" + COLUMN.format())
    whole = support.check(CLEVIS, folder / "column.toml", out=folder / "column",
                          exits=support.JUDGED).part
    found = check(folder, "bar.msh", 'faces = { W = "x0", "force load" = "x1" }',
                  (folder / "column/part_loads.csv").read_text(), exits=support.JUDGED).part
    euler = math.pi**2 * 210e3 * 10**4 / 12 / 4 / 200**2 / 15e3
    near("welded column, buckling", found["buckling"]["factor"], euler, 5e-3)
    for key in ("buckling", "deflection_mm"):
        one, other = (part[key]["factor"] if key == "buckling" else part[key]
                      for part in (found, whole))
        near(f"welded column, {key} as in its mechanism", one, other, 1e-3)
    found = check(folder, "bar.msh", 'faces = { l = "x0", r = "x1" }',
                  "time [s],l.force_x [N],r.force_x [N]\n0,1000,-1000\n",
                  exits=support.JUDGED).part["buckling"]
    near("pressed at both ends, buckling", found["factor"], 4 * 15 * euler, 0.02)
    near("pressed at both ends, its band", found["band"][0], 15 * euler, 0.02)


def struck_bar(folder):
    """A clamped bar of 200 x 10 x 10 mm, pulled by 1 kN from one instant on: waves
    double the stress and the stretch (d'Alembert), whether it is the first instant
    of the file or not, and whatever it bore before."""
    bar = hex_mesh.block((20, 2, 2),
                         lambda x, y, z: (200 * x, 10 * y - 5, 10 * z - 5))
    hex_mesh.write(folder / "bar.msh", bar)
    held = 'faces = { push = "x1" }\nfixed = { x0 = ["x", "y", "z"] }\n'
    for start in (0.0, 1e-3):
        for before in (0, 400):
            rows = [(start, before), (start, 1000), (start + 1e-3, 1000)]
            if start > 0.0:
                rows.insert(0, (0.0, before))
            answer = check(folder, "bar.msh", held + 'interpolation = "linear"',
                           "time [s],push.force_x [N]\n" +
                           "".join(f"{t},{f}\n" for t, f in rows), ratio=0.0)
            truth = 2 * 1000 - before
            what = f"bar struck at {start} s from {before} N"
            near(f"{what}: stress", answer.part["vibration"]["peak_MPa"],
                 truth / 100, 0.03)
            stretch = truth * 0.2 / (210e9 * 1e-4) * 1e3
            near(f"{what}: deflection", answer.part["deflection_mm"], stretch, 0.03)
            low, high = answer.part["deflection_band_mm"]
            if not stretch * 0.97 < high < stretch * 1.15:
                faults.append(f"{what}: deflection {low} to {high} mm")


def refused(folder, code, mesh, history, table):
    answer = check(folder, mesh, history, table, exits=(10, 11, 12))
    line = answer.text.strip().splitlines()[0]
    print(f"refused: {line}")
    if code not in answer.codes:
        faults.append(f"{code} expected for {table!r}: {answer.text}")


def refusals(folder):
    faces = 'faces = { push = "near" }'
    for code, history, table in (
            ("S003", faces, "push.force_x [N]\n1\n"),
            ("S002", faces, "time [s],push.force_x [N],t2 [s]\n0,1,0\n"),
            ("S004", faces, "time [s],push.force_x\n0,1\n"),
            ("S004", faces, "time [s],push.force_x [mm]\n0,1\n"),
            ("S005", faces, 'time [s],push.force_x [N]\n0,"1,5"\n'),
            ("S005", faces, "time [s],push.force_x [N]\n0,nan\n"),
            ("S006", faces, "time [s],push.force_x [N]\n1,1\n0,1\n"),
            ("S012", faces, "time [s],push.force_x [N]\n0\n"),
            ("S012", faces, "time [s],time [s],push.force_x [N]\n0,0,1\n"),
            ("S012", faces, ""),
            ("S003", "", "time [s]\n0\n"),
            ("S007", 'faces = { pull = "near" }', "time [s],push.force_x [N]\n0,1\n"),
            ("M003", "", "time [s],push.force_x [N]\n0,1\n"),
            ("L002", 'pins = { push = "near" }', "time [s],push.force_x [N]\n0,1\n"),
            ("S003", faces + '\nframe = "world"', "time [s],push.force_x [N]\n0,1\n"),
            ("S010", faces + '\nlargest_imbalance = "5 %"',
             "time [s],push.force_x [N]\n0,1\n"),
            ("S006", faces + '\nframe = "world"',
             "time [s],push.force_x [N],orientation_w,orientation_x,"
             "orientation_y,orientation_z\n0,1,1,1,0,0\n")):
        refused(folder, code, "bar.msh", history, table)


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        round_trip(folder)
        driven_lever(folder)
        pushed_bar(folder)
        refusals(folder)
        turning_bar(folder)
        struck_bar(folder)
        held_where_its_reaction_is_given(folder)
        welded_column(folder)
    for fault in faults:
        print("FAULT", fault)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())

#!/usr/bin/env python3
"""What linear statics leaves out: loads act on what they displace. A column pressed
to 1/1.6 of its Euler load and pushed across, a shaft off its axis near its critical
speed, against closed forms of the bent beam; the same far below, where nothing counts.
What may not pass: a column whose loads change between two rows of a history, one of
few cells, a ring under a fluid's pressure, a blade whose spin softens it.

    second_order.py CLEVIS
"""
import math
import sys
import tempfile
from pathlib import Path

import hex_mesh
import scene_text
import support

LENGTH, SIDE, MODULUS, DENSITY = 0.4, 0.01, 210e9, 7850.0
AREA, SECOND_MOMENT = SIDE**2, SIDE**4 / 12
BENDING = MODULUS * SECOND_MOMENT
OFF = 1e-3  # of the shaft's axis


def write_bar(folder, off=0.0):
    """Along x, its axis at y = off."""
    scene_text.write_bar(folder, (LENGTH, SIDE, SIDE), (16, 2, 2), off)


PART = scene_text.BAR + """\
limits = { safety_factor = 1.5, deflection = "8 mm", singular_zones = "exclude" }
"""
MATERIAL = support.steel(ratio=0.0)


def case(name, press, across):
    """Pressed and pushed across at the tip [N]."""
    return f"""[[part.case]]
name = "{name}"
fixed = {{ x0 = ["x", "y", "z"] }}
traction = {{ x1 = ["{-1e-6 * press / AREA} MPa", "{1e-6 * across / AREA} MPa", "0 MPa"] }}
"""


def column(folder, share, across):
    """Pressed by a share of Euler's load, pushed across at its tip [N]."""
    write_bar(folder)
    press = share * math.pi**2 * BENDING / 4 / LENGTH**2
    file = folder / "scene.toml"
    file.write_text(scene_text.head("column", MATERIAL, world="") + PART +
                    case("press", press, across))
    k = math.sqrt(press / BENDING)
    moment = across * math.tan(k * LENGTH) / k
    tip = across / press * (math.tan(k * LENGTH) / k - LENGTH)
    linear = across * LENGTH
    stress = [1e-6 * (m * SIDE / 2 / SECOND_MOMENT + press / AREA) for m in (moment, linear)]
    return file, stress[0] / stress[1], tip / (across * LENGTH**3 / 3 / BENDING)


def shaft(folder, share):
    """Welded to a hub that spins at a share of its first critical speed."""
    write_bar(folder, OFF)
    critical = 1.8751040687**2 * math.sqrt(BENDING / (DENSITY * AREA * LENGTH**4))
    omega = share * critical
    file = folder / "scene.toml"
    file.write_text(scene_text.head("shaft", MATERIAL) + scene_text.part_body("bar") +
                    scene_text.body("hub", "5 kg", "0.01 kg m^2") +
                    scene_text.joint("A", "revolute", "ground", "hub", axis=(1, 0, 0)) +
                    scene_text.joint("W", "weld", "hub", "bar", (0, 1e3 * OFF, 0)) +
                    f"""[[drive]]
joint = "A"
law = "speed"
from = "0 deg"
speed = "{omega * 30 / math.pi} rpm"
[simulation]
duration = "0.1 s"
{PART}pins = {{ W = "x0" }}
""")
    # EI w'''' = rho A omega^2 w from w = OFF, clamped; the tip free
    x = math.sqrt(omega / critical) * 1.8751040687
    k = x / LENGTH
    C, c, S, s = math.cosh(x), math.cos(x), math.sinh(x), math.sin(x)
    p, q = -OFF / 2 * (C - c), -OFF / 2 * (S + s)
    det = (C + c)**2 - (S + s) * (S - s)
    a = (p * (C + c) - q * (S + s)) / det
    b = ((C + c) * q - (S - s) * p) / det
    moment = abs(2 * a * k * k) * BENDING
    tip = OFF / 2 * (C + c) + a * (C - c) + b * (S - s) - OFF
    load = DENSITY * AREA * omega**2 * OFF
    return (file, moment / (load * LENGTH**2 / 2),
            tip / (load * LENGTH**4 / 8 / BENDING))


def among_others(folder):
    """The case that rises most is neither the one that buckles first nor the one with
    the largest stress at rest. @return its stress [MPa]."""
    write_bar(folder)
    euler = math.pi**2 * BENDING / 4 / LENGTH**2
    cases = [("press", 0.6, 0), ("bend", 0, 70), ("both", 0.58, 55)]
    file = folder / "scene.toml"
    file.write_text(scene_text.head("three cases", MATERIAL, world="") + PART + "".join(
        case(name, share * euler, across) for name, share, across in cases))
    _, share, across = cases[2]
    k = math.sqrt(share * euler / BENDING)
    moment = across * math.tan(k * LENGTH) / k
    return file, 1e-6 * (moment * SIDE / 2 / SECOND_MOMENT + share * euler / AREA)


def history(folder):
    """What presses rises as what bends falls, on a straight line between two rows.
    @return (file, largest stress at the ends, and on the way [MPa])."""
    write_bar(folder)
    press = 0.62 * math.pi**2 * BENDING / 4 / LENGTH**2
    across = press / AREA * SECOND_MOMENT / (SIDE / 2) / LENGTH  # as much stress
    (folder / "loads.csv").write_text(
        "time [s],x1.force_x [N],x1.force_y [N],x1.force_z [N]\n"
        f"0,0,{across},0\n1,{-press},0,0\n")

    def stress(share):
        axial, lateral = share * press, (1 - share) * across
        k = math.sqrt(axial / BENDING)
        moment = lateral * (math.tan(k * LENGTH) / k if k > 0 else LENGTH)
        return 1e-6 * (moment * SIDE / 2 / SECOND_MOMENT + axial / AREA)
    ends = max(stress(0.0), stress(1.0))
    most = max(stress(i / 1000) for i in range(1001))
    file = folder / "scene.toml"
    safety = f"{355 / (0.4 * ends + 0.6 * most)}, buckling = 1.5"
    file.write_text(scene_text.head("history", MATERIAL, world="") +
                    PART.replace("1.5", safety) + """[[part.history]]
name = "press"
file = "loads.csv"
interpolation = "linear"
fixed = { x0 = ["x", "y", "z"] }
faces = { x1 = "x1" }
""")
    return file, ends, most


def coarse(folder):
    """A column of four cells, which are too stiff; its limit is 1 % below what it
    deflects by (CalculiX C3D20R, 4 x 4 x 60, NLGEOM: 0.9398 mm; beam 0.9364)."""
    scene_text.write_bar(folder, (0.2, 0.01, 0.01), (4, 1, 1))
    file = folder / "scene.toml"
    file.write_text(scene_text.head("coarse", """[material.steel]
youngs_modulus = "1 GPa"
poissons_ratio = 0.3
density = "1100 kg/m^3"
yield_strength = "100 MPa"
""", world="") + PART.replace("8 mm", "0.93 mm") + """[[part.case]]
name = "press"
fixed = { x0 = ["x", "y", "z"] }
traction = { x1 = ["-0.34 MPa", "0.001 MPa", "0 MPa"] }
""")
    return file


def ring(folder):
    """Quarter of a ring of 50 x 1 mm, 0.5 mm out of round, in a fluid of 0.27 MPa:
    130.3 MPa ([TimoshenkoGere] 7.5, p_cr = 3EI/R^3), 106.7 are allowed; as a dead
    load 98.9."""
    def at(x, y, z):
        angle = (1 - x) * math.pi / 2
        radius = 50 + 0.5 * math.cos(2 * angle) + (y - 0.5)
        return radius * math.cos(angle), radius * math.sin(angle), 10 * z
    hex_mesh.write(folder / "ring.msh", hex_mesh.block((64, 1, 1), at))
    file = folder / "scene.toml"
    file.write_text(scene_text.head("ring", support.steel(strength=160.0), world="") +
                    """[[part]]
name = "ring"
mesh = "ring.msh"
length_unit = "mm"
material = "steel"
limits = { safety_factor = 1.5 }
[[part.case]]
name = "press"
fixed = { x0 = ["x"], x1 = ["y"], z0 = ["z"] }
pressure = { y1 = "0.27 MPa" }
""")
    return file


def blade(folder):
    """Points from its hub's rim, at 300 mm, to the axis: its own spin presses and
    softens it. It bears 1.25 times its loads (Ritz; 1.60 without softening)."""
    hex_mesh.write(folder / "blade.msh", hex_mesh.block(
        (20, 1, 1), lambda x, y, z: (300 - 100 * x, 5 * (0.5 - y), 5 * (z - 0.5))))
    file = folder / "scene.toml"
    file.write_text("""schema = 1
name = "blade"
[material.plastic]
youngs_modulus = "2 GPa"
poissons_ratio = 0.3
density = "1200 kg/m^3"
yield_strength = "60 MPa"
[[part]]
name = "blade"
mesh = "blade.msh"
length_unit = "mm"
material = "plastic"
limits = { safety_factor = 1, buckling = 1.5, singular_zones = "exclude" }
[[part.case]]
name = "spin"
fixed = { x0 = ["x", "y", "z"] }
traction = { x1 = ["0 MPa", "0.002 MPa", "0 MPa"] }
angular_velocity = ["0 rpm", "0 rpm", "2630 rpm"]
""")
    return file


# value, truth, and what it may be over it: a fluid's pressure errs to the safe side
KNOWN = {"coarse": ("deflection_mm", 0.9398, 0.99, 1.01),
         "ring": ("peak_MPa", 130.3, 1.0, 1.15)}


def flat_disc(folder):
    """A quarter of a disc, 5 to 100 mm, that spins at 8000 rpm and is held in its
    plane alone: too slow to count. @return (file, stress at the bore [MPa])."""
    inner, outer, ratio, omega = 0.005, 0.1, 0.3, 8000 * math.pi / 30

    def at(x, y, z):
        radius, angle = 1e3 * inner * (outer / inner)**x, y * math.pi / 2
        return radius * math.cos(angle), radius * math.sin(angle), 6 * z
    hex_mesh.write(folder / "disc.msh", hex_mesh.block((8, 12, 2), at, {"x0": "bore_in"}))
    file = folder / "scene.toml"
    file.write_text(f"""{scene_text.head("disc", support.steel(ratio), world="")}
[[part]]
name = "disc"
mesh = "disc.msh"
length_unit = "mm"
material = "steel"
limits = {{ safety_factor = 1.5 }}
[[part.case]]
name = "spin"
fixed = {{ y0 = ["y"], y1 = ["x"] }}
angular_velocity = ["0 rpm", "0 rpm", "8000 rpm"]
""")
    return file, 1e-6 * (3 + ratio) / 4 * DENSITY * omega**2 * (
        outer**2 + (1 - ratio) / (3 + ratio) * inner**2)


def disc_passes(clevis, faults):
    with tempfile.TemporaryDirectory() as name:
        scene, exact = flat_disc(Path(name))
        answer = support.check(clevis, scene, exits=support.JUDGED)
    print(f"flat disc: {answer.part['verdict']}; {answer.peak:.2f} MPa, exact {exact:.2f}, "
          f"{answer.part['why']}")
    if answer.part["verdict"] != "pass" or abs(answer.peak / exact - 1) > 0.005:
        faults.append(f"flat disc: {answer.part['verdict']}, {answer.peak}")


def may_not_pass(clevis, faults):
    for make in (history, coarse, ring, blade):
        with tempfile.TemporaryDirectory() as name:
            scene = make(Path(name))
            scene, *stress = scene if isinstance(scene, tuple) else (scene,)
            part = support.check(clevis, scene, exits=support.JUDGED).part
        found = part["second_order"]
        print(f"{make.__name__}: {part['verdict']}; {found['peak_MPa']:.1f} MPa, "
              f"{found['deflection_mm']:.4f} mm, {part['why']}")
        if part["verdict"] == "pass":
            faults.append(f"{make.__name__} passes: {part['why']}")
        if make.__name__ in KNOWN:
            key, truth, low, high = KNOWN[make.__name__]
            if not low <= found[key] / truth <= high:
                faults.append(f"{make.__name__}: {found[key]} instead of {truth}")
        if stress and abs(found["peak_MPa"] / stress[1] - 1) > 0.015:
            faults.append(f"{make.__name__}: {found['peak_MPa']} instead of {stress[1]}")
        if stress and not 1.05 * stress[0] < stress[1]:
            faults.append(f"{make.__name__}: nothing happens on the way")


def main():
    clevis = Path(sys.argv[1]).resolve()
    faults = []
    with tempfile.TemporaryDirectory() as name:
        scene, exact = among_others(Path(name))
        part = support.check(clevis, scene, exits=support.JUDGED).part
    found = part["second_order"]
    print(f"three cases: {part['verdict']}; {found['peak_MPa']:.1f} MPa at {found['case']}, "
          f"beam theory {exact:.1f}")
    if part["verdict"] != "fail" or found["case"] != "both":
        faults.append(f"three cases: {part['verdict']} {part['why']}")
    if abs(found["peak_MPa"] / exact - 1.0) > 0.015:
        faults.append(f"three cases: {found['peak_MPa']} instead of {exact}")
    for what, make, verdict in (
            ("column at 1/1.6 of Euler's load", lambda f: column(f, 1 / 1.6, 60), "fail"),
            ("column at a fifteenth", lambda f: column(f, 1 / 15, 60), "pass"),
            ("shaft at 0.95 of its critical speed", lambda f: shaft(f, 0.95), "fail"),
            ("shaft at 0.5", lambda f: shaft(f, 0.5), "pass"),
            ("shaft at 0.05", lambda f: shaft(f, 0.05), "pass"),
            ("shaft at 1.02", lambda f: shaft(f, 1.02), "not judged")):
        with tempfile.TemporaryDirectory() as name:
            scene, stress, tip = make(Path(name))
            part = support.check(clevis, scene, exits=support.JUDGED).part
        found = part["second_order"]
        print(f"{what}: {part['verdict']}; second order over linear theory "
              f"{found and (round(found['stress_ratio'], 4), round(found['deflection_ratio'], 4))}, "
              f"beam theory {stress:.4f} {tip:.4f}")
        if part["verdict"] != verdict:
            faults.append(f"{what}: {part['verdict']} {part['why']}")
        if verdict == "not judged":
            continue
        got = ((found["stress_ratio"], found["deflection_ratio"]) if found
               else (1.0, 1.0))
        for value, exact in zip(got, (stress, tip)):
            # where it is left out, up to a tenth of buckling
            allowed = 0.015 * exact if found else 0.1
            if abs(value - exact) > allowed:
                faults.append(f"{what}: {value:.4f} instead of {exact:.4f}")
    may_not_pass(clevis, faults)
    disc_passes(clevis, faults)
    sys.exit("\n".join(faults) or None)


if __name__ == "__main__":
    main()

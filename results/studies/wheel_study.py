"""Studies of wheels on the ground and of impedance control; for
make_contact_systems, which knows where the tests' modules are."""
import json
import math
import subprocess
from pathlib import Path

from closed_forms import LandingGear
from drops import Drop
from figures import plot
from impedance import (DAMPING, MASS, STIFFNESS, WALL_FORMULA, arc, led_by,
                       ring_down, wall_by, wall_force)
from pieces import restitution
from runs import changed, forces, reactions, simulate
from wheel import IMPACT_LAWS, drop, drop_impact, ground_force

GEOMETRY = Path(__file__).resolve().parents[2] / "geometry"


def drop_study(clevis, folder):
    yield "## Wheel on the ground\n"
    yield ("**Free wheel** (`geometry/wheel/drop.toml`), dropped from 50 mm with "
           "0.3 m/s forward; Simscape's default parameters: 1e6 N/m, 1e3 N s/m, "
           "growth over 0.1 mm, friction 0.5 and 0.3 about 1 mm/s. *Published*: "
           "only that force grows with depth and speed, k d + b d'. "
           "*Corrected*: never below zero, with and without the growth, which "
           "the source leaves open. One impact at 1 m/s without weight:\n")
    yield ("| contact | 1 kg: speed back | exact | 5 kg: speed back | exact |"
           "\n|---|---|---|---|---|")
    laws = IMPACT_LAWS | {"never pulls, grows over 0.1 mm":
                          ('transition = "0.1 mm"', None)}
    for name, (law, pulls) in laws.items():
        cells = []
        for mass in (1, 5):
            exact = (-Drop(1e-4, m=mass, g=0.0).press(1.0)[2]
                     if pulls is None else
                     restitution(1e6, mass, 1e3, pulls)[0])
            found = drop_impact(clevis, GEOMETRY, folder, mass, law)
            cells += [f"{found:.4f}", f"{exact:.4f}"]
        yield f"| {name} | {' | '.join(cells)} |"
    yield ("\n| dropped | two bounces off s | depth at rest um | exact | rolls in "
           "the end m/s | exact |\n|---|---|---|---|---|---|")
    for transition in (0.0, 1e-4):
        exact = Drop(transition)
        depth, events, rows = drop(clevis, GEOMETRY, folder, transition)
        worst = max(abs(a - t) for a, (t, _, _) in
                    zip(exact.bounces(0.050, 2), events))
        yield (f"| growth over {1e3 * transition} mm | {worst:.0e} | {depth:.4f} "
               f"| {1e6 * exact.static_depth():.4f} | "
               f"{rows[-1]['wheel.velocity_x_m_per_s']:.6f} | 0.200000 |")
    plot("wheel_drop.svg", 'set xlabel "t [s]"\nset ylabel "height [mm]"\n'
         'set key top right',
         {"under the wheel": [(row["t_s"], row["wheel.position_y_mm"] - 40)
                              for row in rows[:800:2]]}, "1:2")
    yield ("\nThe depth m g/k = 9.81 um belongs to a force without growth; with "
           "Simscape's growth over 0.1 mm the wheel rests at more than three "
           "times that. Friction never exceeded half the normal force.\n")
    yield "![bounces](wheel_drop.svg)\n"


def driven_ground(clevis, folder, overlap):
    """simulate.json of the landing gear whose wheel is driven `overlap` mm
    into the ground."""
    floor = LandingGear(260).T[1] + overlap
    scene = changed(GEOMETRY / "landing_gear/ground.toml", folder,
                    ("-171.81 mm", f"{floor!r} mm"))
    return simulate(clevis, scene, folder)[0]


def ground_study(clevis, folder):
    yield ("**Landing gear** (`geometry/landing_gear/ground.toml`), its wheel "
           "driven 1 mm into the ground by the last 0.3 mm of the cylinder's "
           "stroke; contact as above. Forces of the ground against the closed form "
           "of the prescribed motion, and reactions at rest against statics: "
           "`verification.mechanism.contact_systems`. Reactions in N:\n")
    result, rows, _ = simulate(
        clevis, GEOMETRY / "landing_gear/ground.toml", folder)
    ground = forces(folder)
    off = max(max(abs(row["ground.effort_N"] - normal),
                  abs(row["ground.friction_N"] - abs(friction)))
              for row in ground
              for normal, friction in [ground_force(row["t_s"])])
    rest = reactions(folder, 2.0)
    plot("ground_forces.svg", 'set xlabel "t [s]"\nset ylabel "force [N]"',
         {name: [(row["t_s"], row[f"ground.{key}_N"]) for row in ground[320:]]
          for name, key in (("normal", "effort"), ("friction", "friction"))},
         "1:2")
    plot("ground_wheel.svg", 'set xlabel "t [s]"\nset ylabel "T [mm]"',
         {axis: [(row["t_s"], row[f"T.marker_{axis}_mm"])
                 for row in rows] for axis in "xy"}, "1:2")
    by_force, _, _ = simulate(
        clevis, GEOMETRY / "landing_gear/ground_by_force.toml", folder)
    pushed = reactions(folder, 3.0)
    last = forces(folder)[-1]["ground.effort_N"]
    yield ("| pair | driven: peak | at s | driven: at rest | pushed with 3500 N: "
           "peak | after 3 s |\n|---|---|---|---|---|---|")
    for joint, other in zip(result["joints"], by_force["joints"]):
        name = joint["name"]
        yield (f"| {name} | {joint['peak_force_N']:.0f} | "
               f"{joint['peak_force_at_s']:.3f} | {rest[name]:.0f} | "
               f"{other['peak_force_N']:.0f} | {pushed[name]:.0f} |")
    yield (f"\nThe forces of the ground are within {off:.0e} N of the closed form. "
           "The peaks come while the wheel still slides: it is friction that "
           "loads A and B. At rest friction is zero, as this smooth law has no "
           "stick.\n")
    yield "![forces of the ground](ground_forces.svg)\n"
    yield "![path of T](ground_wheel.svg)\n"
    yield ("**What the published caveat means.** The source takes its forces for "
           "untrue because of two fixing points. In the plane all reactions are "
           "unique; of the six constraints that are redundant in space none acts "
           "in this plane. The true reason is a prescribed motion against "
           "a penalty: force = stiffness x overlap.\n")
    yield "| overlap mm | ground at rest N | peak at D N |\n|---|---|---|"
    for overlap in (0.5, 1.0, 2.0):
        run = driven_ground(clevis, folder, overlap)
        peak = next(j["peak_force_N"] for j in run["joints"]
                    if j["name"] == "D")
        end = forces(folder)[-1]["ground.effort_N"]
        yield f"| {overlap} | {end:.0f} | {peak:.0f} |"
    yield ("\nPushed by a force (`ground_by_force.toml`) the cylinder's 3500 N "
           f"decide: {last:.0f} N after 3 s, when the wheel has all but stopped "
           "creeping, by the virtual work of push, weights and what friction is "
           "left. The published 1000 N cannot be told from an overlap that "
           "somebody chose.\n")


def stress_study(clevis, folder):
    """The driven ground scene checked to its verdict."""
    subprocess.run([clevis, "check", GEOMETRY / "landing_gear/ground.toml",
                    "--out", folder], capture_output=True, check=False)
    result = json.loads((Path(folder) / "result.json").read_text())
    yield ("**From the ground to stress.** `clevis check geometry/landing_gear/"
           "ground.toml`: the contact acts on the wheel, which is welded to a "
           "bore of BC.\n")
    yield ("| part | peak MPa | band MPa | at s | safety | verdict | why |\n"
           "|---|---|---|---|---|---|---|")
    for part in result["parts"]:
        peak = part["peak_von_mises"]
        low, high = peak["band_MPa"]
        yield (f"| {part['name']} | {peak['value_MPa']:.1f} | {low:.1f} to "
               f"{high:.1f} | {peak['instant_s']:.2f} | "
               f"{part['safety_factor']:.2f} | {part['verdict']} | "
               f"{part['why']} |")
    yield ("\nThe worst instant is that of the greatest friction, which bends "
           "BC.\n")


def impedance_study(clevis, folder):
    yield "## Impedance control of the landing gear's wheel\n"
    yield ("T, the wheel's lowest point, is held by F = -K (x - x0) - "
           "b (v - v0), K = 5 N/mm; the cylinder is free, so only the part "
           "along T's path (a circle of 140 mm) can be imposed. The source "
           "gives no numbers. b = 75.2 N s/m is a damping ratio of 0.7 with the "
           f"{MASS:.4f} kg that T moves at l_x = 210 mm (kinetic energy of all "
           "links, closed form).\n")
    yield "| | found | closed form |\n|---|---|---|"
    _, rows, _ = simulate(
        clevis, GEOMETRY / "landing_gear/impedance.toml", folder)
    way = arc(next(row for row in rows if row["t_s"] == 1))
    yield (f"| way under 50 N along the path, mm | {way:.6f} | "
           f"{140 * math.atan(50 / (STIFFNESS * 0.140)):.6f} on the arc, "
           "P/K = 10 |")
    plot("impedance_push.svg", 'set xlabel "t [s]"\nset ylabel "way [mm]"\n'
         'unset key', {"T": [(row["t_s"], arc(row)) for row in rows[::3]]},
         "1:2")
    exact = math.sqrt(STIFFNESS / MASS) / (2 * math.pi)
    for wanted in (0.7, 0.1):
        damping = 2 * wanted * math.sqrt(STIFFNESS * MASS)
        frequency, ratio = ring_down(clevis, GEOMETRY, folder, damping)
        yield (f"| frequency of the ring-down, damping ratio {wanted}, Hz | "
               f"{frequency:.4f} | {exact:.4f} |\n| its damping ratio | "
               f"{ratio:.5f} | {wanted} |")
    curves = {}
    for damping_of, lag in (("absolute", DAMPING * 0.1 / 5), ("relative", 0)):
        rows, found = led_by(clevis, GEOMETRY, folder, damping_of)
        name = {"absolute": "published", "relative": "corrected"}[damping_of]
        yield (f"| lag behind a target at 0.1 m/s, {name}, mm | {found:.4f} | "
               f"{lag:.4f} |")
        curves[name] = [(row["t_s"], 100 * row["t_s"] - arc(row))
                        for row in rows[:451]]
    plot("impedance_lag.svg", 'set xlabel "t [s]"\nset ylabel "lag [mm]"',
         curves, "1:2")
    found = wall_by(clevis, GEOMETRY, folder)
    yield (f"| force on a wall of 1e5 N/m, target 9 mm behind it, N | "
           f"{found:.4f} | {wall_force():.4f} on the arc, "
           f"{WALL_FORMULA:.4f} straight |")
    yield ("\n*Published*, equation (4.4): b damps the absolute speed, and a moving "
           "target is followed b v / K late. *Corrected*: relative to the "
           "target, no lag. The source's model holds no controller at all: a "
           "contact does not implement (4.4). Here the force acts at T itself; "
           "a cylinder that makes it pushes with F . dT/dl_x, and then the pins "
           "carry other forces than these scenes print.\n")
    yield "![push](impedance_push.svg)\n"
    yield "![lag](impedance_lag.svg)\n"

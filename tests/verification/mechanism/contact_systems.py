#!/usr/bin/env python3
"""Runs `clevis simulate` on the scenes with contact, friction and impedance
and compares with their closed forms.

    contact_systems.py CLEVIS GEOMETRY
"""
import csv
import math
import re
import sys
import tempfile
from pathlib import Path

import source_systems
from closed_forms import LandingGear
from pieces import (Drop, Tribometer, Wall, belt, cranked, restitution,
                    swinging)
from source_systems import expect, faults

WALLS = {"scene": Wall(), "published": Wall(pulls=True),
         "friction": Wall(breakaway=1.4715, kinetic=0.981, viscous=0.5)}

TRIBOMETERS = {"scene": Tribometer(swinging), "belt": Tribometer(belt),
               "crank": Tribometer(cranked)}
# times [s] and upper platform [mm] that the source's parameters give
KNOWN = [(0.075907125, 4.590615), (0.168777, 1.0982), (0.448316, -4.4370),
         (0.551973, -1.5622), (0.607845, -4.6238), (0.696681, -1.0970),
         (0.935814, 4.4225), (1.040140, 1.6426)]


def simulate(clevis, scene, folder):
    """(simulate.json, rows of motion.csv, [(t, force, event)])"""
    result, rows = source_systems.simulate(clevis, scene, folder)
    with open(Path(folder) / "events.csv", newline="") as file:
        events = [(float(row["t_s"]), row["force"], row["event"])
                  for row in csv.DictReader(file)]
    return result, rows, events


def forces(folder):
    with open(Path(folder) / "forces.csv", newline="") as file:
        return [{key: float(value) for key, value in row.items()}
                for row in csv.DictReader(file)]


def changed(scene, folder, *replacements):
    """A copy of the scene with some of its text replaced."""
    text = scene.read_text()
    for old, new in replacements:
        if old not in text:
            raise ValueError(f"{scene} lacks {old}")
        text = text.replace(old, new)
    if 'geometry = "' in text:  # the meshes beside the geometry tree
        meshes = scene.resolve().parents[2] / "meshes" / scene.parent.name
        text = re.sub(r'geometry = "(.*)\.geo"', rf'mesh = "{meshes}/\1.msh"',
                      text)
    copy = Path(folder) / f"changed_{scene.name}"
    copy.write_text(text)
    return copy


def worst_time(name, events, exact):
    """Largest difference of the times [s]; events must match one by one."""
    found = [event for _, _, event in events]
    expected = [event for _, event, *_ in exact]
    if found != expected:
        faults.append(f"{name}: {found} instead of {expected}")
        return math.inf
    return max(abs(a[0] - b[0]) for a, b in zip(events, exact))


def check_energy(name, result, tolerance=1e-8):
    expect(f"{name}: energy [1]",
           result["motion"]["integration"]["relative_energy_error"], 0,
           tolerance)


def impact(clevis, geometry, folder, *replacements):
    """(part of the speed that comes back, duration of the contact [s])"""
    scene = changed(geometry / "wall/impact.toml", folder, *replacements)
    _, rows, events = simulate(clevis, scene, folder)
    (press, _, _), (release, _, _) = events
    return rows[-1]["mass.velocity_x_m_per_s"], release - press


def check_wall(clevis, geometry, folder):
    """Every event of the mass on its spring, and one impact alone."""
    for name, wall in WALLS.items():
        result, _, events = simulate(clevis, geometry / f"wall/{name}.toml",
                                     folder)
        exact = wall.events(0.1, 0.0, 3.0)
        worst = worst_time(f"wall {name}", events, exact)
        expect(f"wall {name}: times [s]", worst, 0, 1e-9)
        check_energy(f"wall {name}", result)
        print(f"wall {name}: {len(events)} events, {worst:.1e} s off")
    for model, known in (("penalty", 0.90720), ("published", 0.90538)):
        e, t = impact(clevis, geometry, folder, ("penalty", model))
        exact_e, exact_t = restitution(1e5, 1.0, 20.0, model == "published")
        expect(f"wall {model}: restitution", e, exact_e, 1e-9)
        expect(f"wall {model}: restitution, source", e, known, 5e-6)
        expect(f"wall {model}: contact time [s]", t, exact_t, 1e-11)
        if model == "penalty":
            expect("wall: contact time, source [ms]", 1e3 * t, 9.7394, 5e-5)
        print(f"wall {model}: restitution {e:.6f}, {1e3 * t:.5f} ms, "
              f"{abs(e - exact_e):.1e} and {abs(t - exact_t):.1e} s off")


def upper_off(rows, exact):
    """Largest distance [mm] of the upper platform from where it belongs."""
    places = exact.positions([row["t_s"] for row in rows])
    return max(abs(row["upper.position_x_mm"] - 1e3 * place)
               for row, place in zip(rows, places))


def check_known_events():
    """The exact solution against the numbers of the source's parameters."""
    pieces = TRIBOMETERS["scene"].pieces(3.0)
    expect("tribometer: events in 3 s", len(pieces) - 1, 23, 0)
    first = math.asin(4.5 / ((1000 - 0.5 * (2 * math.pi)**2) * 0.010)) / (
        2 * math.pi)
    expect("tribometer: first slip [s]", pieces[0][1], first, 1e-13)
    for (_, t, _, place), (known_t, known_x) in zip(pieces, KNOWN):
        expect("tribometer: time, source [s]", t, known_t, 5.1e-7)
        expect("tribometer: upper, source [mm]", 1e3 * place(t), known_x,
               5.1e-5)


def check_belt_period(events):
    """Sticks 2 (Fs - Fk)/(k v), slips (2/w)(pi - atan((Fs - Fk) w/(k v)))."""
    stick = 2 * 1.5 / 20
    w = math.sqrt(2000)
    slip = 2 / w * (math.pi - math.atan(1.5 * w / 20))
    expect("belt: slips, source [s]", slip, 0.083206, 5e-7)
    for (t, _, event), (later, _, _) in zip(events, events[1:]):
        expect("belt: period [s]", later - t,
               slip if event == "slip" else stick, 1e-8)


def check_tribometer(clevis, geometry, folder):
    """Every event to 1e-8 s, and the upper platform's path."""
    check_known_events()
    for name, exact in TRIBOMETERS.items():
        result, rows, events = simulate(
            clevis, geometry / f"tribometer/{name}.toml", folder)
        worst = worst_time(f"tribometer {name}", events,
                           exact.events(rows[-1]["t_s"]))
        off = upper_off(rows, exact)
        expect(f"tribometer {name}: times [s]", worst, 0, 1e-8)
        expect(f"tribometer {name}: path [mm]", off, 0, 1e-7)
        check_energy(f"tribometer {name}", result)
        expect(f"tribometer {name}: load on the sole [N]",
               result["joints"][1]["peak_force_N"], 15, 1e-9)
        if name == "belt":
            check_belt_period(events)
        print(f"tribometer {name}: {len(events)} events, {worst:.1e} s off, "
              f"path {off:.1e} mm")


def regularized(clevis, geometry, folder, model):
    """Largest distance of the upper platform [mm] from the motion with true
    stick, and what the integration took, by another model of friction."""
    scene = changed(geometry / "tribometer/scene.toml", folder,
                    ('kinetic = "3 N"', f'kinetic = "3 N"\n{model}'),
                    ("tolerance = 1e-10", "tolerance = 1e-8"))
    result, rows, _ = simulate(clevis, scene, folder)
    return (upper_off(rows, TRIBOMETERS["scene"]),
            result["motion"]["integration"])


def tanh_model(speed):
    """Friction that creeps with about `speed`; Stribeck's bump, that holds the
    breakaway, is wider by a growing factor: else the tanh cuts it."""
    return (f'model = "regularized"\nregularizing_speed = "{speed!r} m/s"\n'
            f'stribeck_speed = "{10 * speed**(5 / 6)!r} m/s"')


def check_regularized(clevis, geometry, folder):
    """Creeping friction comes to the motion with stick as its speed falls."""
    off = [regularized(clevis, geometry, folder, tanh_model(speed))[0]
           for speed in (1e-3, 1e-5, 1e-7)]
    for slow, slower in zip(off, off[1:]):
        expect("regularised: off, of the former", slower / slow, 0, 0.15)
    expect("regularised: off [mm]", off[-1], 0, 0.01)
    print("regularised friction at 1e-3, 1e-5, 1e-7 m/s: "
          f"{', '.join(f'{x:.1e}' for x in off)} mm off")


def drop(clevis, geometry, folder, transition):
    """(depth at rest [um], events, rows) of the free wheel."""
    scene = changed(geometry / "wheel/drop.toml", folder,
                    ('"0.1 mm"', f'"{1e3 * transition!r} mm"'))
    result, rows, events = simulate(clevis, scene, folder)
    check_energy("drop", result)
    return 1e3 * (40 - rows[-1]["wheel.position_y_mm"]), events, rows


def drop_impact(clevis, geometry, folder, mass, law):
    """Part of 1 m/s that comes back without weight."""
    scene = changed(geometry / "wheel/drop.toml", folder,
                    ("-9.81 m/s^2", "0 m/s^2"),
                    ('["0.3 m/s", "0 m/s"', '["0 m/s", "-1 m/s"'),
                    ('mass = "1 kg"', f'mass = "{mass} kg"'),
                    ('transition = "0.1 mm"', law))
    _, rows, _ = simulate(clevis, scene, folder)
    return rows[-1]["wheel.velocity_y_m_per_s"]


def check_friction_cone(name, folder):
    """Friction is at most 0.5 N, and does act."""
    rows = forces(folder)
    for row in rows:
        if row["ground.friction_N"] > 0.5 * row["ground.effort_N"] + 1e-9:
            faults.append(f"{name}: friction beyond 0.5 N at {row['t_s']} s")
    if not any(row["ground.friction_N"] > 0.25 * row["ground.effort_N"] > 0
               for row in rows):
        faults.append(f"{name}: no friction")


def check_drop(clevis, geometry, folder):
    """Bounces, depth at rest and rolling of a free wheel."""
    for transition in (0.0, 1e-4):
        name = f"drop, {transition * 1e3} mm"
        exact = Drop(transition)
        depth, events, rows = drop(clevis, geometry, folder, transition)
        worst = max(abs(a - t) for a, (t, _, _) in
                    zip(exact.bounces(0.050, 2), events))
        expect(f"{name}: times of two bounces [s]", worst, 0, 1e-9)
        expect(f"{name}: depth at rest [um]", depth,
               1e6 * exact.static_depth(), 1e-6)
        # the impulse of friction turns a disc until it rolls at 2/3
        expect(f"{name}: rolls at [m/s]",
               rows[-1]["wheel.velocity_x_m_per_s"], 0.2, 1e-9)
        expect(f"{name}: turns at [rad/s]",
               rows[-1]["wheel.angular_velocity_z_rad_per_s"], -5, 1e-8)
        check_friction_cone(name, folder)
        if transition == 0:
            expect(f"{name}: depth, source [um]", depth, 9.81, 1e-6)
        print(f"{name}: two bounces {worst:.1e} s off, depth at rest "
              f"{depth:.4f} um")


IMPACT_LAWS = {"published": ('model = "published"', True),
               "never pulls": ('transition = "0 mm"', False)}


def check_drop_impacts(clevis, geometry, folder):
    for mass, *known in ((1, 0.163, 0.298), (5, 0.486, 0.539)):
        for (name, (law, pulls)), to in zip(IMPACT_LAWS.items(), known):
            e = drop_impact(clevis, geometry, folder, mass, law)
            expect(f"{mass} kg, {name}: source", e, to, 5.1e-4)
            exact, _ = restitution(1e6, mass, 1e3, pulls)
            expect(f"{mass} kg, {name}", e, exact, 1e-8)
        smooth = drop_impact(clevis, geometry, folder, mass,
                             'transition = "0.1 mm"')
        weightless = Drop(1e-4, m=mass, g=0.0)
        expect(f"{mass} kg, 0.1 mm", smooth, -weightless.press(1.0)[2], 1e-8)


FLOOR = -171.81  # mm


def reactions(folder, t):
    """{joint: force [N]} at an instant."""
    with open(Path(folder) / "reactions.csv", newline="") as file:
        return {row["joint"]: math.hypot(*(
            float(row[f"force_on_b_world_{axis}_N"]) for axis in "xyz"))
            for row in csv.DictReader(file) if float(row["t_s"]) == t}


def quintic(t):
    """(l_x [mm], its rate [mm/s]) of the cylinder's stroke in 2 s."""
    s = t / 2
    return (160 + 100 * s**3 * (10 - 15 * s + 6 * s * s),
            100 * 30 * s * s * (1 - s)**2 / 2)


def ground_force(t):
    """(normal force, friction) [N] of the ground on the wheel that the
    prescribed motion presses into it; x to the right."""
    l_x, rate = quintic(t)
    gear = LandingGear(l_x)
    depth = 1e-3 * (FLOOR - gear.T[1])  # m
    if depth <= 0:
        return 0.0, 0.0
    speed, sink = (1e-3 * rate * slope for slope in gear.slope)
    grown = Drop(1e-4).growth(depth)
    normal = max(0.0, grown * (1e6 * depth - 1e3 * sink))
    r = abs(speed) / 1e-3
    ratio = (0.5 * 2 * r / (1 + r * r) if r <= 1
             else 0.3 + 0.2 * math.exp(-(r - 1)**2))
    return normal, math.copysign(ratio * normal, -speed)


def check_ground(clevis, geometry, folder):
    """Force and friction of the ground by the closed form of the motion, and
    the reactions in all pairs at rest by statics."""
    scene = geometry / "landing_gear/ground.toml"
    simulate(clevis, scene, folder)
    worst = 0.0
    for row in forces(folder):
        normal, friction = ground_force(row["t_s"])
        worst = max(worst, abs(row["ground.effort_N"] - normal),
                    abs(row["ground.friction_N"] - abs(friction)))
    expect("ground: forces [N]", worst, 0, 1e-6)
    check_friction_cone("ground", folder)
    simulate(clevis, changed(scene, folder, ("-9.81 m/s^2", "0 m/s^2")), folder)
    normal, _ = ground_force(2.0)
    expect("ground: source, about 1000 N", normal, 1000, 2)
    pins, _ = LandingGear(260).statics((0, normal))
    found = reactions(folder, 2.0)
    off = max(abs(found[pin] - force) for pin, force in pins.items())
    expect("ground: reactions [N]", off, 0, 1e-5)
    print(f"ground: forces {worst:.1e} N off, reactions of {len(pins)} pairs "
          f"{off:.1e} N off")


def check_ground_by_force(clevis, geometry, folder):
    """The ground answers what the cylinder's push leaves, by statics."""
    scene = geometry / "landing_gear/ground_by_force.toml"
    copy = changed(scene, folder, ("-9.81 m/s^2", "0 m/s^2"))
    result, _, _ = simulate(clevis, copy, folder)
    check_energy("ground by force", result, 1e-7)  # asks for 1e-8 of place
    last = forces(folder)[-1]
    gear = LandingGear(last["push.position_mm"])
    load = last["ground.friction_N"], last["ground.effort_N"]
    pins, push = gear.statics(load)
    expect("ground by force: push [N]", push, 3500 + last["damper.effort_N"],
           1e-3)
    found = reactions(folder, 3.0)
    off = max(abs(found[pin] - force) for pin, force in pins.items())
    expect("ground by force: reactions [N]", off, 0, 2e-3)
    check_friction_cone("ground by force", folder)
    print(f"ground by force: {load[1]:.1f} N, push {push:.4f} N, reactions "
          f"{off:.1e} N off")


def main():
    clevis, geometry = str(Path(sys.argv[1]).resolve()), Path(sys.argv[2])
    with tempfile.TemporaryDirectory() as folder:
        for check in (check_wall, check_tribometer, check_regularized,
                      check_drop, check_drop_impacts,
                      check_ground, check_ground_by_force):
            check(clevis, geometry, folder)
    for fault in faults:
        print(fault)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())

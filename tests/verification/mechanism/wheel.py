"""A dropped wheel and the landing gear's on the ground, against closed
forms."""
import math

from closed_forms import LandingGear
from drops import Drop
from pieces import restitution
from runs import changed, check_energy, forces, reactions, simulate
from source_systems import expect, faults

IMPACT_LAWS = {"published": ('model = "published"', True),
               "never pulls": ('transition = "0 mm"', False)}
FLOOR = -171.81  # mm


def check_friction_cone(name, folder):
    """Friction is at most 0.5 N, and does act."""
    rows = forces(folder)
    for row in rows:
        if row["ground.friction_N"] > 0.5 * row["ground.effort_N"] + 1e-9:
            faults.append(f"{name}: friction beyond 0.5 N at {row['t_s']} s")
    if not any(row["ground.friction_N"] > 0.25 * row["ground.effort_N"] > 0
               for row in rows):
        faults.append(f"{name}: no friction")


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

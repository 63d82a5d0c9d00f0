"""The mass against a wall, against its closed forms."""
from pieces import Wall, restitution
from runs import changed, check_energy, simulate, worst_time
from source_systems import expect

WALLS = {"scene": Wall(), "published": Wall(pulls=True),
         "friction": Wall(breakaway=1.4715, kinetic=0.981, viscous=0.5)}


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

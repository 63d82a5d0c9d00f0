"""The tribometer, against the piecewise exact solution."""
import math

from runs import changed, check_energy, simulate, worst_time
from source_systems import expect
from stick_slip import Stribeck, Tribometer, belt, cranked, swinging

TRIBOMETERS = {"scene": Tribometer(swinging), "belt": Tribometer(belt),
               "crank": Tribometer(cranked), "stribeck": Stribeck(swinging)}
# times [s] and upper platform [mm] that the source's parameters give
KNOWN = [(0.075907125, 4.590615), (0.168777, 1.0982), (0.448316, -4.4370),
         (0.551973, -1.5622), (0.607845, -4.6238), (0.696681, -1.0970),
         (0.935814, 4.4225), (1.040140, 1.6426)]


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
    """Every event to 1e-8 s, and the upper platform's path. Stribeck's friction
    falls with the speed, which makes errors of slips grow e-fold in 2 ms until
    they slide faster than 5 mm/s."""
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


REGULARIZED = 1e-5  # m/s, of regularized.toml


def regularized(clevis, geometry, folder, speed):
    """Largest distance of the upper platform [mm] from the motion with true
    stick, for friction that creeps with about `speed` (None: that sticks), and
    what the integration took. Stribeck's bump, that holds the breakaway, is
    wider by a growing factor: else the tanh cuts it."""
    def model(speed):
        return (f'regularizing_speed = "{speed:.12g} m/s"\n'
                f'stribeck_speed = "{10 * speed**(5 / 6):.12g} m/s"')

    if speed is None:
        scene = changed(geometry / "tribometer/scene.toml", folder,
                        ("tolerance = 1e-10", "tolerance = 1e-8"))
    else:
        scene = changed(geometry / "tribometer/regularized.toml", folder,
                        (model(REGULARIZED), model(speed)))
    result, rows, _ = simulate(clevis, scene, folder)
    return (upper_off(rows, TRIBOMETERS["scene"]),
            result["motion"]["integration"])


def check_regularized(clevis, geometry, folder):
    """Creeping friction comes to the motion with stick as its speed falls."""
    off = [regularized(clevis, geometry, folder, speed)[0]
           for speed in (1e-3, REGULARIZED, 1e-7)]
    for slow, slower in zip(off, off[1:]):
        expect("regularised: off, of the former", slower / slow, 0, 0.15)
    expect("regularised: off [mm]", off[-1], 0, 0.01)
    print("regularised friction at 1e-3, 1e-5, 1e-7 m/s: "
          f"{', '.join(f'{x:.1e}' for x in off)} mm off")

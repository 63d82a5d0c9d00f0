#!/usr/bin/env python3
"""The gas cylinder's scenes against an integration independent of clevis.

    gas_cylinder.py CLEVIS GEOMETRY [--table]

That one has pressure and temperature for states, where clevis has mass and
energy, and classical Runge-Kutta steps of fixed length. --table prints
results/studies/gas_cylinder.md.
"""
import math
import sys
import tempfile
from pathlib import Path

import runs
from source_systems import expect, faults

R, CP = 287.0, 1005.0
CV = CP - R
P_ENV, T_ENV = 101325.0, 293.15
AREA, DEAD, MASS, DAMPING = math.pi * 0.015**2 / 4, 1e-5, 0.6, 200.0
C = 0.032 / 36000 * math.sqrt(0.35) / math.sqrt(1.185e5)
B, LAMINAR, LEAKAGE = 0.3, 0.999, 1e-6
STOP, STOP_DAMPING, TRANSITION = 1e7, 1500.0, 1e-5

# scene, gauge pressure [Pa], load [N], sections, time to 100 mm and final
# position [mm] of an earlier evaluation by another program
ROWS = (("no_load", 0.1e6, 0.0, 1, 1.1585, 100.004),
        ("light_load", 0.1e6, 10.0, 1, 2.645, 100.003),
        ("no_load_three_sections", 0.1e6, 0.0, 3, 0.419, 100.007),
        ("scene", 10.2e6, 1780.0, 1, 1.269, 100.005),
        ("three_sections", 3.5e6, 1780.0, 3, 0.556, 100.008))


def ellipse(r):
    return math.sqrt(max(0.0, 1 - ((r - B) / (1 - B))**2))


def part(r, straight):
    """Flow over choked flow, with a line or a cubic where it is laminar."""
    if r <= B:
        return 1.0
    if r <= LAMINAR:
        return ellipse(r)
    end, value = 1 - LAMINAR, ellipse(LAMINAR)
    if straight:
        return value * (1 - r) / end
    slope = (LAMINAR - B) / (1 - B)**2 / value
    cubic = (slope - value / end) / (2 * end**2)
    return (1 - r) * (value / end + cubic * ((1 - r)**2 - end**2))


def flow(conductance, a, b, straight):
    """(mass, temperature it comes with), positive from a to b."""
    if a[0] < b[0]:
        mass, temperature = flow(conductance, b, a, straight)
        return -mass, temperature
    choked = a[0] * conductance * 1.185 * math.sqrt(293.15 / a[1])
    return choked * part(b[0] / a[0], straight), a[1]


def stop_force(depth, rate):
    if depth <= 0:
        return 0.0
    t = min(1.0, depth / TRANSITION)
    return max(0.0,
               t * t * (3 - 2 * t) * (STOP * depth + STOP_DAMPING * rate))


def rates(y, supply, load, sections, straight):
    p, T, x, v = y
    V = DEAD + AREA * x
    m_in, T_in = flow(C, (supply, T_ENV), (p, T), straight)
    m_out, T_out = flow(LEAKAGE * C, (p, T), (P_ENV, T_ENV), straight)
    net = m_in - m_out
    enthalpy = CP * (m_in * T_in - m_out * T_out)
    # energy: (c_v/R)(V p' + p V') + p V' = enthalpy; then the gas law
    p_rate = (enthalpy - CP / R * p * AREA * v) * R / CV / V
    T_rate = T * (p_rate / p + AREA * v / V - net * R * T / (p * V))
    force = (sections * (p - P_ENV) * AREA - load - DAMPING * v +
             stop_force(-x, -v) - stop_force(x - 0.1, v))
    return p_rate, T_rate, v, force / MASS


def arrival(gauge, load, sections, straight, step=2e-5):
    """When x reaches 100 mm [s]."""
    y, t = (P_ENV, T_ENV, 0.0, 0.0), 0.0
    args = P_ENV + gauge, load, sections, straight

    def ahead(k, h):
        return tuple(a + h * b for a, b in zip(y, k))

    while y[2] < 0.1:
        before = y
        k1 = rates(y, *args)
        k2 = rates(ahead(k1, step / 2), *args)
        k3 = rates(ahead(k2, step / 2), *args)
        k4 = rates(ahead(k3, step), *args)
        y = tuple(a + step / 6 * (p + 2 * q + 2 * r + s)
                  for a, p, q, r, s in zip(y, k1, k2, k3, k4))
        t += step
    # the speed is steady there
    return t - (y[2] - 0.1) / (0.5 * (y[3] + before[3]))


def depth_under(force):
    """At which the stop holds a force."""
    low, high = 0.0, TRANSITION
    if force >= STOP * TRANSITION:
        return force / STOP
    for _ in range(100):
        depth = 0.5 * (low + high)
        low, high = ((depth, high) if stop_force(depth, 0.0) < force
                     else (low, depth))
    return low


def check_row(clevis, geometry, folder, row):
    scene, gauge, load, sections, known, _ = row
    result, _, events = runs.simulate(
        clevis, geometry / f"gas_cylinder/{scene}.toml", folder)
    # also at the instants inside the stop's impacts
    runs.check_energy(scene, result, 1e-7)
    met = next(t for t, _, what in events if what == "press" and t > 0.01)
    fine, _, fine_events = runs.simulate(
        clevis, runs.changed(geometry / f"gas_cylinder/{scene}.toml", folder,
                             ("tolerance = 1e-8", "tolerance = 1e-10")),
        folder)
    runs.check_energy(f"{scene}, 1e-10", fine, 1e-7)
    finer = next(t for t, _, what in fine_events
                 if what == "press" and t > 0.01)
    expect(f"{scene}: converged [1]", met / finer, 1, 1e-6)
    expect(f"{scene}: earlier evaluation [1]", met / known, 1, 0.02)
    last = runs.forces(folder)[-1]
    depth = last["end.position_mm"] * 1e-3 - 0.1
    exact = depth_under(sections * gauge * AREA - load)
    expect(f"{scene}: depth in the stop [m]", depth, exact, 2e-9)
    chamber = next(f for f in result["forces"]
                   if f["name"] == "cylinder")["chambers"][0]
    expect(f"{scene}: mass balance [1]", chamber["mass_balance_error"], 0,
           1e-13)
    return met, abs(met / finer - 1), depth, exact, chamber


def check_published(clevis, geometry, folder):
    runs.simulate(clevis, geometry / "gas_cylinder/published.toml", folder)
    rows = runs.forces(folder)
    expect("published: highest position [mm]",
           max(row["cylinder.position_mm"] for row in rows), 0, 0)
    depth = rows[-1]["cylinder.position_mm"]
    expect("published: rests at [mm]", depth,
           -1e3 * (1780 - 0.1e6 * AREA) / STOP, 1e-6)
    return depth, min(row["cylinder.position_mm"] for row in rows)


def main():
    clevis, geometry = sys.argv[1], Path(sys.argv[2])
    table = sys.argv[3:] == ["--table"]
    lines = []
    with tempfile.TemporaryDirectory() as folder:
        for row in ROWS:
            scene, gauge, load, sections, known, end = row
            met, change, depth, exact, chamber = check_row(
                clevis, geometry, folder, row)
            if not table and scene not in ("no_load_three_sections",
                                           "three_sections"):
                continue  # long ones for the table only
            own = arrival(gauge, load, sections, False)
            expect(f"{scene}: own integration [1]", met / own, 1, 1e-5)
            line = arrival(gauge, load, sections, True)
            lines.append(
                f"| `{scene}.toml` | {gauge / 1e6:g} | {load:g} | {sections} "
                f"| {met:.6f} | {own:.6f} | {line:.6f} | {known:g} "
                f"| {change:.0e} | {1e6 * depth:.3f} | {1e6 * exact:.3f} "
                f"| {chamber['largest_temperature_K']:.1f} "
                f"| {chamber['mass_balance_error']:.0e} |")
        rest, deepest = check_published(clevis, geometry, folder)
    if table:
        print(TEXT.format(rows="\n".join(lines), rest=rest, deepest=deepest))
    if faults:
        sys.exit("\n".join(faults))


TEXT = """# The gas cylinder

Made by `python3 tests/verification/mechanism/gas_cylinder.py build/release/bin/clevis geometry --table`.

A piston of 0.6 kg and 15 mm bore, stops at 0 and 100 mm (1e7 N/m, 1500 N s/m, transition 0.01 mm), a damper of 200 N s/m,
a valve of Kv 0.032 m³/h, open from the start, insulated. Time to 100 mm: by clevis; by classical Runge–Kutta in
pressure and temperature with the same laws; by that with a straight line where the flow is laminar; as an
earlier evaluation by another program has it. *Change*: of the time from tolerance 1e-8 to 1e-10. The depth in the stop at the end beside (3t² − 2t³) k d = F,
which is F/k beyond the transition.

| scene | MPa gauge | load N | sections | clevis s | own RK4 s | with a line s | earlier s | change | depth µm | exact µm | hottest K | mass balance |
|---|---|---|---|---|---|---|---|---|---|---|---|---|
{rows}

`published.toml`, 0.1 MPa against 1780 N: 17.67 N cannot lift it. The rod never leaves its lower stop; it rests at {rest:.4f} mm =
−(1780 − 17.67) N / 1e7 N/m, at most {deepest:.3f} mm at the instants. The published full stroke needs 10.07 MPa, or a bore of 150.5 mm."""

if __name__ == "__main__":
    main()

#!/usr/bin/env python3
"""Gas cylinder and mechanism that communicate in steps, against one integration
of both, and against classical Runge-Kutta steps of each side between the
communications.

    gas_interface.py CLEVIS GEOMETRY [--table]

--table: prints the part of results/studies/gas_cylinder.md.
"""
import sys
import tempfile
from pathlib import Path

import gas_cylinder as gas
import runs
from source_systems import expect, faults

SCENES = (("no_load", 0.1e6, 0.0), ("scene", 10.2e6, 1780.0))
STEPS = (10, 5, 2, 1, 0.5, 0.2)  # ms


def run(clevis, geometry, folder, name, step):
    """(position [m], drift [J], gap [m], simulate.json) at 0.5 s"""
    coupling = ("" if step is None else
                f'coupling = {{ step = "{step} ms" }}\n')
    scene = runs.changed(
        geometry / f"gas_cylinder/{name}.toml", folder,
        ('type = "gas_cylinder"', 'type = "gas_cylinder"\n' + coupling),
        ('duration = "2 s"', 'duration = "0.5 s"'),
        ("instants = 401", "instants = 51"),
        ("tolerance = 1e-8", "tolerance = 1e-10"))
    result, _, _ = runs.simulate(clevis, scene, folder)
    last = runs.forces(folder)[-1]
    force = next(f for f in result["forces"] if f["name"] == "cylinder")
    if step is None:
        return last["cylinder.position_mm"] * 1e-3, None, None, result
    side = force["interface"]
    return (last["cylinder.position_mm"] * 1e-3, side["energy_drift_J"],
            side["largest_position_gap_mm"] * 1e-3, result)


def own(gauge, load, step, until=0.5, parts=20):
    """The position by classical Runge-Kutta steps of piston and gas apart."""
    p, T, x, v = gas.P_ENV, gas.T_ENV, 0.0, 0.0
    gas_x, force = 0.0, 0.0
    h = step / parts

    def gas_rates(y, rate, at):
        V = gas.DEAD + gas.AREA * at
        m_in, T_in = gas.flow(gas.C, (gas.P_ENV + gauge, gas.T_ENV), y, False)
        m_out, T_out = gas.flow(gas.LEAKAGE * gas.C, y, (gas.P_ENV, gas.T_ENV),
                                False)
        enthalpy = gas.CP * (m_in * T_in - m_out * T_out)
        net = m_in - m_out
        p_rate = (enthalpy - gas.CP / gas.R * y[0] * gas.AREA * rate
                  ) * gas.R / gas.CV / V
        return (p_rate, y[1] * (p_rate / y[0] + gas.AREA * rate / V -
                                net * gas.R * y[1] / (y[0] * V)))

    def piston_rates(y):
        return y[1], (force - load - gas.DAMPING * y[1] +
                      gas.stop_force(-y[0], -y[1]) -
                      gas.stop_force(y[0] - 0.1, y[1])) / gas.MASS

    def advance(y, f, h):
        k1 = f(y, 0.0)
        k2 = f([a + h / 2 * b for a, b in zip(y, k1)], h / 2)
        k3 = f([a + h / 2 * b for a, b in zip(y, k2)], h / 2)
        k4 = f([a + h * b for a, b in zip(y, k3)], h)
        return [a + h / 6 * (b + 2 * c + 2 * d + e)
                for a, b, c, d, e in zip(y, k1, k2, k3, k4)]

    for _ in range(round(until / step)):
        force, rate, start = (p - gas.P_ENV) * gas.AREA, v, gas_x
        for i in range(parts):
            p, T = advance([p, T], lambda y, s: gas_rates(
                y, rate, start + rate * (i * h + s)), h)
            x, v = advance([x, v], lambda y, s: piston_rates(y), h)
        gas_x = start + rate * step
    return x


def main():
    clevis, geometry = sys.argv[1], Path(sys.argv[2])
    table = sys.argv[3:] == ["--table"]
    lines = []
    with tempfile.TemporaryDirectory() as folder:
        for name, gauge, load in SCENES if table else SCENES[:1]:
            exact = run(clevis, geometry, folder, name, None)[0]
            before = None
            for step in STEPS if table else (2, 1):
                x, drift, gap, result = run(clevis, geometry, folder, name,
                                            step)
                runs.check_energy(f"{name}, {step} ms", result, 1e-7)
                if name == "no_load" and step == 1:
                    expect("error falls with the step [1]",
                           before / (x - exact), 2, 0.2)
                before = x - exact
                lines.append(f"| `{name}.toml` | {step:g} | {1e3 * x:.5f} "
                             f"| {1e6 * (x - exact):.2f} | {1e6 * gap:.2f} "
                             f"| {1e3 * drift:.4f} |")
            if name == "no_load":
                expect("own steps of 2 ms [m]",
                       run(clevis, geometry, folder, name, 2)[0],
                       own(gauge, load, 2e-3), 1e-8)
            lines.append(f"| `{name}.toml` | monolithic | {1e3 * exact:.5f} "
                         "| 0 | 0 | 0 |")
    if table:
        print(TEXT.format(rows="\n".join(lines)))
    if faults:
        sys.exit("\n".join(faults))


TEXT = """
## Coupled in steps

Printed by `python3 tests/verification/mechanism/gas_interface.py build/release/bin/clevis geometry --table`.

The source's force interface: gas on one side, the mechanism on the other. With `coupling = {{ step = "1 ms" }}` they communicate at these
times only: over a step the gas takes the piston's last rate, the piston the gas's last force. Piston mass, damper and stops are
the mechanism's, so no mass is counted twice and the interface needs no acceleration. Position at 0.5 s, its error against one
integration of both, the largest gap between the gas's own position and the piston's, and the energy that the interface makes
(work on the mechanism less that of the gas).

| scene | step ms | position mm | error µm | gap µm | energy made mJ |
|---|---|---|---|---|---|
{rows}

At the communications both sides' powers are equal by construction; between them they are not, and energy comes from
nowhere. Without load error and gap fall with the first power of the step. Under 1780 N the rod first falls on its lower stop, where it
bounces within a millisecond: what the gas is told of that is a matter of chance, and it shows until the steps resolve it. In one
integration there is no interface to pay for."""

if __name__ == "__main__":
    main()

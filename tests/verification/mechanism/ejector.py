#!/usr/bin/env python3
"""Runs `clevis simulate` on the ejector and compares its blow with the work of
magnet and spring, which `clevis impact` uses too.

    ejector.py CLEVIS GEOMETRY
"""
import json
import math
import subprocess
import sys
from pathlib import Path


def run(*command):
    found = subprocess.run([*command, "--json"], capture_output=True, text=True)
    if found.returncode:
        sys.exit(found.stderr)
    return json.loads(found.stdout)


def main():
    clevis, geometry = sys.argv[1], Path(sys.argv[2])
    impacts = run(clevis, "simulate", geometry / "ejector/scene.toml")["impacts"]
    blow = impacts[0]
    drive = run(clevis, "impact",
                geometry / "ejector/beam_theory.toml")["ejectors"][0]["drive"]
    # 60 N over 5 mm of a range of 10, 2000 N/m from 3 to 6.75 mm; J = 2e-3
    energy = 60 * 5e-3 * 0.75 - 1000 * (6.75e-3**2 - 3e-3**2)
    speed = 0.1 * math.sqrt(2 * energy / 2e-3)
    mass, push, stiffness = 0.2, 7.95, 1.2524e6
    # the lever is flat within 1e-3 rad while it presses
    peak = push + math.sqrt(push**2 + stiffness * mass * speed**2)
    duration = 2 * math.sqrt(mass / stiffness) * (
        math.pi - math.atan(speed * math.sqrt(stiffness * mass) / push))
    checks = (("speed", blow["approach_speed_m_per_s"], speed, 1e-6),
              ("speed by clevis impact", drive["pusher_speed_m_per_s"], speed,
               1e-12),
              ("1.3727 m/s", speed, 1.3727, 5e-5),
              ("mass", blow["mass_kg"], mass, 1e-6),
              ("pushing", blow["pushing_N"], push, 1e-5),
              ("peak", blow["peak_N"], peak, 1e-3),
              ("duration", blow["duration_s"], duration, 1e-3),
              ("leaves", blow["exit_speed_m_per_s"], speed, 1e-3))
    faults = [what for what, value, known, allowed in checks
              if not abs(value / known - 1) < allowed]
    for what, value, known, _ in checks:
        print(f"{what}: {value:.9g}, {value / known - 1:+.1e}")
    print("\n".join(f"FAIL {what}" for what in faults) or "pass")
    return len(faults) > 0


if __name__ == "__main__":
    sys.exit(main())

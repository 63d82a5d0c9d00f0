#!/usr/bin/env python3
"""Checks the ejector's workpiece and compares the models with what is known.

    ejector.py CLEVIS ROOT

Beam theory by hand; elements in time against Euler's beam on a one-sided
contact of 1e7 N/m, whose root moment is 1.064 times the energy formula's at a
mass ratio of 5.4. Euler's beam has no shear, the rod is six diameters long.
"""
import json
import math
import subprocess
import sys
import tempfile

EULER = 1.064
BEYOND_EULER = 0.04  # shear, rotary inertia, the give of the struck face
SECTION = 0.002      # of the mesh's round section cut along straight edges


def main():
    clevis, root = sys.argv[1:3]
    with tempfile.TemporaryDirectory() as folder:
        run = subprocess.run(
            [clevis, "check", f"{root}/geometry/ejector/scene.toml", "--out",
             folder, "--json"], capture_output=True, text=True)
    if run.returncode != 1:
        sys.exit(f"exit {run.returncode}, 1 expected\n{run.stderr}")
    result = json.loads(run.stdout)
    part = result["parts"][0]
    held = part["support_section"]
    blow = part["impacts"][0]
    published, corrected, moving, _, direct, modal = blow["models"][:6]
    judged = blow["models"][-1]

    mass, speed, push = 0.2, 1.3727254, 7.95
    I, W, length = 490.874e-12, 98.1748e-9, 0.060
    k = 3 * 210e9 * I / length**3
    y = push / k + math.sqrt((push / k)**2 + mass * speed**2 / k)
    third = 3 * push / k
    twice = third + math.sqrt(third**2 + 3 * mass * (2 * speed)**2 / k)
    known = (
        ("mass", blow["mass_kg"], mass, 1e-5),
        ("speed", blow["speed_m_per_s"], speed, 1e-5),
        ("pushing", blow["pushing_N"], push, 1e-4),
        ("mass ratio", blow["mass_ratio"], 5.4, 0.01),
        ("corrected stress", corrected["root_stress_MPa"],
         k * y * length / W / 1e6, SECTION),
        ("corrected deflection", corrected["face_deflection_mm"], 1e3 * y, SECTION),
        ("published stress", published["root_stress_MPa"],
         k / 3 * twice * length / W / 1e6, SECTION),
        ("published deflection", published["face_deflection_mm"], 1e3 * twice,
         SECTION),
        ("moving along", moving["root_stress_MPa"] /
         corrected["root_stress_MPa"], 444.3 / 453.8, 1e-3),
        ("elements in time over the formula", 1 / corrected["ratio"], EULER,
         BEYOND_EULER),
        ("both routes", direct["root_stress_MPa"] /
         modal["root_stress_MPa"], 1.0, 0.01),
        ("part's deflection is the blow's", part["deflection_mm"],
         judged["deflection_mm"], 1e-12),
        ("it is that of the tip", part["deflection_mm"],
         judged["face_deflection_mm"], 0.01),
        ("held section, beside Timoshenko's beam of 20 modes",
         held["nominal_stress_MPa"], 486.7, 0.02),
        ("it is the judged row's", judged["root_stress_MPa"],
         held["nominal_stress_MPa"], 1e-12),
        ("part's peak is the blow's", part["peak_outside_singular_zones"]
         ["value_MPa"], blow["stress_MPa"], 1e-12))
    faults = []
    for what, value, target, allowed in known:
        print(f"{what}: {value:.6g}, {value / target - 1:+.2%} of {target:.6g}")
        if not abs(value / target - 1) < allowed:
            faults.append(what)
    if not (0 < judged["error_percent"] < 5 and "unsafe" in
            corrected["remark"]):
        faults.append("remarks and errors")
    print("\n".join(f"FAIL {fault}" for fault in faults) or "pass")
    return len(faults) > 0


if __name__ == "__main__":
    sys.exit(main())

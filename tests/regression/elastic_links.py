#!/usr/bin/env python3
"""Elastic links share what equilibrium leaves open: a bar held by welds at both
ends, under its own weight, carries q L²/12 at each, of whatever stiffness its
welds are made as long as they are stiffer than the bar. In a disc that spins about the
bar's middle it pulls at both with m ω² L/12, about one end with m ω² L/6 and L/3; rigid
links leave that out, and say so.

    elastic_links.py CLEVIS
"""
import json
import subprocess
import sys
import tempfile
from pathlib import Path

import support

CLEVIS = str(Path(sys.argv[1]).resolve())
LENGTH, SIDE, DENSITY, GRAVITY = 0.2, 0.01, 7850.0, 9.81

# of the welds: 1e-5 of the bar's
FORCE, TURN = '"1e-13 m/N"', '"1e-9 rad/(N m)"'

BAR = """Point(1) = {0, -5, 0}; Point(2) = {200, -5, 0}; Point(3) = {200, 5, 0}; Point(4) = {0, 5, 0};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4}; Plane Surface(1) = {1};
Transfinite Curve {1, 3} = 17; Transfinite Curve {2, 4} = 3;
Transfinite Surface {1}; Recombine Surface {1};
e[] = Extrude {0, 0, 10} { Surface{1}; Layers{2}; Recombine; };
Physical Volume("body") = {e[1]};
Physical Surface("left") = {e[5]}; Physical Surface("right") = {e[3]};
"""


def weld(name, x):
    at = f'["{x} mm", "0 mm", "5 mm"]'
    return f"""
[[joint]]
name = "{name}"
type = "weld"
between = ["ground", "bar"]
at = {{ ground = {at}, bar = {at} }}
axis = [0, 0, 1]
normal = [1, 0, 0]
compliance = {{ force = [{FORCE}, {FORCE}, {FORCE}], moment = [{TURN}, {TURN}, {TURN}] }}
"""


SCENE = """schema = 1
name = "bar between welds"
[world]
gravity = ["0 m/s^2", "-9.81 m/s^2", "0 m/s^2"]
{material}[[body]]
name = "bar"
part = "bar"
placement = {{ origin = ["0 mm", "0 mm", "0 mm"] }}
{welds}
[simulation]
duration = "1 s"
instants = 2
{links}
[[part]]
name = "bar"
geometry = "bar.geo"
length_unit = "mm"
material = "steel"
pins = {{ left = "left", right = "right" }}
"""


def run(folder, *arguments):
    done = subprocess.run([CLEVIS, *arguments], capture_output=True, text=True, cwd=folder)
    if done.returncode not in (0, 1, 4):
        sys.exit(f"clevis {' '.join(arguments)}: {done.stderr}")
    return done.stdout


def scene(links):
    return SCENE.format(material=support.steel(ratio=0.0),
                        welds=weld("left", 0) + weld("right", 200),
                        links=f'links = "{links}"')


def joints_of(folder, text):
    """Of the motion of a scene, and what `simulate` prints of it."""
    (folder / "scene.toml").write_text(text)
    (folder / "bar.geo").write_text(BAR)
    run(folder, "mesh", "scene.toml")
    motion = json.loads(run(folder, "simulate", "scene.toml", "--json"))
    return ({joint["name"]: joint for joint in motion["joints"]},
            run(folder, "simulate", "scene.toml"))


DISC = """[[body]]
name = "disc"
mass = "5 kg"
center_of_mass = ["0 mm", "0 mm", "0 mm"]
inertia = ["0.02 kg m^2", "0.02 kg m^2", "0.03 kg m^2"]
placement = {{ origin = ["{x} mm", "0 mm", "0 mm"] }}
[[joint]]
name = "shaft"
type = "revolute"
between = ["ground", "disc"]
at = {{ ground = ["{x} mm", "0 mm", "5 mm"], disc = ["0 mm", "0 mm", "5 mm"] }}
axis = [0, 0, 1]
[[drive]]
joint = "shaft"
law = "speed"
from = "0 deg"
speed = "{speed} rad/s"
"""
SPEED = 2000.0


def spun_scene(about, links):
    text = scene(links).replace('"-9.81 m/s^2"', '"0 m/s^2"').replace(
        '"ground", "bar"', '"disc", "bar"')
    for x in (0, 200):
        text = text.replace(f'ground = ["{x} mm", "0 mm"', f'disc = ["{x - about} mm", "0 mm"')
    return text.replace('[simulation]\nduration = "1 s"', DISC.format(x=about, speed=SPEED) +
                        '[simulation]\nduration = "1 ms"')


def spun(folder, about, links):
    """Forces at the left and right weld over m ω² L, and what is printed."""
    joints, told = joints_of(folder, spun_scene(about, links))
    pull = DENSITY * SIDE**2 * LENGTH**2 * SPEED**2
    return (*(joints[end]["peak_force_N"] / pull for end in ("left", "right")), told)


def check_spin(folder):
    failed = 0
    for about, links, left, right in ((100, "elastic", 1 / 12, 1 / 12),
                                      (0, "elastic", 1 / 6, 1 / 3),
                                      (100, "rigid", 0.0, 0.0)):
        *found, told = spun(folder, about, links)
        print(f"spun about {about} mm, {links} links: {found[0]:.5f} and {found[1]:.5f}, "
              f"{left:.5f} and {right:.5f} by theory")
        is_right = max(abs(found[0] - left), abs(found[1] - right)) < 2e-4
        if not is_right or ("its spin would stretch" in told) != (links == "rigid"):
            print(told, "FAIL", sep="\n")
            failed = 1
    return failed


def check_band_of_rigid_links(folder):
    """About one end ρ ω² L²/3 presses at the other, of which welds that are alike take
    three quarters on a rigid bar; about its middle they take nothing, and leave ρ ω² L²/8
    for L²/12. The bands hold both."""
    whole = DENSITY * SPEED**2 * LENGTH**2 / 1e6
    failed = 0
    for about, links, peak, truth in ((0, "rigid", 1 / 4, 1 / 3), (0, "elastic", 1 / 3, 1 / 3),
                                      (100, "rigid", 1 / 8, 1 / 12)):
        (folder / "scene.toml").write_text(spun_scene(about, links))
        found = support.check(CLEVIS, folder / "scene.toml", exits=support.JUDGED)
        print(f"spun about {about} mm, {links} links: {found}, {truth * whole:.1f} by theory")
        low, high = found.band
        if (abs(found.peak / whole / peak - 1) > 0.01 or not low <= truth * whole * 1.001
                or not high >= truth * whole * 0.999):
            print(found.text, "FAIL", sep="\n")
            failed = 1
    return failed


def main():
    weight = DENSITY * GRAVITY * SIDE**2  # [N/m]
    clamped = weight * LENGTH**2 / 12.0
    with tempfile.TemporaryDirectory() as name:
        for links, least, most in (("elastic", 0.0, 3e-5), ("rigid", 0.1, 1.0)):
            joints, _ = joints_of(Path(name), scene(links))
            for end in ("left", "right"):
                force = joints[end]["peak_force_N"] / (0.5 * weight * LENGTH) - 1.0
                moment = joints[end]["peak_moment_N_m"] / clamped - 1.0
                print(f"{links} links, {end}: force {force:+.1e}, moment {moment:+.1e} of the clamped bar's")
                if abs(force) > 1e-9 or not least <= abs(moment) <= most:
                    print("FAIL")
                    return 1
        return check_spin(Path(name)) or check_band_of_rigid_links(Path(name))


if __name__ == "__main__":
    sys.exit(main())

"""Loads that act for moments between 201 instants and fewer are in a part's
verdict: a pulse, a sine sampled at its zeros, a blow against a plate, each beside
the same load where nothing can miss it."""
import json
import subprocess
import sys
import tempfile
from pathlib import Path

clevis, meshes = sys.argv[1], Path(sys.argv[2]).resolve()

HEAD = f'''schema = 1
name = "crank under loads in time"

[world]
gravity = ["0 m/s^2", "-9.81 m/s^2", "0 m/s^2"]

[material.steel]
youngs_modulus = "210 GPa"
poissons_ratio = 0.3
density = "7850 kg/m^3"
yield_strength = "355 MPa"

[[body]]
name = "crank"
part = "crank"

[[joint]]
name = "shaft"
type = "revolute"
between = ["ground", "crank"]
point = ["0 mm", "0 mm", "0 mm"]
axis = [0, 0, 1]

[[part]]
name = "crank"
mesh = "{meshes}/tribometer/crank.msh"
length_unit = "mm"
material = "steel"
pins = {{ shaft = "bore_A" }}
drives = {{ shaft = {{ face = "bore_A" }} }}
limits = {{ safety_factor = 1.5 }}
FORCES

[accuracy]
peak_stress = "2 %"
'''
REST = '[[drive]]\njoint = "shaft"\nlaw = "constant"\nfrom = "0 deg"\n'
ALONG_Y = ('between = ["ground", "crank"]\nfrom = ["10 mm", "0 mm", "0 mm"]\n'
           'to = ["10 mm", "0 mm", "0 mm"]\naxis = [0, 1, 0]\n')


def check(blocks, instants, duration, force=None, folder="out"):
    forces = f'forces = {{ {force} = {{ face = "bore_B" }} }}' if force else ""
    scene = HEAD.replace("FORCES", forces) + blocks + (
        f'\n[simulation]\nduration = "{duration} s"\ninstants = {instants}\n')
    with tempfile.TemporaryDirectory() as place:
        file = Path(place) / "scene.toml"
        file.write_text(scene)
        done = subprocess.run([clevis, "check", "--json", file, "--out",
                               Path(place) / folder],
                              capture_output=True, text=True)
    if done.returncode not in (0, 1, 4):
        sys.exit(done.stderr)
    part = json.loads(done.stdout)["parts"][0]
    peak = part["peak_von_mises"]
    print(f"{instants:5d} instants: {peak['value_MPa']:.4g} MPa "
          f"{peak['band_MPa']} {part['verdict']} ({part['why']})")
    return peak["value_MPa"], peak["band_MPa"], part["verdict"]


def require(found, truth, name):
    value, (low, high), verdict = found
    if not low <= truth <= high or verdict == "pass":
        sys.exit(f"{name}: {truth} MPa is the truth")


def force_table(times, newtons):
    return (f'[[force]]\nname = "push"\ntype = "table"\n{ALONG_Y}'
            f'times = {json.dumps([f"{t} s" for t in times])}\n'
            f'efforts = {json.dumps([f"{f} N" for f in newtons])}\n')


print("a pulse of 1 ms and of 4 ms, beside the constant force")
constant = check(REST + force_table([0], [1200]), 2, 1, "push")[0]
for half in (0.0005, 0.002):
    pulse = force_table([0.4536 - half, 0.4536, 0.4536 + half], [0, 1200, 0])
    for instants in (201, 11):
        require(check(REST + pulse, instants, 1, "push"), constant, "pulse")

print("a sine of 100 Hz and 6 rad, its zeros and others, beside 2001 instants")
SINE = ('[[drive]]\njoint = "shaft"\nlaw = "sine"\nfrom = "0 deg"\n'
        'amplitude = "6 rad"\nfrequency = "100 Hz"\n')
truth = check(SINE, 2001, 0.1)[0]
for instants in (11, 5, 15, 16):
    found = check(SINE, instants, 0.1)
    if abs(found[0] - truth) > 2e-3 * truth:
        sys.exit(f"sine: {truth} MPa is the truth")

print("a ball that meets a plate once a turn, beside the force that is largest")
# 12 um deep at 1e8 N/m: 1200 N along -y of the world, where the crank stands upright:
# along -x of the crank
TURN = ('[[drive]]\njoint = "shaft"\nlaw = "speed"\nfrom = "0 deg"\n'
        'speed = "1 rpm"\n')
PLATE = ('[[force]]\nname = "plate"\ntype = "contact"\nbody = "crank"\n'
         'center = ["10 mm", "0 mm", "0 mm"]\nradius = "1 mm"\n'
         'plane_point = ["0 mm", "10.988 mm", "0 mm"]\nnormal = [0, -1, 0]\n'
         'stiffness = "1e8 N/m"\ndamping = "0 N s/m"\n')
pressed = check(REST + force_table([0], [-1200]).replace(
    "axis = [0, 1, 0]", "axis = [1, 0, 0]"), 2, 1, "push")[0]
for instants in (201, 11):
    found = check(TURN + PLATE, instants, 600, "plate")
    if abs(found[0] - pressed) > 0.01 * pressed:
        sys.exit(f"plate: {pressed} MPa is the truth")

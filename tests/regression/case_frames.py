"""A moving part whose worst load is a case with supports of its own has no frames
of the motion: they would show the case's stress at the motion's instants. A
case in balance stands in the motion's load set, whose frames stay."""
import json
import subprocess
import sys
import tempfile
from pathlib import Path

clevis = sys.argv[1]
CASE = """
[[part.case]]
name = "pull"
pins = { bore_C = ["%s", "0 N", "0 N"]%s }
%s
"""
HELD = 'held_by_pin = ["bore_B"]'
FIXED = 'fixed = { bore_B = ["x", "y", "z"] }'
# No stress is read: a fifth of the cells.
COARSE = (("MeshSize {:} = 5;", "MeshSize {:} = 12;"),
          ("Transfinite Curve {14, 15, 24, 25} = 13;",
           "Transfinite Curve {14, 15, 24, 25} = 5;"))


def checked(folder, force, support):
    """Names of the frames, and whether the report's fields are the motion's."""
    scene = folder / "scene.toml"
    text = scene.read_text().partition("\n[[part.case]]")[0]
    balance = f', bore_B = ["-{force}", "0 N", "0 N"]' if not support else ""
    scene.write_text(text + CASE % (force, balance, support))
    done = subprocess.run([clevis, "check", scene, "--out", folder / "out",
                           "--tolerance", "50%"], capture_output=True, text=True)
    if done.returncode not in (0, 1, 4):
        sys.exit(done.stderr)
    view = json.loads((folder / "out/view/part_coupler.json").read_text())
    return sorted((folder / "out/frames").glob("*.vtu")), view["is_motion"]


with tempfile.TemporaryDirectory() as name:
    folder = Path(name) / "rocker"
    subprocess.run([clevis, "init", folder, "--template", "four-bar"], check=True,
                   capture_output=True)
    geometry = folder / "coupler.geo"
    text = geometry.read_text()
    for fine, coarse in COARSE:
        assert fine in text
        text = text.replace(fine, coarse)
    geometry.write_text(text)
    subprocess.run([clevis, "mesh", folder / "scene.toml"], check=True,
                   capture_output=True)
    series = folder / "out/mechanism.pvd"
    for force, support, has_frames, motion_governs in (
            ("50 kN", "", True, False), ("1 N", HELD, True, True),
            ("50 kN", HELD, False, False),
            ("1 N", FIXED, True, True), ("50 kN", FIXED, False, False)):
        frames, is_motion = checked(folder, force, support)
        assert bool(frames) == has_frames == series.exists(), (force, support)
        assert is_motion == motion_governs, (force, support)

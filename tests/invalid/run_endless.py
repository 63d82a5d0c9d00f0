#!/usr/bin/env python3
"""One wrong exponent, and no computer would finish: refused, with what is
fastest.

    run_endless.py CLEVIS SOURCE_DIR
"""
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

HANGS = 120  # s
OVER = 21


class Endless(unittest.TestCase):
    def simulate(self, scene, *arguments):
        return subprocess.run(
            [CLEVIS, "simulate", str(scene), *arguments], text=True,
            capture_output=True, timeout=HANGS)

    def refused_in_time(self, done, *words):
        self.assertEqual(done.returncode, OVER, done.stdout + done.stderr)
        for word in ("K013", "--max-time", *words):
            self.assertIn(word, done.stderr)

    def test_stiff_spring(self):
        for scene in ("scene", "regularized", "crank"):
            done = self.simulate(
                SOURCE / f"geometry/tribometer/{scene}.toml", "--set",
                "force.springs.stiffness=1e12 N/m", "--max-time", "2 s")
            self.refused_in_time(done, "springs", "body upper")

    def test_limit_that_is_enough_is_named(self):
        scene = SOURCE / "geometry/tribometer/crank.toml"
        # Some 2.5 s: far from what nobody waits for, twenty times the limit.
        stiff = ("--set", "force.springs.stiffness=1e7 N/m",
                 "--set", "simulation.duration=1 s", "--max-time")
        done = self.simulate(scene, *stiff, "0.3 s")
        self.refused_in_time(done, "forecast")
        enough = re.search(r'Give --max-time "([^"]+)"', done.stderr)
        self.assertIsNotNone(enough, done.stderr)
        self.assertEqual(self.simulate(scene, *stiff, enough[1]).returncode, 0)

    def test_small_inductance(self):
        text = (SOURCE / "tests/data/scenes/motors.toml").read_text()
        with tempfile.TemporaryDirectory() as folder:
            scene = Path(folder) / "scene.toml"
            scene.write_text(text.replace('"1 mH"', '"1e-25 H"'))
            self.refused_in_time(self.simulate(scene))

    def test_time_as_asked_for(self):
        for limit in ("1 s", "3000 ms"):
            done = self.simulate(
                SOURCE / "geometry/tribometer/crank.toml", "--set",
                "force.springs.stiffness=1e12 N/m", "--max-time", limit)
            self.refused_in_time(
                done, f"{1 if limit == '1 s' else 3} s are allowed")

    def test_motion_that_drives_fix(self):
        scene = SOURCE / "geometry/landing_gear/scene.toml"
        many = ("--set", "simulation.instants=100000", "--max-time")
        done = self.simulate(scene, *many, "0.1 s")
        self.refused_in_time(done, "positions", "instants", "0.1 s are allowed")

    def test_times_out_of_range(self):
        scene = SOURCE / "geometry/tribometer/scene.toml"
        for text in ("0 s", "-1 s", "1e9 s", "60", "5 mm", "nan s"):
            done = self.simulate(scene, "--max-time", text)
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertIn("--max-time", done.stderr)

    def test_body_joined_to_nothing(self):
        text = (SOURCE / "geometry/five_bar/scene.toml").read_text()
        body = ('[[body]]\nname = "loose"\nmass = "1 kg"\n'
                'center_of_mass = ["0 mm", "0 mm", "0 mm"]\n'
                'inertia = ["100 kg mm^2", "100 kg mm^2", "100 kg mm^2"]\n'
                'placement = { origin = ["0 mm", "0 mm", "0 mm"] }\n\n')
        with tempfile.TemporaryDirectory() as folder:
            scene = Path(folder) / "scene.toml"
            scene.write_text(text.replace("[[joint]]", body + "[[joint]]", 1))
            done = self.simulate(scene)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertIn("body loose has no joint", done.stdout)
            self.assertNotIn("no joint", self.simulate(
                SOURCE / "geometry/five_bar/scene.toml").stdout)


if __name__ == "__main__":
    CLEVIS, SOURCE = sys.argv[1], Path(sys.argv[2])
    unittest.main(argv=sys.argv[:1])

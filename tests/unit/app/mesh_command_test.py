#!/usr/bin/env python3
"""`clevis mesh` end to end on a copy of a committed geometry.

Usage: mesh_command_test.py CLEVIS SOURCE_DIR
"""
import os
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SCENE = """schema = 1
name = "one link"

[material.steel]
youngs_modulus = "210 GPa"
poissons_ratio = 0.3
density = "7850 kg/m^3"
yield_strength = "355 MPa"

[[part]]
name = "AB"
geometry = "link_ab.geo"
length_unit = "mm"
material = "steel"

[[part.case]]
name = "pull"
pins = { bore_A = ["-1 N", "0 N", "0 N"], bore_B = ["1 N", "0 N", "0 N"] }
"""


class MeshCommand(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.root = Path(self.folder.name)
        self.geometry = self.root / "geometry" / "gear"
        self.geometry.mkdir(parents=True)
        shutil.copy(SOURCE / "geometry/landing_gear/link_ab.geo",
                    self.geometry)
        (self.geometry / "scene.toml").write_text(SCENE)
        self.mesh = self.root / "meshes" / "gear" / "link_ab.msh"

    def tearDown(self):
        self.folder.cleanup()

    def run_mesh(self, *arguments):
        # Options in a user's home folder would change every mesh.
        (self.root / ".gmsh-options").write_text(
            "Mesh.ElementOrder = 2;\nMesh.MshFileVersion = 2.2;\n")
        return subprocess.run(
            [CLEVIS, "mesh", str(self.geometry / "scene.toml"), *arguments],
            env=dict(os.environ, HOME=str(self.root)), capture_output=True,
            text=True, timeout=120)

    def test_makes_the_committed_mesh_byte_for_byte(self):
        done = self.run_mesh()
        self.assertEqual(done.returncode, 0, done.stderr)
        committed = SOURCE / "meshes/landing_gear/link_ab.msh"
        self.assertEqual(self.mesh.read_bytes(), committed.read_bytes())
        self.assertEqual([f.name for f in self.mesh.parent.iterdir()],
                         ["link_ab.msh"])

    def test_keeps_the_old_mesh_when_gmsh_fails(self):
        self.mesh.parent.mkdir(parents=True)
        self.mesh.write_text("old")
        (self.geometry / "link_ab.geo").write_text("Line(1) = {1, 2};\n")
        done = self.run_mesh()
        self.assertEqual(done.returncode, 11, done.stderr)
        self.assertIn("M010", done.stderr)
        self.assertIn("Unknown control point 1", done.stderr)
        self.assertEqual(self.mesh.read_text(), "old")

    def test_keeps_no_mesh_that_the_gate_refuses(self):
        geo = self.geometry / "link_ab.geo"
        geo.write_text(geo.read_text().replace('"side"', '"round_side"'))
        done = self.run_mesh()
        self.assertEqual(done.returncode, 11, done.stderr)
        self.assertIn("M009", done.stderr)
        self.assertFalse(self.mesh.exists())

    def test_refuses_an_unknown_part(self):
        done = self.run_mesh("--part", "AD")
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertIn("U001", done.stderr)
        self.assertIn("AB", done.stderr)

    def draw_step(self, length):
        """A bar as CAD hands it over."""
        script = self.root / "bar.geo"
        script.write_text(
            'SetFactory("OpenCASCADE");\n'
            f'Box(1) = {{0, 0, 0, {length}, 10, 10}};\nSave "bar.step";\n')
        subprocess.run(["gmsh", "-0", "-v", "1", "bar.geo"], cwd=self.root,
                       check=True, capture_output=True)
        shutil.copy(self.root / "bar.step", self.geometry)

    def test_refuses_a_mesh_whose_step_has_changed(self):
        self.draw_step(100)
        (self.geometry / "bar.geo").write_text(
            'SetFactory("OpenCASCADE");\nMerge "bar.step";\n'
            'Physical Volume("body") = {1};\n'
            'Physical Surface("left") = {1};\n'
            'Physical Surface("right") = {2};\n'
            "Mesh.MeshSizeMax = 10;\nMesh.ElementOrder = 2;\n")
        scene = self.geometry / "scene.toml"
        scene.write_text(
            SCENE.replace("link_ab.geo", "bar.geo").split("pins")[0]
            + 'traction = { left = ["-1 MPa", "0 MPa", "0 MPa"], '
              'right = ["1 MPa", "0 MPa", "0 MPa"] }\n')

        def check():
            return subprocess.run(
                [CLEVIS, "check", str(scene), "--out", str(self.root / "out")],
                capture_output=True, text=True, timeout=120)
        self.assertEqual(self.run_mesh().returncode, 0)
        done = check()
        self.assertIn(done.returncode, (0, 4), done.stdout + done.stderr)
        self.draw_step(120)
        done = check()
        self.assertEqual(done.returncode, 11, done.stdout + done.stderr)
        self.assertIn("a file that it reads", done.stderr)
        self.assertEqual(self.run_mesh().returncode, 0)
        self.assertIn(check().returncode, (0, 4))


if __name__ == "__main__":
    CLEVIS, SOURCE = sys.argv[1], Path(sys.argv[2])
    unittest.main(argv=sys.argv[:1])

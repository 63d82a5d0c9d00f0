"""A solid of STEP as IGES (solids, or surfaces that are sewn; millimetres or
inches) and as BREP: the same faces, and the same verdict.

    other_formats.py CLEVIS SOURCE_DIR IGES_WRITER
"""
import json
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import support

CLEVIS, SOURCE, WRITER = (Path(argument).resolve() for argument in sys.argv[1:4])
STEP = SOURCE / "geometry/step"


class OtherFormats(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.folder = Path(self.temporary.name)

    def tearDown(self):
        self.temporary.cleanup()

    def iges(self, part, form, unit):
        name = f"{part}_{form}_{unit.lower()}.igs"
        subprocess.run([WRITER, STEP / f"{part}.step", name, form, unit],
                       cwd=self.folder, check=True, timeout=60,
                       stdout=subprocess.DEVNULL)
        return name

    def faces(self, file):
        done = subprocess.run([CLEVIS, "faces", file, "--json"], cwd=self.folder,
                              capture_output=True, text=True, timeout=60)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        return json.loads(done.stdout)["solids"][0]

    def check(self, part, geometry, unit=""):
        scene = (STEP / f"{part}.toml").read_text()
        self.assertIn(f'geometry = "{part}.step"', scene)
        (self.folder / "scene.toml").write_text(scene.replace(
            f'geometry = "{part}.step"', f'geometry = "{geometry}"{unit}'))
        return support.check(CLEVIS, self.folder / "scene.toml",
                             exits=support.JUDGED)

    def expect_alike(self, part, geometry, reference, unit=""):
        answer = self.check(part, geometry, unit)
        print(f"{geometry}: {answer}", flush=True)
        self.assertEqual(answer.part["verdict"], reference.part["verdict"])
        low, high = answer.band
        self.assertLess(low, reference.band[1])
        self.assertGreater(high, reference.band[0])
        self.assertAlmostEqual(answer.part["deflection_mm"] /
                               reference.part["deflection_mm"], 1.0, 2)

    def test_bores_of_all_parts(self):
        """Cylinders by their type, diameter and area; volumes."""
        def bores(solid):
            return sorted((round(f["diameter_m"], 8), round(f["area_m2"], 9))
                          for f in solid["faces"] if "cylinder" in f["type"])
        for part in ("bell_crank", "bracket", "con_rod", "fork", "hollow_shaft"):
            here = self.faces(STEP / f"{part}.step")
            for form, unit in (("solids", "MM"), ("surfaces", "INCH")):
                there = self.faces(self.iges(part, form, unit))
                self.assertAlmostEqual(there["volume_m3"] / here["volume_m3"],
                                       1.0, 6, (part, form))
                self.assertEqual(bores(there), bores(here), (part, form))

    def test_verdict_of_a_fork(self):
        shutil.copy(STEP / "fork.step", self.folder)
        reference = self.check("fork", "fork.step")
        for form, unit in (("solids", "INCH"), ("surfaces", "MM")):
            self.expect_alike("fork", self.iges("fork", form, unit), reference)
        subprocess.run(["gmsh", "-0", "-format", "brep", "-o", "fork.brep",
                        "fork.step"], cwd=self.folder, check=True, timeout=60,
                       stdout=subprocess.DEVNULL)
        self.expect_alike("fork", "fork.brep", reference, '\nlength_unit = "mm"')


if __name__ == "__main__":
    sys.argv = sys.argv[:1]
    unittest.main(verbosity=2)

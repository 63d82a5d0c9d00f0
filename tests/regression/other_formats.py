"""A solid of STEP as IGES (solids, or surfaces that are sewn; millimetres or
inches), as BREP, and as STEP of splines: the same faces, and the same verdict.

    other_formats.py CLEVIS SOURCE_DIR CAD_WRITER
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

    def written(self, part, form, unit):
        kind = "step" if form == "splines" else "igs"
        name = f"{part}_{form}_{unit.lower()}.{kind}"
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
        return support.check(CLEVIS, self.folder / "scene.toml", "--tolerance", "10%",
                             "--mesh-rounds", "0", exits=support.JUDGED)

    def expect_alike(self, part, geometry, reference, unit=""):
        answer = self.check(part, geometry, unit)
        print(f"{geometry}: {answer}", flush=True)
        self.assertEqual(answer.part["verdict"], reference.part["verdict"])
        low, high = answer.band
        self.assertLess(low, reference.band[1])
        self.assertGreater(high, reference.band[0])
        # what bands of degree 3, which overlap, would leave open
        self.assertAlmostEqual(answer.peak / reference.peak, 1.0, delta=0.016)
        self.assertAlmostEqual(answer.part["deflection_mm"] /
                               reference.part["deflection_mm"], 1.0, 2)

    def test_bores_of_all_parts(self):
        """Volumes; cylinders with their diameters and areas, by type."""
        def bores(solid):
            return sorted(((f["type"], f["diameter_m"], f["area_m2"])
                           for f in solid["faces"] if "cylinder" in f["type"]),
                          key=lambda f: (f[0], round(f[1], 7), f[2]))
        both = (("surfaces", "INCH"), ("splines", "INCH"))
        for part, forms in (("bracket", both[:1]), ("hollow_shaft", both[:1]),
                            ("fork", both + (("solids", "MM"),))):
            here = self.faces(STEP / f"{part}.step")
            for form, unit in forms:
                there = self.faces(self.written(part, form, unit))
                self.assertAlmostEqual(there["volume_m3"] / here["volume_m3"],
                                       1.0, 4, (part, form))
                pairs = list(zip(bores(there), bores(here), strict=True))
                self.assertGreater(len(pairs), 2)
                for (kind, diameter, area), wanted in pairs:
                    self.assertEqual(kind, wanted[0], (part, form))
                    self.assertAlmostEqual(diameter / wanted[1], 1.0, 6)
                    self.assertAlmostEqual(area / wanted[2], 1.0, delta=3e-5)

    def test_verdict_of_a_fork(self):
        shutil.copy(STEP / "fork.step", self.folder)
        reference = self.check("fork", "fork.step")
        for form, unit in (("solids", "INCH"), ("surfaces", "MM"),
                           ("splines", "INCH")):
            self.expect_alike("fork", self.written("fork", form, unit), reference)
        subprocess.run(["gmsh", "-0", "-format", "brep", "-o", "fork.brep",
                        "fork.step"], cwd=self.folder, check=True, timeout=60,
                       stdout=subprocess.DEVNULL)
        self.expect_alike("fork", "fork.brep", reference, '\nlength_unit = "mm"')


if __name__ == "__main__":
    sys.argv = sys.argv[:1]
    unittest.main(verbosity=2)

"""`clevis init NAME --geometry FILE`: the scene of a CAD file leads to a verdict as
it is. Each STEP file of `geometry`, a link turned in space, parts with one bore,
with bolts, and with none; file names that a scene cannot take.

    init_geometry.py CLEVIS SOURCE_DIR
"""
import json
import math
import re
import shutil
import subprocess
import sys
import tempfile
import tomllib
import unittest
from pathlib import Path

CLEVIS, SOURCE = (Path(argument).resolve() for argument in sys.argv[1:3])

LINK = """SetFactory("OpenCASCADE");
Box(1) = {0, -12, 0, 80, 24, 8};
Cylinder(2) = {0, 0, 0, 0, 0, 8, 12}; Cylinder(3) = {80, 0, 0, 0, 0, 8, 12};
BooleanUnion(4) = { Volume{1}; Delete; }{ Volume{2, 3}; Delete; };
Cylinder(5) = {0, 0, -1, 0, 0, 10, 6}; Cylinder(6) = {80, 0, -1, 0, 0, 10, 6};
BooleanDifference(7) = { Volume{4}; Delete; }{ Volume{5, 6}; Delete; };
"""

# A rod with one eye; a block; a link with a fork at either end.
EYE = """SetFactory("OpenCASCADE");
Box(1) = {0, -15, 0, 60, 30, 12}; Cylinder(2) = {60, 0, 0, 0, 0, 12, 15};
BooleanUnion(3) = { Volume{1}; Delete; }{ Volume{2}; Delete; };
Cylinder(4) = {60, 0, -1, 0, 0, 14, 7};
BooleanDifference(5) = { Volume{3}; Delete; }{ Volume{4}; Delete; };
"""

BLOCK = """SetFactory("OpenCASCADE");
Box(1) = {0, 0, 0, 60, 20, 30};
"""

FORKS = """SetFactory("OpenCASCADE");
Box(1) = {-10, -10, -15, 120, 20, 30};
Box(2) = {-11, -11, -7, 26, 22, 14}; Box(3) = {85, -11, -7, 26, 22, 14};
BooleanDifference(4) = { Volume{1}; Delete; }{ Volume{2, 3}; Delete; };
Cylinder(5) = {0, 0, -20, 0, 0, 40, 4}; Cylinder(6) = {100, 0, -20, 0, 0, 40, 4};
BooleanDifference(7) = { Volume{4}; Delete; }{ Volume{5, 6}; Delete; };
"""

# A link whose wider bore has a keyway: 93 % of its wall is there.
KEYWAY = LINK + """Cylinder(20) = {0, 0, -1, 0, 0, 10, 6.5};
BooleanDifference(21) = { Volume{7}; Delete; }{ Volume{20}; Delete; };
Box(8) = {-8.5, -1.5, -1, 4, 3, 10};
BooleanDifference(9) = { Volume{21}; Delete; }{ Volume{8}; Delete; };
"""

# Two walls that meet in a sharp inner corner, with a bore.
CORNER = """SetFactory("OpenCASCADE");
Box(1) = {0, 0, 0, 40, 20, 8}; Box(2) = {0, 0, 0, 8, 20, 40};
BooleanUnion(3) = { Volume{1}; Delete; }{ Volume{2}; Delete; };
Cylinder(4) = {-1, 10, 28, 10, 0, 0, 5};
BooleanDifference(5) = { Volume{3}; Delete; }{ Volume{4}; Delete; };
"""

ROD = """SetFactory("OpenCASCADE");
Cylinder(1) = {0, 0, 0, 100, 0, 0, 10};
"""

BALL = """SetFactory("OpenCASCADE");
Sphere(1) = {0, 0, 0, 10};
"""


def turned(v, axis, angle):
    """Rodrigues' formula."""
    norm = math.sqrt(sum(a * a for a in axis))
    k = [a / norm for a in axis]
    cross = [k[1] * v[2] - k[2] * v[1], k[2] * v[0] - k[0] * v[2],
             k[0] * v[1] - k[1] * v[0]]
    dot = sum(a * b for a, b in zip(k, v))
    return [v[d] * math.cos(angle) + cross[d] * math.sin(angle)
            + k[d] * dot * (1 - math.cos(angle)) for d in range(3)]


def newtons(vector):
    units = {"N": 1.0, "kN": 1e3}
    return [float(text.split()[0]) * units[text.split()[1]] for text in vector]


class InitGeometry(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.folder = Path(self.temporary.name)

    def tearDown(self):
        self.temporary.cleanup()

    def shape(self, name, script, form="step"):
        (self.folder / "shape.geo").write_text(script)
        subprocess.run(["gmsh", "-0", "-format", form, "-o", name, "shape.geo"],
                       cwd=self.folder, check=True, timeout=60,
                       stdout=subprocess.DEVNULL)
        return name

    def run_clevis(self, *arguments, codes=(0,)):
        done = subprocess.run([CLEVIS, *map(str, arguments)], cwd=self.folder,
                              capture_output=True, text=True, timeout=280)
        self.assertIn(done.returncode, codes, done.stdout + done.stderr)
        return done

    def init(self, name, file):
        """The scene that is written of a file, as data and as text."""
        self.told = self.run_clevis("init", name, "--geometry", file).stdout
        text = (self.folder / name / "scene.toml").read_text()
        self.assertTrue(text.startswith("#:schema ./scene.schema.json\n"))
        json.loads((self.folder / name / "scene.schema.json").read_text())
        self.assertIn("CHANGE the ", text)
        scene = tomllib.loads(text)
        copy = self.folder / name / scene["part"][0]["geometry"]
        self.assertEqual(copy.read_bytes(), (self.folder / file).read_bytes())
        return scene, text

    def check(self, name, *more, codes=(0,)):
        """The part's result. Neither degree 4 nor finer meshes: a verdict is
        wanted, not many digits."""
        done = self.run_clevis("check", f"{name}/scene.toml", "--json", "--out",
                               f"out_{name}", "--tolerance", "5%", *more,
                               codes=codes)
        result = json.loads(done.stdout)
        return result["parts"][0], result["verdict"]

    def test_each_step_file_leads_to_a_verdict(self):
        files = sorted(SOURCE.glob("geometry/**/*.step"))
        self.assertGreaterEqual(len(files), 5)
        for file in files:
            with self.subTest(file=file.name):
                scene, text = self.init(file.stem, file)
                self.assertIn("unit millimetre", text)
                # No refusal: a limit is kept, broken, or lies within the band.
                part, verdict = self.check(file.stem, "--mesh-rounds", "0",
                                           codes=(0, 1, 4))
                self.assertIn(verdict, ("pass", "fail", "not judged"))
                self.assertEqual(part["name"], file.stem)
                # Of the files here no placeholder should frighten anyone.
                self.assertEqual(verdict, "pass")

    def test_a_plain_rod_takes_its_first_mesh(self):
        self.shape("rod.step", ROD)
        self.init("rod", "rod.step")
        done = self.run_clevis("check", "rod/scene.toml", "--json", "--out", "out_rod",
                               "--mesh-rounds", "0")
        peak = json.loads(done.stdout)["parts"][0]["peak_von_mises"]
        self.assertEqual(peak["verdict"], "converged")
        self.assertAlmostEqual(peak["value_MPa"], 10.04, 2)

    def test_what_is_held_and_pulled(self):
        wanted = {"fork": ("bore_A", "bore_B"), "con_rod": ("bore_A", "bore_B"),
                  "bell_crank": ("bore_A", "bore_B"), "bracket": ("base", "bore_A"),
                  "hollow_shaft": ("bore_A", "bore_B")}
        for name, (held, pulled) in wanted.items():
            scene, text = self.init(name, SOURCE / f"geometry/step/{name}.step")
            part = scene["part"][0]
            case = part["case"][0]
            self.assertEqual(list(case["pins"]), [pulled], name)
            self.assertEqual(case.get("held_by_pin", list(case.get("foundation", []))),
                             [held], name)
            self.assertEqual(set(part["faces"]), {held, pulled}, name)
            lines = [line for line in text.splitlines() if line[:1] not in ("#", "")]
            self.assertLessEqual(len(lines), 24, name)
        # Its two ears are one bore; the bracket's bolts stand in comments.
        self.assertRegex(self.scene_of("fork"), r"bore_A: diameter 16 mm, 18 mm "
                         r"long in 2 pieces, middle \(40, 0, 0\) mm, axis \(0, 0, 1\)")
        for bolt in "BCDE":
            self.assertRegex(self.scene_of("bracket"), rf"\n# bore_{bolt}: diameter "
                             rf"11 mm, .*\n# bore_{bolt} = {{")

    def scene_of(self, name):
        return (self.folder / name / "scene.toml").read_text()

    def test_comments_can_be_taken_in(self):
        self.init("bracket", SOURCE / "geometry/step/bracket.step")
        text = re.sub(r"^# (bore_\w = )", r"\1", self.scene_of("bracket"), flags=re.M)
        (self.folder / "bracket/scene.toml").write_text(text)
        done = self.run_clevis("faces", "bracket/scene.toml", "--json")
        groups = [f["group"] for f in json.loads(done.stdout)["solids"][0]["faces"]
                  if "group" in f]
        self.assertEqual(sorted(groups), ["base", "bore_A", "bore_B", "bore_C",
                                          "bore_D", "bore_E"])

    def test_a_turned_link_goes_as_the_straight_one(self):
        axis, angle = (1, 2, 3), 0.7
        self.shape("straight.step", LINK)
        self.shape("turned.step", LINK + f"Rotate {{{{{axis[0]}, {axis[1]}, {axis[2]}}}, "
                   f"{{5, 7, 1}}, {angle}}} {{ Volume{{7}}; }}\n")
        bands = []
        for name in ("straight", "turned"):
            scene, text = self.init(name, f"{name}.step")
            case = scene["part"][0]["case"][0]
            wanted = (turned((1, 0, 0), axis, angle) if name == "turned"
                      else (1, 0, 0))
            force = newtons(case["pins"]["bore_B"])
            size = math.sqrt(sum(f * f for f in force))
            # 10 MPa x 12 mm x 8 mm = 960 N, to one digit.
            self.assertAlmostEqual(size, 1000.0, 3)
            # Which bore is A hangs on where they lie; both pull apart.
            for f, w in zip(force, wanted):
                self.assertAlmostEqual(f / size, w, 6)
            normal = (turned((0, 0, 1), axis, angle) if name == "turned"
                      else (0, 0, 1))
            found = re.findall(r"axis \((.*?)\)$", text, re.M)
            self.assertEqual(len(found), 2)
            for one in found:  # as joints take them, to 1e-6 rad
                one = [float(x) for x in one.split(",")]
                sine = math.dist((0, 0, 0), [
                    one[1] * normal[2] - one[2] * normal[1],
                    one[2] * normal[0] - one[0] * normal[2],
                    one[0] * normal[1] - one[1] * normal[0]])
                self.assertLess(sine, 1e-8)
            part, verdict = self.check(name)
            self.assertEqual(verdict, "pass")
            bands.append(part["peak_von_mises"]["band_MPa"])
        self.assertIn("along (", self.scene_of("turned"))
        self.assertNotIn("along (", self.scene_of("straight").split("[part.faces]")[1])
        self.assertLessEqual(max(b[0] for b in bands), min(b[1] for b in bands), bands)

    def test_one_bore_is_pulled_off_a_plane_face(self):
        scene, _ = self.init("eye", self.shape("eye.step", EYE))
        part = scene["part"][0]
        self.assertEqual(part["faces"]["base"], {"plane": {"normal": [-1, 0, 0]}})
        self.assertEqual(newtons(part["case"][0]["pins"]["bore_A"]), [2000, 0, 0])
        self.assertEqual(self.check("eye")[1], "pass")

    def test_a_bore_with_a_keyway_takes_its_pin(self):
        """The wall that is there carries the pin, and the part's notes say so."""
        scene, text = self.init("keyway", self.shape("keyway.step", KEYWAY))
        self.assertRegex(text, r"bore_A: diameter 13 mm, 8 mm long, 92\.\d+ % of its wall")
        part = scene["part"][0]
        self.assertEqual(set(part["faces"]), {"bore_A", "bore_B"})
        self.assertEqual(list(part["case"][0]["pins"]), ["bore_B"])
        found, _ = self.check("keyway", codes=(0, 4))
        self.assertRegex("\n".join(found["notes"]),
                         r'bore_A presses on "bore_A", of whose wall 92\.\d+ % is there')

    def test_a_bore_with_a_wide_slot_is_left_out(self):
        _, text = self.init("slot", self.shape("slot.step", KEYWAY.replace(
            "{-8.5, -1.5, -1, 4, 3, 10}", "{-8.5, -5.5, -1, 8.5, 11, 10}")))
        for told in (text, self.told):
            self.assertRegex(told, r"left out, for a pin needs most of a wall and here are "
                             r"\d+(\.\d+)? % of one: hollow arc of diameter 13 mm, 8 mm long")
            self.assertIn("`foundation`", told)

    def test_a_sharp_corner_is_not_judged_until_the_scene_says_so(self):
        _, text = self.init("corner", self.shape("corner.step", CORNER))
        self.assertIn('singular_zones = "exclude"', text)
        part, verdict = self.check("corner", codes=(4,))
        self.assertEqual(verdict, "not judged")
        self.assertIn("singular_zones", json.dumps(part))
        # The remedy that scene and result name.
        (self.folder / "corner/scene.toml").write_text(text.replace(
            "limits = { safety_factor = 1.5",
            'limits = { safety_factor = 1.5, singular_zones = "exclude"'))
        self.assertEqual(self.check("corner")[1], "pass")

    def test_without_bores_the_ends_are_pulled_apart(self):
        self.init("block", self.shape("block.step", BLOCK))
        part, verdict = self.check("block")
        self.assertEqual(verdict, "pass")
        # 10 MPa, but for what the bed holds across.
        self.assertAlmostEqual(part["peak_von_mises"]["value_MPa"], 10.0, delta=0.3)

    def test_forks_that_are_alike(self):
        """Each of two pairs of ears is one bore; sharp corners are not judged."""
        name = "two forks (\u00e4).STEP"
        self.shape("forks.step", FORKS)
        (self.folder / "forks.step").rename(self.folder / name)
        scene, _ = self.init("forks", name)
        part = scene["part"][0]
        self.assertEqual(part["geometry"], "two_forks_____.STEP")
        for group in ("bore_A", "bore_B"):
            self.assertEqual(len(part["faces"][group]["all_of"]), 2)
        self.assertEqual(self.check("forks", "--mesh-rounds", "0", codes=(4,))[1],
                         "not judged")

    def test_a_brep_says_its_unit_in_the_scene(self):
        scene, _ = self.init("link", self.shape("mechanism.brep", LINK, "brep"))
        self.assertEqual(scene["part"][0]["length_unit"], "mm")
        self.assertEqual(scene["part"][0]["name"], "mechanism_2")
        self.assertEqual(self.check("link")[1], "pass")

    def test_takes_the_unit_of_the_file(self):
        text = (SOURCE / "geometry/step/con_rod.step").read_text()
        metre = "SI_UNIT(.MILLI.,.METRE.)"
        self.assertIn(metre, text)
        (self.folder / "large.step").write_text(
            text.replace(metre, "SI_UNIT(.CENTI.,.METRE.)"))
        _, text = self.init("large", "large.step")
        self.assertIn("unit centimetre, 1680 x 600 x 180 mm", text)
        self.assertIn("bore_A: diameter 400 mm", text)

    def test_refuses_and_leaves_nothing(self):
        done = self.run_clevis("init", "ball", "--geometry",
                               self.shape("ball.step", BALL), codes=(11,))
        self.assertRegex(done.stderr, r"error\[M017\]: ball.step: .*no bore.*"
                         r"\n  help: .*\[part.faces\]")
        self.assertFalse((self.folder / "ball").exists())
        (self.folder / "mine").mkdir()
        (self.folder / "mine/notes.txt").write_text("mine")
        shutil.copy(SOURCE / "geometry/step/fork.step", self.folder)
        for target in ("mine", "fork.step"):
            done = self.run_clevis("init", target, "--geometry", "fork.step",
                                   codes=(22,))
            self.assertIn("I005", done.stderr)
        self.assertEqual([p.name for p in (self.folder / "mine").iterdir()],
                         ["notes.txt"])
        (self.folder / "bad.step").write_text('SystemCall "touch ran";\n')
        done = self.run_clevis("init", "bad", "--geometry", "bad.step", codes=(11,))
        self.assertIn("M015", done.stderr)
        self.assertFalse((self.folder / "ran").exists())
        self.assertFalse((self.folder / "bad").exists())


if __name__ == "__main__":
    sys.argv = sys.argv[:1]
    unittest.main(verbosity=2)

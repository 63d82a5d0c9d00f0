#!/usr/bin/env python3
"""Settings, plans and collections that must be refused well.

    run_variants.py CLEVIS ROOT

Refused well means: the exit code, the code, the place (the number of the --set,
or line and column of the table), the text, a line of help, nothing on stdout and
no plan.
"""
import json
import subprocess
import sys
import tempfile
from pathlib import Path

SCENE = "geometry/landing_gear/loaded.toml"

# what follows --set, exit code, code, place, text
SETTINGS = [
    (["part.AX.thickness=5 mm"], 10, "S007", "--set 1", 'Did you mean "AB"?'),
    (["part.AB.parameters.thickness=5"], 10, "S004", "--set 1", "has no unit"),
    (["part.AB.parameters.thickness=5 kg"], 10, "S004", "--set 1", "mm"),
    (["part.AB.thicknes=5 mm"], 10, "S002", "--set 1",
     'Did you mean "thickness"?'),
    (["simulation.duration=2 s", "part.AB.material=steel_46"], 10, "S007",
     "--set 2", 'Did you mean "steel_45"?'),
    (["material.steel_45.youngs_modulus=210 MPa m"], 10, "S004", "--set 1",
     "GPa"),
    (["material.steel_45.youngs_modulus=210 kPa"], 10, "S011", "--set 1",
     "range of real materials"),
    (["joint.B.at.AB[3]=1 mm"], 10, "S007", "--set 1", "3 entries"),
    (["joint.B.at.AB=1 mm"], 10, "S005", "--set 1", "array"),
    (["joint.B.at.AB[0].x=1 mm"], 10, "S005", "--set 1", "leads nowhere"),
    (["part.AB.limits.safety_factor=0.5"], 10, "S006", "--set 1", "yield"),
    (["part.AB..x=1"], 10, "S007", "--set 1", "no path"),
    (["part.AB.material"], 2, "U001", "--set 1", "PATH=VALUE"),
    (["schema=1", "schema=1"], 10, "S010", "--set 2", "by --set 1"),
    (["name=\x1b[31m"], 2, "U001", "--set 1", "PATH=VALUE"),
]
# of `mesh`, and of `check` with --mesh
MESHES = [
    (["part.AB.parameters.thicknes=5 mm"], 10, "S007", "--set 1",
     'Did you mean "thickness"?'),
    (["part.AB.parameters.half_width=5 mm"], 10, "S007", "--set 1",
     "assigns half_width itself"),
]
# text of the table, exit code, code, line:column, text
TABLES = [
    ("", 10, "S012", "1:1", "empty"),
    ("part.AB.material\n", 10, "S012", "1:1", "no row"),
    ("part.AB.material\nsteel_46\n", 10, "S007", "2:1", "steel_45"),
    ("variant,part.AB.material\na,steel_45\na,steel_45\n", 10, "S008", "3:1",
     "2:1"),
    ("variant,part.AB.material\na/b,steel_45\n", 10, "S006", "2:1", "folder"),
    ("part.AB.parameters.thickness [mm]\n5\n\n6,7\n", 10, "S012", "4:1",
     "2 fields"),
    ("part.AB.parameters.thickness [mm]\n5\n\"6\n", 10, "S012", "3:1",
     "not closed"),
    ("part.AB.parameters.thickness [kg]\n5\n", 10, "S004", "2:1", "mm"),
    ("part.AB.parameters.thickness\n5\n", 10, "S004", "2:1", "has no unit"),
    ("part.AB.parameters.thick [mm]\n5\n", 10, "S007", "2:1", "thickness"),
    ('part.AB.material,"part.""AB"".material"\nsteel_45,steel_45\n', 10, "S010",
     "2:10", "2:1"),
    ("part AB\n5\n", 10, "S007", "1:1", "no path"),
]


class Checks:
    def __init__(self, clevis, root):
        self.clevis, self.root, self.bad = clevis, root, 0

    def run(self, *arguments):
        return subprocess.run([self.clevis, *map(str, arguments)], text=True,
                              capture_output=True, cwd=self.root, timeout=20)

    def expect(self, arguments, exit_code, code, place, text):
        run = self.run(*arguments)
        head = f"error[{code}]: {place}: "
        holds = (run.returncode == exit_code and run.stderr.startswith(head)
                 and text in run.stderr and "\n  help: " in run.stderr
                 and not run.stdout)
        self.bad += not holds
        print("ok    " if holds else "FAILED", code, *map(str, arguments[2:]),
              "" if holds else (run.returncode, run.stderr, run.stdout))


def settings(checks):
    for values, *expected in SETTINGS:
        options = [word for value in values for word in ("--set", value)]
        for command in ("simulate", "mesh"):
            checks.expect([command, SCENE, *options], *expected)
    for values, *expected in MESHES:
        options = [word for value in values for word in ("--set", value)]
        checks.expect(["mesh", SCENE, *options], *expected)
        checks.expect(["check", SCENE, *options, "--mesh"], *expected)


def plans(checks, folder):
    table = folder / "variants.csv"
    for text, exit_code, code, place, remark in TABLES:
        table.write_text(text)
        checks.expect(["plan", SCENE, "--vary", table, "--out", folder / "out"],
                      exit_code, code, f"{table}:{place}", remark)
    checks.expect(["plan", SCENE, "--vary", folder, "--out", folder / "out"],
                  22, "I001", folder, "is a folder, not a file")
    checks.expect(["plan", SCENE, "--out", folder / "out"], 10, "S003",
                  f"{SCENE}:1:1", "[vary]")
    if (folder / "out").exists():
        checks.bad += 1
        print("FAILED: a plan was written")


def collections(checks, folder):
    plan = folder / "plan.json"
    checks.expect(["collect", folder], 22, "I007", plan, "no such plan")
    plan.write_text('{"schema": 2')
    checks.expect(["collect", folder], 22, "I003", f"{plan}:1:13",
                  "`clevis plan` writes it anew")
    plan.write_text(json.dumps({"schema": 2, "version": "0", "scene": "x", "file": "x",
                                "variants": [{"name": "a"}]}))
    checks.expect(["collect", folder], 22, "I003", f"{plan}:/variants/0",
                  "inputs")


def main():
    checks = Checks(*(str(Path(a).resolve()) for a in sys.argv[1:3]))
    with tempfile.TemporaryDirectory() as folder:
        settings(checks)
        plans(checks, Path(folder))
        collections(checks, Path(folder))
    return checks.bad > 0


if __name__ == "__main__":
    sys.exit(main())

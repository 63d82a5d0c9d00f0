#!/usr/bin/env python3
"""No input makes another program start than clevis and what it is made of.

    run_programs.py CLEVIS SOURCE_DIR

Hostile inputs run under strace: scripts as meshes and CAD files, geometries
with commands, names and paths that a shell would run. Every program that any
process starts must be in PROGRAMS. Skipped (exit code 77) where strace cannot
trace.
"""
import json
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SECONDS = 120
PROGRAMS = {"clevis", "clevis-importer", "clevis-mesher", "gmsh", "ccx", "gnuplot",
            # round the second and third, and the program that it is tried with
            "bwrap", "ld-linux-x86-64.so.2", "ld-linux-aarch64.so.1"}
STARTED = re.compile(r'execve(?:at)?\((?:AT_FDCWD, )?"((?:[^"\\]|\\.)*)".*\) = 0$')
# A shell would run each; none holds a slash, each may be a file's name.
NAMES = ("$(touch ran)", "`touch ran`", "; touch ran", "|touch ran", "'\"; touch ran #")
COMMANDS = ('SystemCall "touch ran";', 'NonBlockingSystemCall "touch ran";',
            'OnelabRun("x", "touch ran");')


class Programs(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.folder = Path(self.temporary.name)
        subprocess.run([CLEVIS, "init", "part", "--template", "part"],
                       cwd=self.folder, check=True, capture_output=True)
        self.scene = (self.folder / "part/scene.toml").read_text()

    def tearDown(self):
        self.temporary.cleanup()

    def started(self, *arguments):
        """Runs clevis; names of the programs that were started."""
        log = self.folder / "programs.log"
        done = subprocess.run(
            ["strace", "-f", "--seccomp-bpf", "-qq", "-e", "trace=execve,execveat", "-e", "signal=none",
             "-o", log, CLEVIS, *map(str, arguments)],
            capture_output=True, text=True, errors="replace", timeout=SECONDS, cwd=self.folder)
        found = [STARTED.search(line) for line in log.read_text(errors="replace").splitlines()]
        programs = [Path(match[1]).name for match in found if match]
        self.assertIn("clevis", programs, done.stderr)
        self.assertNotIn(done.returncode, (70, 127), done.stderr)
        self.assertLessEqual(set(programs), PROGRAMS, arguments)
        self.assertFalse(list(self.folder.rglob("ran")), arguments)
        return done, programs

    def written(self, name, text):
        file = self.folder / name
        file.parent.mkdir(exist_ok=True)
        file.write_text(text)
        return file

    def test_the_tracer_sees_programs(self):
        _, programs = self.started("mesh", "part/scene.toml")
        self.assertIn("gmsh", programs)

    def test_invalid_inputs(self):
        for folder in ("mesh", "loads", "model"):
            for scene in sorted((SOURCE / "tests/invalid" / folder).glob("*.toml")):
                with self.subTest(scene=scene.name):
                    self.started("check", scene, "--out", self.folder / "out")

    def test_commands_of_a_geometry(self):
        geometry = self.folder / "part/link.geo"
        text = geometry.read_text()
        for command in COMMANDS:
            with self.subTest(command=command):
                geometry.write_text(command + "\n" + text)
                done, _ = self.started("mesh", "part/scene.toml")
                self.assertNotEqual(done.returncode, 0)
                self.assertIn("M010", done.stderr)

    def test_scripts_as_cad_files(self):
        for kind in ("step", "iges", "brep"):
            for text in COMMANDS[:1] + ("#!/bin/sh\ntouch ran\n",):
                with self.subTest(kind=kind, text=text):
                    self.written(f"part/solid.{kind}", text)
                    scene = self.scene.replace("link.geo", f"solid.{kind}")
                    if kind != "brep":  # its file has none
                        scene = re.sub("^length_unit.*$", "", scene, flags=re.M)
                    scene = self.written("part/cad.toml", scene)
                    done, _ = self.started("check", scene, "--out", "out")
                    self.assertEqual(done.returncode, 11, done.stderr)

    def test_models(self):
        model = (SOURCE / "tests/data/models/double_pendulum.sdf").read_text()
        include = "<include><uri>{}</uri></include><gravity>"
        hostile = [model.replace("<gravity>", include.format(uri)) for uri in (
            "https://fuel.ignitionrobotics.org/1.0/a/models/b", "model://$(touch ran)")]
        hostile += [model.replace('"elbow"', f'"{name.replace(chr(34), "&quot;")}"')
                    for name in NAMES]
        hostile += ["#!/bin/sh\ntouch ran\n", model.replace("libdriver.so", "/bin/sh")]
        for number, text in enumerate(hostile):
            with self.subTest(number=number):
                self.written("model.sdf", text)
                done, programs = self.started("import", "model.sdf", "--out", f"scene_{number}")
                self.assertIn(done.returncode, (0, 10), done.stderr)
                self.assertEqual("clevis-importer" in programs, text[0] == "<")

    def test_a_model_opens_no_connection(self):
        model = (SOURCE / "tests/data/models/double_pendulum.sdf").read_text()
        self.written("model.sdf", model.replace(
            "<gravity>", "<include><uri>https://fuel.ignitionrobotics.org/1.0/a/models/b</uri>"
            "</include><gravity>"))
        log = self.folder / "calls.log"
        subprocess.run(["strace", "-f", "-qq", "-e", "trace=%network", "-e", "signal=none", "-o",
                        log, CLEVIS, "import", "model.sdf", "--out", "scene"],
                       capture_output=True, timeout=SECONDS, cwd=self.folder, check=True)
        self.assertNotIn("AF_INET", log.read_text(errors="replace"))

    def test_names_of_files(self):
        for name in NAMES:
            with self.subTest(name=name):
                folder = self.folder / name
                shutil.copytree(self.folder / "part", folder)
                shutil.copy(folder / "link.geo", folder / f"{name}.geo")
                scene = folder / "scene.toml"
                done, _ = self.started("check", "--mesh", "--report", "--out",
                                       folder / "out", scene)
                self.assertIn(done.returncode, (0, 1))
                self.started("report", folder / "out")
                self.started("picture", folder / "out", "--part", "link")
                self.started("compare", folder / "out/result.json", folder / "out/result.json")
                scene.write_text(self.scene.replace('"link.geo"', json.dumps(f"{name}.geo")))
                self.started("mesh", scene)

    def test_names_in_a_scene(self):
        for name in NAMES:
            with self.subTest(name=name):
                scene = self.written("part/named.toml", re.sub(
                    '^name = .*$', lambda _, n=name: f"name = {json.dumps(n)}", self.scene,
                    flags=re.M))
                self.started("check", "--mesh", scene, "--report", "--out", "out")


def can_trace():
    return (shutil.which("strace") is not None and subprocess.run(
        ["strace", "-o", "/dev/null", "true"], capture_output=True).returncode == 0)


if __name__ == "__main__":
    CLEVIS, SOURCE = (Path(argument).resolve() for argument in sys.argv[1:3])
    if not can_trace():
        print("strace cannot trace here")
        sys.exit(77)
    unittest.main(argv=sys.argv[:1])

#!/usr/bin/env python3
"""The command line itself: usage errors, help, explain, start-up, colour.

    run_command_line.py CLEVIS SCENES
"""
import json
import os
import pty
import re
import subprocess
import sys
import tempfile
from pathlib import Path

CPU_MILLISECONDS = 60  # promised for everything that does not load deal.II

# arguments, exit code, code, text of the message
REFUSED = [
    (["--quick"], 2, "U001", "See clevis --help."),
    (["chek", "x.toml"], 2, "U001", 'Did you mean "check"?'),
    (["design", "x.toml"], 2, "U001", "Known: check, simulate"),
    (["study"], 2, "U001", "SCENE is required"),
    (["study", "none.toml"], 22, "I001", "none.toml"),
    (["study", "x.toml", "--elements", "C3D8"], 2, "U001", "--elements"),
    (["export"], 2, "U001", "SCENE is required"),
    (["export", "none.toml"], 22, "I001", "none.toml"),
    (["export", "x.toml", "--split", "0"], 2, "U001", "--split"),
    (["check"], 2, "U001", "SCENE is required"),
    (["check", "x.toml", "--tolerance", "zero"], 2, "U001", "--tolerance"),
    (["check", "x.toml", "--tolerance", "0%"], 2, "U001", "out of range"),
    (["check", "x.toml", "--tolerance", "1 mm"], 2, "U001", "ratio"),
    (["check", "x.toml", "--tolerance", "0.5"], 2, "U001", "has no unit"),
    (["modes", "x.toml", "--tolerance", "0.5"], 2, "U001", "has no unit"),
    (["check", "x.toml", "--jobs", "0"], 2, "U001", "--jobs"),
    (["check", "x.toml", "--jobs", "many"], 2, "U001", "--jobs"),
    (["simulate", "x.toml", "--quick"], 2, "U001", "--quick"),
    (["simulate", "x.toml", "y.toml"], 2, "U001", "y.toml"),
    (["compare", "only_one"], 2, "U001", "BASELINE"),
    (["explain", "Q999"], 2, "U002", "Q999"),
    (["simulate", "none.toml"], 22, "I001", "none.toml"),
    (["simulate", "."], 22, "I001", "Give the file itself."),
    (["check", "gear"], 22, "I001", "Give the scene in it: gear/scene.toml."),
    (["check", "gear", "--watch"], 22, "I001", "is a folder, not a file"),
    (["check", "own.STEP"], 10, "S001", "is a CAD file, not a scene"),
    (["mesh", "own.step"], 10, "S001", 'geometry = "own.step"'),
    (["check", "own.step"], 10, "S001", "clevis init NAME --geometry own.step"),
    (["init", "x", "--geometry", "own.step"], 11, "M015", "does not begin as a .step"),
    (["init", "x", "--geometry", "own.msh"], 11, "M015", "is no STEP, IGES or BREP"),
    (["init", "x", "--geometry", "none.step"], 22, "I001", "no such file"),
    (["init", "gear", "--geometry", "own.step"], 22, "I005", "nothing is overwritten"),
    (["init", "x", "--geometry", "own.step", "--template", "part"], 2, "U001",
     "--geometry"),
    (["init", "own.step"], 2, "U001", "clevis init NAME --geometry own.step"),
    (["check", "own.msh"], 10, "S001", 'mesh = "own.msh"'),
    (["simulate", "own.urdf"], 10, "S001", "clevis import own.urdf"),
    (["simulate", "/dev/zero"], 22, "I001", "not a regular file"),
    (["simulate", ""], 22, "I001", "no such file"),
]


class Checks:
    def __init__(self):
        self.bad = 0

    def expect(self, holds, claim, seen=""):
        self.bad += not holds
        print(f"{'ok' if holds else 'FAILED':7}{claim}"
              + ("" if holds else f": {seen!r}"))


def call(clevis, arguments, **options):
    return subprocess.run([clevis, *arguments], capture_output=True, text=True,
                          timeout=10, **options)


def check_refusals(clevis, checks, folder):
    (Path(folder) / "gear").mkdir()
    (Path(folder) / "gear/scene.toml").touch()
    for name in ("own.STEP", "own.step", "own.msh", "own.urdf"):
        (Path(folder) / name).touch()
    for arguments, exit_code, code, text in REFUSED:
        run = call(clevis, arguments, cwd=folder)
        checks.expect(run.returncode == exit_code
                      and run.stderr.startswith(f"error[{code}]: ")
                      and "\n  help: " in run.stderr and text in run.stderr
                      and not run.stdout, " ".join(arguments) or "nothing",
                      run)
        error = json.loads(call(clevis, [*arguments, "--json"],
                                cwd=folder).stdout)["error"]
        checks.expect({"code", "place", "problem", "remedy"} < error.keys()
                      and error["exit_code"] in (2, exit_code),
                      "  as JSON", error)


def check_part_names(clevis, checks, folder):
    """A name that no part of the scene has is one of the command line."""
    scene = Path(folder) / "link/scene.toml"
    subprocess.run([clevis, "init", scene.parent, "--template", "part"], check=True,
                   capture_output=True)
    for command in (["mesh"], ["check", "--mesh"], ["modes"], ["study"], ["export"]):
        run = call(clevis, [*command, scene, "--part", "nix"])
        checks.expect(run.returncode == 2 and "error[U001]: --part: " in run.stderr
                      and "Its parts: link." in run.stderr,
                      f"{command[0]} --part of another name", run)


def check_first_steps(clevis, checks):
    run = call(clevis, [])
    checks.expect(run.returncode == 2 and not run.stdout
                  and run.stderr.count("\n    clevis ") == 3
                  and run.stderr.startswith("error[U001]: "), "nothing: three commands", run)


def check_help(clevis, checks):
    run = call(clevis, ["--help"])
    examples = run.stdout.split("Usage:")[0].count("\n  clevis ")
    checks.expect(run.returncode == 0 and examples == 3,
                  "three examples before the usage", run)
    named = re.findall(r"\S+/\S+", run.stdout.split("Usage:")[0])
    checks.expect(named == ["link/scene.toml"],
                  "no file that is not made before", named)
    checks.expect("design" not in run.stdout, "no command that is not there")
    checks.expect(call(clevis, ["--version"]).stdout.startswith("clevis "),
                  "--version")
    listed = call(clevis, ["explain"]).stdout.splitlines()
    checks.expect(len(listed) > 40, "explain lists the catalogue", listed)
    for line in listed:
        code, exit_code = line.split()[0], line.split()[2]
        run = call(clevis, ["explain", code.lower()])
        if not (run.returncode == 0 and run.stdout.startswith(code + ": ")
                and f"(exit code {exit_code})" in run.stdout):
            checks.expect(False, f"explain {code}", run)


def check_start(clevis, checks, scenes):
    for arguments in (["--help"], ["--version"], ["explain", "S004"],
                      ["simulate", str(scenes / "no_density.toml")]):
        process = os.posix_spawn(
            clevis, [clevis, *arguments], os.environ, file_actions=[
                (os.POSIX_SPAWN_OPEN, fd, "/dev/null", os.O_WRONLY, 0)
                for fd in (1, 2)])
        usage = os.wait4(process, 0)[2]
        milliseconds = 1e3 * (usage.ru_utime + usage.ru_stime)
        checks.expect(milliseconds <= CPU_MILLISECONDS,
                      f"{' '.join(arguments[:1])}: {milliseconds:.0f} ms of "
                      "CPU", milliseconds)
    libraries = subprocess.run(["ldd", clevis], capture_output=True,
                               text=True, check=True).stdout
    checks.expect("deal" not in libraries and "petsc" not in libraries,
                  "links nothing of deal.II", libraries)


def on_terminal(clevis, environment):
    """What an error looks like on a terminal."""
    master, slave = pty.openpty()
    subprocess.run([clevis, "explain", "Q1"], stderr=slave, check=False,
                   env={**os.environ, "TERM": "xterm", **environment})
    os.close(slave)
    return os.read(master, 4096)


def check_output(clevis, checks):
    try:
        on_terminal(clevis, {})
    except OSError as error:  # a container without /dev/pts
        print(f"left out: colour on a terminal: {error}")
    else:
        checks.expect(b"\x1b[" in on_terminal(clevis, {"NO_COLOR": ""}),
                      "colour on a terminal")
        checks.expect(b"\x1b" not in on_terminal(clevis, {"NO_COLOR": "1"}),
                      "no colour with NO_COLOR")
    checks.expect("\x1b" not in call(clevis, ["explain", "Q1"]).stderr,
                  "no colour into a pipe")
    with open("/dev/full", "w") as full:
        run = subprocess.run([clevis, "explain"], stdout=full, check=False,
                             stderr=subprocess.PIPE, text=True)
    checks.expect(run.returncode == 22 and "I002" in run.stderr,
                  "a full disk is noticed", run)


def main():
    clevis, scenes = (str(Path(a).resolve()) for a in sys.argv[1:3])
    checks = Checks()
    with tempfile.TemporaryDirectory() as folder:
        check_refusals(clevis, checks, folder)
        check_part_names(clevis, checks, folder)
    check_first_steps(clevis, checks)
    check_help(clevis, checks)
    check_start(clevis, checks, Path(scenes))
    check_output(clevis, checks)
    return checks.bad > 0


if __name__ == "__main__":
    sys.exit(main())

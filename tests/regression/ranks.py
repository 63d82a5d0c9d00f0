#!/usr/bin/env python3
"""`mpirun -np N clevis`: one part shared among ranks gives the serial check to
1e-8 and the same bits each time, solids and such with fewer cells than ranks too,
whose bytes on their way are counted;
ranks beside the first hold the solver's share alone; parts dealt out give the serial
bits; other commands do their work once, and frequencies
of what would be shared are refused; a rank that is killed ends all.

    ranks.py CLEVIS ROOT
"""
import json
import os
import re
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from hex_mesh import block, write
from support import Checks, make_meshes, steel

SCENE = "geometry/landing_gear/scene.toml"
SHARED = "geometry/nafems_le1/scene.toml"
ENVIRONMENT = os.environ | {  # root is who builds in a container
    "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}
AGREEMENT = 1e-8
MOST_SECONDS = 5.0  # until all ranks have ended


def command(ranks, *arguments):
    start = ["mpirun", "--oversubscribe", "-np", str(ranks)] if ranks > 1 else []
    return [*start, *map(str, arguments)]


def run(ranks, *arguments):
    return subprocess.run(command(ranks, *arguments), capture_output=True, text=True,
                          env=ENVIRONMENT)


def numbers(value, path=""):
    """{path: number or text} of a JSON document without its seconds."""
    if isinstance(value, dict):
        items = [(k, v) for k, v in value.items() if "seconds" not in k]
    elif isinstance(value, list):
        items = list(enumerate(value))
    else:
        return {path: value}
    return {k: v for key, item in items for k, v in numbers(item, f"{path}/{key}").items()}


def checked(clevis, ranks, folder, scene, *options):
    """Of one run: its document without seconds, its files."""
    answer = run(ranks, clevis, "check", scene, "--json", "--out", folder, *options)
    try:
        document = json.loads(answer.stdout)
    except ValueError:
        sys.exit(f"{ranks} ranks, {options}: exit {answer.returncode}\n"
                 f"{answer.stdout}\n{answer.stderr}")
    return numbers(document), sorted(f.name for f in Path(folder).rglob("*") if f.is_file())


def worst(one, other):
    """Largest relative difference of peaks, bands, deflections and energies."""
    def differs(key):
        a, b = one[key], other[key]
        return abs(a - b) / max(abs(a), abs(b)) if a != b else 0.0
    wanted = ("peak_von_mises/value_MPa", "/band_MPa/", "deflection_mm", "strain_energy_mJ")
    keys = [k for k in one if any(w in k for w in wanted) and isinstance(one[k], float)]
    return max(map(differs, keys)), len(keys)


def few_cells(folder):
    """A scene of two hexahedra, pulled; the place of its file."""
    write(folder / "bar.msh", block((2, 1, 1), lambda x, y, z: (40 * x, 10 * y, 10 * z)))
    scene = folder / "bar.toml"
    scene.write_text(f"""schema = 1
name = "two cells"
{steel()}
[[part]]
name = "bar"
mesh = "bar.msh"
length_unit = "mm"
material = "steel"

[[part.case]]
name = "pull"
fixed = {{ x0 = ["x", "y", "z"] }}
traction = {{ x1 = ["10 MPa", "20 MPa", "0 MPa"] }}
""")
    return scene


def shares(clevis, checks, place, name, options, counts):
    """One part on several numbers of ranks against the serial check; the last result."""
    serial, files = checked(clevis, 1, place(f"{name}1"), *options)
    for ranks in counts:
        result, its_files = checked(clevis, ranks, place(f"{name}{ranks}"), *options)
        difference, count = worst(serial, result)
        checks.expect(count > 4 and difference < AGREEMENT,
                      f"{name}: {ranks} ranks share it, {count} numbers within {difference:.1e}")
        checks.expect(its_files == files, f"{name}: {ranks} ranks write the serial files")
    return result


def one_face_sent(checks, result):
    """Of two cells on two ranks the rows of one face go there and back."""
    degree = int(re.search(r"p = (\d)", result["/parts/0/model"])[1])
    told = re.search(r"([0-9.]+) kB between ranks", result["/parts/0/engine_why"])[1]
    expected = f"{2 * 3 * (degree + 1) ** 2 * 8 / 1e3:.1f}"
    checks.expect(told == expected, f"degree {degree}: {told} kB in a product, {expected} by hand")


def memory(clevis, folder):
    """Largest memory of the first rank and of the other one [MB]."""
    script = Path(folder) / "measured"
    script.write_text('#!/bin/sh\nexec /usr/bin/env python3 -c "\n'
                      "import os, resource, subprocess, sys\n"
                      "code = subprocess.run(sys.argv[1:], stdout=subprocess.DEVNULL).returncode\n"
                      "used = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss\n"
                      "rank = os.environ['OMPI_COMM_WORLD_RANK']\n"
                      f"open('{folder}/rank' + rank, 'w').write(str(used))\n"
                      'sys.exit(code)" "$@"\n')
    script.chmod(0o755)
    run(2, script, clevis, "check", SCENE, "--part", "FE2", "--model", "3d", "--set",
        "part.FE2.refine=2", "--engine", "dealii", "--tolerance", "20%", "--out", f"{folder}/out")
    return [int((Path(folder) / f"rank{rank}").read_text()) / 1e3 for rank in (0, 1)]


def shown(clevis, folder):
    """What a user sees on a terminal of the first rank."""
    script = Path(folder) / "terminal"
    script.write_text('#!/bin/sh\nexec /usr/bin/env python3 -c "\n'
                      "import os, pty, sys\n"
                      "sys.exit(os.waitstatus_to_exitcode(pty.spawn(sys.argv[1:])))\n"
                      '" "$@"\n')
    script.chmod(0o755)
    return run(2, script, clevis, "check", SHARED, "--model", "plane-stress", "--engine",
               "dealii", "--out", f"{folder}/shown").stdout


def killed(clevis, folder, rank):
    """Seconds from the end of a rank by force to that of mpirun, its code."""
    process = subprocess.Popen(
        command(2, clevis, "check", SCENE, "--model", "3d", "--engine", "dealii",
                "--tolerance", "0.05%", "--out", folder),
        stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, env=ENVIRONMENT)
    ranks = []
    while len(ranks) < 2 and process.poll() is None:
        children = Path(f"/proc/{process.pid}/task/{process.pid}/children").read_text()
        ranks = [pid for pid in children.split()
                 if "clevis" in Path(f"/proc/{pid}/cmdline").read_text().split("\0")[0]]
        time.sleep(0.05)
    time.sleep(2.0)  # on their way
    os.kill(int(ranks[rank]), signal.SIGKILL)
    start = time.monotonic()
    process.communicate(timeout=60)
    return time.monotonic() - start, process.returncode


def main():
    clevis, root = Path(sys.argv[1]).resolve(), sys.argv[2]
    os.chdir(root)
    make_meshes(clevis, SCENE)
    checks = Checks()
    shared = (SHARED, "--model", "plane-stress", "--engine", "dealii")
    with tempfile.TemporaryDirectory() as folder:
        place = lambda name: Path(folder) / name
        once = shares(clevis, checks, place, "plate", shared, (2, 4))
        again, _ = checked(clevis, 4, place("bits"), *shared)
        checks.expect(again == once, "4 ranks give the same bits again")
        shares(clevis, checks, place, "solid",
               (SCENE, "--part", "FE2", "--model", "3d", "--engine", "dealii",
                "--tolerance", "20%"), (3,))
        two = shares(clevis, checks, place, "two cells",
                     (few_cells(Path(folder)), "--model", "3d", "--engine", "dealii"), (4,))
        one_face_sent(checks, two)
        first, other = memory(clevis, place("").resolve())
        checks.expect(other < 0.75 * first,
                      f"the other rank has {other:.0f} MB, the first {first:.0f} MB")
        dealt_parts = ("--engine", "own", "--part", "AB", "--part", "DCE", "--part", "FE1")
        own, files = checked(clevis, 1, place("own"), SCENE, *dealt_parts)
        dealt, its_files = checked(clevis, 2, place("dealt"), SCENE, *dealt_parts)
        checks.expect(dealt == own, "3 parts dealt out to 2 ranks: the serial bits")
        checks.expect(its_files == files, "and the serial files")
        once, twice = (run(n, clevis, "simulate", SCENE, "--out", place(f"simulate{n}"))
                       for n in (1, 2))
        checks.expect(twice.stdout == once.stdout.replace("simulate1", "simulate2"),
                      "simulate does its work once")
        refused = run(2, clevis, "check", "geometry/none.toml")
        checks.expect(refused.returncode == 22 and refused.stderr.count("none.toml") == 1,
                      f"a missing scene is refused once: {refused.returncode}")
        modes = run(2, clevis, "modes", SCENE, "--part", "FE2", "--set", "part.FE2.refine=3",
                    "--out", place("modes"))
        checks.expect(modes.returncode == 12 and modes.stderr.count("error[F005]: part FE2") == 1,
                      f"frequencies of a part that ranks share are refused: {modes.returncode}")
        progress = re.findall(r"\[ *\] 0/1 +\d+\.\d s +\w+: degree \d",
                              shown(clevis, place("").resolve()))
        checks.expect(bool(progress), f"the first rank shows its progress: {progress[:1]}")
        for rank in (0, 1):
            seconds, code = killed(clevis, place(f"killed{rank}"), rank)
            checks.expect(seconds < MOST_SECONDS and code == 128 + signal.SIGKILL,
                          f"rank {rank} killed ends all in {seconds:.1f} s, exit {code}")
            left = [f.name for f in place(f"killed{rank}").iterdir()]
            checks.expect(left == [".lock"], f"and leaves no result: {left}")
    return checks.exit_code()


if __name__ == "__main__":
    sys.exit(main())

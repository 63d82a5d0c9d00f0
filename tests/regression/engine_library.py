#!/usr/bin/env python3
"""A check loads deal.II, PETSc and MPI where its engine is asked for, and
nothing of them elsewhere: they take 0.3 s and some 200 libraries.
Arguments: clevis scene."""
import os
import subprocess
import sys
import tempfile
from pathlib import Path

THEIRS = ("libdeal.ii", "libpetsc", "libmpi")


def loaded(clevis, scene, engine):
    """Names of THEIRS among the libraries that the check and its workers load."""
    with tempfile.TemporaryDirectory() as folder:
        log = Path(folder) / "libraries"
        run = subprocess.run(
            [clevis, "check", scene, "--engine", engine, "--model",
             "plane-stress", "--out", str(Path(folder) / "out")],
            env={**os.environ, "LD_DEBUG": "files", "LD_DEBUG_OUTPUT": str(log)},
            capture_output=True, text=True, check=False)
        text = "".join(file.read_text(errors="replace")
                       for file in Path(folder).glob("libraries.*"))
    if run.returncode > 1 and run.returncode != 4:
        sys.exit(f"exit code {run.returncode}: {run.stderr}")
    return {name for name in THEIRS if f"/{name}" in text}


def main():
    clevis, scene = sys.argv[1:3]
    failures = 0
    for engine, expected in (("auto", set()), ("own", set()),
                             ("dealii", set(THEIRS))):
        found = loaded(clevis, scene, engine)
        good = found == expected
        failures += not good
        print(f'{"ok  " if good else "FAIL"} --engine {engine}: loads '
              f'{sorted(found) or "none of them"}')
    return failures


if __name__ == "__main__":
    sys.exit(main())

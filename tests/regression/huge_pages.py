#!/usr/bin/env python3
"""A check asks for huge pages where the system gives them on request alone: it
starts itself anew, once, and its result does not depend on that.

    huge_pages.py CLEVIS GEOMETRY
"""
import argparse
import json
import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import support

CHECKS = support.Checks()
SETTING = Path("/sys/kernel/mm/transparent_hugepage/enabled")
TUNABLES = "GLIBC_TUNABLES"


def environment_of(pid):
    """Nothing of a process that has ended."""
    try:
        entries = Path(f"/proc/{pid}/environ").read_bytes().split(b"\0")
    except OSError:
        return {}
    return dict(e.decode().split("=", 1) for e in entries if b"=" in e)


def run(clevis, scene, command, out, tunables=None):
    """(the tunables it ran with, exit code)"""
    environment = {k: v for k, v in os.environ.items() if k != TUNABLES}
    if tunables is not None:
        environment[TUNABLES] = tunables
    process = subprocess.Popen(
        [clevis, command, scene, "--out", out], env=environment,
        stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    seen = None
    while process.poll() is None:  # it starts anew when it comes to that
        seen = environment_of(process.pid).get(TUNABLES, seen)
        time.sleep(0.01)
    return seen, process.wait()


def result(folder):
    part = json.loads((folder / "result.json").read_text())["parts"][0]
    return json.dumps({k: v for k, v in part.items() if k != "seconds"})


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("clevis")
    parser.add_argument("geometry")
    arguments = parser.parse_args()
    scene = Path(arguments.geometry) / "reference_link/scene.toml"
    is_on_request = SETTING.exists() and "[madvise]" in SETTING.read_text()
    with tempfile.TemporaryDirectory() as name:
        folders = [Path(name) / f"{k}" for k in range(3)]
        seen, code = run(arguments.clevis, scene, "check", folders[0])
        wanted = "glibc.malloc.hugetlb=1" if is_on_request else None
        CHECKS.expect(seen == wanted and code == 0,
                      f"check runs with {seen}, exit code {code}")
        own = "glibc.malloc.hugetlb=0"
        seen, code = run(arguments.clevis, scene, "check", folders[1], own)
        CHECKS.expect(seen == own and code == 0,
                      f"what the user set stays: {seen}, exit code {code}")
        own = "glibc.malloc.tcache_count=4"
        seen, code = run(arguments.clevis, scene, "check", folders[2], own)
        CHECKS.expect(seen.startswith(own) and code == 0,
                      f"other tunables stay: {seen}, exit code {code}")
        results = {result(folder) for folder in folders}
        CHECKS.expect(len(results) == 1, "the results are the same")
    return CHECKS.exit_code()


if __name__ == "__main__":
    sys.exit(main())

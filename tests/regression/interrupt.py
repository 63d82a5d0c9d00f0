#!/usr/bin/env python3
"""Ctrl-C during `clevis check`: whole files, exit 130, nothing keeps running.

    interrupt.py CLEVIS SCENE FOLDER

FOLDER holds the result of an undisturbed check, which says how long it takes.
Interrupted before the parts are on their way, the process may end by the
signal itself and leaves nothing.
"""
import json
import os
import signal
import subprocess
import sys
import tempfile
import time
import xml.etree.ElementTree as ElementTree
from pathlib import Path

AT = (0.1, 0.3, 0.5, 0.7, 0.9)  # shares of the undisturbed time
SECONDS_TO_STOP = 5


def file_faults(folder, complete_allowed):
    for file in sorted(folder.rglob("*")):
        if file.name.endswith(".tmp"):
            yield f"{file.name} is left over"
        elif file.suffix in (".vtu", ".pvd", ".xml"):
            try:
                ElementTree.parse(file)
            except ElementTree.ParseError as error:
                yield f"{file.name}: {error}"
    result = folder / "result.json"
    if result.exists():
        document = json.loads(result.read_text())
        if document["complete"] and not complete_allowed:
            yield "result.json says complete"


def group_lives(group):
    try:
        os.killpg(group, 0)
    except ProcessLookupError:
        return False
    return True


def interrupted(clevis, scene, folder, delay):
    """(exit code, faults) of a check that gets SIGINT after `delay` s."""
    process = subprocess.Popen(
        [clevis, "check", scene, "--out", folder, "--json"], text=True,
        stdout=subprocess.PIPE, stderr=subprocess.PIPE,
        start_new_session=True)
    time.sleep(delay)
    os.killpg(process.pid, signal.SIGINT)
    try:
        process.communicate(timeout=SECONDS_TO_STOP)
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, signal.SIGKILL)
        process.communicate()
        return None, [f"still runs {SECONDS_TO_STOP} s after the signal"]
    faults = list(file_faults(folder, process.returncode in (0, 1, 4)))
    if group_lives(process.pid):
        os.killpg(process.pid, signal.SIGKILL)
        faults.append("a worker still runs")
    if process.returncode not in (130, -signal.SIGINT, 0, 1, 4):
        faults.append(f"exit {process.returncode}")
    if process.returncode == 130 and not (folder / "result.json").exists():
        faults.append("no result.json for what was done")
    return process.returncode, faults


def main():
    clevis, scene = sys.argv[1:3]
    undisturbed = json.loads((Path(sys.argv[3]) / "result.json").read_text())
    total = undisturbed["seconds"]["total"]
    bad, codes = 0, []
    for share in AT:
        with tempfile.TemporaryDirectory() as folder:
            code, faults = interrupted(clevis, scene, Path(folder),
                                       share * total)
        codes.append(code)
        print(f"after {share * total:.2f} s: exit {code}", *faults, sep="\n  ")
        bad += len(faults)
    if 130 not in codes:
        print("no check was caught on its way")
        bad += 1
    return bad > 0


if __name__ == "__main__":
    sys.exit(main())

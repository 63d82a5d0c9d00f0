#!/usr/bin/env python3
"""Fifty checks and meshes that are killed or interrupted somewhere: no torn
file, no process and no temporary folder stay, and the next check in the same
folder gives the files of an undisturbed one.

    kills.py CLEVIS SOURCE_DIR
"""
import json
import os
import random
import signal
import subprocess
import sys
import tempfile
import time
import xml.etree.ElementTree as ElementTree
from pathlib import Path

COUNT = 50
SIGNALS = (signal.SIGKILL, signal.SIGKILL, signal.SIGINT, signal.SIGTERM,
           signal.SIGHUP)
SECONDS_TO_STOP = 20
SECONDS_TO_LOAD = 0.1  # before main, the system ends a process by the signal


def torn(folder):
    for file in sorted(folder.rglob("*")):
        try:
            if file.suffix in (".vtu", ".pvd", ".xml"):
                ElementTree.parse(file)
            elif file.suffix == ".json":
                json.loads(file.read_text())
        except (ElementTree.ParseError, ValueError) as error:
            yield f"{file.relative_to(folder)}: {error}"


def contents(folder):
    """Bytes by name, but those that hold seconds by what else they hold."""
    found = {}
    for file in sorted(folder.rglob("*")):
        if not file.is_file() or file.name == ".lock":
            continue
        if file.name == "result.json":
            document = json.loads(file.read_text())
            document.pop("seconds")
            for part in document["parts"]:
                part.pop("seconds")
            found[file.name] = json.dumps(document)
        elif file.name in ("parts.csv", "junit.xml"):
            found[file.name] = ""  # seconds too
        else:
            found[str(file.relative_to(folder))] = file.read_bytes()
    return found


def alive(group):
    try:
        os.killpg(group, 0)
    except ProcessLookupError:
        return False
    return True


def killed(command, delay, number, temporary):
    """Faults of a process that gets a signal after a delay."""
    process = subprocess.Popen(
        command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
        start_new_session=True, env=dict(os.environ, TMPDIR=str(temporary)))
    time.sleep(delay)
    ended = process.poll() is not None
    if not ended:
        os.kill(process.pid, number)
    try:
        process.wait(timeout=SECONDS_TO_STOP)
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, signal.SIGKILL)
        process.wait()
        yield "still ran after the signal"
    until = time.monotonic() + SECONDS_TO_STOP
    while alive(process.pid) and time.monotonic() < until:
        time.sleep(0.02)
    if alive(process.pid):
        os.killpg(process.pid, signal.SIGKILL)
        yield "a process of it stays"
    if number == signal.SIGKILL or ended:
        return
    if delay < SECONDS_TO_LOAD and process.returncode == -number:
        return
    if process.returncode not in (130, 0, 1, 4):
        yield f"exit {process.returncode}"
    left = [entry.name for entry in temporary.iterdir()]
    if left:
        yield f"{left} stay"


def coarse_four_bar(clevis, folder):
    """The template with a fifth of the cells, meshed; its scene."""
    subprocess.run([clevis, "init", folder / "rocker", "--template", "four-bar"],
                   check=True, stdout=subprocess.DEVNULL)
    geometry = folder / "rocker/coupler.geo"
    text = geometry.read_text()
    for fine, coarse in (("MeshSize {:} = 5;", "MeshSize {:} = 12;"),
                         ("25} = 13;", "25} = 5;")):
        assert fine in text
        text = text.replace(fine, coarse)
    geometry.write_text(text)
    scene = folder / "rocker/scene.toml"
    subprocess.run([clevis, "mesh", scene], check=True, stdout=subprocess.DEVNULL)
    return scene


def main():
    clevis, source = sys.argv[1], Path(sys.argv[2])
    rng = random.Random(16)
    bad = 0
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        (folder / "tmp").mkdir()
        check = [clevis, "check", str(coarse_four_bar(clevis, folder)), "--out"]
        start = time.monotonic()
        done = subprocess.run(check + [str(folder / "whole")],
                              stdout=subprocess.DEVNULL)
        seconds = time.monotonic() - start
        if done.returncode not in (0, 1, 4):
            print(f"exit {done.returncode} of the undisturbed check")
            return True
        for k in range(COUNT):
            number = SIGNALS[k % len(SIGNALS)]
            delay = rng.uniform(0.0, 1.1) * seconds
            faults = list(killed(check + [str(folder / "out")], delay, number,
                                 folder / "tmp"))
            faults += torn(folder / "out")
            for entry in (folder / "tmp").iterdir():  # of SIGKILL
                subprocess.run(["rm", "-r", str(entry)], check=True)
            if faults:
                print(f"{k}: {number.name} after {delay:.3f} s", *faults,
                      sep="\n  ")
            bad += len(faults)
        subprocess.run(check + [str(folder / "out")],
                       stdout=subprocess.DEVNULL)
        wanted, found = contents(folder / "whole"), contents(folder / "out")
        for file in sorted(wanted.keys() | found.keys()):
            if wanted.get(file) != found.get(file):
                print(f"{file} differs from that of the undisturbed check")
                bad += 1

        # A mesh whose geometry never ends.
        (folder / "scene.toml").write_text(
            (source / "geometry/cook/scene.toml").read_text())
        (folder / "membrane.geo").write_text("For i In {0:1e9}\nx = i;\nEndFor\n")
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            faults = list(killed([clevis, "mesh", str(folder / "scene.toml")],
                                 1.0, number, folder / "tmp"))
            if faults:
                print(f"mesh: {number.name}", *faults, sep="\n  ")
            bad += len(faults)
    print(f"{COUNT} checks of {seconds:.2f} s and 3 meshes killed, "
          f"{bad} faults")
    return bad > 0


if __name__ == "__main__":
    sys.exit(main())

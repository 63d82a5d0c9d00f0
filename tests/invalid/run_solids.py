#!/usr/bin/env python3
"""Hostile and unfit CAD files: each is refused with its code, a place and what
to do, clevis itself never crashes or hangs, and nothing in a file is ever run.
`clevis init --geometry` refuses as `clevis faces` does and leaves nothing behind.

    run_solids.py CLEVIS SOURCE_DIR [COUNT [SEED]]

Beside the cases below, COUNT (12) copies of a STEP file are damaged at random:
each must be described or refused with a documented exit code.
"""
import os
import random
import re
import subprocess
import sys
import tempfile
from pathlib import Path

SECONDS = 60
CLEVIS, SOURCE = (Path(argument).resolve() for argument in sys.argv[1:3])
COUNT = int(sys.argv[3]) if len(sys.argv) > 3 else 12
SEED = int(sys.argv[4]) if len(sys.argv) > 4 else 1
FORK = (SOURCE / "geometry/step/fork.step").read_bytes()
SCRIPT = b'SystemCall "touch ran"; Printf("x") > "ran";\n'

# Made by gmsh: what a CAD system may export by mistake.
SHAPES = {
    "two_solids": "Box(1) = {0, 0, 0, 10, 10, 10}; Box(2) = {20, 0, 0, 10, 10, 10};",
    "open_shell": "Box(1) = {0, 0, 0, 10, 10, 10}; "
                  "Recursive Delete { Volume{1}; } Rectangle(9) = {0, 0, 0, 10, 10};",
    "faces_alone": "Box(1) = {0, 0, 0, 10, 10, 10}; Delete { Volume{1}; } "
                   "Recursive Delete { Surface{6}; }",
    "loose_face": "Box(1) = {0, 0, 0, 10, 10, 10}; Rectangle(9) = {0, 0, 30, 10, 10};",
    "touches_itself": "Box(1) = {0, 0, 0, 10, 10, 10}; Box(2) = {10, 10, 0, 10, 10, 10};"
                      " Box(3) = {0, 0, -5, 20, 20, 5};"
                      " BooleanUnion(4) = { Volume{1}; Delete; }{ Volume{2, 3}; Delete; };",
}


def run(*arguments, cwd):
    return subprocess.run([CLEVIS, *arguments], cwd=cwd, capture_output=True,
                          text=True, errors="replace", timeout=SECONDS)


def faults(done, codes, folder):
    """What is wrong with how a file was refused."""
    if (folder / "ran").exists():
        yield "a script in the file was run"
    head = re.search(r"^error\[(\w+)\]: (.+)", done.stderr, re.M)
    if head is None:
        yield f"no refusal, exit {done.returncode}: {done.stderr[-200:]!r}"
        return
    if head[1] not in codes:
        yield f"{head[1]} instead of {codes}: {head[2]}"
    if done.returncode != (22 if head[1] == "I001" else 11):
        yield f"exit {done.returncode} with {head[1]}"
    if not re.search(r"^  help: .{8,}", done.stderr, re.M):
        yield "no help"


def shapes(folder):
    for name, text in SHAPES.items():
        (folder / "shape.geo").write_text(f'SetFactory("OpenCASCADE");\n{text}\n')
        subprocess.run(["gmsh", "-0", "-format", "step", "-o", name + ".step",
                        "shape.geo"], cwd=folder, check=True, timeout=60,
                       stdout=subprocess.DEVNULL)
        (folder / "shape.geo").unlink()
        yield name + ".step", (folder / (name + ".step")).read_bytes(), {"M016"}


def loops(text):
    """Entities that refer to themselves, and to one another in a circle."""
    own = re.sub(rb"#(\d+) = (\w+)\(''?,#\d+", rb"#\1 = \2('',#\1", text)
    shell = re.search(rb"#(\d+) = CLOSED_SHELL\('',\(([^)]*)\)\)", text)
    circle = text.replace(shell[2], b"#" + shell[1])
    return own, circle


def cases(folder):
    """Name, content and the codes of which one is due."""
    for name in ("script.step", "script.stp", "script.igs", "script.brep"):
        yield name, SCRIPT, {"M015"}
    yield "empty.step", b"", {"M015"}
    yield "head_alone.step", b"ISO-10303-21;\n", {"M010", "M016"}
    yield "script_behind_head.step", b"ISO-10303-21;\n" + SCRIPT, {"M010", "M016"}
    yield "script_in_data.step", FORK.replace(
        b"DATA;", b"DATA;\n" + SCRIPT), {"M010", "M016", ""}
    for part in (10, 50, 90):
        yield f"cut_{part}.step", FORK[:len(FORK) * part // 100], {"M010", "M016"}
    for number, text in enumerate(loops(FORK)):
        yield f"loop_{number}.step", text, {"M010", "M016"}
    number = rb"(CARTESIAN_POINT\('',\()(-?[\d.E+-]+)"
    yield "far.step", re.sub(number, rb"\g<1>1.E9", FORK, count=400), {"M010"}
    yield "nan.step", re.sub(number, rb"\g<1>NAN", FORK), {"M010"}
    metre = b"SI_UNIT(.MILLI.,.METRE.)"
    assert metre in FORK
    yield "kilometre.step", FORK.replace(metre, b"SI_UNIT(.KILO.,.METRE.)"), {"M007"}
    yield "picometre.step", FORK.replace(metre, b"SI_UNIT(.PICO.,.METRE.)"), {
        "M007", "M016"}
    yield "spaces.step", b"ISO-10303-21;\n" + b" " * (200 << 20), {"M010", "M016"}
    yield "large.step", b"ISO-10303-21;\n" + b" " * (257 << 20), {"M015"}
    yield from shapes(folder)


def pipe(folder):
    """One that nobody writes, in place of a geometry: what a command waits for."""
    os.mkfifo(folder / "pipe.step")
    for arguments in (("faces", "pipe.step"), ("init", "made", "--geometry", "pipe.step")):
        try:
            for text in faults(run(*arguments, cwd=folder), {"I001"}, folder):
                yield f"{arguments[0]} of a pipe: {text}"
        except subprocess.TimeoutExpired:
            yield f"{arguments[0]} of a pipe: no end"
    (folder / "pipe.step").unlink()


def thin(folder):
    """A plate of a hundredth of a micrometre: its scene, file and unit are told."""
    (folder / "thin.geo").write_text(
        'SetFactory("OpenCASCADE");\nBox(1) = {0, 0, 0, 60, 20, 0.00001};\n')
    subprocess.run(["gmsh", "-0", "-format", "step", "-o", "thin.step", "thin.geo"],
                   cwd=folder, check=True, timeout=60, stdout=subprocess.DEVNULL)
    run("init", "thin", "--geometry", "thin.step", cwd=folder)
    done = run("check", "thin/scene.toml", "--out", "out", cwd=folder)
    yield from faults(done, {"M007"}, folder)
    if "error[M007]: thin/thin.step: " not in done.stderr:
        yield f"another file is named: {done.stderr}"
    if "length_unit" in done.stderr:
        yield f"a key that a STEP file may not have: {done.stderr}"


def damaged(text, rng):
    for _ in range(rng.randrange(1, 20)):
        i = rng.randrange(len(text))
        text = text[:i] + bytes([rng.randrange(256)]) + text[i + rng.randrange(3):]
    return text


def main():
    bad = 0
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for case, text, codes in cases(folder):
            (folder / case).write_bytes(text)
            done = run("faces", case, cwd=folder)
            passed = done.returncode == 0 and "" in codes
            found = [] if passed else list(faults(done, codes, folder))
            if not passed:
                made = run("init", "made", "--geometry", case, cwd=folder)
                # either may be stopped by the limit of time, whatever it would find
                ended = all("did not finish" not in end.stderr for end in (done, made))
                if ended and (made.returncode, made.stderr) != (done.returncode,
                                                                done.stderr):
                    found.append(f"init --geometry refuses it otherwise: {made.stderr}")
                if (folder / "made").exists():
                    found.append("init --geometry leaves a folder behind")
                found += [f"init: {text}" for text in faults(made, codes, folder)]
            print(f"{'FAILED' if found else 'ok':7}{case:28}exit {done.returncode:2}  "
                  + (done.stderr.splitlines() or [""])[0][:100])
            for text in found:
                print(f"         {text}")
            bad += bool(found)
            (folder / case).unlink()
        for text in (*pipe(folder), *thin(folder)):
            print(f"FAILED {text}")
            bad += 1
        rng = random.Random(SEED)
        for i in range(COUNT):
            (folder / "damaged.step").write_bytes(damaged(FORK, rng))
            done = run("faces", "damaged.step", cwd=folder)
            if done.returncode != 0:
                found = list(faults(done, {"M007", "M010", "M015", "M016"}, folder))
                bad += bool(found)
                for text in found:
                    print(f"FAILED damaged {i} of seed {SEED}: {text}")
    print(f"{bad} refused badly")
    return bad > 0


if __name__ == "__main__":
    sys.exit(main())

#!/usr/bin/env python3
"""Damages valid scenes at random places: clevis must refuse or compute, never
crash or hang.

    run_corrupted.py CLEVIS FOLDER [COUNT [SEED]]

Every scene of FOLDER is damaged COUNT times (60), and a third as often by a seed
that is drawn anew and printed, unless SEED says which: cut off, a byte changed or
removed, a line lost, doubled or moved, a number replaced. Some files that are
no text at all come on top. A run must end within 10 s with a documented exit
code, other than 70 (internal error), and say so on stderr unless it passes.
"""
import random
import re
import subprocess
import sys
import tempfile
import time
from collections import Counter
from pathlib import Path

SECONDS = 20  # of which --max-time allows a motion 3
DOCUMENTED = {0, 1, 2, 3, 4, 10, 11, 12, 20, 21, 22}
NUMBERS = [b"0", b"-1", b"1e999", b"1e-300", b"nan", b"9223372036854775807",
           b"0x10", b"1_0", b"true", b'""', b"[]", b"{}"]


def cut(text, rng):
    return text[:rng.randrange(len(text))]


def change_byte(text, rng):
    i = rng.randrange(len(text))
    return text[:i] + bytes([rng.randrange(256)]) + text[i + 1:]


def remove_byte(text, rng):
    i = rng.randrange(len(text))
    return text[:i] + text[i + 1:]


def shuffle_line(text, rng):
    lines = text.splitlines(keepends=True)
    line = lines.pop(rng.randrange(len(lines)))
    for _ in range(rng.randrange(3)):
        lines.insert(rng.randrange(len(lines) + 1), line)
    return b"".join(lines)


def replace_number(text, rng):
    found = rng.choice(list(re.finditer(rb"-?\d+(\.\d+)?", text)))
    return text[:found.start()] + rng.choice(NUMBERS) + text[found.end():]


def no_texts(rng):
    """Files that nobody would call a scene."""
    yield b""
    yield b"\xef\xbb\xbf"
    yield b"\0" * 4096
    yield b"schema = 1\nname = \"x\"\n".decode().encode("utf-16")
    yield rng.randbytes(1 << 16)
    yield b"#" * (10 << 20)
    yield b"[[body]]\nname = \"B\"\n" * (1 << 19)
    yield b"a." * 100_000 + b"a = 1\n"
    yield b"[" + b"a." * 100_000 + b"a]\n"
    yield b"a = " + b"[" * 100_000
    yield b"x = " + (b"{" + b"a." * 64 + b"a = [\n") * 255
    yield b"\x7fELF" + rng.randbytes(1 << 12)


def run(clevis, file):
    """(exit code or None, whether it said what is wrong)."""
    try:
        done = subprocess.run(
            [clevis, "simulate", file.name, "--out", "out", "--max-time", "3 s"],
            cwd=file.parent, capture_output=True, timeout=SECONDS)
    except subprocess.TimeoutExpired:
        return None, False
    return done.returncode, b"\n  help: " in done.stderr


def main():
    clevis = str(Path(sys.argv[1]).resolve())
    count = int(sys.argv[3]) if len(sys.argv) > 3 else 60
    draws = [(1, count), (int(time.time()), count // 3)]
    if len(sys.argv) > 4:
        draws = [(int(sys.argv[4]), count)]
    damages = [cut, change_byte, remove_byte, shuffle_line, replace_number]
    scenes = sorted(Path(sys.argv[2]).rglob("*.toml"))
    inputs = []
    for seed, times in draws:
        rng = random.Random(seed)
        print(f"seed {seed}")
        inputs += [(damage.__name__, damage(scene.read_bytes(), rng))
                   for scene in scenes for _ in range(times)
                   for damage in [rng.choice(damages)]]
    inputs += [("no_text", text) for text in no_texts(rng)]
    codes, bad = Counter(), 0
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "damaged.toml"
        for kind, text in inputs:
            file.write_bytes(text)
            code, said = run(clevis, file)
            codes[code] += 1
            if code not in DOCUMENTED or (code != 0 and not said):
                bad += 1
                kept = Path(tempfile.gettempdir()) / f"damaged_{bad}.toml"
                kept.write_bytes(text)
                print(f"FAILED: {kind}: exit {code}, input kept as {kept}")
    print(f"{len(inputs)} damaged scenes, exit codes: "
          + ", ".join(f"{code}: {n}" for code, n in sorted(
              codes.items(), key=str)))
    return bad > 0 or not scenes


if __name__ == "__main__":
    sys.exit(main())

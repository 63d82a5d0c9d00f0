"""Every file, command and output of a document, run in its order.

    tutorial.py CLEVIS SOURCE_DIR DOCUMENT [--update]

DOCUMENT is README.md or one of docs and docs/scene. It runs in an empty folder with
`geometry` and `meshes` of the sources.

Blocks of the document: "```toml scene.toml" (or any language and file) writes a
file, "```diff scene.toml" changes one, "```console" holds commands after "$ " and
what they print. A line of "…" stands for any lines. Numbers may differ by 1 %,
the last number of a line (processor time) at will. With --update the outputs
in the document are written anew.
"""
import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

BLOCK = re.compile(r"^```(\w+)(?: (\S+))?\n(.*?)^```$", re.M | re.S)
NUMBER = re.compile(r"[-+]?\d+(?:\.\d+)?(?:e[-+]?\d+)?$")
TOLERANCE = 0.01
ROUND_OFF = 1e-9  # closures and power balances


def is_same(seen, wanted, is_last):
    seen, wanted = seen.strip("[](),"), wanted.strip("[](),")
    if seen == wanted:
        return True
    if not (NUMBER.match(seen) and NUMBER.match(wanted)):
        return False
    a, b = float(seen), float(wanted)
    return is_last or abs(a - b) <= TOLERANCE * max(abs(b), ROUND_OFF) or (
        max(abs(a), abs(b)) < ROUND_OFF)


def lines_agree(seen, wanted):
    a, b = seen.split(), wanted.split()
    if len(a) != len(b):
        return False
    if a and a[-1] in ("s", "s)"):  # "pass 0.34 s"
        a, b = a[:-1], b[:-1]
    return all(is_same(x, y, k == len(a) - 1)
               for k, (x, y) in enumerate(zip(a, b)))


def fault(seen, wanted):
    """The first wanted line that is not there, or an unexpected one."""
    at, skips = 0, False
    for line in wanted:
        if line.strip() == "…":
            skips = True
            continue
        while skips and at < len(seen) and not lines_agree(seen[at], line):
            at += 1
        if at == len(seen) or not lines_agree(seen[at], line):
            got = seen[at] if at < len(seen) else "nothing"
            return f"wanted {line!r}, got {got!r}"
        at, skips = at + 1, False
    if not skips and at < len(seen):
        return f"unexpected: {seen[at]!r}"
    return None


def change(text, diff):
    """Replaces each run of "-" lines by the "+" lines behind it."""
    for old, new in re.findall(r"((?:^-.*\n)+)((?:^\+.*\n)*)", diff, re.M):
        plain = [re.sub(r"^[-+]", "", t, flags=re.M) for t in (old, new)]
        if text.count(plain[0]) != 1:
            sys.exit(f"the diff's line is there {text.count(plain[0])} times: {plain[0]}")
        text = text.replace(*plain)
    return text


def run(command, folder, path):
    """Lines of the output; stderr only counts as far as it refuses."""
    done = subprocess.run(["bash", "-c", command], cwd=folder, text=True,
                          capture_output=True, env=os.environ | {"PATH": path})
    refusal = [line for line in done.stderr.splitlines()
               if line.startswith(("error", "  help"))]
    return done.stdout.splitlines() + refusal


def console(block, folder, path, place, faults):
    """Runs the commands of a block; the block with what they print."""
    text = []
    for command, wanted in re.findall(r"^\$ (.*)\n((?:(?!\$ ).*\n)*)", block, re.M):
        seen = run(command, folder, path)
        wrong = fault(seen, wanted.splitlines())
        if wrong:
            faults.append(f"{place}: $ {command}\n    {wrong}")
        text += [f"$ {command}", *(wanted.splitlines() if "…" in wanted else seen)]
    return "\n".join(text) + "\n"


def main(clevis, source, name, update):
    document = Path(source) / name
    text = document.read_text()
    path = f"{Path(clevis).resolve().parent}:{os.environ['PATH']}"
    faults, result, end = [], "", 0
    with tempfile.TemporaryDirectory() as temporary:
        folder = Path(temporary)
        for given in ("geometry", "meshes"):
            (folder / given).symlink_to(Path(source).resolve() / given)
        for match in BLOCK.finditer(text):
            language, file, block = match.groups()
            place = f"{name}:{text.count(chr(10), 0, match.start()) + 1}"
            if language == "console":
                block = console(block, folder, path, place, faults)
            elif language == "toml" and not file:
                faults.append(f"{place}: no file, so nothing runs it")
            elif file:
                target = folder / file
                target.parent.mkdir(parents=True, exist_ok=True)
                target.write_text(change(target.read_text(), block)
                                  if language == "diff" else block)
            result += text[end:match.start(3)] + block
            end = match.end(3)
    if update:
        document.write_text(result + text[end:])
        return 0
    print("\n".join(faults) or f"every command printed what {name} says")
    return 1 if faults else 0


if __name__ == "__main__":
    words = [word for word in sys.argv[1:] if word != "--update"]
    sys.exit(main(*words, "--update" in sys.argv))

#!/usr/bin/env python3
"""Runs clevis on invalid scenes and checks that each is refused well.

    run_invalid.py CLEVIS FOLDER

Each *.toml in FOLDER says in its first lines what must happen:
    # expect: S004 10 "text that the message must hold" at 12
    # run: check --part DCE
that is code, exit code, text (\\" for a quote), optionally the line of the
place, and optionally the command (default: simulate). Refused well means: the
exit code and the code, a place (file:line:column for scene errors), the text,
a line of help, a message of bounded length, one JSON document on stdout if the command knows --json, no
result file, within 5 s.
"""
import json
import re
import subprocess
import sys
import tempfile
from pathlib import Path

SECONDS = 5
LONGEST = 2500  # characters of a message, whatever the input holds
EXPECT = re.compile(
    r'#\s*expect:\s*([A-Z]\d{3})\s+(\d+)\s+"((?:[^"\\]|\\.)*)"(?:\s+at\s+(\d+))?')
RUN = re.compile(r"#\s*run:\s*(.+)")
WITH_JSON = ("simulate", "check", "transmission", "impact")


def expectation(scene):
    """(code, exit code, text, line or None), command of a case."""
    head = scene.read_text(errors="replace").splitlines()[:5]
    found = next(filter(None, map(EXPECT.match, head)), None)
    if found is None:
        raise SystemExit(f"{scene}: no line '# expect: CODE EXIT \"text\"'")
    command = next(filter(None, map(RUN.match, head)), None)
    return ((found[1], int(found[2]), found[3].replace('\\"', '"'),
             found[4] and int(found[4])),
            command[1].split() if command else ["simulate"])


def faults_of(scene, expected, run, results):
    """What is wrong with the refusal."""
    code, exit_code, text, line = expected
    message = run.stderr.decode(errors="replace")
    if run.returncode != exit_code:
        yield f"exit {run.returncode} instead of {exit_code}"
    head = re.search(r"^error\[(\w+)\]: (.*)$", message, re.MULTILINE)
    if head is None:
        yield f"no line error[CODE]: {message[-300:]!r}"
        return
    if head[1] != code:
        yield f"code {head[1]} instead of {code}: {head[2]}"
    place = re.match(r"(.*\.toml):(\d+):(\d+): .", head[2])
    if code.startswith("S") and (place is None or place[1] != str(scene)):
        yield f"no file:line:column in {head[2]!r}"
    if line and (place is None or int(place[2]) != line):
        yield f"place is not line {line}: {head[2]!r}"
    if text not in message:
        yield f"{text!r} is not in {message!r}"
    if len(message) > LONGEST:
        yield f"a message of {len(message)} characters"
    if not re.search(r"^  help: .{8,}", message, re.MULTILINE):
        yield "no line of help"
    if run.args[1] in WITH_JSON:
        try:
            error = json.loads(run.stdout)["error"]
            if (error["code"], error["exit_code"]) != (code, exit_code):
                yield f"JSON says {error}"
        except (ValueError, KeyError, TypeError) as failure:
            yield f"stdout is not one JSON error: {failure!r}"
    if (results / "result.json").exists():
        yield "a result was written"


def check(clevis, scene):
    expected, command = expectation(scene)
    with tempfile.TemporaryDirectory() as folder:
        results = Path(folder) / "out"
        arguments = [str(clevis), command[0], str(scene), *command[1:]]
        if command[0] in WITH_JSON:
            arguments += ["--json", "--out", str(results)]
        try:
            run = subprocess.run(arguments, capture_output=True, cwd=folder,
                                 timeout=SECONDS)
        except subprocess.TimeoutExpired:
            return expected, [f"still running after {SECONDS} s"]
        return expected, list(faults_of(scene, expected, run, results))


def main():
    clevis, folder = (Path(argument).resolve() for argument in sys.argv[1:3])
    scenes = sorted(folder.glob("*.toml"))
    bad = 0
    for scene in scenes:
        (code, exit_code, _, _), faults = check(clevis, scene)
        bad += bool(faults)
        print(f"{'FAILED' if faults else 'ok':7}{code}  exit {exit_code:2}  "
              f"{scene.stem}")
        for fault in faults:
            print(f"         {fault}")
    print(f"{len(scenes) - bad} of {len(scenes)} invalid inputs refused well")
    return bad > 0 or not scenes


if __name__ == "__main__":
    sys.exit(main())

#!/usr/bin/env python3
"""What every command promises: exit code, one JSON document, a quick start.

    contract.py CLEVIS ROOT [CPU_MILLISECONDS]

With a limit given, `simulate` and `--version` must start and end within that
processor time. Only its own engine loads deal.II.
"""
import json
import os
import resource
import subprocess
import sys
import tempfile
from pathlib import Path

SCENE = "geometry/landing_gear/scene.toml"
TRANSMISSION = "geometry/transmission/example.toml"
EJECTOR = "geometry/ejector/beam_theory.toml"
RUNS = 10

# arguments, exit code
TEXT = [
    (["--version"], 0), (["--help"], 0), (["check", "--help"], 0),
    (["explain"], 0), (["explain", "S004"], 0), (["explain", "Q999"], 2),
    ([], 2), (["chek", SCENE], 2), (["check"], 2), (["check", SCENE, "-x"], 2),
    (["check", SCENE, "--tolerance", "1 mm"], 2),
    (["mesh", "missing.toml"], 22), (["transmission", TRANSMISSION], 0),
    (["impact", EJECTOR], 0),
    (["simulate", "geometry/landing_gear/bearings.toml"], 0),
    (["modes", SCENE, "--modes", "0"], 2),
    (["modes", SCENE, "--part", "nobody"], 2),
]
JSON = [
    (["simulate", SCENE, "--json"], 0),
    (["transmission", TRANSMISSION, "--json"], 0),
    (["impact", EJECTOR, "--json"], 0), (["impact", SCENE, "--json"], 10),
    (["transmission", SCENE, "--json"], 10),
    (["simulate", "missing.toml", "--json"], 22),
    (["simulate", "README.md", "--json"], 10),
    (["check", "missing.toml", "--json"], 22),
    (["check", SCENE, "--part", "nobody", "--json"], 2),
    (["check", "--json"], 2), (["check", SCENE, "--jobs", "0", "--json"], 2),
    (["compare", "missing.json", "missing.json", "--json"], 22),
    (["nonsense", "--json"], 2),
]
WITHOUT_DEALII = [["--version"], ["--help"], ["explain"], ["simulate", SCENE],
                  ["transmission", TRANSMISSION], ["impact", EJECTOR],
                  ["mesh", "missing.toml"],
                  ["compare", "missing.json", "missing.json"],
                  ["check", SCENE, "--part", "nobody"]]
WITH_DEALII = ["check", "geometry/reference_link/scene.toml", "--engine", "dealii",
               "--model", "plane-stress"]


def run(command, folder, root, environment=None):
    out = ["--out", folder] if command[:1] in (["simulate"], ["check"]) else []
    clevis = [os.environ["CLEVIS"], *command, *out]
    return subprocess.run(clevis, cwd=root, capture_output=True, text=True,
                          env={**os.environ, **(environment or {})})


def outcome_faults(folder, root):
    for command, code in TEXT + JSON:
        done = run(command, folder, root)
        name = "clevis " + " ".join(command)
        if done.returncode != code:
            yield f"{name}: exit {done.returncode}, not {code}: {done.stderr}"
        if code and not (done.stderr.startswith("error[")
                         and "\n  help: " in done.stderr):
            yield f"{name}: stderr names no error and help: {done.stderr!r}"
        if "--json" not in command:
            if code and done.stdout:
                yield f"{name}: a failure wrote to stdout: {done.stdout!r}"
            continue
        try:
            document = json.loads(done.stdout)
        except json.JSONDecodeError as error:
            yield f"{name}: stdout is not one JSON document: {error}"
            continue
        if code and document["error"]["exit_code"] != done.returncode:
            yield f"{name}: the document has another exit code: {document}"


def full_disk_faults(root):
    with open("/dev/full", "w") as full:
        done = subprocess.run([os.environ["CLEVIS"], "explain"], stdout=full,
                              stderr=subprocess.PIPE, cwd=root)
    if done.returncode != 22:
        yield f"stdout on a full disk: exit {done.returncode}, not 22"


def loads_dealii(command, folder, root):
    trace = Path(folder) / "trace"
    run(command, folder, root,
        {"LD_DEBUG": "files", "LD_DEBUG_OUTPUT": str(trace)})
    traces = list(Path(folder).glob("trace.*"))
    text = "".join(file.read_text(errors="replace") for file in traces)
    for file in traces:
        file.unlink()
    return "libdeal.ii" in text


def dealii_faults(folder, root):
    for command in WITHOUT_DEALII:
        if loads_dealii(command, folder, root):
            yield f"clevis {' '.join(command)} loads deal.II"
    if not loads_dealii(WITH_DEALII, folder, root):
        yield "--engine dealii loads no deal.II: this test sees nothing"


def processor_milliseconds(command, folder, root):
    """Least of RUNS: what others do on the machine hardly enters."""
    def used():
        usage = resource.getrusage(resource.RUSAGE_CHILDREN)
        return usage.ru_utime + usage.ru_stime
    times = []
    for _ in range(RUNS):
        before = used()
        run(command, folder, root)
        times.append(1e3 * (used() - before))
    return min(times)


def speed_faults(folder, root, limit):
    for command in (["--version"], ["simulate", SCENE]):
        least = processor_milliseconds(command, folder, root)
        print(f"clevis {' '.join(command)}: {least:.0f} ms of processor time")
        if least > limit:
            yield f"clevis {' '.join(command)} takes more than {limit} ms"


def main():
    os.environ["CLEVIS"] = str(Path(sys.argv[1]).resolve())
    root = Path(sys.argv[2])
    with tempfile.TemporaryDirectory() as folder:
        faults = [*outcome_faults(folder, root), *full_disk_faults(root),
                  *dealii_faults(folder, root)]
        if len(sys.argv) > 3:
            faults += speed_faults(folder, root, float(sys.argv[3]))
    print("\n".join(faults) or "all promises hold")
    return len(faults) > 0


if __name__ == "__main__":
    sys.exit(main())

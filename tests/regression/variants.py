#!/usr/bin/env python3
"""Many variants end to end: plan, run by each recipe of docs/cluster.md, collect.

    variants.py CLEVIS ROOT

A link AB pulled along its axis: its peak goes as 1 / thickness, its mass as the
thickness. Then what may go wrong: jobs that are killed, results that are
missing, damaged or of other inputs, two jobs in one folder.
"""
import csv
import fcntl
import io
import json
import os
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import xml.etree.ElementTree as ElementTree
from pathlib import Path

SCENE = """schema = 1
name = "a link that is pulled"

[material.steel_45]
youngs_modulus = "210 GPa"
poissons_ratio = 0.3
density = "7850 kg/m^3"
yield_strength = "355 MPa"

[[part]]
name = "AB"
geometry = "link_ab.geo"
length_unit = "mm"
material = "steel_45"
limits = { safety_factor = 1.5 }

[[part.case]]
name = "pull"
pins = { bore_A = ["-2500 N", "0 N", "0 N"], bore_B = ["2500 N", "0 N", "0 N"] }
"""
SIZE = "part.AB.parameters.thickness"
TABLE = f'''variant,{SIZE} [mm],"part.AB.case[0].name"
thin,2.5,pull
thick,10,"it's pulled, ""hard"""
middle,5,pull
'''
SECONDS = re.compile(r'"(\w*seconds|total|mesh|choose|assemble|factor|solve|'
                     r'recover|write|scene_and_meshes|mechanism|loads|parts)": '
                     r"[\d.e+-]+")


class Study:
    def __init__(self, clevis, root, folder):
        self.clevis, self.folder, self.bad = clevis, folder, 0
        gear = folder / "geometry" / "gear"
        gear.mkdir(parents=True)
        shutil.copy(root / "geometry/landing_gear/link_ab.geo", gear)
        self.scene = gear / "scene.toml"
        self.scene.write_text(SCENE)
        (folder / "variants.csv").write_text(TABLE)
        self.environment = {
            **os.environ, "HOME": str(folder),
            "PATH": f"{Path(clevis).parent}:{os.environ['PATH']}"}

    def expect(self, holds, claim, seen=""):
        self.bad += not holds
        print(f"{'ok' if holds else 'FAILED':7}{claim}"
              + ("" if holds else f": {seen}"))

    def run(self, *arguments, program=None):
        return subprocess.run([program or self.clevis, *map(str, arguments)],
                              cwd=self.folder, text=True, capture_output=True,
                              env=self.environment, timeout=250)

    def shell(self, script):
        return subprocess.run(["sh", "-c", script], cwd=self.folder, text=True,
                              capture_output=True, env=self.environment,
                              timeout=250)

    def plan(self, out="study"):
        run = self.run("plan", "geometry/gear/scene.toml", "--vary",
                       "variants.csv", "--out", out, "--tolerance", "5%",
                       program="clevis")
        self.expect(run.returncode == 0, "plan", run)
        (self.folder / "jobs.txt").write_text(run.stdout)
        return run.stdout.splitlines()

    def collected(self, out="study"):
        run = self.run("collect", out)
        rows = csv.DictReader(
            io.StringIO((self.folder / out / "variants.csv").read_text()))
        return run, {row["variant"]: row for row in rows}


def content(folder):
    """Bytes of the files by name, times that a run took left out."""
    files = {}
    for file in sorted(folder.rglob("*")):
        if not file.is_file() or file.name == ".lock":
            continue
        text = file.read_bytes()
        if file.name == "result.json":
            text = SECONDS.sub("", file.read_text())
        elif file.name == "parts.csv":
            rows = list(csv.DictReader(io.StringIO(file.read_text())))
            text = [{k: v for k, v in row.items() if "seconds" not in k}
                    for row in rows]
        elif file.name == "junit.xml":
            text = re.sub(r'time="[^"]*"', "", file.read_text())
        files[str(file.relative_to(folder))] = text
    return files


def check_plan(study):
    lines = study.plan()
    study.expect(len(lines) == 3, "a command per variant", lines)
    study.expect(study.plan() == lines, "the same plan twice")
    study.expect(all(line.startswith("clevis check ") for line in lines),
                 "commands start the program that planned", lines)
    stale = study.run("check", "geometry/gear/scene.toml", "--set",
                      SIZE + "=3 mm", "--out", "x")
    study.expect(stale.returncode == 11 and "M011" in stale.stderr,
                 "a mesh that is not made is refused", stale)


def check_results(study):
    run, rows = study.collected()
    peak = {name: float(row["peak_MPa"]) for name, row in rows.items()}
    mass = {name: float(row["mass_kg"]) for name, row in rows.items()}
    # Peaks are known to the tolerance of 5 %.
    study.expect(abs(peak["thin"] / peak["thick"] - 4) < 0.2
                 and abs(peak["middle"] / peak["thick"] - 2) < 0.1,
                 "the peak goes as 1 / thickness", peak)
    study.expect(abs(mass["thin"] / mass["thick"] - 0.25) < 1e-6,
                 "the mass goes as the thickness", mass)
    verdicts = {name: row["verdict"] for name, row in rows.items()}
    study.expect(verdicts == {"thin": "fail", "middle": "pass",
                              "thick": "pass"}, "verdicts", verdicts)
    study.expect(run.returncode == 1, "exit code of a failure", run)
    study.expect("lightest that passes: middle" in run.stdout,
                 "the lightest that passes", run.stdout)
    study.expect(float(rows["thin"]["peak_low_MPa"]) <= peak["thin"]
                 <= float(rows["thin"]["peak_high_MPa"]), "bands")
    script = (study.folder / "study/variants.gp").read_text()
    dots = re.findall(r"^[\d.]+ [\d.]+ [\d.]+ [\d.]+ ", script, re.M)
    study.expect(len(dots) == 6, "a dot per variant and value", len(dots))
    if shutil.which("gnuplot"):
        figure = ElementTree.parse(study.folder / "study/variants.svg").getroot()
        texts = [text.strip() for text in figure.itertext()]
        study.expect("AB" in texts and "peak, MPa" in texts, "is drawn", texts)
    meshes = {file.name for file in
              (study.folder / "meshes/gear").glob("link_ab-*.msh")}
    study.expect(len(meshes) == 3, "a mesh for each", meshes)


def check_resume(study, lines):
    thin = study.folder / "study/thin/result.json"
    before = thin.stat().st_mtime_ns
    again = study.shell(lines[0])
    study.expect(again.returncode == 1 and "finished before: fail"
                 in again.stdout and thin.stat().st_mtime_ns == before,
                 "a finished variant is skipped", again)
    document = study.shell(lines[0] + " --json")
    study.expect(json.loads(document.stdout)["verdict"] == "fail",
                 "skipped, as JSON", document)
    study.scene.write_text("# a remark\n" + SCENE)
    study.expect("finished before" in study.shell(lines[0]).stdout,
                 "a remark in the scene changes nothing")
    study.scene.write_text(SCENE.replace("355 MPa", "800 MPa"))
    stale, rows = study.collected()
    study.expect(rows["thin"]["missing"] == "", "collect goes by the plan",
                 rows["thin"])
    study.plan()
    stale, rows = study.collected()
    study.expect(stale.returncode == 4 and
                 "of other inputs" in rows["thin"]["missing"],
                 "results of another scene are not taken", stale)
    fresh = study.shell(lines[0])
    study.expect(fresh.returncode == 0 and "finished" not in fresh.stdout,
                 "other inputs are checked anew", fresh)
    study.scene.write_text(SCENE)
    study.plan()
    study.shell(lines[0])


def check_missing(study, lines):
    results = {name: study.folder / "study" / name / "result.json"
               for name in ("thin", "middle", "thick")}
    kept = {name: file.read_text() for name, file in results.items()}
    results["thin"].unlink()
    results["middle"].write_text(kept["middle"][:1000])
    results["thick"].write_text(kept["thick"].replace(
        '"complete": true', '"complete": false'))
    run, rows = study.collected()
    study.expect(run.returncode == 22, "exit code of a damaged result", run)
    study.expect("no result" in rows["thin"]["missing"]
                 and rows["middle"]["missing"].startswith("I003")
                 and "interrupted" in rows["thick"]["missing"],
                 "missing, damaged and interrupted variants are told", rows)
    study.expect("no variant passes" in run.stdout, "none of them passes")
    for line in lines:
        study.shell(line)
    study.expect(study.collected()[0].returncode == 1, "and made again")
    refused = study.shell(lines[0].replace(
        SIZE + "=2.5 mm", "part.AB.material=steel_46"))
    run, rows = study.collected()
    study.expect(run.returncode == 1 and not rows["thin"]["missing"],
                 "a refusal of other inputs hides no result", run)
    results["thin"].unlink()
    run, rows = study.collected()
    study.expect(refused.returncode == run.returncode == 10
                 and rows["thin"]["missing"].startswith("S007 --set 1"),
                 "a refusal is told with its code", (refused, run))
    study.shell(lines[0])


def processes_of(word):
    """Processes whose command line holds the word."""
    found = []
    for entry in Path("/proc").iterdir():
        if entry.name.isdigit():
            try:
                if word.encode() in (entry / "cmdline").read_bytes():
                    found.append(int(entry.name))
            except OSError:
                pass
    return found


def check_kills(study, lines):
    reference = content(study.folder / "study/thin")
    start = time.monotonic()
    shutil.rmtree(study.folder / "study/thin")
    study.shell(lines[0])
    took = time.monotonic() - start
    study.expect(content(study.folder / "study/thin") == reference,
                 "the same files again")
    for share in (0.2, 0.4, 0.6, 0.8):
        shutil.rmtree(study.folder / "study/thin")
        job = subprocess.Popen(["sh", "-c", "exec " + lines[0]],
                               cwd=study.folder, env=study.environment,
                               stdout=subprocess.DEVNULL,
                               stderr=subprocess.DEVNULL)
        time.sleep(share * took)
        os.kill(job.pid, signal.SIGKILL)
        job.wait()
        deadline = time.monotonic() + 2
        while processes_of("study/thin") and time.monotonic() < deadline:
            time.sleep(0.02)
        study.expect(not processes_of("study/thin"),
                     f"killed after {share:.0%}: nobody works on")
        resumed = study.shell(lines[0])
        same = content(study.folder / "study/thin")
        study.expect(resumed.returncode == 1 and same == reference,
                     f"killed after {share:.0%}: the same files",
                     (resumed, same.keys() ^ reference.keys(),
                      [k for k in same if same[k] != reference.get(k)]))


def check_lock(study, lines):
    with open(study.folder / "study/thin/.lock", "w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        start = time.monotonic()
        second = study.shell(lines[0].replace("--resume ", ""))
        study.expect(second.returncode == 22 and "I006" in second.stderr
                     and not (study.folder / "study/thin/error.json").exists(),
                     f"a second run is refused ({time.monotonic() - start:.1f} "
                     "s)", second)
    result = study.folder / "study/thin/result.json"
    result.unlink()
    os.mkfifo(result)
    fifo = study.run("compare", result, result)
    study.expect(fifo.returncode == 22 and "I001" in fifo.stderr,
                 "compare does not wait for a FIFO", fifo)
    fifo = study.shell(lines[0])
    study.expect(fifo.returncode == 1 and result.is_file(),
                 "nor does a check whose result it stands for", fifo)
    third = study.shell(lines[0].replace("--resume ", ""))
    study.expect(third.returncode == 1, "and taken when the first is gone",
                 third)
    typing_error = study.shell(
        lines[0].replace("--resume ", "").replace(SIZE, SIZE + "x"))
    study.expect(typing_error.returncode == 10 and
                 (study.folder / "study/thin/result.json").exists(),
                 "a typing error costs no result", typing_error)


def recipe(root, heading, language):
    """The code block of docs/cluster.md below a word in bold."""
    text = (root / "docs/cluster.md").read_text()
    return re.search(rf"\*\*{heading}\*\*.*?```{language}\n(.*?)```", text,
                     re.S)[1]


def check_recipes(study, root):
    study.collected()
    reference = content(study.folder / "study")
    ways = [("A loop", None, recipe(root, "A loop", "sh"))]
    ways.append(("GNU parallel", "parallel",
                 recipe(root, "GNU parallel", "sh")))
    (study.folder / "job.sh").write_text(recipe(root, "SLURM", "sh"))
    ways.append(("SLURM's script", None,
                 "for i in 1 2 3; do SLURM_ARRAY_TASK_ID=$i sh job.sh; done"))
    (study.folder / "Snakefile").write_text(recipe(root, "Snakemake",
                                                   "python"))
    ways.append(("Snakemake", "snakemake", "snakemake --cores 2"))
    for name, program, script in ways:
        if program and not shutil.which(program):
            print(f"left out: {name} is not installed")
            continue
        shutil.rmtree(study.folder / "study")
        study.plan()
        run = study.shell(script)
        study.collected()
        found = content(study.folder / "study")
        study.expect(found == reference, f"{name}: the same files",
                     (run, found.keys() ^ reference.keys()))


def main():
    clevis, root = str(Path(sys.argv[1]).resolve()), Path(sys.argv[2])
    with tempfile.TemporaryDirectory() as folder:
        study = Study(clevis, root, Path(folder))
        check_plan(study)
        lines = (study.folder / "jobs.txt").read_text().splitlines()
        for line in lines:
            run = study.shell(line)
            study.expect(run.returncode in (0, 1), "a job", run)
        check_results(study)
        check_resume(study, lines)
        check_missing(study, lines)
        check_kills(study, lines)
        check_lock(study, lines)
        check_recipes(study, root)
    return study.bad > 0


if __name__ == "__main__":
    sys.exit(main())

#!/usr/bin/env python3
"""The page of `clevis report` in a real Chromium.

    report_page.py CLEVIS SOURCE bundle          viewer/dist is what viewer/src makes
    report_page.py CLEVIS SOURCE page FOLDER     the report and glTF of a check
    report_page.py CLEVIS SOURCE simulate        mechanisms: one of each folder of geometry
    report_page.py CLEVIS SOURCE motions         mechanisms: all others, what differs from one to another
    report_page.py CLEVIS SOURCE alone NAME=FOLDER...
                                                 parts without a mechanism: all, of those named the results
                                                 that other tests left in FOLDER
    report_page.py CLEVIS SOURCE blow            a part under a blow
    report_page.py CLEVIS SOURCE opening         a part whose worst instant is not the first
    report_page.py CLEVIS SOURCE failed          a part that could not be computed
    report_page.py CLEVIS SOURCE hostile         texts of a scene that would be code

Returns 77 (skipped) without Node.js, the packages of viewer/package-lock.json
or, of pages, Chromium.
"""
import json
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

SKIPPED = 77
# Of each folder of geometry with a mechanism one scene.
SIMULATED = ["antenna/scene", "bennett/scene", "braiding/scene", "catapult/scene",
             "ejector/scene", "five_bar/scene", "gas_cylinder/scene", "landing_gear/pneumatic",
             "step/four_bar", "tribometer/crank", "two_window_four_bar/scene", "wall/scene",
             "wheel/drop"]
# Of these a page with drives and one with contacts are looked at in full.
IN_FULL = ["antenna/scene", "wheel/drop"]


# A check of which only the pictures count.
QUICK = ["--tolerance", "50 %", "--mesh-rounds", "0", "--max-dofs", "60000"]


def node_is_there(viewer):
    """Ends this script where those of viewer/ cannot run."""
    if not shutil.which("node"):
        print("skipped: no node; Debian's package nodejs brings it")
        sys.exit(SKIPPED)
    if not (viewer / "node_modules/esbuild").is_dir():
        print("skipped: npm ci --ignore-scripts in viewer/ installs what is "
              "missing")
        sys.exit(SKIPPED)


def node(source, script, *arguments):
    """What a script of viewer/ says."""
    viewer = Path(source) / "viewer"
    node_is_there(viewer)
    run = subprocess.run(["node", viewer / script, *arguments],
                         capture_output=True, text=True)
    print(run.stdout + run.stderr, end="")
    if run.returncode == SKIPPED:
        sys.exit(SKIPPED)
    return run.returncode


def run_clevis(clevis, *arguments):
    run = subprocess.run([clevis, *arguments], capture_output=True, text=True)
    if run.returncode != 0:
        sys.exit(f"clevis {arguments[0]}: exit {run.returncode}\n{run.stderr}")
    return run.stdout.strip()


def page(clevis, source, folder):
    with tempfile.TemporaryDirectory() as name:
        files = [Path(name) / f"{which}.html" for which in "ab"]
        for file in files:
            run_clevis(clevis, "report", folder, "--out", file)
        if files[0].read_bytes() != files[1].read_bytes():
            print("two reports of one result differ")
            return 1
        code = node(source, "test/report.mjs", files[0], folder)
        glb = run_clevis(clevis, "export", folder, "--glb", "--out", name)
        parts = json.loads((Path(folder) / "result.json").read_text())["parts"]
        return code or node(source, "test/glb.mjs", glb, str(len(parts)))


def scenes(source, table):
    """All sample scenes that have such a table: "antenna/scene" …"""
    return sorted(f"{file.parent.name}/{file.stem}"
                  for file in Path(source, "geometry").glob("*/*.toml")
                  if f"\n[[{table}]]" in file.read_text())


def try_motions(clevis, source, wanted, *options):
    with tempfile.TemporaryDirectory() as name:
        pages = []
        for scene in wanted:
            folder = Path(name) / scene.replace("/", "_")
            run_clevis(clevis, "simulate", "--report", "--out", folder,
                       f"{source}/geometry/{scene}.toml")
            pages += [folder / "report.html", folder]
        return node(source, "test/report.mjs", *options, *pages)


def simulate(clevis, source):
    missing = ({Path(scene).parent.name for scene in scenes(source, "body")}
               - {Path(scene).parent.name for scene in SIMULATED})
    if missing:
        print(f"no scene of {missing} is tried")
        return 1
    others = [scene for scene in SIMULATED if scene not in IN_FULL]
    return (try_motions(clevis, source, IN_FULL)
            or try_motions(clevis, source, others, "--brief"))


def motions(clevis, source):
    others = [scene for scene in scenes(source, "body") if scene not in SIMULATED]
    return try_motions(clevis, source, others, "--brief")


def alone(clevis, source, *given):
    results = dict(entry.split("=") for entry in given)
    wanted = sorted(set(scenes(source, "part")) - set(scenes(source, "body")))
    unknown = set(results) - set(wanted)
    if unknown:
        print(f"no scenes of parts alone: {unknown}")
        return 1
    with tempfile.TemporaryDirectory() as name:
        pages = []
        for scene in wanted:
            folder = Path(results.get(scene) or Path(name) / scene.replace("/", "_"))
            if scene not in results:
                subprocess.run([clevis, "check", *QUICK, "--out", folder,
                                f"{source}/geometry/{scene}.toml"], capture_output=True)
            page = Path(name) / f"{scene.replace('/', '_')}.html"
            run_clevis(clevis, "report", folder, "--out", page)
            pages += [page, folder]
        return node(source, "test/report.mjs", "--brief", *pages)


def blow(clevis, source):
    with tempfile.TemporaryDirectory() as name:
        # the workpiece fails by it
        subprocess.run([clevis, "check", "--report", "--tolerance", "10%", "--out",
                        name, f"{source}/geometry/ejector/scene.toml"],
                       capture_output=True)
        return node(source, "test/report.mjs", Path(name) / "report.html", name)


def opening(clevis, source):
    with tempfile.TemporaryDirectory() as name:
        made = Path(name) / "crank_rocker"
        run_clevis(clevis, "init", made, "--template", "four-bar")
        run_clevis(clevis, "check", "--mesh", "--report", "--tolerance", "10%", "--out",
                   name, made / "scene.toml")
        [part] = json.loads((Path(name) / "result.json").read_text())["parts"]
        if part["peak_von_mises"]["instant_s"] <= 0:
            print("the worst instant is the first: no test")
            return 1
        return node(source, "test/report.mjs", "--brief", Path(name) / "report.html", name)


def failed(clevis, source):
    with tempfile.TemporaryDirectory() as name:
        made = Path(name) / "crank_rocker"
        run_clevis(clevis, "init", made, "--template", "four-bar")
        subprocess.run([clevis, "check", "--mesh", "--report", "--max-dofs", "100",
                        "--out", name, made / "scene.toml"], capture_output=True)
        result = json.loads((Path(name) / "result.json").read_text())
        if result["parts"] or len(result["failures"]) != 1:
            print("the part is computed: no test")
            return 1
        return node(source, "test/report.mjs", "--brief", Path(name) / "report.html", name)


def hostile(clevis, source):
    code = ("</script><script>document.title='owned'</script>"
            "<img src=x onerror=alert(1)>")
    text = Path(f"{source}/geometry/two_window_four_bar/scene.toml").read_text()
    lines = text.splitlines()
    first = next(i for i, line in enumerate(lines) if line.startswith("name = "))
    lines[first] = f"name = {json.dumps(code)}"
    with tempfile.TemporaryDirectory() as name:
        scene = Path(name) / "scene.toml"
        scene.write_text("\n".join(lines) + f"\n# {code}\n")
        run_clevis(clevis, "simulate", "--report", "--out", name, scene)
        html = (Path(name) / "report.html").read_text()
        if "<img" in html or "<script>document" in html:
            print("text of the scene stands in the page as markup")
            return 1
        return node(source, "test/report.mjs", Path(name) / "report.html", name)


def main():
    clevis, source, what, *rest = sys.argv[1:]
    if what == "bundle":
        return node(source, "build.mjs", "--check")
    return {"page": page, "simulate": simulate, "motions": motions, "alone": alone,
            "blow": blow, "opening": opening, "failed": failed, "hostile": hostile}[what](
        clevis, source, *rest)


if __name__ == "__main__":
    sys.exit(main())

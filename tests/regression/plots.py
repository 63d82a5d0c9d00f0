#!/usr/bin/env python3
"""Plots by gnuplot, a program that is not ours: what a scene calls its things means nothing
to it, and without it, or where it fails, the result stands and the script remains.

    plots.py CLEVIS

77 (skipped) without gnuplot.
"""
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree
from pathlib import Path

from support import Checks

# Ends of strings, commands, substitution, macros, markup of gnuplot and of SVG.
HOSTILE = ("a\"; system(\"touch owned\") # 'x' `touch owned` @x {/Symbol a} ^2_3 \\101 $0 "
           "</text><script>touch</script> !touch owned ü")
OWNED = "owned"


def texts(svg):
    root = ElementTree.parse(svg).getroot()
    return root, [" ".join("".join(node.itertext()).split()) for node in root.iter()
                  if node.tag.endswith("text")]


def main():
    clevis = Path(sys.argv[1]).resolve()
    if shutil.which("gnuplot") is None:
        print("no gnuplot")
        return 77
    checks = Checks()
    with tempfile.TemporaryDirectory() as name:
        home = Path(name)
        (home / ".gnuplot").write_text("set output 'owned'\nsystem('touch owned')\n")
        environment = os.environ | {"HOME": name}

        def run(*command, **more):
            return subprocess.run(list(map(str, command)), cwd=home, text=True,
                                  capture_output=True, env=environment | more)

        run(clevis, "init", "link", "--template", "part")
        quoted = HOSTILE.replace('"', '""')
        (home / "rows.csv").write_text(f'variant,name,part.link.thickness\n'
                                       f'a,"{quoted}",8 mm\nb,plain,10 mm\n')
        scene = home / "link/scene.toml"
        scene.write_text(re.sub('^name = "link"$', lambda _: f"name = {json.dumps(HOSTILE)}",
                                scene.read_text(), count=1, flags=re.M))
        jobs = run(clevis, "plan", scene, "--vary", "rows.csv", "--out", "plan", "--tolerance",
                   "10%")
        done = run("sh", "-c", jobs.stdout)
        checks.expect(done.returncode == 0, f"planned and run: {jobs.stderr}{done.stderr[:300]}")
        svg, script = home / "plan/variants.svg", home / "plan/variants.gp"

        done = run(clevis, "collect", "plan")
        code, table = done.returncode, done.stdout
        checks.expect(svg.exists() and not done.stderr, f"drawn: {done.stderr}")
        root, found = texts(svg)
        whole = " ".join(HOSTILE.split())
        checks.expect(f"{whole}, variants" in found, f"names are texts: {found}")
        checks.expect(not [node for node in root.iter() if node.tag.endswith("script")],
                      "and not markup")
        checks.expect("link" in found and "peak, MPa" in found, "axes are named")

        first = svg.read_bytes()
        run(clevis, "collect", "plan")
        checks.expect(svg.read_bytes() == first, "the same data give the same bytes")
        svg.unlink()
        subprocess.run(["gnuplot", "-d", script.name], cwd=script.parent, check=True)
        checks.expect(svg.read_bytes() == first, "the script draws it by hand too")

        done = run(clevis, "collect", "plan", PATH="/nowhere")
        checks.expect(done.returncode == code and "gnuplot-nox" in done.stderr
                      and "variants.gp" in done.stderr and script.exists() and not svg.exists()
                      and done.stdout.splitlines()[:4] == table.splitlines()[:4],
                      f"without gnuplot: {done.stderr}")
        broken = home / "bin"
        broken.mkdir()
        (broken / "gnuplot").write_text(
            '#!/bin/sh\nprintf "<svg" >variants.svg\necho "no such \033[31mfont" >&2\nexit 3\n')
        (broken / "gnuplot").chmod(0o755)
        done = run(clevis, "collect", "plan", PATH=f"{broken}:{os.environ['PATH']}")
        checks.expect(done.returncode == code and "no such" in done.stderr
                      and "\033" not in done.stderr and not svg.exists(),
                      f"a gnuplot that fails: {done.stderr}")
        checks.expect(not list(home.rglob(OWNED)), "nothing was run")
    return checks.exit_code()


if __name__ == "__main__":
    sys.exit(main())

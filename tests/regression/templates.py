"""The commands that clevis names when called without any lead to a verdict. Each
template of `clevis init` meshes and passes its check as it is; a folder that
holds anything is refused; completion scripts know every command."""
import json
import shlex
import subprocess
import sys
import tempfile
from pathlib import Path

clevis = sys.argv[1]


def run(*arguments, cwd, code=0):
    done = subprocess.run([clevis, *arguments], cwd=cwd, capture_output=True,
                          text=True)
    if done.returncode != code:
        sys.exit(f"{arguments}: exit code {done.returncode}, {code} wanted\n"
                 f"{done.stdout}{done.stderr}")
    return done.stdout + done.stderr


with tempfile.TemporaryDirectory() as name:
    folder = Path(name)
    steps = [shlex.split(line, comments=True)[1:]
             for line in run(cwd=folder, code=2).splitlines()
             if line.startswith("    clevis ")]
    told = [run(*step, cwd=folder) for step in steps]
    assert len(steps) == 3 and "verdict: pass" in told[1], told
    assert "report: results/link/report.html" in told[1], told
    for word, parts in (("part", 1), ("four-bar", 1), ("slider-crank", 1),
                        ("landing-gear", 5)):
        run("init", word, "--template", word, cwd=folder)
        first = (folder / word / "scene.toml").read_text().splitlines()[0]
        assert first == "#:schema ./scene.schema.json", first
        json.loads((folder / word / "scene.schema.json").read_text())
        if word == "slider-crank":  # the mechanism before any mesh
            told = run("simulate", "--mesh", "--report", f"{word}/scene.toml", cwd=folder)
            assert "report: results/slider-crank/report.html" in told, told
        run("mesh", f"{word}/scene.toml", cwd=folder)
        result = json.loads(run("check", "--json", "--tolerance", "5%",
                                f"{word}/scene.toml", cwd=folder).partition("\n}\n")[0]
                            + "\n}")
        assert result["verdict"] == "pass" and len(result["parts"]) == parts
    refusal = run("init", "part", cwd=folder, code=22)
    assert "I005" in refusal, refusal
    assert "U001" in run("init", "x", "--template", "y", cwd=folder, code=2)
    for shell in ("bash", "zsh", "fish"):
        script = run("completion", shell, cwd=folder)
        for word in ("check", "simulate", "init"):
            assert word in script, (shell, word)
    (folder / "c.bash").write_text(run("completion", "bash", cwd=folder))
    done = subprocess.run(
        ["bash", "-c", "source c.bash; COMP_WORDS=(clevis check --mo); "
         "COMP_CWORD=2; _clevis; echo ${COMPREPLY[@]}"], cwd=folder,
        capture_output=True, text=True)
    assert done.stdout.strip() == "--model", done.stdout + done.stderr
    assert "gmsh" in run("doctor", cwd=folder)

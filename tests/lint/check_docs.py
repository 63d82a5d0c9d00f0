#!/usr/bin/env python3
"""Fail if the documents promise what is not there.

    check_docs.py CLEVIS

Every relative link of a *.md leads to a file (and heading) that the package
installs with it, every `./...` command exists, every `clevis COMMAND --option` is one that `clevis --help`
knows, the exit codes in README.md are those of base/messages/exit_code.h, the pages of the scene
file name every key of its schema, have an example of every type of force and a test each, and no tracked
text names a folder of one developer's machine or leaves work open.
"""
import json
import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
TEXTS = {".md", ".cc", ".h", ".py", ".txt", ".toml", ".geo", ".json", ".cmake",
         ""}
# Split, so that this file does not match itself.
UNWANTED = re.compile(r"(?<![\w.$}])/(?:home|root|work|Users)" + r"/\w"
                      r"|\b(?:TO" r"DO|FIX" r"ME|XX" r"X)\b")


def documents():
    return sorted([*ROOT.glob("*.md"), *ROOT.glob("docs/**/*.md"),
                   *ROOT.glob("results/**/*.md")])


def slug(heading):
    """The anchor that a heading gets on a code host."""
    kept = re.sub(r"[^\w\- ]", "", heading.strip().lower())
    return kept.replace(" ", "-")


def anchors(document):
    headings = re.findall(r"^#+ (.*)$", document.read_text(), re.M)
    return {slug(heading) for heading in headings}


def link_faults(document):
    for target in re.findall(r"\]\(([^)\s]+)\)", document.read_text()):
        if re.match(r"\w+:", target):
            continue
        path, _, anchor = target.partition("#")
        file = (document.parent / path).resolve() if path else document
        if not file.exists():
            yield f"link to {target}: no such file"
        elif anchor and file.suffix == ".md" and anchor not in anchors(file):
            yield f"link to {target}: no such heading"


def is_installed(name, rules):
    """By the rules of cmake/Package.cmake: files, and folders with patterns."""
    files, folders = rules
    return name in files or any(
        name.startswith(folder + "/") and Path(name).suffix in endings
        for folder, endings in folders)


def install_rules():
    text = (ROOT / "cmake/Package.cmake").read_text()
    files = set(re.search(r"install\(FILES (.*?) TYPE DOC\)", text)[1].split())
    folders = [(folder, set(re.findall(r'PATTERN "\*(\.\w+)"', rest)))
               for folder, rest in re.findall(
                   r"install\(DIRECTORY (\S+) DESTINATION \${CMAKE_INSTALL_DOCDIR}(.*?)\)\n",
                   text, re.S)]
    return files, folders


def package_faults():
    rules = install_rules()
    for document in documents():
        name = document.relative_to(ROOT).as_posix()
        if not is_installed(name, rules):
            continue
        for target in re.findall(r"\]\(([^):#]+)", document.read_text()):
            file = (document.parent / target).resolve()
            if file.is_dir() or not file.is_relative_to(ROOT):
                continue
            if not is_installed(file.relative_to(ROOT).as_posix(), rules):
                yield f"{name}: link to {target}: the package does not install it"


def code_of(document):
    """Fenced blocks line by line, and inline code."""
    text = document.read_text()
    for block in re.findall(r"^```\w*\n(.*?)^```", text, re.M | re.S):
        yield from block.splitlines()
    yield from re.findall(r"`([^`\n]+)`", text)


def command_faults(document, clevis):
    for line in code_of(document):
        for script in re.findall(r"^\s*(\.?/?\.ci/\w+|tests/\S+\.py)", line):
            if not (ROOT / script).is_file():
                yield f"command {script}: no such file"
        call = re.match(r"\s*clevis ([a-z]+)\b(.*)", line)
        if call is None:
            continue
        run = subprocess.run([clevis, call[1], "--help"], text=True,
                             capture_output=True)
        if run.returncode:
            yield f"command clevis {call[1]}: {run.stderr.strip()}"
            continue
        for option in re.findall(r"--[a-z]+", call[2].split("#")[0]):
            if not re.search(rf"{option}\b", run.stdout):
                yield f"clevis {call[1]} has no option {option}"


def exit_code_faults():
    enum = re.search(r"enum class ExitCode {(.*?)}",
                     (ROOT / "src/base/messages/exit_code.h").read_text(), re.S)
    used = {int(code) for code in re.findall(r"= (\d+)", enum[1])} | {130}
    table = re.search(r"^## Exit codes\n(.*?)(?=^## |\Z)",
                      (ROOT / "README.md").read_text(), re.M | re.S)
    told = {int(code) for code in
            re.findall(r"^\| (\d+) \|", table[1] if table else "", re.M)}
    for code in sorted(used ^ told):
        yield f"exit code {code} is " + (
            "not explained" if code in used else "never returned")


def schema_keys(table):
    """Of a JSON Schema and its definitions, by the name of the table."""
    for name, part in {"": table, **table.get("$defs", {})}.items():
        for key in part.get("properties", {}):
            yield name, key


def scene_faults():
    pages = sorted((ROOT / "docs/scene").glob("*.md"))
    words = {word for page in [ROOT / "docs/scene.md", *pages]
             for word in re.findall(r"\w+", page.read_text())}
    schema = json.loads((ROOT / "docs/scene.schema.json").read_text())
    for table, key in schema_keys(schema):
        if key not in words:
            yield f"docs/scene: no page names the key {key} of {table}"
    forces = (ROOT / "docs/scene/forces.md").read_text()
    examples = "".join(re.findall(r"^```toml \S+\n(.*?)^```", forces, re.M | re.S))
    for name in schema["$defs"]["force"]["properties"]["type"]["enum"]:
        if f'type = "{name}"' not in examples:
            yield f"docs/scene/forces.md: no example of the type {name}"
    tests = (ROOT / "tests/regression/CMakeLists.txt").read_text()
    tested = re.search(r"foreach\(page (.*?)\)", tests, re.S)[1].split()
    for name in sorted({page.stem for page in pages} ^ set(tested)):
        yield f"docs/scene/{name}.md and regression.scene.{name}: one is missing"


def text_faults():
    tracked = subprocess.run(["git", "ls-files", "-z"], cwd=ROOT, text=True,
                             capture_output=True)
    names = (tracked.stdout.split("\0")[:-1] if tracked.returncode == 0 else
             [str(p.relative_to(ROOT)) for d in ("src", "tests", "docs")
              for p in (ROOT / d).rglob("*") if p.is_file()])
    for name in names:
        path = ROOT / name
        if path.suffix not in TEXTS or not path.is_file():
            continue
        lines = path.read_text(errors="replace").splitlines()
        for number, line in enumerate(lines, 1):
            if found := UNWANTED.search(line):
                yield f"{name}:{number}: {found[0]!r} does not belong here"


def main():
    clevis = str(Path(sys.argv[1]).resolve())
    faults = [f"{document.relative_to(ROOT)}: {fault}"
              for document in documents()
              for fault in (*link_faults(document),
                            *command_faults(document, clevis))]
    faults += [f"README.md: {fault}" for fault in exit_code_faults()]
    faults += scene_faults()
    faults += package_faults()
    faults += text_faults()
    print("\n".join(faults) or f"{len(documents())} documents hold")
    return len(faults) > 0


if __name__ == "__main__":
    sys.exit(main())

#!/usr/bin/env python3
"""Fail if a source is cited that docs/bibliography.md lacks, or listed uncited.

    check_bibliography.py

A key is a bracket of four letters and digits or more that begins with a
capital, as [Lottes2023] or [ISO281]: longer than units ([MPa], [N m]), and not
followed by a Markdown link's target. The first cell of a row of a table in the
bibliography defines it. Cited are keys in README.md, docs/**/*.md,
results/studies/*.md and in the comments of the sources.
"""
import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
BIBLIOGRAPHY = ROOT / "docs/bibliography.md"
KEY = re.compile(r"(?<![\w!\[`])\[([A-Z][A-Za-z0-9]{3,})\](?![(\[])")
ROW = re.compile(r"^\| \[([A-Z][A-Za-z0-9]{3,})\] \|", re.M)


def cited(path):
    """Keys of a text by line; of a source those in its comments."""
    for number, line in enumerate(path.read_text().splitlines(), 1):
        if path.suffix in (".h", ".cc"):
            line = "".join(re.findall(r"//.*", line))
        for key in KEY.findall(line):
            yield key, f"{path.relative_to(ROOT)}:{number}"


def main():
    keys = ROW.findall(BIBLIOGRAPHY.read_text())
    faults = [f"{key} stands twice in the bibliography"
              for key in sorted(set(keys)) if keys.count(key) > 1]
    texts = [ROOT / "README.md", *sorted((ROOT / "docs").glob("**/*.md")),
             *sorted((ROOT / "results/studies").glob("*.md")),
             *sorted(p for p in (ROOT / "src").rglob("*")
                     if p.suffix in (".h", ".cc"))]
    used = set()
    for text in texts:
        for key, place in cited(text):
            if key not in keys:
                faults.append(f"{place}: [{key}] is not in the bibliography")
            elif text != BIBLIOGRAPHY:
                used.add(key)
    faults += [f"[{key}] is cited nowhere" for key in keys if key not in used]
    print("\n".join(faults) or f"{len(keys)} sources, all cited")
    return len(faults) > 0 or not keys


if __name__ == "__main__":
    sys.exit(main())

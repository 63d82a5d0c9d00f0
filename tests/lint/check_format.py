#!/usr/bin/env python3
"""Fail if a C++ source is not formatted as .clang-format says.

    check_format.py [--fix]

Version 14, as on Debian 12: other versions break lines differently.
"""
import re
import subprocess
import sys
from pathlib import Path

CLANG_FORMAT = "clang-format-14"


def main():
    root = Path(__file__).resolve().parents[2]
    files = [str(path.relative_to(root)) for folder in ("src", "tests")
             for path in sorted((root / folder).rglob("*"))
             if path.suffix in (".h", ".cc")]
    if "--fix" in sys.argv:
        return subprocess.run([CLANG_FORMAT, "-i", *files], cwd=root).returncode
    run = subprocess.run([CLANG_FORMAT, "--dry-run", "--Werror", *files],
                         cwd=root, stderr=subprocess.PIPE, text=True)
    bad = sorted(set(re.findall(r"^(\S+):\d+:\d+: error", run.stderr, re.M)))
    for file in bad:
        print(f"{file}: not formatted; {CLANG_FORMAT} -i {file}")
    if run.returncode and not bad:
        print(run.stderr)
    print(f"{len(files)} sources, {len(bad)} to format")
    return run.returncode or not files


if __name__ == "__main__":
    sys.exit(main())

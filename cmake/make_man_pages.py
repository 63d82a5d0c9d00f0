#!/usr/bin/env python3
"""Manual pages of clevis and of each command, from what --help prints.

    make_man_pages.py HELP2MAN CLEVIS FOLDER

Writes clevis.1 and clevis-COMMAND.1. No date stands in them: the same program
makes the same bytes.
"""
import os
import re
import subprocess
import sys
from pathlib import Path

TITLE = re.compile(r'^\.TH \S+ "1" "[^"]*"', re.M)


def output(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True,
                          env=os.environ | {"LC_ALL": "C.UTF-8"}).stdout


def commands(clevis):
    """{name: what it does} of `clevis --help`."""
    listed = re.search(r"^Subcommands:\n(.*?)\n\n", output(clevis, "--help"), re.M | re.S)[1]
    return dict(re.findall(r"^  (\w+) +(.*)$", listed, re.M))


def page(help2man, clevis, name, about, also, option):
    text = output(help2man, "--no-info", f"--name={about}", f"--help-option={option}", clevis)
    dashed = name.replace("-", r"\-")
    text = TITLE.sub(rf'.TH {dashed.upper()} "1" ""'.replace("\\", r"\\"), text)
    text = re.sub(r"^clevis \\- ", rf"{dashed} \- ".replace("\\", r"\\"), text, count=1, flags=re.M)
    text = re.sub(r"^\.SH EXAMPLES\n\.IP\n((?:(?!\.).*\n)+)", ".SH EXAMPLES\n.nf\n\\1.fi\n", text,
                  flags=re.M)
    text = re.sub(r"^\.PP\nExit codes: (.*)\n\.IP\n", '.SH "EXIT STATUS"\n\\1\n', text, flags=re.M)
    text = re.sub(r"^\.SH SEE ALSO\n.*?(?=^\.SH|\Z)", "", text, flags=re.M | re.S)
    return text + ".SH \"SEE ALSO\"\n" + ",\n".join(
        rf".BR {other.replace('-', chr(92) + '-')} (1)" for other in also) + "\n"


def main():
    help2man, clevis, folder = sys.argv[1], str(Path(sys.argv[2]).resolve()), Path(sys.argv[3])
    folder.mkdir(parents=True, exist_ok=True)
    known = commands(clevis)
    pages = {"clevis": page(help2man, clevis, "clevis",
                            "checks whether the link parts of a mechanism hold",
                            [f"clevis-{name}" for name in known], "--help")}
    for name, about in known.items():
        pages[f"clevis-{name}"] = page(help2man, clevis, f"clevis-{name}", about, ["clevis"],
                                       f"{name} --help")
    for name, text in pages.items():
        (folder / f"{name}.1").write_text(text)


if __name__ == "__main__":
    main()

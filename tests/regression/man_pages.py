"""The manual pages name every command and option, and groff sets them without a word.

    man_pages.py CLEVIS FOLDER

77 where help2man made no pages.
"""
import re
import shutil
import subprocess
import sys
from pathlib import Path

from support import Checks

clevis, folder = sys.argv[1], Path(sys.argv[2])
if not (folder / "clevis.1").is_file():
    print("no help2man, no pages")
    sys.exit(77)


def help_of(*command):
    return subprocess.run([clevis, *command, "--help"], check=True, capture_output=True,
                          text=True).stdout


def is_set(file):
    if shutil.which("groff") is None:
        return True
    done = subprocess.run(["groff", "-man", "-ww", "-Kutf8", "-Tutf8", file],
                          capture_output=True, text=True)
    return done.returncode == 0 and not done.stderr


checks = Checks()
top = help_of()
commands = re.findall(r"^  (\w+) ", re.search(r"Subcommands:\n(.*?)\n\n", top, re.S)[1], re.M)
pages = {"clevis": top} | {f"clevis-{name}": help_of(name) for name in commands}
checks.expect({p.stem for p in folder.glob("*.1")} == set(pages), f"{len(pages)} pages")
for name, printed in pages.items():
    text = (folder / f"{name}.1").read_text().replace("\\", "")
    options = set(re.findall(r"^  (?:-\w,)?(--[a-z]+)", printed, re.M))
    missing = {option for option in options if option not in text}
    checks.expect(options and not missing, f"{name}: {len(options)} options {missing or ''}")
    checks.expect(f".TH {name.upper()} " in text and f"\n{name} - " in text, f"{name}: title")
    checks.expect(is_set(folder / f"{name}.1"), f"{name}: groff is content")
contents = (folder / "clevis.1").read_text()
checks.expect(all(f"\n.TP\n{name}\n" in contents for name in commands),
              "clevis.1 lists every command")
sys.exit(checks.exit_code())

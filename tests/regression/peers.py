#!/usr/bin/env python3
"""results/studies/peers.md says what its data say, and its script's rows of clevis
still run and are right.

    peers.py CLEVIS SOURCE

77 (skipped) without gnuplot.
"""
import csv
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

from support import Checks

# What a mechanism may be off at a tolerance of 1e-8 [m]; the light cart-pole, the
# worst, is by 2.5e-7.
ALLOWED = 1e-6
LINK_PEAK = 55.0025  # MPa; results/studies/reference_link


def page_of(study, data, folder):
    (folder / "peers.csv").write_text(data)
    subprocess.run([sys.executable, study, "--page", "--out", folder], check=True,
                   capture_output=True)
    return (folder / "peers.md").read_text()


def other_time(data):
    """The data with one more digit before the first time of a process."""
    return re.sub(r"(clevis simulate,auto,1e-08,)", r"\g<1>9", data, count=1)


def main():
    clevis, studies = sys.argv[1], Path(sys.argv[2]) / "results/studies"
    if shutil.which("gnuplot") is None:
        print("no gnuplot")
        return 77
    checks, study = Checks(), studies / "make_peers"
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        data = (studies / "peers.csv").read_text()
        stored = (studies / "peers.md").read_text()
        checks.expect(page_of(study, data, folder) == stored, "the page is that of its data")
        checks.expect(page_of(study, other_time(data), folder) != stored,
                      "another time is another page")
        for picture in re.findall(r"\]\((peers_\w+\.svg)\)", stored):
            checks.expect((studies / picture).is_file() and (folder / picture).is_file(),
                          f"{picture} is there and drawn")
        (folder / "peers.csv").unlink()
        problems = ["reference_link", "andrews", "light_cart_pole", "governor", "bricard",
                    "two_window_four_bar", "crank_rocker", "spatial_slider_crank"]
        done = subprocess.run([sys.executable, study, clevis, "--own", "--out", folder,
                               *problems], capture_output=True, text=True)
        checks.expect(done.returncode == 0, f"clevis' rows run: {done.stderr[-300:]}")
        with open(folder / "peers.csv", newline="") as file:
            rows = {(row["problem"], row["setting"]): row for row in csv.DictReader(file)}
        for problem in problems[1:]:
            error = rows[problem, "1e-08"]["error"]
            checks.expect(error != "" and float(error) < ALLOWED, f"{problem}: {error} m")
        low, high = map(float, rows["reference_link", "1 %"]["band"].split(" to "))
        checks.expect(low < LINK_PEAK < high, f"the band [{low}, {high}] MPa holds the link's peak")
    return checks.exit_code()


if __name__ == "__main__":
    sys.exit(main())

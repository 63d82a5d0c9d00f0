#!/usr/bin/env python3
"""Writes the measured accuracy of the verification tests as one page.

    accuracy_table.py BUILD_FOLDER [PAGE]

Runs the test binaries that print lines "measured, ...", "published, ..." and
orders of convergence, and writes them to PAGE (default
results/studies/accuracy.md).
"""
import re
import subprocess
import sys
from pathlib import Path

ORDERS = re.compile(
    r"(\d)-D, degree (\d), +(\d+) DoF: displacement (\S+) order (\S+), "
    r"stress (\S+) order (\S+), energy (\S+) order (\S+)")


def table(header, rows):
    lines = ["| " + " | ".join(header) + " |", "|" + "---|" * len(header)]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows])


def main():
    build = Path(sys.argv[1]) / "tests/verification/elasticity"
    page = Path(sys.argv[2] if len(sys.argv) > 2 else
                "results/studies/accuracy.md")
    measured, published, orders = [], [], []
    for name in ("error_per_dof", "published", "manufactured"):
        run = subprocess.run([build / f"verification_{name}"],
                             stdout=subprocess.PIPE, text=True, check=True)
        for line in run.stdout.splitlines():
            cells = [cell.strip().replace(";", ",") for cell in line.split(",")]
            if cells[0] == "measured":
                measured.append(cells[1:])
            elif cells[0] == "published":
                problem, value, source, error, tolerance, dofs = cells[1:]
                published.append([problem, value, source,
                                  f"{100 * float(error):+.3f} %",
                                  f"{100 * float(tolerance):.2g} %", dofs])
            elif match := ORDERS.match(line):
                orders.append(list(match.groups()))
    page.write_text(f"""# Accuracy

Written by `python3 tests/verification/accuracy_table.py build/release`; the tests fail beyond the stated bounds.

Peak stress against closed forms, degree 4: within 1e-3 on at most 2e4 degrees of freedom, within 1e-5 on at most 2e5
(`error_per_dof_test.cc`).

{table(["problem", "DoF", "error", "DoF", "error"], measured)}

Published values (`published_test.cc`, with the sources):

{table(["problem", "clevis", "published", "difference", "allowed", "DoF"], published)}

Manufactured solutions with body force on curved cells, orders between two meshes; p + 1, p and 2p are due, ±0.1
(`manufactured_test.cc`):

{table(["dim", "p", "DoF", "displacement", "order", "stress", "order", "energy", "order"], orders)}
""")
    print(page)
    return 0


if __name__ == "__main__":
    sys.exit(main())

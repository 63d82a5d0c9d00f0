#!/usr/bin/env python3
"""Holds a result against its baseline, and the comparison against faults.

    compare_baseline.py CLEVIS FOLDER BASELINE

The result must agree with the baseline; with one peak stress changed by 0.5 %
(each part in turn) `clevis compare` must return 3 and name part and quantity.
"""
import copy
import json
import subprocess
import sys
import tempfile
from pathlib import Path

PLANTED = 1.005


def compare(clevis, result, baseline):
    return subprocess.run([clevis, "compare", result, baseline, "--json"],
                          stdout=subprocess.PIPE, text=True)


def planted_results(result):
    """(name, copy of the result with one peak changed) per part."""
    for number, part in enumerate(result["parts"]):
        planted = copy.deepcopy(result)
        planted["parts"][number]["peak_von_mises"]["value_MPa"] *= PLANTED
        yield part["name"], planted


def main():
    clevis, baseline = sys.argv[1], Path(sys.argv[3])
    if not baseline.exists():
        print(f"{baseline} is missing: docs/results.md says how to make it")
        return 1
    result = Path(sys.argv[2]) / "result.json"
    faults = []
    if compare(clevis, result, baseline).returncode != 0:
        print(subprocess.run([clevis, "compare", result, baseline],
                             stdout=subprocess.PIPE, text=True).stdout)
        faults.append("the result left its baseline")
    planted_of = dict(planted_results(json.loads(result.read_text())))
    with tempfile.TemporaryDirectory() as folder:
        changed = Path(folder) / "result.json"
        for name, planted in planted_of.items():
            changed.write_text(json.dumps(planted))
            run = compare(clevis, changed, baseline)
            moved = [(row["of"], row["quantity"])
                     for row in json.loads(run.stdout)["moved"]]
            if run.returncode != 3 or not any(
                    name in of and quantity == "peak_von_mises"
                    for of, quantity in moved):
                faults.append(f"0.5 % in the peak of {name} passed: exit "
                              f"{run.returncode}, {moved}")
    if not planted_of:
        faults.append("the result holds no part")
    print("\n".join(faults) or f"holds; {len(planted_of)} changes caught")
    return len(faults)


if __name__ == "__main__":
    sys.exit(main())

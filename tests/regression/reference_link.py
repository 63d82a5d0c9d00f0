#!/usr/bin/env python3
"""The reference link's peak of von Mises, inside its thickness, against the
converged 3-D value: within the tolerance asked for, and inside the band.
Arguments: clevis scene [folder that keeps the last result, for other tests]."""
import json
import subprocess
import sys
import tempfile

CONVERGED = 55.013  # MPa, +- 0.001


def main():
    clevis, scene = sys.argv[1:3]
    failures = 0
    for tolerance in (0.01, 0.001):
        with tempfile.TemporaryDirectory() as temporary:
            folder = sys.argv[3] if len(sys.argv) > 3 else temporary
            run = subprocess.run(
                [clevis, "check", scene, "--json", "--out", folder,
                 "--tolerance", f"{100 * tolerance} %"],
                capture_output=True, text=True, check=False)
        part = json.loads(run.stdout)["parts"][0]
        peak = part["peak_von_mises"]
        low, high = peak["band_MPa"]
        good = (run.returncode == 0 and low <= CONVERGED <= high and
                abs(peak["value_MPa"] - CONVERGED) <= tolerance * CONVERGED)
        failures += not good
        print(f'{"ok  " if good else "FAIL"} {100 * tolerance:g} %: '
              f'{peak["value_MPa"]:.3f} [{low:.3f}, {high:.3f}] MPa, '
              f'{part["model"]}, {part["dofs"]} DoF, {part["stopped_because"]}')
    return failures


if __name__ == "__main__":
    sys.exit(main())

#!/usr/bin/env python3
"""A scene's probe must be within a tolerance of a published value, and its
band must hold it. Arguments: clevis scene part probe value_MPa tolerance [folder
that keeps the result, for other tests]."""
import json
import subprocess
import sys
import tempfile


def main():
    clevis, scene, part_name, probe_name = sys.argv[1:5]
    published, tolerance = map(float, sys.argv[5:7])
    with tempfile.TemporaryDirectory() as temporary:
        folder = sys.argv[7] if len(sys.argv) > 7 else temporary
        run = subprocess.run([clevis, "check", scene, "--json", "--out", folder],
                             capture_output=True, text=True, check=False)
    if run.returncode != 0:
        print(f"exit {run.returncode}: {run.stderr}")
        return 1
    part = next(p for p in json.loads(run.stdout)["parts"]
                if p["name"] == part_name)
    probe = next(p for p in part["probes"] if p["name"] == probe_name)
    value, (low, high) = probe["value_MPa"], probe["band_MPa"]
    print(f"{value:.4f} MPa, band [{low:.4f}, {high:.4f}], published {published}")
    near = abs(value - published) <= tolerance * abs(published)
    return 0 if near and low <= published <= high else 1


if __name__ == "__main__":
    sys.exit(main())

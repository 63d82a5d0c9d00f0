#!/usr/bin/env python3
"""Runs `clevis simulate` on the scenes with contact and friction and compares
with their closed forms.

    contact_systems.py CLEVIS GEOMETRY
"""
import sys
import tempfile
from pathlib import Path

from source_systems import faults
from tribometer import check_regularized, check_tribometer
from wall import check_wall
from wheel import (check_drop, check_drop_impacts, check_ground,
                   check_ground_by_force)


def main():
    clevis, geometry = str(Path(sys.argv[1]).resolve()), Path(sys.argv[2])
    with tempfile.TemporaryDirectory() as folder:
        for check in (check_wall, check_tribometer, check_regularized,
                      check_drop, check_drop_impacts,
                      check_ground, check_ground_by_force):
            check(clevis, geometry, folder)
    for fault in faults:
        print(fault)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())

#!/usr/bin/env python3
"""Bands hold the known peak on irregular meshes that gmsh draws.

    bands.py CLEVIS [--seed N]

Fixed draws of the band study (results/studies/make_bands) on tetrahedra and
hexahedra: a band that converged holds the peak, whatever the mesh, and enough of
them converge. One row more is drawn anew each run and printed with its seed; it
fails the test only if its band misses by more than GROSS. --seed: that row again.
"""
import argparse
import random
import sys
import tempfile
from pathlib import Path

import band_run
import band_shapes

# (part, seed): rows of the study, meshes of a few hundred cells
FIXED = (("hollow_sphere-1", 1), ("lame_ring-2", 1), ("lame_ring-3", 1),
         ("spinning_ring-2", 1), ("spinning_ring-3", 1), ("lame_ring-2", 2),
         ("lame_ring-3", 2), ("spinning_ring-1", 2), ("eye_link-2", 1),
         ("lug-1", 1), ("plate_hole-1", 1), ("tee-1", 1), ("hook-1", 1),
         ("hub_disc-1", 1),  # a bad cell stands seven times above the peak
         # ends of coarse cells over the groove's round kink: no corner is there
         ("grooved_bar-2", 6), ("grooved_bar-2", 7))
GROSS = 0.03
# Known peaks are good to 1e-5 to 5e-4 of theirs, each row by its own; no band's end
# is told to more than this.
HAIR = 1e-4


def drawn(clevis, part, seed, stored):
    with tempfile.TemporaryDirectory() as folder:
        return band_run.drawn(clevis, Path(folder), band_shapes.shape(part),
                              random.Random(f"{seed} {part} 0"), stored)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("clevis")
    parser.add_argument("--seed", type=int)
    arguments = parser.parse_args()
    stored, faults, converged = band_run.references(), [], 0
    for part, seed in FIXED:
        row = drawn(arguments.clevis, part, seed, stored)
        print(band_run.line(row), flush=True)
        if row["peak"] not in ("converged", "not converged"):
            faults.append(f"{part}: {row['peak']}, {row.get('note')}")
        elif row["peak"] == "converged":
            converged += 1
            if not row["held"] and row["miss"] > HAIR:
                faults.append(f"{part}: the band misses by {row['miss']:.2%}")
    if converged < len(FIXED) // 2:
        faults.append(f"only {converged} of {len(FIXED)} converge")
    seed = arguments.seed or random.SystemRandom().randrange(1, 10**9)
    part = random.Random(seed).choice(band_run.parts(stored))
    row = drawn(arguments.clevis, part, seed, stored)
    print(f"drawn anew, --seed {seed}: {band_run.line(row)}", flush=True)
    if row["peak"] == "converged" and row["miss"] > GROSS:
        faults.append(f"--seed {seed}: the band misses by {row['miss']:.2%}")
    print("\n".join(f"FAIL {fault}" for fault in faults) or "pass")
    return len(faults) > 0


if __name__ == "__main__":
    sys.exit(main())

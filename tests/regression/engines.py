#!/usr/bin/env python3
"""Both engines give the same check: deflection and strain energy to 1e-9, peak
and band to 1e-8, the same verdict. deal.II in the processor's SIMD lanes gives that
of one lane.

    engines.py CLEVIS ROOT [SCENE [PART [MODEL]]]

Without SCENE the parts of ROWS; with it that scene by the models named. Prints a
row per part with the differences and the seconds of either engine."""
import os
import sys
import tempfile
from pathlib import Path

from support import JUDGED, check

DISPLACEMENT, STRESS = 1e-9, 1e-8
MODELS = ("plane-stress", "3d")

ROWS = [  # scene, part, model
    ("landing_gear/scene", "AB", "3d"),
    ("lame_ring/scene", None, "plane-stress"),
    ("cook/scene", None, "plane-stress"),
    ("nafems_le1/scene", None, "plane-stress"),
    ("reference_link/scene", None, "plane-stress"),
    ("reference_link/scene", None, "3d"),
]


def relative(a, b):
    return abs(a - b) / max(abs(a), abs(b), 1e-300)


def judged(part):
    """Away from singular zones that govern: within one the peak has no value, and
    cells graded towards it turn the last bits of displacements into stress."""
    return part.get("peak_outside_singular_zones") or part["peak_von_mises"]


def differences(own, other):
    """Of two parts' results: displacement, energy, judged peak and its band."""
    peaks = judged(own), judged(other)
    return (relative(own["deflection_mm"], other["deflection_mm"]),
            relative(own["strain_energy_mJ"], other["strain_energy_mJ"]),
            relative(*(peak["value_MPa"] for peak in peaks)),
            max(relative(a, b) for a, b in zip(*(peak["band_MPa"] for peak in peaks))))


def run(clevis, scene, part, model, engine, folder):
    options = ["--model", model, "--engine", engine] + (["--part", part] if part else [])
    return check(clevis, scene, *options, out=Path(folder) / engine)


def compare(clevis, scene, part, model, faults):
    with tempfile.TemporaryDirectory() as folder:
        answers = [run(clevis, scene, part, model, engine, folder)
                   for engine in ("own", "dealii")]
    names = {p["name"]: p for p in answers[1].parts}
    if not answers[0].parts:
        print(f"{scene.stem}, {part or 'all'}, {model}: {answers[0]} | {answers[1]}")
    if {a.code in JUDGED for a in answers} != {True}:
        if answers[0].codes != answers[1].codes:
            faults.append(f"{scene}, {model}: own {answers[0]}, deal.II {answers[1]}")
    for own in answers[0].parts:
        name = own["name"]
        if name not in names:
            faults.append(f"{scene}, {name}, {model}: deal.II gives none: {answers[1].codes}")
            continue
        other = names[name]
        displacement, energy, peak, band = differences(own, other)
        seconds = [p["seconds"]["total"] if "seconds" in p else float("nan")
                   for p in (own, other)]
        print(f"| {name} | {own['model']} | {own['dofs']} | {own['load_columns']} "
              f"| {displacement:.1e} | {energy:.1e} | {peak:.1e} | {band:.1e} "
              f"| {seconds[0]:.2f} | {seconds[1]:.2f} |", flush=True)
        if other["engine"] != "dealii" or own["engine"] != "own":
            faults.append(f"{name}: engines {own['engine']}, {other['engine']}")
        if (own["model"], own["verdict"]) != (other["model"], other["verdict"]):
            faults.append(f"{name}: {own['model']}, {own['verdict']} by own, "
                          f"{other['model']}, {other['verdict']} by deal.II")
        if not (max(displacement, energy) < DISPLACEMENT and max(peak, band) < STRESS):
            faults.append(f"{name}, {own['model']}: displacement {displacement:.1e}, energy "
                          f"{energy:.1e}, peak {peak:.1e}, band {band:.1e}")


def compare_lanes(clevis, root, faults):
    """The reference link as a solid in all lanes and in one."""
    results = []
    for instructions in ("avx512", "plain"):
        os.environ["CLEVIS_INSTRUCTIONS"] = instructions
        with tempfile.TemporaryDirectory() as folder:
            results.append(run(clevis, root / "geometry/reference_link/scene.toml", None, "3d",
                               "dealii", folder).parts[0])
    del os.environ["CLEVIS_INSTRUCTIONS"]
    off = max(differences(*results))
    same_bits = results[0]["strain_energy_mJ"] == results[1]["strain_energy_mJ"]
    print(f"lanes of the processor against one: {off:.1e}")
    if not off < DISPLACEMENT:
        faults.append(f"lanes: differ by {off:.1e}")
    if same_bits and "avx2" in Path("/proc/cpuinfo").read_text():
        faults.append("lanes: the same bits, so both took one lane")


def main():
    clevis, root = sys.argv[1], Path(sys.argv[2])
    rows = ROWS
    if len(sys.argv) > 3:
        part = sys.argv[4] if len(sys.argv) > 4 else None
        models = sys.argv[5:] or MODELS
        rows = [(sys.argv[3], part, model) for model in models]
    faults = []
    print("| part | model | DoF | columns | displacement | energy | peak | band | own s | deal.II s |\n"
          "|---|---|---|---|---|---|---|---|---|---|")
    for scene, part, model in rows:
        compare(clevis, root / "geometry" / f"{scene}.toml", part, model, faults)
    if rows is ROWS:
        compare_lanes(clevis, root, faults)
    print("\n".join(faults))
    return len(faults) > 0


if __name__ == "__main__":
    sys.exit(main())

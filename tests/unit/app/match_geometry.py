#!/usr/bin/env python3
"""Every mesh under meshes/ is what gmsh makes of its .geo today, every STEP file
what geometry/step/make does.

Usage: match_geometry.py SOURCE_DIR
"""
import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

VARIANT = re.compile("-[0-9a-f]{16}$")
COORDINATE_TOLERANCE = 1e-9  # mm; other builds of gmsh may round differently


def fnv1a(data):
    value = 0xCBF29CE484222325
    for byte in data:
        value = (value ^ byte) * 0x100000001B3 % 2**64
    return f"{value:016x}"


def mesh(geo):
    with tempfile.TemporaryDirectory() as folder:
        out = Path(folder) / "part.msh"
        subprocess.run(["gmsh", "-3", "-format", "msh41", "-nt", "1", "-o",
                        str(out), str(geo)], cwd=folder, check=True,
                       env=dict(os.environ, HOME=folder),
                       stdout=subprocess.DEVNULL)
        return out.read_text()


def sections(text):
    """Lines by section name, without the comments."""
    result, name = {}, None
    for line in text.splitlines():
        if name is None:
            name = line.strip().removeprefix("$")
            result[name] = []
        elif line.strip() == f"$End{name}":
            name = None
        else:
            result[name].append(line)
    return result


def same_line(a, b, name):
    if a == b:
        return True
    words_a, words_b = a.split(), b.split()
    if name not in ("Nodes", "Entities") or len(words_a) != len(words_b):
        return False
    return all(abs(float(p) - float(q)) <= COORDINATE_TOLERANCE
               for p, q in zip(words_a, words_b))


def differences(geo, msh):
    kept, fresh = sections(msh.read_text()), sections(mesh(geo))
    stamp = kept.pop("Comments", [""])[0].split()
    if stamp != ["clevis", "geometry", "fnv1a", fnv1a(geo.read_bytes())]:
        yield "the stamp is not that of the .geo; run `clevis mesh`"
    if kept.keys() != fresh.keys():
        yield f"sections {list(kept)} instead of {list(fresh)}"
        return
    for name, lines in fresh.items():
        if len(lines) != len(kept[name]):
            yield (f"${name}: {len(kept[name])} lines instead of "
                   f"{len(lines)}")
            continue
        for number, (a, b) in enumerate(zip(kept[name], lines), 1):
            if not same_line(a, b, name):
                yield f"${name}, line {number}: {a} instead of {b}"
                break


def outdated_solids(root):
    """STEP files that their script does not write as they are."""
    folder = root / "geometry/step"
    with tempfile.TemporaryDirectory() as fresh:
        subprocess.run([folder / "make", fresh], check=True)
        return [step for step in sorted(folder.glob("*.step"))
                if step.read_bytes() != (Path(fresh) / step.name).read_bytes()]


def main(root):
    bad = 0
    for step in outdated_solids(root):
        print(f"{step}: not what geometry/step/make writes")
        bad += 1
    geometries = {geo.relative_to(root / "geometry").with_suffix("")
                  for geo in (root / "geometry").rglob("*.geo")
                  if not geo.with_suffix(".step").exists()}
    meshes = {msh.relative_to(root / "meshes").with_suffix("")
              for msh in (root / "meshes").rglob("*.msh")
              # those of solids and of variants are made when they are needed
              if msh.parent.name != "step" and not VARIANT.search(msh.stem)}
    if not geometries or geometries != meshes:
        print(f"without partner: {sorted(map(str, geometries ^ meshes))}")
        bad += 1
    for part in sorted(geometries & meshes):
        geo = (root / "geometry" / part).with_suffix(".geo")
        msh = (root / "meshes" / part).with_suffix(".msh")
        found = list(differences(geo, msh))
        for text in found:
            print(f"{msh}: {text}")
        bad += len(found)
        print(f"{part}: {'differs' if found else 'matches'}")
    return bad


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1]).resolve()) > 0)

#!/usr/bin/env python3
"""Fail if a file under src/ includes what LAYERS does not allow (CI, first
step)."""
import re
import sys
from pathlib import Path

LAYERS = {  # module: (modules it may include, outside libraries it may include)
    "base": ("", "Eigen fmt udunits2"),
    "part": ("base", "Eigen fmt"),
    "mechanism": ("base part", "Eigen fmt"),
    "machine": ("base part mechanism", "Eigen fmt"),
    "scene": ("base part mechanism machine", "Eigen fmt toml"),
    "mesh": ("base part", "Eigen fmt"),
    "loads": ("base part mechanism", "Eigen fmt"),
    "dynamics": ("base loads", "Eigen fmt"),
    "beam": ("base part machine mesh loads", "Eigen fmt"),
    "elasticity": ("base part mesh loads dynamics", "deal.II petsc Eigen fmt"),
    "calculix": ("base part mesh loads elasticity", "Eigen fmt"),
    "stress": ("base part mesh loads dynamics elasticity", "deal.II Eigen fmt"),
    "assessment": ("base part mesh loads dynamics beam elasticity stress", "Eigen fmt"),
    "report": ("base part mechanism machine beam assessment", "Eigen fmt nlohmann"),
    "study": ("base part mesh loads elasticity stress assessment report",
              "Eigen fmt nlohmann"),
    "app": ("base part mechanism machine scene mesh loads dynamics beam elasticity calculix"
            " stress assessment study report", "Eigen fmt nlohmann CLI"),
}
LIBRARIES = r"(Eigen|deal\.II|gmsh|petsc|nlohmann|fmt|toml|CLI|udunits2)"


def check(root):
    bad = 0
    for path in sorted((root / "src").rglob("*.[hc]*")):
        module = path.relative_to(root).parts[1]
        if module not in LAYERS:
            print(f"{path}: module {module} has no row in LAYERS")
            bad += 1
            continue
        ours, theirs = (set(names.split()) | {module} for names in LAYERS[module])
        for number, line in enumerate(path.read_text().splitlines(), 1):
            mine = re.match(r'\s*#\s*include\s*"(\w+)/', line)
            other = re.match(rf"\s*#\s*include\s*[<\"]{LIBRARIES}", line)
            if (mine and mine[1] not in ours) or (other and other[1] not in theirs):
                print(f"{path}:{number}: {module} may not have {line.strip()}")
                bad += 1
    return bad


if __name__ == "__main__":
    sys.exit(check(Path(sys.argv[1] if len(sys.argv) > 1 else ".")) > 0)

#!/usr/bin/env python3
"""Reads the field files of a check with VTK, the reader of ParaView.

    vtu_files.py CLEVIS FOLDER

Every file opens without a warning; the numbers in it are finite; its highest
stress is the peak of result.json; higher-order and linear cells fill the same
space, also where the part moves; the series name files that are there.
Returns 77 (skipped) if Python has no VTK.
"""
import json
import math
import sys
import xml.etree.ElementTree as ElementTree
from pathlib import Path

try:
    from vtkmodules.vtkCommonCore import vtkOutputWindow, vtkStringOutputWindow
    from vtkmodules.vtkFiltersVerdict import vtkCellSizeFilter
    from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
except ImportError as missing:
    print(f"skipped: {missing}; Debian's package python3-vtk9 brings it")
    sys.exit(77)

# Fields are stored in single precision.
ROUND_OFF = 2e-6
# VTK sums a higher-order cell over the same linear cells.
SAME_CELLS = 1e-5
# Chords of the frames, which hold fewer cells.
COARSE = 3e-2
# Rigid motion with points in single precision, of which a cell is 1/100.
RIGID = 1e-5
FIELDS = {"displacement", "von_mises", "stress_xx", "stress_yy", "stress_zz",
          "stress_xy", "stress_yz", "stress_xz"}
HISTORY = {"von_mises_worst", "worst_time", "safety_factor"}


class Grid:
    """A .vtu file as VTK sees it."""

    def __init__(self, file):
        said = vtkStringOutputWindow()
        vtkOutputWindow.SetInstance(said)
        reader = vtkXMLUnstructuredGridReader()
        reader.SetFileName(str(file))
        reader.Update()
        self.warnings = said.GetOutput()
        self.grid = reader.GetOutput()
        points = self.grid.GetPointData()
        self.arrays = {points.GetArrayName(i): points.GetArray(i)
                       for i in range(points.GetNumberOfArrays())}

    def size(self):
        """Area and volume of all cells together."""
        sizes = vtkCellSizeFilter()
        sizes.SetInputData(self.grid)
        sizes.ComputeSumOn()
        sizes.Update()
        sums = sizes.GetOutput().GetFieldData()
        return sum(sums.GetArray(name).GetValue(0) for name in ("Area", "Volume"))

    def faults(self, expected):
        if self.warnings:
            yield f"VTK says {self.warnings!r}"
        if self.grid.GetNumberOfCells() == 0:
            yield "holds no cell"
        if missing := expected - set(self.arrays):
            yield f"lacks {sorted(missing)}"
        for name, array in self.arrays.items():
            for component in range(array.GetNumberOfComponents()):
                if not all(map(math.isfinite, array.GetRange(component))):
                    yield f"{name} is not finite"

    def largest(self, name):
        return self.arrays[name].GetRange()[1]


def near(a, b, relative):
    return abs(a - b) <= relative * abs(b)


def part_faults(folder, part):
    name, peak = part["name"], part["peak_von_mises"]
    curved, linear = Grid(folder / f"{name}.vtu"), Grid(
        folder / f"{name}_linear.vtu")
    for grid in (curved, linear):
        yield from grid.faults(FIELDS | HISTORY)
        highest = grid.largest("von_mises_worst")
        if peak["verdict"] == "converged" and not near(
                highest, 1e6 * peak["field_maximum_MPa"], ROUND_OFF):
            yield f"highest stress {highest} Pa, in result.json {peak}"
        if not near(grid.largest("von_mises"), highest, ROUND_OFF):
            yield "is not at the worst instant"
    if not near(linear.size(), curved.size(), SAME_CELLS):
        yield f"sizes {curved.size()} and, linear, {linear.size()}"
    sizes = []
    frames = sorted((folder / "frames").glob(f"{name}_*.vtu"))
    for number, frame in enumerate(frames):
        grid = Grid(frame)
        yield from (f"{frame.name} {fault}" for fault in grid.faults(FIELDS))
        if number % (len(frames) // 2) == 0:  # first, middle, last
            sizes.append(grid.size())
    if not all(near(size, linear.size(), COARSE) for size in sizes):
        yield f"frames of the sizes {sizes}, not {linear.size()}"
    if max(sizes) - min(sizes) > RIGID * max(sizes):
        yield f"changes its size while it moves: {sizes}"


def series_faults(file, parts):
    sets = ElementTree.parse(file).findall(".//DataSet")
    times = sorted({float(entry.get("timestep")) for entry in sets})
    if len(sets) != parts * len(times) or len(times) < 2:
        yield f"{len(sets)} files for {parts} parts and {len(times)} times"
    for entry in sets:
        if not (file.parent / entry.get("file")).is_file():
            yield f"names {entry.get('file')}, which is not there"


def main():
    folder = Path(sys.argv[2])
    parts = json.loads((folder / "result.json").read_text())["parts"]
    faults = []
    for part in parts:
        faults += [f"{part['name']}: {f}" for f in part_faults(folder, part)]
    series = sorted(folder.glob("*.pvd"))
    for file in series:
        count = len(parts) if file.name == "mechanism.pvd" else 1
        faults += [f"{file.name}: {f}" for f in series_faults(file, count)]
    print("\n".join(faults) or f"{len(parts)} parts and {len(series)} series "
          f"of {len(list(folder.rglob('*.vtu')))} files hold")
    return len(faults) > 0 or not parts or not series


if __name__ == "__main__":
    sys.exit(main())

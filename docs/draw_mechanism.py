#!/usr/bin/env python3
"""Draws the moving parts with their stress, as seen along the joint axes.

    draw_mechanism.py FOLDER PICTURE.png [TITLE]

FOLDER is the output of a `clevis check`; the first, the middle and the last
frame of its series are drawn over each other, in this order. Needs python3-vtk9 and
gnuplot-nox.
"""
import json
import subprocess
import sys
from pathlib import Path

from vtkmodules.vtkFiltersGeometry import vtkGeometryFilter
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader

MILLI, MEGA = 1e-3, 1e6

PLOT = """
set terminal pngcairo size 1400,900 font "sans,15"
set output "{picture}"
set title "{title}" noenhanced
set view map
set size ratio -1
set xlabel "x [mm]"
set ylabel "y [mm]"
set cblabel "von Mises stress [MPa]" offset 1
set palette defined (0 "#30387f", 0.15 "#2c7fb8", 0.35 "#41b6a4", \\
                     0.55 "#a6d96a", 0.75 "#fee08b", 0.9 "#f46d43", 1 "#a50026")
set cbrange [0:{highest:.6g}]
set pm3d corners2color mean interpolate 2,2 border retrace
unset key
set grid front
splot "-" using 1:2:3:4 with pm3d
"""


def front_faces(file):
    """Quads or triangles that are seen from +z: [(x, y, z, stress), ...]."""
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(file))
    surface = vtkGeometryFilter()
    surface.SetInputConnection(reader.GetOutputPort())
    surface.Update()
    mesh = surface.GetOutput()
    stress = mesh.GetPointData().GetArray("von_mises")
    for cell in range(mesh.GetNumberOfCells()):
        ids = mesh.GetCell(cell).GetPointIds()
        points = [mesh.GetPoint(ids.GetId(k)) +
                  (stress.GetValue(ids.GetId(k)),)
                  for k in range(ids.GetNumberOfIds())]
        area = sum(a[0] * b[1] - b[0] * a[1]
                   for a, b in zip(points, points[1:] + points[:1]))
        if area > 0:
            yield points


def gnuplot_block(points):
    """One quad as a grid of two lines of two points."""
    corners = [*points, points[-1]][:4]
    rows = (corners[0], corners[1]), (corners[3], corners[2])
    return "\n\n".join(
        "\n".join("{:.5g} {:.5g} {:.5g} {:.5g}".format(
            *(value / MILLI for value in p[:3]), p[3] / MEGA) for p in row)
        for row in rows) + "\n\n\n"


def main():
    folder, picture = Path(sys.argv[1]), sys.argv[2]
    result = json.loads((folder / "result.json").read_text())
    layers = [], [], []
    for part in result["parts"]:
        frames = sorted((folder / "frames").glob(f"{part['name']}_*.vtu"))
        for layer, faces in enumerate(layers):
            faces += front_faces(frames[layer * (len(frames) - 1) // 2])
    for faces in layers:
        faces.sort(key=lambda points: sum(p[2] for p in points) / len(points))
    faces = sum(layers, [])
    highest = max(point[3] for points in faces for point in points) / MEGA
    title = sys.argv[3] if len(sys.argv) > 3 else result["scene"]
    script = PLOT.format(picture=picture, title=title, highest=highest)
    data = "".join(map(gnuplot_block, faces))
    subprocess.run(["gnuplot"], input=script + data + "e\n", text=True,
                   check=True)


if __name__ == "__main__":
    main()

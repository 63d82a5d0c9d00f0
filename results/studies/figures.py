"""Line plots of the studies, by gnuplot."""
import subprocess
from pathlib import Path

HERE = Path(__file__).resolve().parent


def plot(picture, settings, curves, columns):
    """curves: {title: [(x, y), ...]}; one file, `columns` to plot by."""
    blocks = "\n\n\n".join("\n".join(" ".join(map(str, point)) for point in data)
                           for data in curves.values())
    lines = ", ".join(f'$data index {i} using {columns} with lines lw 2 '
                      f'title "{title}"' for i, title in enumerate(curves))
    command = "splot" if columns.count(":") == 2 else "plot"
    script = (f'set terminal svg size 800,560 font "sans,13" background "white"\n'
              f'set output "{HERE / picture}"\nset grid\nset key top left\n'
              f"{settings}\n$data << END\n{blocks}\nEND\n{command} {lines}\n")
    subprocess.run(["gnuplot"], input=script, text=True, check=True)

"""Rows of mechanisms: clevis by its command and as a library, and the peers' programs
of tests/benchmarks, one process a row."""
import csv
import tempfile
from pathlib import Path

import measure
import scenes

TITLES = {
    "andrews": "Andrews' squeezing mechanism, 0.03 s",
    "light_cart_pole": "Light cart-pole, 10 s",
    "governor": "Stiff governor, 10 s",
    "bricard": "Bricard's mechanism, 10 s",
    "two_window_four_bar": "Two-window four-bar, 10 s",
    "crank_rocker": "Crank-rocker, 10 s",
    "spatial_slider_crank": "Spatial slider-crank, 5 s",
}
COMMAND = "clevis simulate"
ACCURACIES = [f"1e-{k:02d}" for k in range(3, 13)]
STEPS = [f"h = 1e-{k:02d} s" for k in range(2, 7)]
# program: (title, Debian's package, methods, settings)
PROGRAMS = {
    "work_precision": ("clevis, as a library", "",
                       ["clevis", "clevis DOP853", "clevis Radau IIA"], ACCURACIES),
    "simbody_precision": ("Simbody 3.7", "libsimbody-dev",
                          ["Simbody 3.7 Merson", "Simbody 3.7 CPodes BDF"], ACCURACIES[:8]),
    "mujoco_precision": ("MuJoCo 2.2.2", "libmujoco-dev",
                         ["MuJoCo 2.2.2 RK4 (2h)", "MuJoCo 2.2.2 Euler (2h)",
                          "MuJoCo 2.2.2 implicit (2h)"], STEPS),
    "sundials_precision": ("SUNDIALS 6.4", "libsundials-dev",
                           ["SUNDIALS 6.4 CVODE BDF", "SUNDIALS 6.4 CVODE Adams",
                            "SUNDIALS 6.4 ARKODE ERK 8", "SUNDIALS 6.4 ARKODE DIRK 5",
                            "SUNDIALS 6.4 IDA"], ACCURACIES),
}
LIMIT = 10  # processor seconds of a process


def row(problem, program, method, setting, run, work, error, remark=""):
    return {"kind": "mechanism", "problem": problem, "program": program, "method": method,
            "setting": setting, "user_s": f"{run.user:.4f}", "wall_s": f"{run.wall:.4f}",
            "work_s": work, "error": error, "band": "", "remark": remark}


def by_command(clevis, problem, settings, rounds):
    """Rows of `clevis simulate`: the whole process with reading and writing."""
    with tempfile.TemporaryDirectory() as name:
        scene = Path(name) / "scene.toml"
        scene.write_text(scenes.SCENES[problem]()[0].text())
        for setting in settings:
            command = [clevis, "simulate", scene, "--out", Path(name) / "out", "--set",
                       f"simulation.tolerance={setting}"]
            runs = [measure.run(command, LIMIT) for _ in range(rounds)]
            one = measure.least(runs)
            if one.status != 0:
                words = "over the limit" if one.status is None else one.errors.split("\n")[0]
                yield row(problem, COMMAND, "auto", setting, one, "", "", words)
                return
            error = scenes.error(problem, Path(name) / "out")
            yield row(problem, COMMAND, "auto", setting, one, "", f"{error:.3e}")


def by_program(file, problem, method, settings, rounds):
    """Rows of a program of tests/benchmarks; a ladder ends where two runs take too long."""
    title, over = PROGRAMS[file.name][0], 0
    for setting in settings:
        command = [file, "--run", problem, method, setting]
        runs, cells = [], []
        for _ in range(rounds):
            one = measure.run(command, LIMIT)
            found = [cell for cell in csv.DictReader(one.text.splitlines())
                     if cell["problem"] == problem]
            if found:
                cells.append(found[0])
            runs.append(one)
            if one.user > 1.0:
                break  # long ones once
        if not cells:  # ended by the limit, or no setting of this problem
            over += runs[0].status is None
            if over == 2:
                return
            continue
        one = measure.least(runs)
        if cells[0]["steps"] is None:
            yield row(problem, title, method, setting, one, "", "", cells[0]["cpu_ms"])
            over += cells[0]["cpu_ms"].startswith("over")
            if over == 2:
                return
            continue
        work = min(float(cell["cpu_ms"]) for cell in cells)
        yield row(problem, title, method, setting, one, f"{1e-3 * work:.6f}",
                  cells[0]["position_or_time_error"])


def rows(clevis, programs, problems, rounds):
    """programs: {name: file} of those that are there."""
    for problem in problems:
        yield from by_command(clevis, problem, ACCURACIES[:8], rounds)
        for name, file in programs.items():
            for method in PROGRAMS[name][2]:
                yield from by_program(file, problem, method, PROGRAMS[name][3], rounds)

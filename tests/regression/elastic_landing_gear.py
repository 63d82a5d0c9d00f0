#!/usr/bin/env python3
"""Elastic links of the landing gear, in its plane and in space, with a load
beside the plane: reactions are in balance, are the rigid links' where
equilibrium fixes them or joints give way far more than links, and do not depend
on the order of the joints.

    elastic_landing_gear.py CLEVIS GEOMETRY
"""
import csv
import json
import re
import subprocess
import sys
import tempfile
from pathlib import Path

CLEVIS = str(Path(sys.argv[1]).resolve())
GEOMETRY = Path(sys.argv[2]).resolve() / "landing_gear"

IN_PLANE, BESIDE = (500.0, 1000.0, 0.0), (500.0, 1000.0, 200.0)  # [N]
# The cylinder's drive acts between its two bodies and is no joint's reaction.
BODIES = (("AB",), ("BC",), ("wheel",), ("DCE",), ("FE1", "FE2"))
# Of a joint, far more than of the links: these share nothing then.
SOFT = "compliance = {{ force = [{0}, {0}, {0}], moment = [{1}, {1}, {1}] }}".format(
    '"1e-2 m/N"', '"10 rad/(N m)"')

faults = []


def scene(links, load, spatial=True, reverse=False, soft=False):
    """loaded.toml at rest and without weight at its ends, few instants."""
    text = (GEOMETRY / "loaded.toml").read_text()
    text = text.replace('"-9.81 m/s^2"', '"0 m/s^2"')
    text = text.replace('force = ["500 N", "1000 N", "0 N"]',
                        f"force = {[f'{f} N' for f in load]}")
    text = text.replace("instants = 201", f'instants = 3\nlinks = "{links}"')
    if spatial:
        text += '\n[mechanism]\ndimension = "spatial"\n'
    joints = re.findall(r"\[\[joint\]\].*?(?=\n\n)", text, re.DOTALL)
    assert len(joints) == 8 and f"{load[0]} N" in text and "links" in text
    for old, new in zip(joints, reversed(joints) if reverse else joints):
        text = text.replace(old, f"<{joints.index(new)}>")
    for k, joint in enumerate(joints):
        text = text.replace(f"<{k}>", f"{joint}\n{SOFT}" if soft else joint)
    return text


class Run:
    """Reactions of one simulation: (t, joint) -> row of reactions.csv."""

    def __init__(self, folder, **options):
        self.load = options["load"]
        (folder / "scene.toml").write_text(scene(**options))
        done = subprocess.run([CLEVIS, "simulate", "scene.toml", "--json",
                               "--out", "out"], capture_output=True, text=True,
                              cwd=folder, check=False)
        if done.returncode != 0:
            sys.exit(f"{options}: exit {done.returncode}, {done.stderr}")
        self.document = json.loads(done.stdout)
        with open(folder / "out/reactions.csv", encoding="utf-8") as file:
            self.rows = {(float(r["t_s"]), r["joint"]): r
                         for r in csv.DictReader(file)}
        with open(folder / "out/motion.csv", encoding="utf-8") as file:
            self.motion = {float(r["t_s"]): r for r in csv.DictReader(file)}

    def wrench(self, key):
        """Force [N] and moment [N m] on the joint's second body, in W."""
        return [float(self.rows[key][f"{what}_on_b_world_{axis}_{unit}"])
                for what, unit in (("force", "N"), ("moment", "N_m"))
                for axis in "xyz"]

    def largest(self):
        return max(abs(x) for key in self.rows for x in self.wrench(key))

    def difference(self, other, components=range(6)):
        """Largest over the instants of both and joints, over the largest
        reaction."""
        both = self.rows.keys() & other.rows.keys()
        if not {0.0, 1.0, 2.0} <= {t for t, _ in both}:
            sys.exit("the scene's instants are not in both")
        return max(abs(self.wrench(key)[c] - other.wrench(key)[c])
                   for key in both for c in components) / self.largest()

    def imbalance(self, t):
        """Of the bodies where they rest: loads and reactions about the origin,
        over the largest reaction."""
        worst = 0.0
        for bodies in BODIES:
            total = [0.0] * 6
            if "wheel" in bodies:
                at = [float(self.motion[t][f"T.marker_{a}_mm"]) * 1e-3
                      for a in "xyz"]
                add(total, 1.0, at, [*self.load, 0.0, 0.0, 0.0])
            for (time, joint), row in self.rows.items():
                sign = (row["body_b"] in bodies) - (row["body_a"] in bodies)
                if time != t or sign == 0:
                    continue
                at = [float(row[f"point_world_{a}_mm"]) * 1e-3 for a in "xyz"]
                add(total, sign, at, self.wrench((t, joint)))
            worst = max(worst, *map(abs, total))
        return worst / self.largest()


def add(total, sign, p, wrench):
    f, m = wrench[:3], wrench[3:]
    turn = [p[1] * f[2] - p[2] * f[1], p[2] * f[0] - p[0] * f[2],
            p[0] * f[1] - p[1] * f[0]]
    for k in range(3):
        total[k] += sign * f[k]
        total[3 + k] += sign * (m[k] + turn[k])


def expect(what, value, allowed):
    good = value <= allowed  # NaN is not
    print(f"{what}: {value:.1e}, allowed {allowed:.0e}{'' if good else ' FAIL'}")
    if not good:
        faults.append(what)


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for file in GEOMETRY.glob("*.geo"):
            (folder / file.name).write_text(file.read_text())
        (folder / "scene.toml").write_text(scene("elastic", IN_PLANE))
        subprocess.run([CLEVIS, "mesh", "scene.toml"], cwd=folder, check=True,
                       capture_output=True)

        def run(links, load, **options):
            return Run(folder, links=links, load=load, **options)

        # Equilibrium fixes all in the plane, the rank's tolerance apart.
        rigid = run("rigid", IN_PLANE, spatial=False)
        expect("plane", run("elastic", IN_PLANE, spatial=False)
               .difference(rigid), 1e-10)
        expect("load in the plane, space", run("elastic", IN_PLANE)
               .difference(rigid), 1e-10)

        elastic, rigid = run("elastic", BESIDE), run("rigid", BESIDE)
        for t in (0.0, 2.0):  # at rest
            expect(f"balance at {t:.0f} s", elastic.imbalance(t), 1e-9)
        expect("in the plane, load beside it",
               elastic.difference(rigid, components=(0, 1, 5)), 1e-10)
        # Links of 5 mm bend across the plane: they share otherwise, but no
        # reaction outgrows what rigid links carry.
        share = elastic.difference(rigid, components=(2, 3, 4))
        expect("shares differ by at least 1e-3", 1e-3 / share, 1.0)
        expect("and at most by the load across",
               share * elastic.largest() / BESIDE[2], 1.0)
        expect("order of the joints",
               elastic.difference(run("elastic", BESIDE, reverse=True)), 1e-9)
        expect("soft joints", run("elastic", BESIDE, soft=True).difference(
            run("rigid", BESIDE, soft=True)), 1e-5)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())

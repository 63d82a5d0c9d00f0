#!/usr/bin/env python3
"""Pictures that need no browser: of parts by `clevis check`, of a mechanism by
`clevis picture`.

    pictures.py CLEVIS SOURCE_DIR RESULT_DIR

RESULT_DIR holds a check of the loaded landing gear. What is drawn is held to the
numbers of result.json and to the size of the part in its mesh.
"""
import base64
import json
import re
import shutil
import struct
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree
import zlib
from pathlib import Path

from support import Checks

SVG = "{http://www.w3.org/2000/svg}"
LINK = "{http://www.w3.org/1999/xlink}href"
SAME_COLOUR = 12  # of 255: farther off are mesh lines and the mean with the white beside
# Three pixels are 0.6 mm; beside a hole of 7.5 mm the stress falls by 7/3 of itself over the
# radius (Kirsch), so by 19 %.
LEAST_SHARE = 0.8


def pixels(png):
    """Rows of (r, g, b) of an unfiltered PNG of 8 bits."""
    at, data = 8, b""
    while at < len(png):
        size, kind = struct.unpack(">I4s", png[at:at + 8])
        content = png[at + 8:at + 8 + size]
        if kind == b"IHDR":
            width, height, depth, colour = struct.unpack(">IIBB", content[:10])
            assert (depth, colour) == (8, 2), "not 8 bits of RGB"
        if kind == b"IDAT":
            data += content
        at += 12 + size
    raw, rows = zlib.decompress(data), []
    for y in range(height):
        line = raw[y * (3 * width + 1):(y + 1) * (3 * width + 1)]
        assert line[0] == 0, "a filtered row"
        rows.append([tuple(line[1 + 3 * x:4 + 3 * x]) for x in range(width)])
    return rows


class Drawing:
    def __init__(self, file):
        self.root = ElementTree.parse(file).getroot()
        self.texts = [node.text or "" for node in self.root.iter(f"{SVG}text")]
        image = self.root.find(f"{SVG}image")
        self.top = float(image.get("y"))
        self.rows = pixels(base64.b64decode(image.get(LINK).split(",", 1)[1]))

    @property
    def box(self):
        """Width and height of what is drawn [pixel]."""
        drawn = [(x, y) for y, row in enumerate(self.rows) for x, p in enumerate(row)
                 if p != (255, 255, 255)]
        xs, ys = zip(*drawn)
        return max(xs) - min(xs) + 1, max(ys) - min(ys) + 1

    @property
    def mark(self):
        circle = self.root.find(f"{SVG}circle")
        return float(circle.get("cx")), float(circle.get("cy")) - self.top

    @property
    def colours(self):
        """Of the legend, from the lowest."""
        return [tuple(bytes.fromhex(stop.get("stop-color")[1:]))
                for stop in self.root.iter(f"{SVG}stop")]


    def share_of(self, colour):
        """Which share of the legend has this colour; -1: none has."""
        given, best = self.colours, (SAME_COLOUR, -1.0)
        for k in range(10 * (len(given) - 1) + 1):
            low, part = given[min(k // 10, len(given) - 2)], k / 10 - min(k // 10, len(given) - 2)
            high = given[min(k // 10, len(given) - 2) + 1]
            away = max(abs(c - (a + part * (b - a))) for a, b, c in zip(low, high, colour))
            best = min(best, (away, k / 10 / (len(given) - 1)))
        return best[1]


def positions(view):
    """x, y, z of all places [mm]: blocks of integers."""
    given = view["positions_mm"]
    numbers = base64.b64decode(given["integers"]["base64"])
    flat = struct.unpack(f"<{len(numbers) // 2}H", numbers)
    n = len(flat) // 3
    return [[given["origin"][k] + given["scale"] * v for v in flat[k * n:(k + 1) * n]]
            for k in range(3)]


def plates(checks, folder):
    """Plates are seen straight: places of the mesh have places on the picture."""
    result = json.loads((folder / "result.json").read_text())
    for part in result["parts"]:
        drawing = Drawing(folder / f"{part['name']}.svg")
        peak, detail = part["peak_von_mises"], " ".join(drawing.texts[:2])
        checks.expect(part["verdict"] in detail and f"{peak['value_MPa']:.5g} MPa" in detail
                      and f"[{peak['band_MPa'][0]:.5g}, {peak['band_MPa'][1]:.5g}]" in detail
                      and peak["group"] in detail, f"{part['name']}: says {detail}")
        view = json.loads((folder / f"view/part_{part['name']}.json").read_text())
        if not view["faces_z_mm"]:
            continue
        x, y, _ = positions(view)
        width, height = max(x) - min(x), max(y) - min(y)
        turned = height > 1.6 * width
        if turned:
            width, height = height, width
        drawn = drawing.box
        checks.expect(abs(drawn[0] / drawn[1] * height / width - 1) < 0.02,
                      f"{part['name']}: drawn as {drawn} pixels, {width:.1f} x {height:.1f} mm")
        scale = drawn[0] / width
        bar = next(t for t in drawing.texts if t.endswith(" mm"))
        lines = [tuple(map(float, re.findall(r"[\d.]+", node.get("d"))))
                 for node in drawing.root.iter(f"{SVG}path")]
        flat = max((b[2] - b[0] for b in lines if b[1] == b[3] and b[0] == 90.0))
        checks.expect(abs(flat / scale - float(bar.split()[0])) < 0.02 * float(bar.split()[0]),
                      f"{part['name']}: the scale of {bar} is {flat / scale:.2f} mm long")
        across, up = (y, [-v for v in x]) if turned else (x, y)
        at = peak["at_mm"]
        place = (at[1], -at[0]) if turned else (at[0], at[1])
        middle = [0.5 * (min(v) + max(v)) for v in (across, up)]
        wanted = (430 + scale * (place[0] - middle[0]),
                  0.5 * len(drawing.rows) - scale * (place[1] - middle[1]))
        away = max(abs(a - b) for a, b in zip(drawing.mark, wanted))
        checks.expect(away < 2, f"{part['name']}: the mark is {away:.2f} pixels off")
        cx, cy = map(round, drawing.mark)
        near = [drawing.rows[j][i] for j in range(cy - 3, cy + 4) for i in range(cx - 3, cx + 4)
                if 0 <= j < len(drawing.rows) and 0 <= i < len(drawing.rows[0])]
        share = max(drawing.share_of(colour) for colour in near)
        checks.expect(share >= LEAST_SHARE,
                      f"{part['name']}: at the peak the colour of {share:.2f} of the largest stress")


def commands(checks, clevis, source, folder, name):
    def run(*arguments):
        return subprocess.run([clevis, "picture", *map(str, arguments)], text=True,
                              capture_output=True)
    out = Path(name) / "mechanism.svg"
    done = run(folder, "--out", out)
    checks.expect(done.returncode == 0 and done.stdout.strip() == str(out), "draws the mechanism")
    drawing = Drawing(out)
    checks.expect("0 s, 1 s, 2 s" in " ".join(drawing.texts), "at three instants")
    checks.expect(len(drawing.root.findall(f"{SVG}circle")) == 0
                  and drawing.box[1] > 400, "as large as the picture")
    committed = Drawing(source / "results/studies/landing_gear_loaded.svg")
    checks.expect(committed.texts == drawing.texts and committed.box == drawing.box,
                  "README's picture is what the command draws")
    again = Path(name) / "again.svg"
    run(folder, "--part", "DCE", "--out", again)
    checks.expect(Drawing(again).texts == Drawing(folder / "DCE.svg").texts,
                  "--part draws what `check` drew")
    for code, arguments in (("U001", (folder, "--part", "nobody")),
                            ("I008", (name,)), ("I002", (folder, "--out", "/proc/picture.svg"))):
        done = run(*arguments)
        checks.expect(done.returncode == (2 if code == "U001" else 22) and code in done.stderr,
                      f"{code}: {done.stderr.strip()[:90]}")
    for file in ("x.png", "x", "x.SVG"):
        done = run(folder, "--out", Path(name) / file)
        checks.expect(done.returncode == 2 and "U001" in done.stderr and file in done.stderr
                      and "x.svg" in done.stderr and not (Path(name) / file).exists(),
                      f"--out {file} is refused: {done.stderr.strip()[:120]}")
    old = Path(name) / "old"
    shutil.copytree(folder, old)
    view = old / "view/part_DCE.json"
    text = json.loads(view.read_text())
    text["triangles"]["base64"] = "////" * (len(text["triangles"]["base64"]) // 4)
    view.write_text(json.dumps(text))
    done = run(old)
    checks.expect(done.returncode == 22 and "I003" in done.stderr,
                  f"a damaged view is refused: {done.stderr.strip()[:90]}")
    stored = (folder / "result.json").read_text()
    for damage in ('"high"', "1e999", "NaN", "null"):
        (old / "result.json").write_text(
            re.sub(r'("safety_factor": )[\d.]+', r"\g<1>" + damage, stored, count=1))
        done = subprocess.run([clevis, "report", old], text=True, capture_output=True)
        checks.expect(done.returncode == 22 and "I003" in done.stderr,
                      f"report refuses {damage}: {done.stderr.strip()[:90]}")


def without_mechanism(checks, clevis, name):
    """What has no moving parts, or no parts at all, says what can be drawn."""
    home = Path(name)
    for template in ("part", "four-bar"):
        subprocess.run([clevis, "init", template, "--template", template], cwd=name, check=True,
                       capture_output=True)
    part, motion = home / "part_out", home / "motion_out"
    check = [clevis, "check", "--mesh", home / "part/scene.toml", "--out", part,
             "--tolerance", "10%"]
    subprocess.run(check, capture_output=True)
    for command in (["mesh"], ["simulate", "--out", motion]):
        subprocess.run([clevis, *command, home / "four-bar/scene.toml"], check=True,
                       capture_output=True)
    link = json.loads((part / "result.json").read_text())["parts"][0]["name"]
    for arguments, remedy in (((part,), f"--part {link}"), ((motion,), "clevis report"),
                              ((motion, "--part", link), "clevis report")):
        done = subprocess.run([clevis, "picture", *arguments], text=True, capture_output=True)
        checks.expect(done.returncode == 22 and "I008" in done.stderr and remedy in done.stderr,
                      f"refused with what to do: {done.stderr.strip()[:200]}")
    done = subprocess.run([clevis, "picture", part, "--part", link], capture_output=True)
    checks.expect(done.returncode == 0, "one part alone is drawn")
    scene = home / "part/scene.toml"
    scene.write_text(scene.read_text().replace(f'name = "{link}"', 'name = "other"'))
    subprocess.run(check, capture_output=True)
    checks.expect((part / "other.svg").exists() and not (part / f"{link}.svg").exists(),
                  "the picture of a part that is gone goes with its files")


def failing_report(checks, clevis, name):
    """A report that cannot be written does not swallow the verdict."""
    out = Path(name) / "part_out"
    (out / "report.html").mkdir()
    (out / "report.html/kept").touch()
    check = [clevis, "check", "--report", Path(name) / "part/scene.toml", "--out", out,
             "--tolerance", "10%"]
    done = subprocess.run(check, capture_output=True, text=True)
    checks.expect(done.returncode == 22 and "I002" in done.stderr and "verdict: " in done.stdout,
                  f"the table stands: {done.stdout[-200:]}{done.stderr[:200]}")
    done = subprocess.run([*check, "--json"], capture_output=True, text=True)
    checks.expect(done.returncode == 22 and json.loads(done.stdout)["error"]["code"] == "I002",
                  f"and --json is one document: {done.stdout[:100]}")
    shutil.rmtree(out / "report.html")
    done = subprocess.run(check, capture_output=True, text=True)
    checks.expect(done.returncode == 0 and f"report: {out}/report.html\n" in done.stderr,
                  f"one that is written is told: {done.stderr}")


def hostile(checks, clevis, name):
    """A scene's own words are text in the picture."""
    code = "</text><script>alert(1)</script> &amp; `touch owned`"
    subprocess.run([clevis, "init", "bar", "--template", "four-bar"], cwd=name, check=True,
                   capture_output=True)
    scene = Path(name) / "bar/scene.toml"
    scene.write_text(re.sub('^name = .*$', lambda _: f"name = {json.dumps(code)}",
                            scene.read_text(), count=1, flags=re.M))
    out = Path(name) / "out"
    for command in (["check", "--mesh", scene, "--out", out, "--tolerance", "10%"],
                    ["picture", out]):
        done = subprocess.run([clevis, *command], capture_output=True, text=True)
        checks.expect(done.returncode == 0, f"clevis {command[0]}: {done.stderr[:200]}")
    drawing = Drawing(out / "mechanism.svg")
    checks.expect(not list(drawing.root.iter(f"{SVG}script"))
                  and any("<script>" in text for text in drawing.texts), "names are text")


def main():
    clevis, source, folder = Path(sys.argv[1]).resolve(), *map(Path, sys.argv[2:4])
    checks = Checks()
    plates(checks, folder)
    with tempfile.TemporaryDirectory() as name:
        commands(checks, clevis, source, folder, name)
        without_mechanism(checks, clevis, name)
        failing_report(checks, clevis, name)
        hostile(checks, clevis, name)
    return checks.exit_code()


if __name__ == "__main__":
    sys.exit(main())

#!/usr/bin/env python3
"""`clevis check --watch` as an editor and a browser meet it.

    watch.py CLEVIS SOURCE_DIR run      saves, faults, meshes, an end by Ctrl-C
    watch.py CLEVIS SOURCE_DIR report   an open report follows, in Chromium
    watch.py CLEVIS SOURCE_DIR hostile  files that vanish, folders in their place
    watch.py CLEVIS SOURCE_DIR shared   two watches on one folder of results

`report` returns 77 (skipped) without Node.js, the packages of viewer or Chromium.
"""
import fcntl
import json
import os
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from report_page import SKIPPED, node_is_there
from support import Checks

PATIENCE = 120  # s for one run on a busy machine
SETTLED = 1.5   # s in which a run that nobody wants would begin
QUICK = 0.25    # s between saves that are one; a busy machine may not be so quick
ENDED, AGAIN = "watching ", "checking again"


class Watch:
    """A running `clevis check --watch` on a part of its own."""

    def __init__(self, clevis, folder, *arguments, name="link"):
        self.folder = Path(folder)
        subprocess.run([clevis, "init", name, "--template", "part"], cwd=folder,
                       check=True, capture_output=True)
        self.home = self.folder / name
        self.scene = self.home / "scene.toml"
        self.out = self.folder / "out"
        self.temporary = self.folder / "tmp"
        self.temporary.mkdir()
        self.log = self.folder / "log"
        with self.log.open("w") as log:
            self.process = subprocess.Popen(
                [clevis, "check", "--watch", self.scene, "--out", self.out,
                 "--tolerance", "10%", *arguments],
                stdout=log, stderr=log, start_new_session=True,
                env=os.environ | {"TMPDIR": str(self.temporary)})

    def text(self):
        return self.log.read_text()

    def runs(self):
        """How many have come to their end."""
        return self.text().count(ENDED)

    def wait(self, runs):
        """Until so many have. @return the text of the last one"""
        end = time.monotonic() + PATIENCE
        while self.runs() < runs:
            if time.monotonic() > end or self.process.poll() is not None:
                self.kill()
                sys.exit(f"no run {runs}, exit {self.process.poll()}:\n{self.text()}")
            time.sleep(0.05)
        return self.text().split(ENDED)[runs - 1]

    def result(self):
        return json.loads((self.out / "result.json").read_text())

    def save(self, old, new, file=None):
        """As editors do: another file takes the place of the old one."""
        file = file or self.scene
        text = file.read_text()
        if old not in text:
            sys.exit(f"{file} lacks {old!r}")
        fresh = file.with_suffix(".swp")
        fresh.write_text(text.replace(old, new))
        fresh.replace(file)

    def interrupt(self):
        """Ctrl-C. @return the exit code; None if it does not end"""
        os.killpg(self.process.pid, signal.SIGINT)
        try:
            return self.process.wait(timeout=20)
        except subprocess.TimeoutExpired:
            self.kill()
            return None

    def lives(self):
        try:
            os.killpg(self.process.pid, 0)
        except ProcessLookupError:
            return False
        return True

    def kill(self):
        if self.lives():
            os.killpg(self.process.pid, signal.SIGKILL)


def run(clevis, _):
    checks = Checks()
    with tempfile.TemporaryDirectory() as folder:
        watch = Watch(clevis, folder)
        first = watch.wait(1)
        checks.expect("cells," in first, "the mesh that is missing is made")
        peak = watch.result()["parts"][0]["peak_von_mises"]["value_MPa"]
        time.sleep(SETTLED)
        checks.expect(watch.text().count(AGAIN) == 0, "and asks for no other run")

        watch.save('thickness = "10 mm"', 'thickness = "5 mm"')
        checks.expect("scene.toml changed" in watch.wait(2), "a saved scene is checked again")
        twice = watch.result()["parts"][0]["peak_von_mises"]["value_MPa"]
        checks.expect(abs(twice - 2 * peak) < 0.1 * peak,
                      f"half the thickness gives about twice the stress: {peak} {twice}")

        begun, saved = watch.text().count(AGAIN), [time.monotonic()]
        for k in range(5, 10):
            watch.save(f'thickness = "{k} mm"', f'thickness = "{k + 1} mm"')
            time.sleep(0.08)
            saved.append(time.monotonic())
        watch.wait(3)
        time.sleep(SETTLED)
        begun = watch.text().count(AGAIN) - begun
        slowest = max(b - a for a, b in zip(saved, saved[1:]))
        checks.expect(watch.runs() == 3 and (begun == 1 or slowest > QUICK),
                      f"five quick saves are one run: {begun}, {slowest:.2f} s between them")

        good = watch.scene.read_text()
        watch.scene.write_text(good.replace("schema = 1", "schema = ["))
        checks.expect("error[S001]" in watch.wait(4), "a scene that fails tells its error")
        watch.scene.write_text(good)
        checks.expect("verdict" in watch.wait(5), "and is waited for")

        geometry = next(watch.home.glob("*.geo"))
        text = geometry.read_text()
        geometry.write_text(text + "\n// another version\n")
        again = watch.wait(6)
        checks.expect("cells," in again and "M011" not in again,
                      "a changed geometry is meshed anew")
        time.sleep(SETTLED)
        checks.expect(watch.runs() == 6, "the mesh made so asks for no other run")

        included = watch.home / "more.geo"
        geometry.write_text(text + '\nInclude "more.geo";\n')
        included.write_text("// nothing\n")
        watch.wait(7)
        included.write_text("// still nothing\n")
        checks.expect("more.geo changed" in watch.wait(8), "files that a geometry reads count")

        mesh = next(watch.home.glob("*.msh"))
        mesh.unlink()
        checks.expect("cells," in watch.wait(9), "a deleted mesh is made again")
        same = watch.result()["parts"][0]["peak_von_mises"]["value_MPa"]
        checks.expect(abs(same - peak) < 1e-9 * peak, f"with the same peak {same} {peak}")

        checks.expect(watch.interrupt() == 130, "Ctrl-C ends it with 130")
        checks.expect(not watch.lives(), "no process is left")
        checks.expect(not list(watch.temporary.iterdir()), "no temporary file is left "
                      f"{list(watch.temporary.iterdir())}")
        checks.expect(not list(watch.folder.rglob("*.tmp")), "no unfinished file is left")
    with tempfile.TemporaryDirectory() as folder:
        watch = Watch(clevis, folder)
        time.sleep(0.3)  # while it meshes or solves
        checks.expect(watch.interrupt() == 130, "Ctrl-C during a run ends it with 130")
        checks.expect(not watch.lives() and not list(watch.temporary.iterdir())
                      and not list(watch.folder.rglob("*.tmp")), "nothing is left of that run")
    return checks.exit_code()


def report(clevis, source):
    viewer = Path(source) / "viewer"
    node_is_there(viewer)
    checks = Checks()
    with tempfile.TemporaryDirectory() as folder:
        watch = Watch(clevis, folder, "--report")
        watch.wait(1)
        page = watch.out / "report.html"
        browser = subprocess.Popen(["node", viewer / "test/follow.mjs", page, watch.scene],
                                   text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        told, _ = browser.communicate(timeout=3 * PATIENCE)
        print(told, end="")
        if browser.returncode == SKIPPED:
            watch.kill()
            sys.exit(SKIPPED)
        checks.expect(browser.returncode == 0, "an open report follows")
        checks.expect('id="watch"' in page.read_text(), "the watched report follows its mark")
        checks.expect(watch.interrupt() == 130, "Ctrl-C ends it with 130")
        html = page.read_text()
        checks.expect('id="watch"' not in html and "img-src data:;" in html,
                      "the report that is left follows nothing")
        checks.expect(not (watch.out / "report_watch.svg").exists(), "the mark goes")
        plain = watch.folder / "plain.html"
        subprocess.run([clevis, "report", watch.out, "--out", plain], check=True,
                       capture_output=True)
        checks.expect(plain.read_bytes() == page.read_bytes(),
                      "it is the one that `clevis report` writes")
    return checks.exit_code()


def hostile(clevis, _):
    checks = Checks()
    with tempfile.TemporaryDirectory() as folder:
        missing = subprocess.run([clevis, "check", "--watch", Path(folder) / "no.toml"],
                                 capture_output=True, text=True, timeout=PATIENCE)
        checks.expect(missing.returncode == 22 and "I001" in missing.stderr,
                      "a scene that was never there is refused at once")
        for more in ("--json", "--resume"):
            refused = subprocess.run([clevis, "check", "--watch", more, "scene.toml"],
                                     capture_output=True, text=True, timeout=PATIENCE)
            checks.expect(refused.returncode == 2, f"--watch with {more} is refused")
        watch = Watch(clevis, folder, "--report")
        watch.wait(1)
        text = watch.scene.read_text()
        watch.scene.unlink()
        checks.expect("error[I001]" in watch.wait(2), "a deleted scene is told")
        watch.scene.mkdir()
        checks.expect("error[I001]" in watch.wait(3), "a folder in its place too")
        watch.scene.rmdir()
        watch.scene.write_text(text)
        checks.expect("verdict" in watch.wait(4), "its return is noticed")
        shutil.rmtree(watch.out)
        watch.save("safety_factor = 1.5", "safety_factor = 1.7")
        watch.wait(5)
        checks.expect((watch.out / "report.html").is_file(), "a deleted folder is made again")
        shutil.rmtree(watch.out)
        watch.out.write_text("a file")
        watch.save("safety_factor = 1.7", "safety_factor = 1.5")
        checks.expect("error[I002]" in watch.wait(6), "a file in place of the folder is told")
        watch.out.unlink()
        geometry = next(watch.home.glob("*.geo"))
        geometry.write_text("While(1) Endless = 1;\n")
        time.sleep(1.5)  # its mesh is being made
        geometry.write_text("nonsense;\n")
        checks.expect("error[M010]" in watch.wait(7), "a geometry that fails is told")
        checks.expect(watch.interrupt() == 130 and not watch.lives(), "Ctrl-C ends it with 130")
        checks.expect(not list(watch.temporary.iterdir()), "no temporary file is left")
    return checks.exit_code()


def shared(clevis, _):
    """The folder is held by another clevis: the change is not lost."""
    checks = Checks()
    with tempfile.TemporaryDirectory() as folder:
        watch = Watch(clevis, folder)
        watch.wait(1)
        peak = watch.result()["parts"][0]["peak_von_mises"]["value_MPa"]
        with (watch.out / ".lock").open() as lock:
            fcntl.flock(lock, fcntl.LOCK_EX)
            watch.save('thickness = "10 mm"', 'thickness = "5 mm"')
            end = time.monotonic() + PATIENCE
            while "it is waited for" not in watch.text() and time.monotonic() < end:
                time.sleep(0.05)
            time.sleep(SETTLED)
            checks.expect(watch.text().count("it is waited for") == 1 and watch.runs() == 1,
                          "a held folder is told once, and waited for")
            watch.save('thickness = "5 mm"', 'thickness = "4 mm"')
            while watch.text().count("it is waited for") < 2 and time.monotonic() < end:
                time.sleep(0.05)
            checks.expect("given up" in watch.text(), "a change meanwhile begins anew")
        watch.wait(2)
        now = watch.result()["parts"][0]["peak_von_mises"]["value_MPa"]
        checks.expect(abs(now - 2.5 * peak) < 0.2 * peak and "I006" not in watch.text(),
                      f"checked when the folder is free: {peak} {now}")
        checks.expect(watch.interrupt() == 130 and not watch.lives(), "Ctrl-C ends it with 130")
    with tempfile.TemporaryDirectory() as folder:
        watch = Watch(clevis, folder)
        watch.wait(1)
        other = subprocess.Popen(
            [clevis, "check", "--watch", watch.scene, "--out", watch.out, "--tolerance", "10%"],
            stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, start_new_session=True)
        watch.save('thickness = "10 mm"', 'thickness = "5 mm"')
        watch.wait(2)
        time.sleep(SETTLED)
        os.killpg(other.pid, signal.SIGINT)
        told = other.communicate(timeout=PATIENCE)[1]
        checks.expect("I006" not in told + watch.text() and told.count(ENDED) >= 1,
                      f"two watches: neither is refused: {told}")
        watch.interrupt()
    return checks.exit_code()


if __name__ == "__main__":
    clevis, source, what = Path(sys.argv[1]).resolve(), *sys.argv[2:4]
    sys.exit({"run": run, "report": report, "hostile": hostile, "shared": shared}[what](clevis, source))

#!/usr/bin/env python3
"""What the system refuses ends with the documented code, never with 70, a
signal or without end.

    run_environment.py CLEVIS SOURCE_DIR
"""
import os
import resource
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

MEMORY, IO = 21, 22
HANGS = 300  # s


def limited(kind, value):
    """Sets a limit of the process to come."""
    return lambda: resource.setrlimit(kind, (value, value))


class Environment(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.folder = Path(self.temporary.name)
        self.link = SOURCE / "geometry/reference_link/scene.toml"

    def tearDown(self):
        self.temporary.cleanup()

    def run_clevis(self, *arguments, **options):
        return subprocess.run(
            [CLEVIS, *map(str, arguments)], capture_output=True, text=True,
            timeout=HANGS, cwd=options.pop("cwd", self.folder), **options)

    def refused(self, done, exit_code, *words):
        self.assertEqual(done.returncode, exit_code, done.stderr)
        for word in words:
            self.assertIn(word, done.stdout + done.stderr)

    def refused_until_enough(self, arguments, sizes):
        """Refused with the least memory, done with the most [MB], and one or
        the other between: how much threads reserve changes from run to run."""
        codes = []
        for megabytes in sizes:
            done = self.run_clevis(
                *arguments,
                preexec_fn=limited(resource.RLIMIT_AS, megabytes * 10**6))
            if done.returncode != 0:
                self.refused(done, MEMORY, "X002")
            codes.append(done.returncode)
        self.assertEqual(codes[0], MEMORY)
        self.assertEqual(codes[-1], 0)

    def test_little_memory(self):
        """From too little for the libraries to enough."""
        self.refused_until_enough(
            ("check", self.link, "--out", self.folder),
            (60, 100, 150, 200, 220, 240, 260, 280, 300, 330, 350, 370, 390, 400, 600, 2000))

    def test_little_memory_for_a_motion(self):
        self.refused_until_enough(
            ("simulate", SOURCE / "geometry/landing_gear/scene.toml"),
            (40, 50, 60, 70, 80, 100, 120, 150, 200, 300, 1000))

    def test_short_files(self):
        for size in (0, 1000, 100_000):
            with self.subTest(size=size):
                done = self.run_clevis(
                    "check", self.link, "--tolerance", "50%", "--out",
                    self.folder / f"out{size}",
                    preexec_fn=limited(resource.RLIMIT_FSIZE, size))
                self.refused(done, IO, "I002")

    def test_long_names(self):
        for path in ("a" * 300, "/".join(["abcdefgh"] * 600)):
            for command in ("check", "export", "study", "modes", "report"):
                done = self.run_clevis(command, path + ".toml")
                self.refused(done, IO)
            self.refused(self.run_clevis("compare", path, path), IO)

    def test_deleted_working_folder(self):
        # Its name is taken again by nobody; the shell removes what it is in.
        done = subprocess.run(
            ["sh", "-c", 'mkdir gone && cd gone && rmdir ../gone && exec "$@"',
             "sh", CLEVIS, "check", str(self.link)],
            capture_output=True, text=True, timeout=HANGS, cwd=self.folder)
        self.refused(done, IO)

    def test_senseless_thread_counts(self):
        for count in ("0", "abc", ""):
            done = self.run_clevis(
                "check", self.link, "--out", self.folder,
                env=dict(os.environ, DEAL_II_NUM_THREADS=count))
            self.assertEqual(done.returncode, 0, done.stderr)

    def test_killed_worker(self):
        scene = SOURCE / "geometry/landing_gear/scene.toml"
        process = subprocess.Popen(
            [CLEVIS, "check", str(scene), "--part", "AB", "--part", "BC", "--jobs", "1",
             "--out", str(self.folder)], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
            text=True)
        children = Path(f"/proc/{process.pid}/task/{process.pid}/children")
        until = time.monotonic() + HANGS
        while not (workers := children.read_text().split()):
            self.assertIsNone(process.poll(), "it ended without a worker")
            self.assertLess(time.monotonic(), until)
            time.sleep(0.01)
        os.kill(int(workers[0]), signal.SIGKILL)
        out, error = process.communicate(timeout=HANGS)
        self.assertEqual(process.returncode, MEMORY, error)
        self.assertIn("X002", out + error)


if __name__ == "__main__":
    CLEVIS, SOURCE = sys.argv[1], Path(sys.argv[2])
    unittest.main(argv=sys.argv[:1])

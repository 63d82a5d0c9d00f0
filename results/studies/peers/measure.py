"""Programs as processes: what they print, and what they take."""
import os
import resource
import subprocess
import time

THREADS = {"OPENBLAS_NUM_THREADS": "1", "OMP_NUM_THREADS": "1", "MKL_NUM_THREADS": "1"}


class Run:
    """What a process printed, and its seconds."""

    def __init__(self, status, text, errors, user, wall):
        self.status, self.text, self.errors = status, text, errors
        self.user, self.wall = user, wall


def run(command, limit=60, **more):
    """One run of a command, its children counted, on one thread.

    limit: processor seconds that it gets; a run over it has status None.
    """
    def limited():
        resource.setrlimit(resource.RLIMIT_CPU, (limit, limit + 1))

    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    start = time.monotonic()
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True,
                          env=os.environ | THREADS, preexec_fn=limited, **more)
    wall = time.monotonic() - start
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    user = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    return Run(done.returncode if done.returncode >= 0 else None, done.stdout, done.stderr,
               user, wall)


def must(command):
    """Runs what a row needs; its words in the exception where it fails."""
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True)
    if done.returncode != 0:
        raise RuntimeError(f"{' '.join(map(str, command))}: {done.stderr or done.stdout}")


def least(runs):
    """Of equal runs the one of least processor time, with the least wall time."""
    best = min(runs, key=lambda one: one.user)
    best.wall = min(one.wall for one in runs)
    return best

# SPDX-License-Identifier: MIT
"""The timing pass of the study work-precision: CPU seconds (user and system) of the command of every point, apart from the runs that give its errors.

A run that takes longer than SECONDS is stopped there (--max-walltime) and its CPU seconds are scaled by the work that was left: a step or a collision of one run
costs the same anywhere in it. Repeats go round all points, one process at a time, so that a drift of the machine meets all alike.
"""
import json
import os
import shutil
import statistics
import subprocess
import sys
import tempfile
from pathlib import Path

import precision_points as table

SECONDS = 0.4
# A cycle of grains has cheap parts and dear ones, so that a few cycles are timed, by width.
SECONDS_OF_GRAINS = {10: 0.8, 20: 2.0, 28: 3.0}
REPEATS = 10
BUSY = 0.5  # load above which CPU seconds scatter


def timed_commands():
    """{name: (engine, scene, changes, seconds)}: every point of the continuum that is drawn, and one MD run of each width."""
    drawn = [p for key in table.CURVES for p in table.curve(*key)] + table.model_points()
    commands = {p.name: ("continuum", p.scene, p.changes, SECONDS) for p in drawn}
    for width, (_, seeds, cycles) in table.WIDTHS.items():
        commands[f"md_{width}_s{seeds[0]}"] = ("md", table.CELL["ch4_shock"], table.grains(width, seeds[0], cycles), SECONDS_OF_GRAINS[width])
    return commands


def once(study, engine, scene, changes, seconds, folder):
    """CPU seconds of one run, and the work it got through; None for all of it."""
    words = [word for change in changes for word in ("--set", change)]
    command = [study.shaken, engine, study.root / scene, *words, "--quiet", "--overwrite", "--out", folder, "--max-walltime", seconds]
    child = subprocess.Popen(list(map(str, command)), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, env=os.environ | {"OMP_NUM_THREADS": "1"})
    _, status, used = os.wait4(child.pid, 0)
    child.returncode = os.waitstatus_to_exitcode(status)
    cpu = used.ru_utime + used.ru_stime
    if child.returncode != 75:
        return cpu, None
    said = json.loads((Path(folder) / f"{engine}.status.json").read_text())
    return cpu, said["rate"] * said["elapsed_seconds"]


def make(study, fresh=False):
    """Fills OUT/HASH/timings.json: {name: [[CPU seconds, work or null], ...]}, and goes on where it was cut."""
    path = study.folder / "timings.json"
    repeats = int(os.environ.get("REPEATS", REPEATS))
    timings = {} if fresh else study.timings()
    commands = timed_commands()
    missing = [(n, name) for n in range(repeats) for name in commands if len(timings.get(name, [])) <= n]
    if missing and os.getloadavg()[0] > BUSY:
        print(f"work-precision: the machine is busy (load {os.getloadavg()[0]:.1f}), CPU seconds will scatter; "
              "time again when it is quiet with: scripts/reproduce work-precision --figure timings", file=sys.stderr)
    folder = tempfile.mkdtemp(prefix="shaken_timing_")
    try:
        for n, name in missing:
            timings.setdefault(name, []).append(once(study, *commands[name], folder))
            if name == list(commands)[-1]:
                path.write_text(json.dumps(timings, indent=1) + "\n")
    finally:
        path.write_text(json.dumps(timings, indent=1) + "\n")
        shutil.rmtree(folder, ignore_errors=True)
    return timings


def cost_of(repeats, whole, wanted=None):
    """Median, tenth and ninetieth percentile of CPU seconds. whole: the work of the timed run, in what the program counts of its progress (steps of the
    continuum, collisions of the MD), nothing if it failed: the seconds are then those until it did; wanted: the work to be paid for, if not all of it."""
    if not repeats:
        return {}
    seconds = [cpu * (wanted or whole) / (done or whole) if whole else cpu for cpu, done in repeats]
    tenths = statistics.quantiles(seconds, n=10, method="inclusive") if len(seconds) > 1 else seconds * 9
    return {"cpu_seconds": statistics.median(seconds), "cpu_low": tenths[0], "cpu_high": tenths[-1]}

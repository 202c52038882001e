# SPDX-License-Identifier: MIT
"""The stability maps: where each method lives and dies, and how it ends. Some thousand short runs, a table, two figures.

Not Snakemake's work: a run takes a second, and every way to end is a result.
"""
import hashlib
import pathlib
import shutil
import subprocess

import changed
import probe
import stability_points
import stability_table
import workflow

FIGURES = {"figure_stability_continuum": {}, "figure_stability_md": {}}


def make(root, out, figures, jobs, dry_run, command):
    """The points that are not there yet, OUT/stability.csv, and the figures; 1 where a point ends in a way that it must not."""
    shaken = workflow.executable(root)
    if shaken is None:
        return 66
    out = pathlib.Path(out).resolve()
    table = [root / "scripts/workflow/stability_table.py", root, shaken, out, jobs, *(["--dry-run"] if dry_run else [])]
    code = run(table)
    if dry_run or code not in (0, 1):
        return code
    return max([code, *(run([root / f"scripts/figures/{name}.py", out]) for name in figures or FIGURES)])


def run(words):
    return subprocess.run(["/usr/bin/python3", "-B", *map(str, words)], check=False).returncode


def kept(_root):
    """A part for each map."""
    maps = {}
    for point in stability_points.points():
        maps.setdefault(point.map, []).append(point)
    return [changed.Part(f"map {name}", "stability", [run_of(run) for run in stability_table.runs_of(points)]) for name, points in maps.items()]


def run_of(run):
    return probe.Run(run.engine, f"data/scenes/{run.scene}.toml", run.changes)


def remake(today, _parts):
    """The whole table, seven minutes of processor time; of one program, so that a cut remake goes on and no run of another is taken for its own."""
    out = today.out / hashlib.sha1(today.shaken.read_bytes()).hexdigest()[:12]
    code = make(today.root, out, [], today.jobs, False, today.command)
    if code:
        return code
    shutil.copy(out / "stability.csv", today.root / "data/expected/stability.csv")
    for part in kept(today.root):
        today.stamps(part).record(part.runs)
    return 0

# SPDX-License-Identifier: MIT
"""The stability maps: where each method lives and dies, and how it ends. Some thousand short runs, a table, two figures.

Not Snakemake's work: a run takes a second, and every way to end is a result.
"""
import pathlib
import subprocess

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

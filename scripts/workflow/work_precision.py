# SPDX-License-Identifier: MIT
"""The study work-precision: speed against accuracy, in three charts that are never mixed: error of the continuum's discretisation, statistical error of the MD,
error of the model. A fourth shows the timings that the charts rest on; asked for by name (--figure timings) it takes them anew and draws what was drawn again.
A fifth has the three in small.

Runs give the errors, once (OUT/HASH, kept for the program of that git hash); the timing pass runs the commands again, one at a time, ten times each.
Leaves OUT/work_precision.csv, the rows of data/expected/work_precision.csv, and OUT/summary.md, the tables of docs/work_precision.md.
"""
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import changed
import precision_continuum
import precision_grains
import precision_model
import precision_points
import precision_summary
import precision_timings
import workflow
from precision_study import Study, read_rows, write_rows

CONTINUUM = ("ch4_shock", "stripes", "riemann", "wave")
# Figure: the studies it draws, and the function that makes their rows.
FIGURES = {
    "figure_discretisation": (CONTINUUM, precision_continuum.rows),
    "figure_statistics": (("md",), precision_grains.rows),
    "figure_model": (("model",), precision_model.rows),
    "figure_timings": ((), None),
    "figure_overview": ((), None),
}


def needs(figure, runs, comparisons):
    """The runs and comparisons behind a figure."""
    def is_needed(name):
        continuum = name.startswith(CONTINUUM) or name.startswith("md_partner")
        grains = name.startswith(("md_", "continuum_"))
        return {"figure_discretisation": continuum, "figure_statistics": grains}.get(figure, figure == "figure_model")
    return {n: r for n, r in runs.items() if is_needed(n)}, {n: c for n, c in comparisons.items() if is_needed(n)}


def git_hash(shaken):
    said = subprocess.run([shaken, "--version"], capture_output=True, text=True, check=True).stdout
    return re.search(r"\((\S+)\)", said)[1]


def make(root, out, figures, jobs, dry_run, command):
    """The study, or the named figures of it; Snakemake's exit code, 66 where the program is missing."""
    shaken = Path(os.environ.get("SHAKEN", root / "build" / "release" / "shaken"))
    if not shaken.is_file():
        print(f"{shaken} is not there; make it with: scripts/build (or name another in SHAKEN)", file=sys.stderr)
        return 66
    out = (root / out).resolve()
    if figures and not (out / "work_precision.csv").is_file() and not any(FIGURES[name][0] for name in figures):
        print(f"{out / 'work_precision.csv'} is not there: {', '.join(figures)} draws what the others leave; make them with: scripts/reproduce work-precision", file=sys.stderr)
        return 66
    study = Study(root, out, out / git_hash(shaken), shaken, jobs)
    retime = "figure_timings" in figures
    wanted = {name: FIGURES[name] for name in FIGURES if not figures or name in figures or (retime and is_made(out, name))}
    os.environ["OMP_NUM_THREADS"] = "1"
    runs, comparisons = {}, {}
    for name in wanted:
        more = needs(name, precision_points.workflow_runs(), precision_points.workflow_comparisons())
        runs |= more[0]
        comparisons |= more[1]
    if runs:
        code = workflow.make(root, study.folder, {"runs": runs, "comparisons": comparisons, "figures": {}}, jobs, dry_run)
        if code or dry_run:
            return code
    study.folder.mkdir(parents=True, exist_ok=True)
    precision_timings.make(study, fresh=retime)
    table = out / "work_precision.csv"
    for studies, rows_of in wanted.values():
        if rows_of:
            kept = [r for r in read_rows(table, as_written=True) if r["study"] not in studies] if table.is_file() else []
            write_rows(table, kept + rows_of(study))
    (out / "summary.md").write_text(precision_summary.text(read_rows(table)))
    return draw(study, list(wanted), command)


def is_made(out, figure):
    return (out / "figures" / f"{figure}.png").is_file()


def draw(study, figures, command):
    for name in figures:
        script = [study.root / "scripts/figures" / f"{name}.py", study.out, study.folder / "timings.json", study.shaken, command]
        code = subprocess.run(["/usr/bin/python3", "-B", *map(str, script)], check=False).returncode
        if code:
            return code
    return 0


EXPECTED = "data/expected/work_precision.csv"


def kept(_root):
    """A part for each chart that runs are behind."""
    runs, comparisons = precision_points.workflow_runs(), precision_points.workflow_comparisons()
    return [changed.Part(name, "work_precision", [changed.run_of(runs, run, profiles=True) for run in needs(name, runs, comparisons)[0]])
            for name, (studies, _) in FIGURES.items() if studies]


def remake(today, parts):
    """The stale charts, all their runs by one program (OUT/HASH), and the rows that are kept of them; rows of other charts stay."""
    table = today.out / "work_precision.csv"
    today.out.mkdir(parents=True, exist_ok=True)
    shutil.copy(today.root / EXPECTED, table)
    code = make(today.root, today.out, [*(part.name for part in parts), "figure_overview"], today.jobs, False, today.command)
    if code:
        return code
    shutil.copy(table, today.root / EXPECTED)
    for part in parts:
        today.stamps(part).record(part.runs)
    return 0

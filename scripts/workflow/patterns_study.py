# SPDX-License-Identifier: MIT
"""What chapters 5 and 6 share: fill the rows that figures need, make their runs, draw them, and write the report; and what of it is stale."""
import os
import pathlib
import re
import subprocess

import changed
import probe
import rows
import workflow


def make(root, out, all_figures, runs, figures, jobs, dry_run, command, title, makers=()):
    """figures: names asked for; all that are not long when empty. makers: {name of a file under `out`: maker(root, out)}. An exit code."""
    wanted = {name: needs for name, needs in all_figures.items() if name in figures or not (figures or needs.get("long"))}
    tables = [(root / table, planned) for needs in wanted.values() for table, planned in needs.get("rows", [])]
    shaken = os.environ.get("SHAKEN", str(root / "build/release/shaken"))
    for table, planned in tables:
        lacking = rows.missing(table, planned)
        print(f"{table.relative_to(root)}: {len(planned) - len(lacking)} rows of {len(planned)} are there", flush=True)
        if dry_run:
            print("".join(f"  lacking: {row.command}\n" for row in lacking), end="")
        elif os.environ.get("ROWS") != "kept":
            os.chdir(root)  # rows name their scenes from there
            code = rows.fill(table, planned, shaken, pathlib.Path(out).resolve() / "rows")
            if code:
                return code
    # The tables are inputs of a figure: one more row, and it is drawn again. What a maker makes is not there yet in a dry run.
    drawn = {name: {"runs": needs.get("runs", []),
                    "files": [str(root / table) for table, _ in needs.get("rows", []) if (root / table).is_file()]
                    + [str(pathlib.Path(out).resolve() / made) for made in needs.get("files", []) if not dry_run]}
             for name, needs in wanted.items()}
    for made in dict.fromkeys(file for needs in wanted.values() for file in needs.get("files", []) if not dry_run):
        makers[made](root, out)
    code = workflow.make(root, out, workflow.select(runs, {}, drawn, everything=False), jobs, dry_run)
    if code or dry_run:
        return code
    report = [root / "scripts/figures/chapter_report.py", out, command, title]
    return subprocess.run(["/usr/bin/python3", "-B", *map(str, report)], check=False).returncode


def tables_of(all_figures):
    return {table: planned for needs in all_figures.values() for table, planned in needs.get("rows", [])}


def run_of(row, runs):
    """Of a row; `runs`, of the study, have the run whose file it starts from."""
    start = next((re.search(r"runs/([^/]+)/", setting)[1] for setting in row.settings if setting.startswith("initial.file=")), None)
    return probe.Run(row.engine, row.scene, tuple(row.settings), start=changed.run_of(runs, start, profiles=False) if start else None)


def kept(root, study, all_figures, runs):
    """A part for each table of rows and for each figure of runs that is not long."""
    parts = []
    for table, planned in tables_of(all_figures).items():
        there = dict.fromkeys(row["command"] for row in rows.read(root / table))
        wanted = {row.command for row in planned}
        past = tuple(command for command in there if command not in wanted)
        name, made = pathlib.Path(table), [run_of(row, runs) for row in planned]
        parts.append(changed.Part(name.name, name.stem, made, frozenset(wanted - set(there)), past))
    for name, needs in all_figures.items():
        if needs.get("runs") and not needs.get("long"):
            parts.append(changed.Part(name, f"{study}_figures", [changed.run_of(runs, run, profiles=False) for run in needs["runs"]]))
    return parts


class Renewal:
    """Rows of one table that are made anew, each stamped when it is there."""

    def __init__(self, today, part, runs):
        self._stamps, self._runs = today.stamps(part), runs

    def is_stale(self, row):
        return bool(self._stamps.why_stale(run_of(row, self._runs)))

    def prepare(self, folder, row):
        self._stamps.prepare(folder, run_of(row, self._runs))

    def made(self, row):
        self._stamps.record([run_of(row, self._runs)])


def remake(today, parts, all_figures, runs, make_figures):
    """The stale rows, then the figures that are drawn from them or from stale runs."""
    names = {part.name: part for part in parts}
    for table, planned in tables_of(all_figures).items():
        part = names.get(pathlib.Path(table).name)
        if part is None:
            continue
        for command in part.past:
            rows.remove(today.root / table, command)
        code = rows.fill(today.root / table, planned, str(today.shaken), today.out / "rows", Renewal(today, part, runs))
        if code:
            return code
        today.stamps(part).forget(part.runs)
    figures = [name for name, needs in all_figures.items()
               if not needs.get("long") and (name in names or any(pathlib.Path(table).name in names for table, _ in needs.get("rows", [])))]
    drawn = [part for part in parts if part.name in all_figures]
    if drawn:
        behind = [run for part in drawn for run in all_figures[part.name]["runs"]]
        changed.prepare(today.stamps(drawn[0]), today.out, runs, behind, profiles=False)
    code = make_figures(today.root, today.out, figures, today.jobs, False, today.command)
    for part in [] if code else drawn:
        today.stamps(part).record(part.runs)
    return code

# SPDX-License-Identifier: MIT
"""scripts/reproduce STUDY --changed: which runs behind what is kept are stale, and those made again.

A study says with kept() what it keeps, as parts, and makes the stale ones of them with remake(). Stamps are written as runs are
made, so that a cut remake goes on where it was.
"""
import collections
import dataclasses
import os
import pathlib
import shutil

import probe
import workflow
from stamps import Stamps, with_starts


@dataclasses.dataclass
class Part:
    """What is kept together: its name, the file of its stamps, and the runs behind it. lacking: commands of which there is no row;
    past: rows that nobody asks for any more; files: what it reads beside the runs."""
    name: str
    stamps: str
    runs: list
    lacking: frozenset = frozenset()
    past: tuple = ()
    files: tuple = ()


@dataclasses.dataclass
class Today:
    """Where a study is made again, and what the program of today says."""
    root: pathlib.Path
    out: pathlib.Path
    shaken: pathlib.Path
    jobs: int
    command: str
    prober: probe.Prober

    def stamps(self, part):
        return Stamps(self.root, part.stamps, self.prober)

    def why_stale(self, part):
        """{run: why}"""
        stamps = self.stamps(part)
        files = stamps.why_files(part.files)
        found = {run: "lacking" if run.command in part.lacking else stamps.why_stale(run) or files for run in part.runs}
        return {run: why for run, why in found.items() if why}


def make(root, studies, out, jobs, dry_run, command, record=False):
    """Lists what is stale of {name: module} and, unless dry_run, makes it; an exit code. record: in place of that, what
    has no stamp gets one, as made by today's program."""
    shaken = workflow.executable(root)
    if shaken is None:
        return 66
    os.chdir(root)
    prober = probe.Prober(root, shaken, root / "out/probes", jobs)
    stale = {}
    for name, study in studies.items():
        today = Today(root, (root / (out or f"out/{name}")).resolve(), shaken, jobs, command, prober)
        parts = study.kept(root)
        prober.fill(prober.text, [run for part in parts for run in with_starts(part.runs)])
        # Where the scene says enough no probe is made.
        wanted = Stamps.lacks if record else Stamps.asks_a_probe
        asked = [run for part in parts for run in with_starts(part.runs) if wanted(today.stamps(part), run)]
        prober.fill(prober.numbers, asked)
        if record:
            for part in parts:
                stamps = today.stamps(part)
                stamps.record([run for run in part.runs if stamps.lacks(run)], part.files)
            continue
        stale[name] = {part.name: today.why_stale(part) for part in parts}
        show(name, parts, stale[name])
    if dry_run or record:
        return 0
    code = 0
    for name, study in studies.items():
        today = Today(root, (root / (out or f"out/{name}")).resolve(), shaken, jobs, command, prober)
        wanted = [part for part in study.kept(root) if stale[name][part.name] or part.past]
        code = max(code, study.remake(today, wanted) if wanted else 0)
    return code


def show(study, parts, stale):
    """A line for each file of stamps, engine and reason; one for all that is fresh."""
    fresh = [part for part in parts if not stale[part.name] and not part.past]
    if fresh:
        runs = {run for part in fresh for run in part.runs}
        print(f"{study:15} {f'{len(fresh)} of {len(parts)} kept':28} fresh   {f'{len(runs)} runs':10}", flush=True)
    for name, together in grouped(parts).items():
        runs = {run for part in together for run in part.runs}
        reasons = {run: why for part in together for run, why in stale[part.name].items()}
        number = sum(bool(stale[part.name]) for part in together)
        title = together[0].name if len(together) == 1 else f"{name}, {number} of {len(together)} parts"
        engines = collections.Counter(run.engine for run in runs)
        for (engine, why), count in sorted(collections.Counter((run.engine, why) for run, why in reasons.items()).items()):
            print(f"{study:15} {title:28} stale   {engine:10} {count:4} of {engines[engine]:4}: {why}", flush=True)
    for part in parts:
        if part.past:
            print(f"{study:15} {part.name:28} past    {len(part.past)} rows that are no longer asked for", flush=True)


def grouped(parts):
    """{file of stamps: parts}"""
    found = {}
    for part in parts:
        found.setdefault(part.stamps, []).append(part)
    return found


def run_of(runs, name, profiles):
    """A run of a study's {name: run} (workflow/Snakefile) as it is stamped."""
    run = runs[name]
    start = run_of(runs, run["start"], profiles) if run.get("start") else None
    return probe.Run(run["engine"], run["scene"], tuple(run["changes"]), profiles, start)


def prepare(stamps, out, runs, names, profiles):
    """Empties the folders of runs of which today's program makes something else, and of those that start from one."""
    emptied = {}

    def is_emptied(name):
        if name not in emptied:
            start, folder = runs[name].get("start"), pathlib.Path(out) / "runs" / name
            if start and is_emptied(start):
                shutil.rmtree(folder, ignore_errors=True)
            emptied[name] = stamps.prepare(folder, run_of(runs, name, profiles))
        return emptied[name]

    for name in names:
        is_emptied(name)

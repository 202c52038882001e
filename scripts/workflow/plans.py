# SPDX-License-Identifier: MIT
"""The study plans: what `shaken plan` foretells against what is then found (scripts/check_plans.py)."""
import hashlib
import pathlib
import subprocess
import sys

import changed
import probe

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
import check_plans

FIGURES = {}


def make(root, out, _figures, _jobs, dry_run, _command, names=()):
    """The rows of these scenes, or of all; an exit code."""
    if dry_run:
        print(f"plans: {', '.join(check_plans.SCENES)}")
        return 0
    words = [root / "scripts/check_plans.py", "--out", out, *(["--only", *names] if names else [])]
    return subprocess.run(["/usr/bin/python3", "-B", *map(str, words)], check=False).returncode


def kept(_root):
    """A part for each scene. The planner's table of measured errors is built into the program."""
    def runs(scene, settings):
        return [probe.Run(engine, f"data/scenes/{scene}.toml", settings) for engine in ("md", "continuum")]
    files = ("data/expected/work_precision.csv",)
    return [changed.Part(name, "plans", runs(*scene[:2]), files=files) for name, scene in check_plans.SCENES.items()]


def remake(today, parts):
    """The stale scenes; all of one program."""
    out = today.out / hashlib.sha1(today.shaken.read_bytes()).hexdigest()[:12]
    code = make(today.root, out, [], today.jobs, False, today.command, [part.name for part in parts])
    for part in [] if code else parts:
        today.stamps(part).record(part.runs, part.files)
    return code

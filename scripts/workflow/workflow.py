# SPDX-License-Identifier: MIT
"""Writes the configuration of workflow/Snakefile and calls Snakemake."""
import json
import os
import pathlib
import shutil
import subprocess
import sys


def select(runs, comparisons, figures, everything):
    """What the figures need of all that there is, or all of it."""
    if everything:
        return {"runs": runs, "comparisons": comparisons, "figures": figures}
    wanted = {name for needs in figures.values() for name in needs.get("comparisons", [])}
    compared = {name: comparison for name, comparison in comparisons.items() if name in wanted}
    names = {run for needs in figures.values() for run in needs.get("runs", [])}
    for comparison in compared.values():
        names |= {*comparison["md"], comparison["continuum"]}
    names |= {runs[name]["start"] for name in names if runs[name].get("start")}
    return {"runs": {name: run for name, run in runs.items() if name in names}, "comparisons": compared, "figures": figures}


def executable(root):
    """Where shaken is; None, and a sentence on where it comes from, if it is not there."""
    shaken = pathlib.Path(os.environ.get("SHAKEN", root / "build" / "release" / "shaken"))
    if shaken.is_file():
        return shaken
    print(f"{shaken} is not there; make it with: scripts/build (or name another in SHAKEN)", file=sys.stderr)
    return None


def make(root, out, config, jobs, dry_run=False, more=()):
    """Snakemake's exit code; 66 where a program is missing, with a sentence on where it comes from."""
    shaken = executable(root)
    if shaken is None:
        return 66
    if not shutil.which("snakemake") and subprocess.run([root / "scripts/setup", "scripts/packages_studies.txt"], check=False).returncode:
        return 66
    out = pathlib.Path(out).resolve()
    out.mkdir(parents=True, exist_ok=True)
    path = out / "workflow.json"
    runs = {name: run | {"scene": str(root / run["scene"])} for name, run in config["runs"].items()}
    config = {"shaken": str(shaken), "scripts": str(root / "scripts"), "out": str(out)} | config | {"runs": runs}
    path.write_text(json.dumps(config, indent=1) + "\n")
    # Not the code: a line moved in the Snakefile remakes no run.
    command = ["snakemake", "--snakefile", str(root / "scripts/workflow/Snakefile"), "--configfile", str(path), "--directory", str(out),
               "--cores", str(jobs), "--rerun-triggers", "mtime", "params", "--rerun-incomplete", "--keep-going", "--quiet",
               *(["--dry-run"] if dry_run else []), *more]
    return subprocess.run(command, check=False).returncode

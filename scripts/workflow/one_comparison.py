#!/usr/bin/env python3
"""`shaken compare` of the runs that ended well: one_comparison.py SHAKEN DIR [--md RUN ...] --continuum RUN [--first-cycle]

MD runs that failed of their own physics are left out and named in summary.json under "failed"; where none is left, or the continuum
failed, summary.json holds nothing else.
"""
import json
import pathlib
import subprocess
import sys


def main():
    if len(sys.argv) < 4:
        print(__doc__, file=sys.stderr)
        return 2
    shaken, folder, *words = sys.argv[1:]
    folder = pathlib.Path(folder)
    arguments, failed, has_md, has_continuum = [], [], False, False
    while words:
        word = words.pop(0)
        if word not in ("--md", "--continuum"):
            arguments.append(word)
            continue
        run = words.pop(0)
        end = json.loads((pathlib.Path(run) / f"{word[2:]}.end.json").read_text())
        if end["exit_code"] != 0:
            failed.append({"run": run, "cycle": end["cycle"], "said": end["said"]})
            continue
        arguments += [word, run]
        has_md = has_md or word == "--md"
        has_continuum = has_continuum or word == "--continuum"
    path = folder / "summary.json"
    summary = {}
    if has_md and has_continuum:
        done = subprocess.run([shaken, "compare", str(folder), *arguments], stdout=subprocess.DEVNULL)
        if done.returncode:
            return done.returncode
        summary = json.loads(path.read_text())
    folder.mkdir(parents=True, exist_ok=True)
    path.write_text(json.dumps(summary | {"failed": failed}, indent=2) + "\n")
    return 0


if __name__ == "__main__":
    sys.exit(main())

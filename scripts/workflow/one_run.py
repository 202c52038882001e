#!/usr/bin/env python3
"""One run of one engine, taken up where it was cut: one_run.py SHAKEN ENGINE DIR SCENE [SECTION.KEY=VALUE ...]

Leaves DIR/ENGINE.end.json: exit code, what was said last, seconds of wall clock, and the cycle reached. A run that fails of its
own physics (exit code 1, inelastic collapse) is a result and ends well here; a wrong scene, a full disk or a stop do not.
"""
import json
import pathlib
import subprocess
import sys
import time

PHYSICS_FAILED = 1


def main():
    if len(sys.argv) < 5:
        print(__doc__, file=sys.stderr)
        return 2
    shaken, engine, folder, scene, *changes = sys.argv[1:]
    folder = pathlib.Path(folder)
    sets = [word for change in changes for word in ("--set", change)]
    described = subprocess.run([shaken, "scene", scene, *sets], capture_output=True, text=True)
    if described.returncode:
        print(described.stderr, end="", file=sys.stderr)
        return described.returncode
    if is_cut(folder, engine, described.stdout):
        command = [shaken, engine, "--quiet", "--resume", str(folder)]
    else:
        command = [shaken, engine, scene, *sets, "--quiet", "--overwrite", "--out", str(folder)]
    begin = time.monotonic()
    run = subprocess.run(command, capture_output=True, text=True)
    seconds = time.monotonic() - begin
    if run.returncode not in (0, PHYSICS_FAILED):
        print(run.stderr, end="", file=sys.stderr)
        return run.returncode
    end = {"engine": engine, "exit_code": run.returncode, "said": (run.stderr or run.stdout).strip().splitlines()[-1:],
           "seconds": round(seconds, 2), "cycle": status(folder, engine).get("cycle"), "changes": changes}
    aside = folder / f"{engine}.end.json.part"
    aside.write_text(json.dumps(end, indent=1) + "\n")
    aside.rename(folder / f"{engine}.end.json")
    return 0


def is_cut(folder, engine, scene):
    """Whether the folder holds a checkpoint of just this scene."""
    written = folder / "scene.toml"
    return (folder / f"{engine}.checkpoint").is_file() and written.is_file() and written.read_text() == scene


def status(folder, engine):
    path = folder / f"{engine}.status.json"
    return json.loads(path.read_text()) if path.is_file() else {}


if __name__ == "__main__":
    sys.exit(main())

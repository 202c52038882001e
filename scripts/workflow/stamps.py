# SPDX-License-Identifier: MIT
"""Stamps: with what each kept run was made, so that a later program can say which are stale.

data/expected/stamps/NAME.json, one a table, has for each command the resolved scene (as what departs from the scene's own)
and the numbers of its probe (probe.py). A run is stale when a key that it reads has another value than on the stamp, when its
probe gives other numbers, when the run it starts from is stale, or when it has no stamp. A key that is new or gone says nothing
by itself, nor does "auto" that has become a value: what it does, the probe shows.
"""
import hashlib
import json
import pathlib
import shutil

import probe

FOLDER = "data/expected/stamps"
# Keys that an engine does not read. The bins of profiles reach as high as the continuum's lid.
UNREAD = {"md": ("scene.name", "continuum."), "continuum": ("scene.name", "md.", "box.ceiling")}
LID = "continuum.lid"


def reads(run, key):
    return not key.startswith(UNREAD[run.engine]) or run.profiles and run.engine == "md" and key == LID


def with_starts(runs):
    """They and the runs that they start from."""
    found = list(dict.fromkeys(runs))
    for run in found:
        if run.start and run.start not in found:
            found.append(run.start)
    return found


class Stamps:
    """The stamps of one table, or of the figures of one study."""

    def __init__(self, root, name, prober):
        self._root, self._path, self._prober = pathlib.Path(root), pathlib.Path(root) / FOLDER / f"{name}.json", prober
        self._kept = json.loads(self._path.read_text()) if self._path.is_file() else {"scenes": {}, "probes": {}, "runs": {}}

    def why_stale(self, run):
        """In a few words; nothing of a run that is not stale."""
        stamp = self._kept["runs"].get(run.command)
        if stamp is None:
            return "no stamp"
        scene, numbers = self._kept["scenes"][stamp["scene"]] | stamp["departs"], self._kept["probes"][stamp["probe"]]
        return self._moved(run, scene, numbers) or ("it starts from a stale run" if run.start and self.why_stale(run.start) else "")

    def prepare(self, folder, run):
        """Empties a folder unless it holds just this run by a program that makes the same of it, be it cut; it then goes on."""
        folder = pathlib.Path(folder)
        known = folder / "stamp.json"
        if known.is_file():
            stamp = json.loads(known.read_text())
            if stamp["command"] == run.command and not self._moved(run, stamp["scene"], stamp["probe"]):
                return False
        elif (folder / f"{run.engine}.end.json").is_file() and not self.why_stale(run):
            return False
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir(parents=True)
        known.write_text(json.dumps({"command": run.command, "scene": self._prober.text(run), "probe": self._prober.numbers(run)}) + "\n")
        return True

    def asks_a_probe(self, run):
        """Whether its scene is that of its stamp."""
        stamp = self._kept["runs"].get(run.command)
        return stamp is not None and not self._moved_keys(run, self._kept["scenes"][stamp["scene"]] | stamp["departs"])

    def _moved(self, run, scene, numbers):
        return self._moved_keys(run, scene) or ("its probe differs" if probe.differing(numbers, self._prober.numbers(run)) else "")

    def _moved_keys(self, run, scene):
        now = self._prober.text(run)
        if "refused" in now:
            return "" if "refused" in scene else "today the scene is refused"
        moved = [key for key in scene if key in now and scene[key] not in (now[key], "auto") and reads(run, key)]
        return ", ".join(f"{key} {scene[key]} -> {now[key]}" for key in moved)

    def lacks(self, run):
        return run.command not in self._kept["runs"]

    def why_files(self, files):
        moved = [file for file in files if self._kept.get("files", {}).get(file) != self._digest(file)]
        return ", ".join(moved) + " is another" if moved else ""

    def _digest(self, file):
        return hashlib.sha1((self._root / file).read_bytes()).hexdigest()

    def record(self, runs, files=()):
        """These are made by today's program, and from these files."""
        if files:
            self._kept["files"] = {file: self._digest(file) for file in files}
        for run in with_starts(runs):
            scene = self._prober.text(probe.Run(run.engine, run.scene, ()))
            departs = {key: value for key, value in self._prober.text(run).items() if scene.get(key) != value}
            self._kept["runs"][run.command] = {"program": self._prober.program, "scene": self._id("scenes", scene), "departs": departs,
                                               "probe": self._id("probes", self._prober.numbers(run))}
        self._write()

    def forget(self, wanted):
        """Drops the stamps of what is no longer asked for."""
        commands = {run.command for run in with_starts(wanted)}
        self._kept["runs"] = {command: stamp for command, stamp in self._kept["runs"].items() if command in commands}
        self._write()

    def _id(self, what, values):
        name = hashlib.sha1(json.dumps(values, sort_keys=True).encode()).hexdigest()[:8]
        self._kept[what][name] = values
        return name

    def _write(self):
        used = self._kept["runs"].values()
        for what, key in (("scenes", "scene"), ("probes", "probe")):
            names = {stamp[key] for stamp in used}
            self._kept[what] = {name: values for name, values in self._kept[what].items() if name in names}
        # A line a run, so that a change of one is a change of one line.
        def lines(table):
            return ",\n".join(f"{json.dumps(name)}: {json.dumps(values)}" for name, values in sorted(table.items()))
        parts = [f'"{what}": {{\n{lines(table)}\n}}' for what, table in self._kept.items()]
        self._path.parent.mkdir(parents=True, exist_ok=True)
        aside = self._path.with_suffix(".part")
        aside.write_text("{" + ",\n".join(parts) + "}\n")
        aside.rename(self._path)

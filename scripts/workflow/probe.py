# SPDX-License-Identifier: MIT
"""What a run reads, found out cheaply: the text of its scene as `shaken scene` resolves it, and the numbers of a probe.

A probe is one cycle of the same scene with the same choices on a coarse grid or in a small box: a second, and the same numbers
from every compiler. Numbers, not the state's hash: a change of the last bit is no reason to make hours of runs again. What the
continuum has at the end of the cycle is good to six digits; of grains only the first tenth of it is, since a difference of 1e-16
grows to 3e-6 by ft = 0.2 (two runs of ch4_shock whose initial temperatures differ by one unit in the last place).
"""
import concurrent.futures
import csv
import dataclasses
import hashlib
import json
import os
import pathlib
import subprocess
import tempfile
import tomllib

import h5py
import numpy as np

SAME = 1e-6            # relative difference of two numbers that count as one
ROUND_OFF = 1e-9       # of the largest number of a probe: what is less is a sum that cancels
GRAINS_UNTIL = 2       # sample of an MD probe that is looked at, of twenty a cycle
SPACING, COLUMNS, SIDE, MOST_SECONDS = 0.4, 12, 10.0, 20
LENGTH = {"layer": ("sample.settle=0", "sample.average=1", "sample.phases=20", "sample.frames=0", "sample.frame_cycles=1"),
          "uniform": ("sample.settle=0", "sample.duration=2", "sample.interval=0.25")}
LEFT_OUT = ("sample.", "md.seed=", "initial.seed=", "initial.file=", "initial.phase=", "continuum.spacing")  # of a layer's or a gas's own settings


@dataclasses.dataclass(frozen=True)
class Run:
    """A run behind something kept. profiles: its bins are compared, so that it reads how high they go; start: the run whose last
    state it begins with."""
    engine: str
    scene: str
    settings: tuple
    profiles: bool = False
    start: "Run | None" = None

    @property
    def command(self):
        return " ".join(["shaken", self.engine, self.scene, *(f"--set {setting}" for setting in self.settings)])


class Prober:
    """Texts and probes of one program, kept in `folder` by what the program and the scene files hold."""

    def __init__(self, root, shaken, folder, jobs=2):
        self._root, self._shaken, self._jobs = pathlib.Path(root), str(shaken), jobs
        self._kept = pathlib.Path(folder) / f"{hashlib.sha1(pathlib.Path(shaken).read_bytes()).hexdigest()[:12]}.json"
        self._known = json.loads(self._kept.read_text()) if self._kept.is_file() else {}
        said = subprocess.run([self._shaken, "--version"], capture_output=True, text=True, check=True).stdout
        self.program = said.partition("(")[2].partition(")")[0] or said.strip()

    def fill(self, ask, runs):
        """text or numbers of all runs, `jobs` at a time."""
        with concurrent.futures.ThreadPoolExecutor(self._jobs) as pool:
            list(pool.map(ask, dict.fromkeys(runs)))
        self._keep()

    def text(self, run):
        """{section.key: value} of the resolved scene, or {"refused": sentence}."""
        settings = tuple(setting for setting in run.settings if not setting.startswith("initial.file="))
        return self._once(["scene", run.scene, *settings], lambda: self._text(run.scene, settings))

    def numbers(self, run):
        """{observable: number} of the run's probe, or {"end": how it ended} of one that fails."""
        changes = self.settings(run)
        if changes is None:
            return {"end": "refused"}
        return self._once([run.engine, run.scene, *changes], lambda: self._numbers(run.engine, run.scene, changes))

    def settings(self, run):
        """Those of its probe; None where the scene is refused."""
        text = self.text(run)
        if "refused" in text:
            return None
        kind = text["scene.kind"]
        if kind not in LENGTH:  # a tube: short as it is
            return tuple(s for s in run.settings if not s.startswith("continuum.spacing=") or self._is_coarse(run, s))
        changes = [*(s for s in run.settings if not s.startswith(LEFT_OUT)), *LENGTH[kind]]
        if kind == "uniform":
            return tuple(changes + ["particles.number=256"] * (run.engine == "md"))
        if run.engine == "continuum":
            spacing, across = text["continuum.spacing"], text.get("continuum.spacing_horizontal", 0)
            return tuple(changes + [f"continuum.spacing={max(spacing, SPACING):g}",
                                    f"continuum.spacing_horizontal={max(across, text['box.x'] / COLUMNS):g}"])
        area = text["box.x"] * text["box.y"]
        if area > SIDE**2:
            changes = [s for s in changes if not s.startswith(("box.x=", "box.y=", "particles.number="))]
            changes += [f"box.x={SIDE:g}", f"box.y={SIDE:g}", f"particles.number={round(text['particles.number'] * SIDE**2 / area)}"]
        return tuple(changes)

    def _is_coarse(self, run, setting):
        """Whether a spacing is no finer than the scene's own."""
        return float(setting.partition("=")[2]) >= self.text(Run(run.engine, run.scene, ()))["continuum.spacing"]

    def _once(self, words, ask):
        scene = (self._root / words[1]).read_bytes()
        key = hashlib.sha1(json.dumps(words).encode() + scene).hexdigest()
        if key not in self._known:
            self._known[key] = ask()
        return self._known[key]

    def _keep(self):
        self._kept.parent.mkdir(parents=True, exist_ok=True)
        aside = self._kept.with_suffix(".part")
        aside.write_text(json.dumps(dict(self._known)))
        aside.rename(self._kept)

    def _text(self, scene, settings):
        said = subprocess.run([self._shaken, "scene", scene, *words_of(settings)], capture_output=True, text=True, cwd=self._root)
        if said.returncode:
            return {"refused": said.stderr.strip().partition("\n")[0]}
        return dict(flat(tomllib.loads(said.stdout)))

    def _numbers(self, engine, scene, settings):
        with tempfile.TemporaryDirectory(prefix="shaken_probe_") as aside:
            folder = pathlib.Path(aside) / "run"
            command = [self._shaken, engine, scene, *words_of(settings), "--quiet", "--out", str(folder)]
            alone = os.environ | {"OMP_NUM_THREADS": "1"}
            said = subprocess.run(limited(command, MOST_SECONDS), capture_output=True, cwd=self._root, env=alone)
            if said.returncode < 0:
                return {"end": "slow"}
            if said.returncode:
                return {"end": {1: "failed", 65: "refused", 75: "slow"}.get(said.returncode, f"exit code {said.returncode}")}
            return of_tube(folder) if (folder / "verification.csv").is_file() else of_run(folder, engine)


def limited(command, seconds):
    """The command, killed after so many seconds of processor time: the machine may be busy."""
    return ["sh", "-c", f'ulimit -t {seconds}; exec "$@"', "sh", *command]


def of_run(folder, engine):
    at = GRAINS_UNTIL if engine == "md" else -1
    with h5py.File(folder / f"{engine}.h5") as file:
        return {name: float(f"{group['value'][at]:.8g}") for name, group in file["observables"].items()
                if not name.startswith("momentum_")}


def of_tube(folder):
    """Mean magnitude of each profile."""
    with open(folder / "verification.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    columns = {name: np.array([float(row[name]) for row in rows]) for name in rows[0] if not name.startswith(("exact", "height"))}
    return {name: float(f"{np.abs(values).mean():.8g}") for name, values in columns.items()}


def words_of(settings):
    return [word for setting in settings for word in ("--set", setting)]


def flat(tables, prefix=""):
    for key, value in tables.items():
        if isinstance(value, dict) and "law" not in value:
            yield from flat(value, f"{prefix}{key}.")
        else:
            yield prefix + key, value


def differing(before, now):
    """Names whose numbers are not the same; what only one of them has says nothing."""
    if "end" in before or "end" in now:
        return [] if before.get("end") == now.get("end") else ["end"]
    common = [name for name in before if name in now]
    largest = max((abs(before[name]) for name in common), default=0.0)

    def is_other(a, b):
        return abs(a - b) > SAME * max(abs(a), abs(b)) + ROUND_OFF * largest

    return [name for name in common if is_other(before[name], now[name])]

# SPDX-License-Identifier: MIT
"""What a run folder holds, as arrays: compare.h5 and summary.json, and the particle frames of md.h5 if there are any.

Units: sigma, sqrt(sigma/g). Phases are ft in [0, 1), in [0, 2) for a layer of period two: `cycles`. Heights in compare.h5 are above the plate; `lab` adds the plate.
"""
import json
import sys
import tomllib
from pathlib import Path

import h5py
import numpy as np

LAYER_VOLUME_FRACTION = 0.04 * 0.65


class RunError(Exception):
    """A run folder that lacks something, in words for the user."""


class Engine:
    """One engine's group of compare.h5; arrays by the names of docs/formats.md, errors NaN where there are none."""

    def __init__(self, group):
        self._values = {}
        group.visititems(lambda name, item: self._values.__setitem__(name, item[()]) if isinstance(item, h5py.Dataset) else None)

    def __call__(self, name):
        return self._values[name]

    def error(self, name):
        return self._values.get(name + "_error", np.full(np.shape(self._values[name]), np.nan))

    @property
    def volume_fraction(self):
        return self("density") * np.pi / 6

    @property
    def volume_fraction_error(self):
        return self.error("density") * np.pi / 6


class Run:
    def __init__(self, folder, figures=None):
        """figures: where figures go, if not into the folder."""
        self.folder = Path(folder)
        self.figures = Path(figures) if figures else self.folder / "figures"
        self.finer = None  # the continuum on half the spacing, where there is one
        compare = self.folder / "compare.h5"
        summary = self.folder / "summary.json"
        for needed in (compare, summary):
            if not needed.is_file():
                raise RunError(f"{needed}: not there; make it with: shaken compare {self.folder}")
        with h5py.File(compare) as file:
            self.phase = file["phase"][()]
            self.cycles = int(file["phase"].attrs.get("period", 1))
            self.height = file["height"][()]
            self.plate_height = file["plate/height"][()]
            self.plate_velocity = file["plate/velocity"][()]
            self.md = Engine(file["md"])
            self.continuum = Engine(file["continuum"])
            self.scene = tomllib.loads(file["provenance/scene"][()].decode())
        self.summary = json.loads(summary.read_text())

    def is_of(self, scene):
        """Whether the run's scene agrees with every value of `scene`, a part of a scene as nested tables."""
        return all(self.scene.get(section, {}).get(key) == value for section, keys in scene.items() for key, value in keys.items())

    def grid_error(self, name, factor=1.0):
        """|error| of the continuum's array from its grid: of second order, 4/3 of the change at half the spacing; zeros if unknown."""
        if self.finer is None:
            return np.zeros_like(self.continuum(name))
        return factor * 4 / 3 * np.abs(self.continuum(name) - self.finer(name))

    def nearest(self, phase):
        """Index of the sampled phase nearest to ft, round the period."""
        half = self.cycles / 2
        distance = np.abs((self.phase - phase + half) % self.cycles - half)
        return int(np.argmin(distance))

    def bin_edges(self):
        width = self.height[1] - self.height[0]
        return np.append(self.height - width / 2, self.height[-1] + width / 2)

    def frame(self, phase):
        """(phase, positions) of the particle frame nearest to ft, or None where md.h5 has no frames of that cycle of the period."""
        path = self._trajectory()
        if not path.is_file():
            return None
        with h5py.File(path) as file:
            if "particles/all/position/value" not in file or "particles/all/phase" not in file:
                return None
            phases = file["particles/all/phase"][()]
            if (self.summary["md"].get("period") or 1) > 1:
                phases = phases + is_second(file)
            distance = np.abs((phases - phase + self.cycles / 2) % self.cycles - self.cycles / 2)
            nearest = int(np.argmin(distance))
            if self.cycles > 1 and distance[nearest] > 0.25:
                return None
            return float(phases[nearest]), file["particles/all/position/value"][nearest]

    def _trajectory(self):
        """md.h5 of the folder itself, or of the first of the runs that were averaged."""
        own, runs = self.folder / "md.h5", self.summary.get("runs", {}).get("md", [])
        return own if own.is_file() or not runs else Path(runs[0]) / "md.h5"

    def each_md_run(self):
        """(density, velocity) of every MD run that was averaged, arrays (phases, bins) as in compare.h5; velocity NaN where there is nothing."""
        for folder in self.summary.get("runs", {}).get("md", []):
            with h5py.File(Path(folder) / "md.h5") as file:
                profiles = file["profiles"]
                sums, samples = profiles["sums"][()].sum(axis=0), profiles["samples"][()].sum(axis=0)
                volume = profiles["area"][()] * profiles["bin_width"][()]
            with np.errstate(invalid="ignore"):
                yield sums[:, :, 0] / (samples[:, None] * volume), sums[:, :, 3] / sums[:, :, 0]

    def box_width(self):
        with h5py.File(self._trajectory()) as file:
            edges = file["particles/all/box/edges"]
            values = edges["value"][0] if isinstance(edges, h5py.Group) else edges[()]
            return float(values[0, 0] if np.ndim(values) == 2 else values[0])


def is_second(file):
    """Of each frame of md.h5, 1 in a cycle of the lower centre of mass, which comes second in a period of two, and 0 in the others."""
    heights = file["profiles/centre_of_mass"][()]
    scene = tomllib.loads(file["provenance/scene"][()].decode())
    cycle = np.round(file["particles/all/position/step"][()] / heights.shape[1] - file["particles/all/phase"][()]).astype(int)
    odd_is_first = np.nanmean(np.nanmean(heights[1::2], axis=0) - np.nanmean(heights[::2], axis=0)) > 0
    return (cycle - scene["sample"]["settle"] + odd_is_first) % 2


class Study:
    """What scripts/reproduce made: OUT/comparisons/NAME, OUT/runs/NAME, OUT/figures."""

    def __init__(self, folder):
        self.folder = Path(folder)
        self.figures = self.folder / "figures"

    def run(self, name, finer=None):
        """A comparison as a run, with the continuum of another comparison, on half the spacing, for its grid error."""
        run = Run(self.folder / "comparisons" / name, self.figures)
        if finer and (self.folder / "comparisons" / finer / "compare.h5").is_file():
            run.finer = Run(self.folder / "comparisons" / finer).continuum
        return run

    def summary(self, name):
        path = self.folder / "comparisons" / name / "summary.json"
        if not path.is_file():
            raise RunError(f"{path}: not there; make it with: scripts/reproduce ch4 --out {self.folder}")
        return json.loads(path.read_text())


def main_of_study(draw):
    """Runs a figure script that needs several comparisons: `python3 figure_x.py OUT`."""
    if len(sys.argv) != 2:
        print(f"usage: {Path(sys.argv[0]).name} OUT", file=sys.stderr)
        return 2
    try:
        print(draw(Study(sys.argv[1])))
    except RunError as error:
        print(error, file=sys.stderr)
        return 66
    return 0


def main(draw):
    """Runs one figure script: `python3 figure_x.py DIR`, of a run folder or of the study of a chapter."""
    if len(sys.argv) != 2:
        print(f"usage: {Path(sys.argv[0]).name} DIR", file=sys.stderr)
        return 2
    try:
        study = Study(sys.argv[1])
        is_study = (study.folder / "comparisons").is_dir()
        print(draw(study.run("default", finer="dz_0.1") if is_study else Run(study.folder)))
    except RunError as error:
        print(error, file=sys.stderr)
        return 66
    return 0

#!/usr/bin/python3
"""Do standard errors hold? The scatter of every printed number over seeds beside the error that each run says: scripts/scatter_of_seeds.py [STUDY ...]

Runs each study (default: all) with as many seeds as wanted and prints the mean of each number, its scatter over the seeds, the
root mean square of the errors, and the ratio of the two, which is 1 where errors are right; at the end the geometric mean of the ratios.
A number that is known to one of the sampled phases has the resolution of that in its error, and here in its scatter.
The scatter of n seeds is itself known to 1/sqrt(2 (n - 1)), 11 % of forty; the errors of short runs add to that.
"""
import argparse
import json
import math
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[1]
ELASTIC = ["particles.number=100", "initial.volume_fraction=0.1", "sample.frames=0", "sample.settle=10"]
LAYER = ["particles.number=984", "box.x=10", "box.y=10", "sample.phases=100", "sample.settle=10", "sample.average=40", "sample.frames=0"]
STUDIES = {  # scene and what is set in it
    "elastic": ("uniform_elastic", [*ELASTIC, "sample.interval=0.5", "sample.duration=200"]),
    "short_intervals": ("uniform_elastic", [*ELASTIC, "sample.interval=0.02", "sample.duration=40"]),
    "cooling": ("uniform_cooling", ["particles.number=500", "sample.frames=0", "sample.duration=100000"]),
    "late": ("uniform_late", ["particles.number=500", "sample.frames=0"]),
    "layer": ("ch4_shock", LAYER),
}


class Runs:
    """Runs the command in folders of its own."""

    def __init__(self, shaken, folder):
        self.shaken, self.folder = shaken, pathlib.Path(folder)

    def __call__(self, *words):
        subprocess.run([self.shaken, "-q", *words], check=True, stdout=subprocess.DEVNULL)

    def engine(self, name, scene, settings, to):
        self(name, scene, *(word for setting in settings for word in ("--set", setting)), "--out", self.folder / to)

    def summaries(self, scene, settings, seeds, first=1):
        """summary.json of every seed; of a layer that of its comparison with one run of the continuum."""
        is_layer = 'kind = "layer"' in scene.read_text()
        if is_layer:
            self.engine("continuum", scene, settings, "continuum")
        for seed in range(first, first + seeds):
            self.engine("md", scene, [*settings, f"md.seed={seed}", f"initial.seed={seed}"], f"{seed}")
            if is_layer:
                self("compare", self.folder / f"{seed}", "--md", self.folder / f"{seed}", "--continuum", self.folder / "continuum")
            yield json.loads((self.folder / f"{seed}" / "summary.json").read_text())
            for file in (self.folder / f"{seed}").iterdir():
                file.unlink()


def numbers(summary, prefix=""):
    """Every number that has a standard error: (name, value, error, resolution)."""
    if isinstance(summary, list):
        for entry in {entry["name"]: entry for entry in summary}.values():
            yield entry["name"], entry["measured"], entry["standard_error"], 0.0
        return
    for key, value in summary.items():
        error = summary.get(f"{key}_error")
        if isinstance(value, dict):
            yield from numbers(value, f"{prefix}{key}.")
        elif isinstance(error, list):
            yield from ((f"{prefix}{key}[{i}]", *pair, 0.0) for i, pair in enumerate(zip(value, error)))
        elif f"{key}_error" in summary:
            yield prefix + key, value, error, summary.get(f"{key}_resolution", 0.0)


def table(summaries):
    """Rows of (name, mean, scatter, rms of the errors, ratio, seeds) of numbers known in at least half of the runs."""
    found = {}
    for summary in summaries:
        for name, value, error, resolution in numbers(summary):
            if None not in (value, error):
                found.setdefault(name, []).append((value, error, resolution))
    for name, runs in found.items():
        if len(runs) < 2 or 2 * len(runs) < len(summaries):
            continue
        values, errors, resolutions = zip(*runs)
        scatter = math.hypot(statistics.stdev(values), resolutions[0] / math.sqrt(12))
        said = math.sqrt(statistics.fmean(error * error for error in errors))
        yield name, statistics.fmean(values), scatter, said, scatter / said if said > 0 else math.nan, len(runs)


def geometric_mean(ratios):
    return statistics.geometric_mean(ratio for ratio in ratios if ratio > 0)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("studies", nargs="*", metavar="STUDY", help=", ".join(STUDIES))
    parser.add_argument("--seeds", type=int, default=40)
    parser.add_argument("--first", type=int, default=1, help="the first seed")
    parser.add_argument("--shaken", type=pathlib.Path, default=os.environ.get("SHAKEN", ROOT / "build/release/shaken"))
    options = parser.parse_args()
    if unknown := set(options.studies) - set(STUDIES):
        parser.error(f"no study {', '.join(sorted(unknown))}; there are {', '.join(STUDIES)}")
    ratios = []
    print("| study | number | mean | scatter over seeds | error said (rms) | ratio | seeds |\n|---|---|---|---|---|---|---|")
    for study in options.studies or STUDIES:
        scene, settings = STUDIES[study]
        with tempfile.TemporaryDirectory() as folder:
            rows = table(list(Runs(options.shaken, folder).summaries(ROOT / f"data/scenes/{scene}.toml", settings, options.seeds, options.first)))
            for name, mean, scatter, said, ratio, seeds in rows:
                print(f"| {study} | {name} | {mean:.5g} | {scatter:.2g} | {said:.2g} | {ratio:.2f} | {seeds} |", flush=True)
                ratios.append(ratio)
    print(f"\n{len(ratios)} numbers: geometric mean of the ratios {geometric_mean(ratios):.2f}, smallest {min(ratios):.2f}, largest {max(ratios):.2f}")


if __name__ == "__main__":
    main()

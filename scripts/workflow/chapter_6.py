# SPDX-License-Identifier: MIT
"""The rows, runs and figures of chapter 6: fluctuations, the onset of order, and the noise of the Swift-Hohenberg model that fits them.

Rows are kept under data/expected and made only where one is lacking; ROWS=kept in the environment makes none.
"""
import dataclasses
import os
import pathlib
import subprocess

import model_scatter
import patterns_study
from rows import Row

ONSET = "data/scenes/ch6_onset.toml"
ONSET_SLOW = "data/scenes/ch6_onset_slow.toml"
DISPERSION = "data/scenes/ch5_dispersion.toml"
ONSET_MD = "data/expected/ch6_onset_md.csv"
ONSET_DOWN_MD = "data/expected/ch6_onset_down_md.csv"
FLUCTUATIONS_MD = "data/expected/ch6_fluctuations_md.csv"
ONSET_SLOW_MD = "data/expected/ch6_onset_slow_md.csv"
ONSET_CONTINUUM = "data/expected/ch6_onset_continuum.csv"
MODEL = "data/expected/ch6_swift_hohenberg.csv"
SCATTER = "data/expected/ch6_fit_scatter.csv"

ACCELERATIONS = ("1.7", "1.8", "1.9", "1.95", "2.0", "2.05", "2.1", "2.15", "2.2", "2.25", "2.3")
SLOW_ACCELERATIONS = ("1.7", "1.75", "1.8", "1.82", "1.85", "1.87", "1.88", "1.89", "1.9", "2.0", "2.2")
STRIP_ACCELERATIONS = ("1.95", "2.05", "2.1")   # below, rows of spheres lock across its ten diameters and a cycle takes minutes
SECOND_SEED = ("1.9", "2.0", "2.1", "2.15", "2.2")
CONTINUUM_ACCELERATIONS = ("1.9", "2.2", "2.6", "3.0", "3.4", "3.6", "4.0")
FLUID_ACCELERATIONS = ("2.0", "2.2", "2.6", "3.0")
# A wave to start from: what it comes to does not depend on it, and noise would take hundreds of cycles to grow by 3 per cent each.
FROM_A_WAVE = ("continuum.dimension=2", "initial.wave=0.5", "initial.wave_x=2", "initial.wave_y=0")
# Strengths F of the model's noise that the fit chooses among: shaken fit-noise.
MODEL_OPTIONS = ("--noises", "3e-4,1e-3,3e-3,6e-3,9e-3,1.2e-2,1.6e-2,2.2e-2,4e-2", "--controls", "21", "--seeds", "2", "--model", MODEL)


def onset_rows():
    other = ("initial.seed=2", "md.seed=2")
    return [Row("md", ONSET, "plate.acceleration", gamma) for gamma in ACCELERATIONS] + [
        Row("md", ONSET, "plate.acceleration", gamma, other) for gamma in SECOND_SEED]


def onset_down_rows():
    """From the stripes of Gamma = 2.2, which scripts/reproduce ch6 --figure 6.1 leaves, down."""
    stripes = ('initial.file="out/ch6/runs/md_2.2/md.checkpoint"', "sample.settle=100")
    return [Row("md", ONSET, "plate.acceleration", gamma, stripes) for gamma in ("2.1", "2.15")]


def onset_slow_rows():
    return [Row("md", ONSET_SLOW, "plate.acceleration", gamma) for gamma in SLOW_ACCELERATIONS]


def fluctuation_rows():
    """Waves of the strip below onset, where every whole number of them is seen; of the cell of figure 6.2, the last run of each acceleration; and of figure 6.5's below its onset."""
    long = ("sample.settle=100", "sample.average=200")
    strip = [Row("md", DISPERSION, "plate.acceleration", gamma, long) for gamma in STRIP_ACCELERATIONS]
    last_of = {row.value: row for row in onset_rows()}   # one run of each acceleration
    slow = [row for row in onset_slow_rows() if float(row.value) < 1.9]
    return [dataclasses.replace(row, fluctuations=first) for first, some in ((100, (*strip, *last_of.values())), (30, slow)) for row in some]


def continuum_rows():
    settled, sooner = ("sample.settle=150", "sample.average=10"), ("sample.settle=40", "sample.average=10", "continuum.closure=jenkins_richman_fluid")
    return [Row("continuum", ONSET, "plate.acceleration", gamma, FROM_A_WAVE + settled) for gamma in CONTINUUM_ACCELERATIONS] + [
        Row("continuum", ONSET, "plate.acceleration", gamma, FROM_A_WAVE + sooner) for gamma in FLUID_ACCELERATIONS]


def runs():
    made = {}

    def add(name, engine, scene, *changes):
        made[name] = {"engine": engine, "scene": scene, "changes": list(changes), "start": None}

    for gamma in ("1.9", "2.2"):
        add(f"md_{gamma}", "md", ONSET, f"plate.acceleration={gamma}", "sample.settle=150", "sample.average=2")
    for gamma in ("2.2", "3.6"):
        add(f"continuum_{gamma}", "continuum", ONSET, f"plate.acceleration={gamma}", "sample.settle=80", "sample.average=2", *FROM_A_WAVE)
    # Tables 6.1 and 6.2: cells of 126 x 10, the cycle after thirty, eight states of it. At f* = 0.4174 waves fade by 0.75 a cycle, so one column says the same.
    states = ("box.x=126", "particles.number=7560", "plate.acceleration=2.2", "sample.settle=30", "sample.average=1", "sample.phases=40", "sample.frames=8",
              "sample.map_bin=3", "continuum.spacing_horizontal=3.0", "continuum.lid=25")
    for f, dimension in (("0.25", "2"), ("0.4174", "1")):
        flat = ("initial.noise=0",) if dimension == "1" else ()
        for law, constant in (("", ()), ("_constant", ("continuum.restitution=0.7",))):
            add(f"states_{f}{law}", "continuum", DISPERSION, f"plate.frequency_star={f}", f"continuum.dimension={dimension}", *states, *flat, *constant)
    return made


MD = (ONSET_MD, onset_rows())
FIT = {"rows": [MD], "files": ["fit.json"]}
FIGURES = {
    "figure_6_1": {"runs": ["md_1.9", "md_2.2", "continuum_2.2", "continuum_3.6"]},
    "figure_6_2": {"rows": [MD, (ONSET_CONTINUUM, continuum_rows())]},
    "figure_6_3": {"rows": [MD, (ONSET_DOWN_MD, onset_down_rows())], "files": ["fit.json"]},
    "figure_6_4": FIT,
    "figure_6_5": {"rows": [MD, (ONSET_SLOW_MD, onset_slow_rows())]},
    "figure_6_scatter": {"rows": [MD], "files": ["fit.json", "scatter.csv"]},
    "figure_6_fluctuations": {"rows": [(FLUCTUATIONS_MD, fluctuation_rows())]},
    "figure_6_tables": {"runs": [f"states_{f}{e}" for f in ("0.25", "0.4174") for e in ("", "_constant")]},
}


def fit(root, out):
    """OUT/fit.json: what `shaken fit-noise` says of the MD's rows."""
    shaken = os.environ.get("SHAKEN", root / "build/release/shaken")
    keep(out, "fit.json", subprocess.run([shaken, "fit-noise", ONSET_MD, *MODEL_OPTIONS], check=True, stdout=subprocess.PIPE, text=True, cwd=root).stdout)


def scatter(root, out):
    """OUT/scatter.csv: the fits of fields of a known noise, kept under data/expected; half an hour of a core from nothing."""
    if os.environ.get("ROWS") != "kept":
        model_scatter.fill(root / SCATTER, root / MODEL, os.environ.get("SHAKEN", root / "build/release/shaken"), os.cpu_count())
    keep(out, "scatter.csv", (root / SCATTER).read_text())


def keep(out, name, text):
    """Writes a file only where it is another, so that figures that are drawn from it are not drawn again."""
    path = pathlib.Path(out).resolve() / name
    path.parent.mkdir(parents=True, exist_ok=True)
    if not path.exists() or path.read_text() != text:
        path.write_text(text)


def make(root, out, figures, jobs, dry_run, command):
    """The chapter, or the named figures of it; an exit code."""
    return patterns_study.make(root, out, FIGURES, runs(), figures, jobs, dry_run, command, "Chapter 6: onset of patterns and fluctuations", {"fit.json": fit, "scatter.csv": scatter})


def kept(root):
    return patterns_study.kept(root, "ch6", FIGURES, runs())


def remake(today, parts):
    return patterns_study.remake(today, parts, FIGURES, runs(), make)

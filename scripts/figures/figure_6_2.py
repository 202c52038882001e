# SPDX-License-Identifier: MIT
"""Figure 6.2: mean square of the layer's height against the plate's acceleration, MD and continuum."""
import sys

import numpy as np

import run_folder
import tables
from style import DENSITY, LENGTH, TEMPERATURE, plt, points, save

NAME = "figure_6_2"
CAPTION = (
    "Figure 6.2. Mean square deviation of the local height of the centre of mass, bins of 2 x 2 at ft = 0.25, against the peak acceleration: MD "
    "(triangles; 400 cycles to settle, 100 averaged, bars of one standard error) and the continuum, started from a wave (circles; squares: jenkins_richman_fluid; values below "
    "1e-4 are drawn there). Broken lines: the onsets of the source, 1.955 in its continuum and 2.15 for long-range order in its MD; dotted: where our continuum's small wave neither grows nor fades on the same columns, 2 wide, which put it 0.4 too low (figure 5.converged)."
)
LOWEST = 1e-4
# Words, table, closure that a row names, marker, colour.
FAMILIES = (("MD", "ch6_onset_md.csv", None, "^", DENSITY), ("continuum", "ch6_onset_continuum.csv", None, "o", TEMPERATURE),
            ("continuum, a fluid's transport at packing", "ch6_onset_continuum.csv", "jenkins_richman_fluid", "s", LENGTH))


def draw(study):
    figure, axis = plt.subplots(figsize=(6.2, 4.4))
    columns = {name: [] for name in ("engine", "Gamma", "mean square/sigma^2", "error")}
    for engine, table, closure, marker, colour in FAMILIES:
        rows = tables.merged([row for row in tables.rows(table) if tables.setting(row, "continuum.closure") == closure])
        if not rows:
            continue
        gamma, square, error = (np.array([row[key] for row in rows]) for key in ("value", "mean_square", "mean_square_error"))
        points(axis, gamma, np.maximum(square, LOWEST), y_error=np.where(square > LOWEST, error, 0), marker=marker, color=colour, mfc="none",
               ms=6, label=engine, linestyle="none" if engine == "MD" else "-", lw=0.8)
        for values in zip([engine] * len(gamma), gamma, square, error):
            for name, value in zip(columns, values):
                columns[name].append(value)
    published = tables.published(6)
    axis.axvline(published["continuum_onset"]["value"], color=TEMPERATURE, ls="--", lw=0.9)
    axis.axvline(published["onset"]["value"], color=DENSITY, ls="--", lw=0.9)
    onset = tables.growth_onset(wide="2")
    if np.isfinite(onset):
        axis.axvline(onset, color=TEMPERATURE, ls=":", lw=1.1)
    axis.set_yscale("log")
    axis.set_ylim(LOWEST, 2)
    axis.set_xlabel(r"peak acceleration $\Gamma$")
    axis.set_ylabel(r"$\langle\psi^2\rangle/\sigma^2$")
    axis.legend(loc="center right")
    return save(figure, study.figures, NAME, columns)


if __name__ == "__main__":
    sys.exit(run_folder.main_of_study(draw))

# SPDX-License-Identifier: MIT
"""Figure 6.5: mean square of the pattern over the layer's mean height squared, at two frequencies."""
import sys

import numpy as np

import run_folder
import tables
from style import DENSITY, LENGTH, plt, points, save

NAME = "figure_6_5"
CAPTION = (
    "Figure 6.5. Mean square deviation of the local height over the squared mean height at ft = 0.25 against the peak acceleration, MD: f* = 0.4174 in "
    "a cell of 42 x 42 (triangles) and f* = 0.25 in one of 84 x 84 (squares), two wavelengths square each. Bars: one standard error."
)
TABLES = (("0.4174", "ch6_onset_md.csv", "^", DENSITY), ("0.25", "ch6_onset_slow_md.csv", "s", LENGTH))


def draw(study):
    figure, axis = plt.subplots(figsize=(5.8, 4.2))
    columns = {name: [] for name in ("f*", "Gamma", "mean square over mean height squared", "error")}
    for frequency, table, marker, colour in TABLES:
        rows = tables.merged(tables.rows(table))
        if not rows:
            axis.text(0.03, 0.75, f"no rows of $f^*$ = {frequency} yet", transform=axis.transAxes, fontsize=8, color=colour)
            continue
        gamma, ratio = (np.array([row[key] for row in rows]) for key in ("value", "relative_mean_square"))
        error = ratio * np.array([row["mean_square_error"] / row["mean_square"] for row in rows])
        points(axis, gamma, ratio, y_error=error, marker=marker, ms=6, color=colour, mfc="none", linestyle="-", lw=0.6, label=f"$f^*$ = {frequency}")
        for values in zip([float(frequency)] * len(gamma), gamma, ratio, error):
            for name, value in zip(columns, values):
                columns[name].append(value)
    axis.set_ylim(bottom=0)
    axis.set_xlabel(r"peak acceleration $\Gamma$")
    axis.set_ylabel(r"$\langle\psi^2\rangle/\langle z_{cm}\rangle^2$")
    axis.legend(loc="upper left")
    return save(figure, study.figures, NAME, columns)


if __name__ == "__main__":
    sys.exit(run_folder.main_of_study(draw))

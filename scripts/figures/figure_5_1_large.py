# SPDX-License-Identifier: MIT
"""Figure 5.1: the stripes of the MD in a cell of 126 x 126, in two cycles that follow one another."""
import sys

import numpy as np

import overhead_map
import run_folder
from style import plt, save

NAME = "figure_5_1_large"
CAPTION = (
    "Figure 5.1. Height of the layer's centre of mass from above at ft = 0.25 in a cell of 126 x 126 (95,256 grains, bins of 1 x 1, from a flat state), Gamma = 2.2, f* = 0.4174, in two cycles "
    "that follow one another: stripes 21 diameters apart, crests where the cycle before had troughs."
)


def draw(study):
    psi, cycles, sides, gamma = overhead_map.maps_of(study.folder / "runs/md_large/md.h5")
    figure, axes = plt.subplots(1, 2, figsize=(8.6, 3.9))
    columns = overhead_map.new_columns()
    for axis, values, cycle in zip(axes, psi, cycles):
        image = overhead_map.panel(axis, values, sides, np.abs(psi).max(), rf"MD, $\Gamma$ = {gamma:g}, cycle {cycle}")
        overhead_map.add(columns, "MD", gamma, cycle, values, sides)
    figure.colorbar(image, ax=axes, label=overhead_map.LABEL, shrink=0.8)
    return save(figure, study.figures, NAME, columns)


if __name__ == "__main__":
    sys.exit(run_folder.main_of_study(draw))

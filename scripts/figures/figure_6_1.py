# SPDX-License-Identifier: MIT
"""Figure 6.1: the layer from above below and above onset, MD and continuum."""
import sys

import overhead_map
import run_folder

NAME = "figure_6_1"
CAPTION = (
    "Figure 6.1. The layer from above at ft = 0.25, height of its centre of mass in bins of 2 x 2: MD at Gamma = 1.9 and 2.2 (upper row), the continuum at 2.2, "
    "where a wave put in at the start has died away, and at 3.6, where it lasts (lower row; uniform along y by the run's choice). One scale for all."
)
PANELS = (("MD", "md_1.9", "md"), ("MD", "md_2.2", "md"), ("continuum", "continuum_2.2", "continuum"), ("continuum", "continuum_3.6", "continuum"))


def draw(study):
    return overhead_map.panels(study, NAME, PANELS, columns_of_panels=2)


if __name__ == "__main__":
    sys.exit(run_folder.main_of_study(draw))

# SPDX-License-Identifier: MIT
"""Figure 5.1: the layer of 126 x 126 from above, MD and continuum."""
import sys

import overhead_map
import run_folder

NAME = "figure_5_1_large"
CAPTION = (
    "Figure 5.1. Height of the layer's centre of mass from above at ft = 0.25 in a cell of 126 x 126: MD (bins of 1 x 1, from a flat state) at Gamma = 2.2 and the "
    "continuum (cells of 2 x 2, from a wave of 21) at Gamma = 4.0, where it has stripes; f* = 0.4174."
)
PANELS = (("MD", "md_large", "md"), ("continuum", "continuum_large", "continuum"))


def draw(study):
    return overhead_map.panels(study, NAME, PANELS, columns_of_panels=2)


if __name__ == "__main__":
    sys.exit(run_folder.main_of_study(draw))

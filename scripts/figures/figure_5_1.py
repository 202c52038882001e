# SPDX-License-Identifier: MIT
"""Figure 5.1 on the small cell: the layer from above, MD and continuum."""
import sys

import overhead_map
import run_folder

NAME = "figure_5_1"
CAPTION = (
    "Figure 5.1, on a cell of 42 x 42 in place of 126 x 126 (--figure 5.1.large). Height of the layer's centre of mass from above at ft = 0.25, bins of 1 x 1: MD at "
    "Gamma = 2.2, the continuum at 3.6, where it has stripes (uniform along y by the run's choice), and at 2.2 with a fluid's transport at packing (closure jenkins_richman_fluid), f* = 0.4174. One scale for all, to which 98 per cent of the bins keep."
)
PANELS = (("MD", "md_stripes", "md"), ("continuum", "continuum_stripes", "continuum"), ("a fluid's transport", "continuum_fluid", "continuum"))


def draw(study):
    return overhead_map.panels(study, NAME, PANELS, columns_of_panels=3)


if __name__ == "__main__":
    sys.exit(run_folder.main_of_study(draw))

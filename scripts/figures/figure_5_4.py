# SPDX-License-Identifier: MIT
"""Figure 5.4: volume fraction across the stripes over two cycles."""
import sys

import run_folder
from slice_figures import one_field

NAME = "figure_5_4"
CAPTION = (
    "Figure 5.4. Volume fraction over a plane across the stripes, at eight phases of two cycles: MD (left), continuum (right). "
    "Both at peak acceleration 3.6, where the continuum has stripes (the source: 2.2, where ours are flat), f* = 0.4174; MD: mean over all "
    "particles along the stripes and over four times two cycles; grey: no particle, or volume fraction below 0.001. Thick line: the plate."
)


def draw(study):
    return one_field(study, NAME, "nu")


if __name__ == "__main__":
    sys.exit(run_folder.main_of_study(draw))

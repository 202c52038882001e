# SPDX-License-Identifier: MIT
"""Figure 5.4: volume fraction across the stripes over two cycles."""
import sys

import run_folder
from slice_figures import one_field

NAME = "figure_5_4"
CAPTION = (
    "Figure 5.4. Volume fraction over a plane across the stripes, at eight phases of two cycles: MD (left), continuum (right). "
    "MD at the source's peak acceleration, 2.2; the continuum at 3.6, since at 2.2 ours stays flat; f* = 0.4174. MD: mean over all particles along "
    "the stripes and four times two cycles; grey: too few particles to tell, or volume fraction below 0.001. Thick line: the plate."
)


def draw(study):
    return one_field(study, NAME, "nu")


if __name__ == "__main__":
    sys.exit(run_folder.main_of_study(draw))

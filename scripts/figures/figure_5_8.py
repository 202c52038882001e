# SPDX-License-Identifier: MIT
"""Figure 5.8: volume fraction and temperature while the shock passes."""
import sys

import run_folder
from slice_figures import two_fields

NAME = "figure_5_8"
CAPTION = (
    "Figure 5.8. Volume fraction and granular temperature while the layer lands and the shock passes. "
    "MD at the source's peak acceleration, 2.2; the continuum at 3.6, since at 2.2 ours stays flat; f* = 0.4174. MD: mean over all particles along "
    "the stripes and four times two cycles; grey: too few particles to tell, or volume fraction below 0.001. Thick line: the plate."
)


def draw(study):
    return two_fields(study, NAME, ("nu", "T"))


if __name__ == "__main__":
    sys.exit(run_folder.main_of_study(draw))

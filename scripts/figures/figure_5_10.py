# SPDX-License-Identifier: MIT
"""Figure 5.10: horizontal velocity and pressure gradient while the shock passes."""
import sys

import run_folder
from slice_figures import two_fields

NAME = "figure_5_10"
CAPTION = (
    "Figure 5.10. Horizontal velocity and the slope of the pressure along x while the layer lands and the shock passes; the pressure is the equation of state at each engine's density and temperature, and is not drawn where MD's spheres lie in planes, above 0.6. "
    "MD at the source's peak acceleration, 2.2; the continuum at 3.6, since at 2.2 ours stays flat; f* = 0.4174. MD: mean over all particles along "
    "the stripes and four times two cycles; grey: too few particles to tell, or volume fraction below 0.001. Thick line: the plate."
)


def draw(study):
    return two_fields(study, NAME, ("u_x", "dP/dx"))


if __name__ == "__main__":
    sys.exit(run_folder.main_of_study(draw))

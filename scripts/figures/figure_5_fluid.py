# SPDX-License-Identifier: MIT
"""Stripes of the continuum with a fluid's transport at packing, at the source's own peak acceleration, beside MD's."""
import sys

import run_folder
from slice_figures import two_fields

NAME = "figure_5_fluid"
CAPTION = (
    "Volume fraction and horizontal velocity while the layer lands, MD and the continuum with the closure jenkins_richman_fluid, whose viscosity and conductivity go on as a fluid's where the pressure diverges: both at the source's peak acceleration, 2.2, f* = 0.4174. "
    "With the default closure the continuum stays flat there. MD: mean over all particles along the stripes and four times two cycles; grey: too few particles to tell, or volume fraction below 0.001. Thick line: the plate."
)
RUNS = (("MD", "md_stripes", "md"), ("continuum", "continuum_fluid", "continuum"))


def draw(study):
    return two_fields(study, NAME, ("nu", "u_x"), runs=RUNS)


if __name__ == "__main__":
    sys.exit(run_folder.main_of_study(draw))

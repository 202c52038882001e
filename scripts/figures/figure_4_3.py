# SPDX-License-Identifier: MIT
"""Figure 4.3: Mach number and ten times the volume fraction against height, when the shock is fully formed."""
import sys

import numpy as np

import mach_against_height
import run_folder
from mach_against_height import PHASE
from style import DENSITY, save

NAME = "figure_4_3"
CAPTION = (
    "Figure 4.3. Mach number with respect to the plate (dashed line: continuum, triangles: MD) and ten times the volume "
    "fraction (solid line: continuum, circles: MD) against height at ft = 0.22. Bars are one standard error. "
    "Dotted: Ma = 1. The spread of MD densities next to the plate is no noise: spheres stand in planes there."
)


def draw(run):
    index = run.nearest(PHASE)
    figure, columns = mach_against_height.draw(run, mach_against_height.Beside(
        10 * run.md.volume_fraction[index], 10 * run.md.volume_fraction_error[index], 10 * run.continuum.volume_fraction[index],
        run.grid_error("density", 10 * np.pi / 6)[index], DENSITY, r"$10\,\nu$"))
    return save(figure, run.figures, NAME, columns | {
        "nu MD": run.md.volume_fraction[index], "nu MD error": run.md.volume_fraction_error[index],
        "nu continuum": run.continuum.volume_fraction[index],
    })


if __name__ == "__main__":
    sys.exit(run_folder.main(draw))

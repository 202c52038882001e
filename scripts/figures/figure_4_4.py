# SPDX-License-Identifier: MIT
"""Figure 4.4: Mach number and mean free path against height, when the shock is fully formed."""
import sys

import mach_against_height
import run_folder
from mach_against_height import PHASE, in_layer
from style import LENGTH, save

NAME = "figure_4_4"
CAPTION = (
    "Figure 4.4. Mach number with respect to the plate (dashed line: continuum, triangles: MD) and mean free path over the "
    "particle's diameter (solid line: continuum, circles: MD) against height at ft = 0.22. Bars are one standard error, bands the "
    "continuum's grid error. Dotted: one."
)


def draw(run):
    index = run.nearest(PHASE)
    figure, columns = mach_against_height.draw(run, mach_against_height.Beside(
        in_layer(run.md, index, "mean_free_path"), run.md.error("mean_free_path")[index],
        in_layer(run.continuum, index, "mean_free_path"), run.grid_error("mean_free_path")[index], LENGTH, r"$\lambda/\sigma$"), 8)
    return save(figure, run.figures, NAME, columns | {
        "lambda MD/sigma": run.md("mean_free_path")[index], "lambda MD error/sigma": run.md.error("mean_free_path")[index],
        "lambda continuum/sigma": run.continuum("mean_free_path")[index],
    })


if __name__ == "__main__":
    sys.exit(run_folder.main(draw))

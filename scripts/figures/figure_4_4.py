# SPDX-License-Identifier: MIT
"""Figure 4.4: Mach number and mean free path against height, when the shock is fully formed."""
import sys

import numpy as np

import run_folder
from run_folder import LAYER_VOLUME_FRACTION
from style import LENGTH, MACH, PLATE, bands, plt, points, save

NAME = "figure_4_4"
PHASE = 0.22
CAPTION = (
    "Figure 4.4. Mach number with respect to the plate (dashed line: continuum, triangles: MD) and mean free path over the "
    "particle's diameter (solid line: continuum, circles: MD) against height at ft = 0.22. Bars are one standard error, bands the "
    "continuum's grid error. Dotted: one."
)


def draw(run):
    index = run.nearest(PHASE)
    plate = run.plate_height[index]
    z = run.height + plate
    figure, axis = plt.subplots(figsize=(4.6, 4.8))
    mach = {}
    for engine in (run.continuum, run.md):
        # Outside the layer the gas is too thin for a temperature, and Mach numbers do not count.
        mach[engine] = np.where(engine.volume_fraction[index] > 0.2 * LAYER_VOLUME_FRACTION, engine("mach")[index], np.nan)
    axis.plot(mach[run.continuum], z, "--", color=MACH, label=r"$\mathrm{Ma}$, continuum")
    points(axis, mach[run.md], z, run.md.error("mach")[index], marker="^", color=MACH, mfc="none", label=r"$\mathrm{Ma}$, MD")
    path = {}
    for engine in (run.continuum, run.md):
        path[engine] = np.where(engine.volume_fraction[index] > 0.2 * LAYER_VOLUME_FRACTION, engine("mean_free_path")[index], np.nan)
    axis.plot(path[run.continuum], z, color=LENGTH, label=r"$\lambda/\sigma$, continuum")
    points(axis, path[run.md], z, run.md.error("mean_free_path")[index], marker="o", color=LENGTH, mfc="none", label=r"$\lambda/\sigma$, MD")
    bands(axis, z, mach[run.continuum], run.grid_error("mach")[index], MACH)
    bands(axis, z, path[run.continuum], run.grid_error("mean_free_path")[index], LENGTH)
    axis.axvline(1.0, color="0.6", lw=0.8, ls=":")
    axis.axhline(plate, color=PLATE, lw=2)
    axis.text(7.8, plate - 0.4, "plate", ha="right", va="top", fontsize=9)
    upper = np.nanmax([run.md("layer/upper")[index], run.continuum("layer/upper")[index]]) + plate
    axis.set_ylim(max(0.0, plate - 3), 5 * np.ceil((upper + 3) / 5))
    axis.set_xlim(0, 8)
    axis.set_xlabel(r"$\mathrm{Ma}$,  $\lambda/\sigma$")
    axis.set_ylabel(r"height $z/\sigma$")
    axis.set_title(f"$ft = {run.phase[index]:.2f}$", fontsize=10)
    axis.legend(loc="upper right")
    return save(figure, run.figures, NAME, {
        "z/sigma": z,
        "Ma MD": run.md("mach")[index], "Ma MD error": run.md.error("mach")[index],
        "Ma continuum": run.continuum("mach")[index],
        "lambda MD/sigma": run.md("mean_free_path")[index], "lambda MD error/sigma": run.md.error("mean_free_path")[index],
        "lambda continuum/sigma": run.continuum("mean_free_path")[index],
    })


if __name__ == "__main__":
    sys.exit(run_folder.main(draw))

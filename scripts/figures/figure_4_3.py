# SPDX-License-Identifier: MIT
"""Figure 4.3: Mach number and ten times the volume fraction against height, when the shock is fully formed."""
import sys

import numpy as np

import run_folder
from run_folder import LAYER_VOLUME_FRACTION
from style import DENSITY, MACH, PLATE, bands, plt, points, save

NAME = "figure_4_3"
PHASE = 0.22
CAPTION = (
    "Figure 4.3. Mach number with respect to the plate (dashed line: continuum, triangles: MD) and ten times the volume "
    "fraction (solid line: continuum, circles: MD) against height at ft = 0.22. Bars are one standard error. "
    "Dotted: Ma = 1. The spread of MD densities next to the plate is no noise: spheres stand in planes there."
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
    axis.plot(10 * run.continuum.volume_fraction[index], z, color=DENSITY, label=r"$10\,\nu$, continuum")
    points(axis, 10 * run.md.volume_fraction[index], z, 10 * run.md.volume_fraction_error[index], marker="o", color=DENSITY,
           mfc="none", label=r"$10\,\nu$, MD")
    bands(axis, z, mach[run.continuum], run.grid_error("mach")[index], MACH)
    bands(axis, z, 10 * run.continuum.volume_fraction[index], run.grid_error("density", 10 * np.pi / 6)[index], DENSITY)
    axis.axvline(1.0, color="0.6", lw=0.8, ls=":")
    axis.axhline(plate, color=PLATE, lw=2)
    axis.text(axis.get_xlim()[1] * 0.97, plate - 0.4, "plate", ha="right", va="top", fontsize=9)
    upper = np.nanmax([run.md("layer/upper")[index], run.continuum("layer/upper")[index]]) + plate
    axis.set_ylim(max(0.0, plate - 3), 5 * np.ceil((upper + 3) / 5))
    axis.set_xlim(left=0)
    axis.set_xlabel(r"$\mathrm{Ma}$,  $10\,\nu$")
    axis.set_ylabel(r"height $z/\sigma$")
    axis.set_title(f"$ft = {run.phase[index]:.2f}$", fontsize=10)
    axis.legend(loc="upper right")
    return save(figure, run.figures, NAME, {
        "z/sigma": z,
        "Ma MD": run.md("mach")[index], "Ma MD error": run.md.error("mach")[index],
        "Ma continuum": run.continuum("mach")[index],
        "nu MD": run.md.volume_fraction[index], "nu MD error": run.md.volume_fraction_error[index],
        "nu continuum": run.continuum.volume_fraction[index],
    })


if __name__ == "__main__":
    sys.exit(run_folder.main(draw))

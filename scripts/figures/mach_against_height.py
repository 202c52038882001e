# SPDX-License-Identifier: MIT
"""What figures 4.3 and 4.4 share: the Mach number against height at one phase, with another quantity beside it."""
from collections import namedtuple

import numpy as np

from run_folder import LAYER_VOLUME_FRACTION
from style import MACH, PLATE, bands, plt, points

PHASE = 0.22

# Values of both engines against height, the error of MD, the grid error of the continuum; label with its symbol.
Beside = namedtuple("Beside", "md md_error continuum grid_error colour symbol")


def in_layer(engine, index, field):
    """Outside the layer the gas is too thin for a temperature, and neither Mach numbers nor free paths count."""
    return np.where(engine.volume_fraction[index] > 0.2 * LAYER_VOLUME_FRACTION, engine(field)[index], np.nan)


def draw(run, beside, widest=None):
    """The figure, and the columns that both figures write. widest: end of the axis; without: as the data ask."""
    index = run.nearest(PHASE)
    plate = run.plate_height[index]
    z = run.height + plate
    figure, axis = plt.subplots(figsize=(4.6, 4.8))
    mach = {engine: in_layer(engine, index, "mach") for engine in (run.continuum, run.md)}
    axis.plot(mach[run.continuum], z, "--", color=MACH, label=r"$\mathrm{Ma}$, continuum")
    points(axis, mach[run.md], z, run.md.error("mach")[index], marker="^", color=MACH, mfc="none", label=r"$\mathrm{Ma}$, MD")
    axis.plot(beside.continuum, z, color=beside.colour, label=f"{beside.symbol}, continuum")
    points(axis, beside.md, z, beside.md_error, marker="o", color=beside.colour, mfc="none", label=f"{beside.symbol}, MD")
    bands(axis, z, mach[run.continuum], run.grid_error("mach")[index], MACH)
    bands(axis, z, beside.continuum, beside.grid_error, beside.colour)
    axis.axvline(1.0, color="0.6", lw=0.8, ls=":")
    axis.axhline(plate, color=PLATE, lw=2)
    axis.set_xlim(0, widest)
    axis.text(axis.get_xlim()[1] * 0.97, plate - 0.4, "plate", ha="right", va="top", fontsize=9)
    upper = np.nanmax([run.md("layer/upper")[index], run.continuum("layer/upper")[index]]) + plate
    axis.set_ylim(max(0.0, plate - 3), 5 * np.ceil((upper + 3) / 5))
    axis.set_xlabel(rf"$\mathrm{{Ma}}$,  {beside.symbol}")
    axis.set_ylabel(r"height $z/\sigma$")
    axis.set_title(f"$ft = {run.phase[index]:.2f}$", fontsize=10)
    axis.legend(loc="upper right")
    return figure, {"z/sigma": z, "Ma MD": run.md("mach")[index], "Ma MD error": run.md.error("mach")[index],
                    "Ma continuum": run.continuum("mach")[index]}
